// SPDX-License-Identifier: BSD-3-Clause
#include "core/plugin/library.h"

#include <boost/dll/shared_library.hpp>
#include <cstring>
#include <exception>
#include <string_view>
#include <utility>

namespace latchwork::plugin {
namespace {

using SharedLibrary = std::shared_ptr<boost::dll::shared_library>;

/// Destroys an object of the plugin; the library goes with this, after the object.
struct Destroyer {
  SharedLibrary library;
  void (*destroy)(void*);
  void operator()(void* object) const { destroy(object); }
};

/// Boost wraps what dlerror said: "load() failed (dlerror system message: …): Bad file descriptor".
/// The part after it is an error code that means nothing.
std::string LoaderText(std::string_view what) {
  constexpr std::string_view kBegin = "(dlerror system message: ";
  const std::size_t begin = what.find(kBegin);
  const std::size_t end = what.rfind("): ");
  if (begin == std::string_view::npos || end == std::string_view::npos || end < begin) {
    return std::string(what);
  }
  return std::string(what.substr(begin + kBegin.size(), end - begin - kBegin.size()));
}

MadeObject MakeFrom(SharedLibrary library, const sdk::PluginInfo& expected) {
  const auto& info = library->get<const sdk::PluginInfo>("latchwork_plugin_info");
  if (std::memcmp(&info, &expected, sizeof(info)) != 0) {
    return {nullptr, "its plugin record in memory is not the one in its file"};
  }
  void* (*const create)() = &library->get<void*()>("latchwork_plugin_create");
  void (*const destroy)(void*) = &library->get<void(void*)>("latchwork_plugin_destroy");
  void* const object = create();
  if (object == nullptr) {
    return {nullptr,
            "it made no object: latchwork_plugin_create gave null (its constructor threw)"};
  }
  return {std::shared_ptr<void>(object, Destroyer{std::move(library), destroy}), {}};
}

}  // namespace

MadeObject MakeObject(const std::filesystem::path& file, const sdk::PluginInfo& expected) {
  using boost::dll::load_mode::rtld_local;
  using boost::dll::load_mode::rtld_now;
  try {
    // With lazy binding a missing symbol would end the process at its first call.
    return MakeFrom(std::make_shared<boost::dll::shared_library>(file, rtld_now | rtld_local),
                    expected);
  } catch (const std::exception& error) {
    return {nullptr, LoaderText(error.what())};
  }
}

}  // namespace latchwork::plugin
