// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_CONFIG_DOCUMENT_H_
#define LATCHWORK_CONFIG_DOCUMENT_H_

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "latchwork/config/xml.h"
#include "latchwork/logic/diagnostic.h"

namespace latchwork::config {

inline constexpr std::size_t kMaxIncludeDepth = 16;

/// An agent file with its includes spliced in.
struct Document {
  struct Source {
    std::string name;
    std::string bytes;
  };
  Element root;                   ///< The <agent> without its children.
  std::vector<Element> elements;  ///< What stands in it, in order.
  std::vector<Source> sources;    ///< In the order of reading.
  std::string fingerprint;
  logic::Diagnostics diagnostics;
  bool has_reader = true;  ///< See XmlFile.
  bool is_agent = false;   ///< There is an <agent> to check.
  bool is_whole =
      true;  ///< Nothing is missing or unknown in it, so that what is not there was not written.
};

/// `fragments` are read as if they were included at the end.
Document ReadDocument(const std::filesystem::path& file,
                      const std::vector<std::filesystem::path>& fragments);

/// Orders diagnostics by source and place, cuts them after a hundred, and gives each its excerpt.
void Arrange(const std::vector<Document::Source>& sources, logic::Diagnostics& diagnostics);

}  // namespace latchwork::config

#endif  // LATCHWORK_CONFIG_DOCUMENT_H_
