// SPDX-License-Identifier: BSD-3-Clause
#include "core/config/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <utility>

#include "core/logic/fingerprint.h"
#include "latchwork/config/agent.h"

namespace latchwork::config {
namespace {

constexpr std::string_view kFormat = "1";
constexpr std::array<std::string_view, 6> kKnown = {"world", "layer",   "override",
                                                    "wire",  "inhibit", "event"};

class DocumentReader {
 public:
  Document Read(const std::filesystem::path& file,
                const std::vector<std::filesystem::path>& fragments) {
    Enter(file, file.filename().string(), {}, "agent");
    for (const std::filesystem::path& fragment : fragments) {
      Enter(fragment, fragment.filename().string(), {}, "fragment");
    }
    document_.fingerprint = fmt::format("{:016x}", fingerprint_);
    return std::move(document_);
  }

 private:
  struct Entered {
    std::filesystem::path path;
    logic::SourcePlace place;
    bool open = true;
  };

  void Say(const logic::SourcePlace& place, std::string message, std::string hint = "") {
    document_.diagnostics.push_back({place, std::move(message), std::move(hint), ""});
  }

  /// With its length, so that the border between two texts counts.
  void AddToFingerprint(std::string_view text) {
    fingerprint_ = logic::Fingerprint(fmt::format("{}:", text.size()), fingerprint_);
    fingerprint_ = logic::Fingerprint(text, fingerprint_);
  }

  void Enter(const std::filesystem::path& file, const std::string& name,
             const logic::SourcePlace& included_at, std::string_view root) {
    XmlFile xml = ReadXml(file, AgentSchema());
    AddToFingerprint(name);
    AddToFingerprint(xml.bytes);
    document_.sources.push_back({file.string(), std::move(xml.bytes)});
    document_.is_whole = document_.is_whole && xml.complete;
    document_.has_reader = document_.has_reader && xml.has_reader;
    if (CheckFormat(xml) && CheckRoot(xml, root)) {
      const std::size_t index = entered_.size();
      entered_.push_back({Canonical(file), included_at, true});
      ++depth_;
      Splice(xml.root, file);
      --depth_;
      entered_[index].open = false;
    }
  }

  static std::filesystem::path Canonical(const std::filesystem::path& file) {
    std::error_code error;
    std::filesystem::path path = std::filesystem::weakly_canonical(file, error);
    return error ? file : path;
  }

  /// A file of another format is not judged by the schema of this one.
  bool CheckFormat(XmlFile& xml) {
    const Attribute* format = xml.root.Find("format");
    if (format != nullptr && format->value != kFormat) {
      Say(format->place, fmt::format("format '{}' is not known", format->value),
          fmt::format("this build of latchwork reads format {}", kFormat));
      document_.is_whole = false;
      return false;
    }
    for (auto& diagnostic : xml.diagnostics) document_.diagnostics.push_back(std::move(diagnostic));
    return true;
  }

  bool CheckRoot(const XmlFile& xml, std::string_view root) {
    const bool is_wrong_one =
        xml.root.name != root && (xml.root.name == "agent" || xml.root.name == "fragment");
    if (is_wrong_one && root == "agent") {
      Say(xml.root.place, "this is a fragment, which is only there to be included",
          "give the agent file that includes it");
    } else if (is_wrong_one) {
      Say(xml.root.place, "an included file is a <fragment>, this is an <agent>");
    }
    if (xml.root.name != root) document_.is_whole = false;
    return xml.root.name == root;
  }

  void Splice(Element& root, const std::filesystem::path& file) {
    std::vector<Element> children = std::exchange(root.children, {});
    if (root.name == "agent") {
      document_.root = std::move(root);
      document_.is_agent = true;
    }
    for (Element& child : children) {
      if (child.name == "include") {
        Include(child, file);
      } else if (std::ranges::find(kKnown, child.name) != kKnown.end()) {
        document_.elements.push_back(std::move(child));
      } else {
        document_.is_whole = false;
      }
    }
  }

  void Include(const Element& element, const std::filesystem::path& from) {
    const Attribute* name = element.Find("file");
    if (name == nullptr || name->value.empty() || !MayEnter(*name, from)) {
      document_.is_whole = false;
      return;
    }
    const std::filesystem::path file = (from.parent_path() / name->value).lexically_normal();
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) {
      document_.is_whole = false;
      Say(name->place, fmt::format("the included file '{}' cannot be read", file.string()),
          std::filesystem::exists(file, error) ? "it is not a regular file"
                                               : "there is no such file");
      return;
    }
    Enter(file, name->value, name->place, "fragment");
  }

  bool MayEnter(const Attribute& name, const std::filesystem::path& from) {
    const std::filesystem::path path = Canonical(from.parent_path() / name.value);
    const auto before = std::ranges::find(entered_, path, &Entered::path);
    if (before != entered_.end() && before->open) {
      Say(name.place, fmt::format("'{}' includes itself", path.filename().string()));
      return false;
    }
    if (before != entered_.end()) {
      Say(name.place, fmt::format("'{}' is included twice", path.filename().string()),
          fmt::format("first at {}:{}", before->place.file, before->place.line));
      return false;
    }
    if (depth_ >= kMaxIncludeDepth) {
      Say(name.place, fmt::format("includes are nested more than {} deep", kMaxIncludeDepth));
      return false;
    }
    return true;
  }

  Document document_;
  std::uint64_t fingerprint_ = logic::kFingerprintStart;
  std::vector<Entered> entered_;
  std::size_t depth_ = 0;
};

}  // namespace

Document ReadDocument(const std::filesystem::path& file,
                      const std::vector<std::filesystem::path>& fragments) {
  return DocumentReader().Read(file, fragments);
}

}  // namespace latchwork::config
