// SPDX-License-Identifier: BSD-3-Clause
#include "core/config/xml_module.h"

#include <dlfcn.h>

#include <filesystem>
#include <string>
#include <utility>

#include "core/config/read_bytes.h"

namespace latchwork::config {
namespace {

struct Module {
  decltype(&latchwork_parse_xml) parse = nullptr;
  std::string problem;
};

/// The folder of the library that this function is in.
std::filesystem::path OwnFolder() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&OwnFolder), &info) == 0) return {};
  return std::filesystem::path(info.dli_fname).parent_path();
}

/// By its whole path: the folders that the loader would search are not always those of the caller.
Module Load() {
  const std::filesystem::path file = OwnFolder() / LATCHWORK_XML_MODULE;
  void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* const entry = library == nullptr ? nullptr : dlsym(library, "latchwork_parse_xml");
  if (entry == nullptr) return {nullptr, dlerror()};
  return {reinterpret_cast<decltype(&latchwork_parse_xml)>(entry), {}};
}

XmlFile ReadChecked(std::string bytes, std::string_view name, std::string_view schema) {
  XmlFile file;
  file.bytes = std::move(bytes);
  if (auto wrong = CheckText(file.bytes, name, kMaxXmlBytes)) {
    file.diagnostics.push_back(*std::move(wrong));
    return file;
  }
  static const Module module = Load();
  if (module.parse != nullptr) {
    module.parse(file, name, schema);
  } else {
    file.has_reader = false;
    file.diagnostics.push_back({{std::string(name), 0, 0},
                                "the reader of XML files cannot be loaded: " + module.problem,
                                "it belongs beside liblatchwork.so: install latchwork anew",
                                ""});
  }
  return file;
}

}  // namespace

XmlFile ReadXml(const std::filesystem::path& file, std::string_view schema) {
  XmlFile result;
  auto bytes = ReadBytes(file, kMaxXmlBytes, result.diagnostics);
  if (!bytes) return result;
  return ReadChecked(*std::move(bytes), file.string(), schema);
}

XmlFile ReadXmlText(std::string_view text, std::string_view name, std::string_view schema) {
  return ReadChecked(std::string(text), name, schema);
}

}  // namespace latchwork::config
