// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PLUGIN_REGISTRY_H_
#define LATCHWORK_PLUGIN_REGISTRY_H_

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/plugin/plugin_search.h"
#include "latchwork/sdk/layer.h"
#include "latchwork/sdk/plugin.h"
#include "latchwork/sdk/reasoner.h"
#include "latchwork/sdk/world.h"

namespace latchwork::plugin {

/// A file *.so of the search path, as far as it can be known without running any of it.
struct PluginEntry {
  std::filesystem::path file;
  std::optional<sdk::PluginInfo>
      info;  ///< Only when its fields can be trusted to mean what they say.
  std::string
      name;  ///< That of the record, whatever the file is called; without a record the file's stem.
  std::string version;
  std::string summary;
  std::string
      problem;  ///< Why it cannot be used, in words; empty when nothing is known against it.
};

enum class MakeFailure : std::uint8_t {
  kNone,
  kUnknownName,  ///< No plugin of that kind and name in the search path.
  kUnusable,     ///< There is one, but it cannot be loaded; or there are several.
};

/// An object of a plugin, or why there is none: one line with the file, the reason and the folders
/// that were searched. The plugin stays loaded as long as the object lives. What the object hands
/// out (attachments of a body, spans) may need it too, so keep the object until those are gone.
template <typename Base>
struct Made {
  std::shared_ptr<Base> object;
  MakeFailure failure = MakeFailure::kNone;
  std::string error;
};

/// The plugins of a search path. The folders are searched once, when the registry is made; no code
/// of a plugin runs before it is asked for an object. A kind and name that two files of the search
/// path claim is refused: which one is meant, nobody can tell from an agent file. Thread rule: all
/// members may be called from any thread.
class Registry {
 public:
  explicit Registry(const std::vector<std::filesystem::path>& search_path);

  /// All *.so, also those that cannot be used, in the order of the search path, then by file name.
  const std::vector<PluginEntry>& List() const { return plugins_; }
  const std::vector<SearchedFolder>& folders() const { return folders_; }
  /// The names that Make* knows and has nothing against, sorted.
  std::vector<std::string> Names(sdk::PluginKind kind) const;

  Made<sdk::Layer> MakeLayer(std::string_view name) const;
  Made<sdk::Reasoner> MakeReasoner(std::string_view name) const;
  Made<sdk::World> MakeWorld(std::string_view name) const;

  /// The folder with the plugin's own files: <name>/ beside the library, whether it exists or not;
  /// empty when there is no (or more than one) plugin of that name.
  std::filesystem::path DataFolder(sdk::PluginKind kind, std::string_view name) const;
  /// Of the bytes of the library, 16 hexadecimal digits (FNV-1a, 64 bits); empty when they cannot
  /// be read.
  std::string Fingerprint(sdk::PluginKind kind, std::string_view name) const;
  /// "/a, /b (No such file or directory)": for messages.
  std::string SearchedText() const;

 private:
  std::vector<const PluginEntry*> Candidates(sdk::PluginKind kind, std::string_view name) const;
  template <typename Base>
  Made<Base> Make(sdk::PluginKind kind, std::string_view name) const;

  std::vector<SearchedFolder> folders_;
  std::vector<PluginEntry> plugins_;
};

/// "layer", "reasoner", "world".
std::string_view Name(sdk::PluginKind kind);

}  // namespace latchwork::plugin

#endif  // LATCHWORK_PLUGIN_REGISTRY_H_
