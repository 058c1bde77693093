// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_CONFIG_XML_H_
#define LATCHWORK_CONFIG_XML_H_

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/logic/diagnostic.h"

namespace latchwork::config {

struct Attribute {
  std::string name;
  std::string value;
};

/// An XML element with its place. Attribute order is the file's.
struct Element {
  std::string name;
  std::vector<Attribute> attributes;
  std::vector<Element> children;
  std::string text;           ///< Character data, trimmed.
  logic::SourcePlace place;   ///< Of the start tag.

  /// The value of an attribute, or null.
  const std::string* Find(std::string_view attribute) const;
};

struct XmlFile {
  Element root;
  logic::Diagnostics diagnostics;
  std::string bytes;  ///< The text of the file, for fingerprints and excerpts.
};

/// Parses a file and validates it against a schema (Xerces-C, SAX2). A document type declaration is refused, nothing outside the
/// file is ever fetched. All errors at once, each with its place. Depth and size are limited.
XmlFile ReadXml(const std::filesystem::path& file, std::string_view schema);
XmlFile ReadXmlText(std::string_view text, std::string_view name, std::string_view schema);

}  // namespace latchwork::config

#endif  // LATCHWORK_CONFIG_XML_H_
