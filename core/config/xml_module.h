// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_CONFIG_XML_MODULE_H_
#define LATCHWORK_CONFIG_XML_MODULE_H_

#include <string_view>

#include "latchwork/config/xml.h"

/// The one function of the module liblatchwork_xml, which stands beside liblatchwork and is loaded
/// by the first XML text that is read: the libraries behind Xerces cost every start of a command
/// more than most proofs take. Parses `file.bytes` and fills in the rest.
extern "C" void latchwork_parse_xml(latchwork::config::XmlFile& file, std::string_view name,
                                    std::string_view schema);

#endif  // LATCHWORK_CONFIG_XML_MODULE_H_
