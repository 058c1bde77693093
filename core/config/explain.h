// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_CONFIG_EXPLAIN_H_
#define LATCHWORK_CONFIG_EXPLAIN_H_

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/config/schema_index.h"
#include "latchwork/config/xml.h"
#include "latchwork/logic/diagnostic.h"

namespace latchwork::config {

/// What the validator said against each element, by the (line, column) of its start tag.
using Complaints = std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::string>>;

/// Puts complaints of the validator into words that help: unknown elements and attributes with the
/// nearest known name, missing attributes, values with what is allowed. The validator is the judge:
/// nothing is said against an element without a complaint, and a complaint that cannot be put
/// better is given as it is. What is inside an unknown element is not complained about.
logic::Diagnostics Explain(const Element& root, const SchemaIndex& schema,
                           const Complaints& complaints);

}  // namespace latchwork::config

#endif  // LATCHWORK_CONFIG_EXPLAIN_H_
