// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SDK_PLUGIN_H_
#define LATCHWORK_SDK_PLUGIN_H_

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include "latchwork/sdk/layer.h"
#include "latchwork/sdk/reasoner.h"
#include "latchwork/sdk/world.h"

namespace latchwork::sdk {

/// Raised with every change of a header in sdk/ or logic/ that old plugins would not survive.
inline constexpr std::uint32_t kAbi = 4;
inline constexpr std::uint32_t kPluginMagic = 0x4c57504cU;  // "LPWL" in memory

enum class PluginKind : std::uint32_t { kLayer = 1, kReasoner = 2, kWorld = 3 };

/// What a plugin is and how it was built. Plain bytes without pointers, in a section of its own, so
/// that a host can read it from the file and refuse a plugin before any of its code runs. Texts end
/// with a zero byte.
struct PluginInfo {
  std::uint32_t magic;
  std::uint32_t size;  ///< sizeof(PluginInfo)
  std::uint32_t abi;
  PluginKind kind;
  std::uint64_t cxx;  ///< __cplusplus
  std::array<char, 64> compiler;
  std::array<char, 32> stdlib;
  std::array<char, 32> sanitizers;
  std::array<char, 64> name;
  std::array<char, 32> version;
  std::array<char, 160> summary;
};
static_assert(std::is_trivially_copyable_v<PluginInfo> && std::is_standard_layout_v<PluginInfo>);

template <std::size_t kSize>
constexpr std::array<char, kSize> FixedText(std::string_view text) {
  std::array<char, kSize> result{};
  std::copy_n(text.begin(), std::min(text.size(), kSize - 1), result.begin());
  return result;
}

// gcc tells of its sanitizers by macros, clang by features.
#if defined(__has_feature)
#define LATCHWORK_HAS_FEATURE(feature) __has_feature(feature)
#else
#define LATCHWORK_HAS_FEATURE(feature) 0
#endif
#if defined(__SANITIZE_ADDRESS__) || LATCHWORK_HAS_FEATURE(address_sanitizer)
inline constexpr std::string_view kSanitizers = "address";
#elif defined(__SANITIZE_THREAD__) || LATCHWORK_HAS_FEATURE(thread_sanitizer)
inline constexpr std::string_view kSanitizers = "thread";
#else
inline constexpr std::string_view kSanitizers = "none";
#endif
#undef LATCHWORK_HAS_FEATURE

#if defined(_GLIBCXX_USE_CXX11_ABI) && _GLIBCXX_USE_CXX11_ABI
inline constexpr std::string_view kStandardLibrary = "libstdc++ cxx11";
#elif defined(__GLIBCXX__)
inline constexpr std::string_view kStandardLibrary = "libstdc++ old";
#else
inline constexpr std::string_view kStandardLibrary = "other";
#endif

#if defined(__clang__)
#define LATCHWORK_COMPILER "clang " __clang_version__
#else
#define LATCHWORK_COMPILER "gcc " __VERSION__
#endif

constexpr PluginInfo MakePluginInfo(PluginKind kind, std::string_view name,
                                    std::string_view version, std::string_view summary) {
  return {kPluginMagic,
          static_cast<std::uint32_t>(sizeof(PluginInfo)),
          kAbi,
          kind,
          static_cast<std::uint64_t>(__cplusplus),
          FixedText<64>(LATCHWORK_COMPILER),
          FixedText<32>(kStandardLibrary),
          FixedText<32>(kSanitizers),
          FixedText<64>(name),
          FixedText<32>(version),
          FixedText<160>(summary)};
}

/// The base class of a kind, for LATCHWORK_PLUGIN.
template <typename Class>
constexpr PluginKind KindOf() {
  if constexpr (std::is_base_of_v<Layer, Class>) {
    return PluginKind::kLayer;
  } else if constexpr (std::is_base_of_v<Reasoner, Class>) {
    return PluginKind::kReasoner;
  } else {
    static_assert(std::is_base_of_v<World, Class>, "a plugin is a Layer, a Reasoner or a World");
    return PluginKind::kWorld;
  }
}
template <typename Class>
using PluginBase =
    std::conditional_t<std::is_base_of_v<Layer, Class>, Layer,
                       std::conditional_t<std::is_base_of_v<Reasoner, Class>, Reasoner, World>>;

}  // namespace latchwork::sdk

/// Exports `Class` (default constructible, derived from Layer, Reasoner or World) as a plugin. Once
/// in each shared library, outside any namespace. Three C symbols are exported: the record, a
/// create and a destroy function.
///
///   LATCHWORK_PLUGIN(my::Corridor, "corridor", "1.0", "keeps to the right of a corridor")
#define LATCHWORK_PLUGIN(Class, Name, Version, Summary)                                            \
  extern "C" {                                                                                     \
  __attribute__((                                                                                  \
      visibility("default"))) extern const ::latchwork::sdk::PluginInfo latchwork_plugin_info;     \
  __attribute__((used, section(".latchwork")))                                                     \
  const ::latchwork::sdk::PluginInfo latchwork_plugin_info =                                       \
      ::latchwork::sdk::MakePluginInfo(::latchwork::sdk::KindOf<Class>(), Name, Version, Summary); \
  __attribute__((visibility("default"))) void* latchwork_plugin_create() noexcept {                \
    try {                                                                                          \
      return static_cast<::latchwork::sdk::PluginBase<Class>*>(new Class());                       \
    } catch (...) {                                                                                \
      return nullptr;                                                                              \
    }                                                                                              \
  }                                                                                                \
  __attribute__((visibility("default"))) void latchwork_plugin_destroy(void* object) noexcept {    \
    delete static_cast<::latchwork::sdk::PluginBase<Class>*>(object);                              \
  }                                                                                                \
  }

#endif  // LATCHWORK_SDK_PLUGIN_H_
