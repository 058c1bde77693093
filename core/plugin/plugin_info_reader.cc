// SPDX-License-Identifier: BSD-3-Clause
#include "core/plugin/plugin_info_reader.h"

#include <elf.h>
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <functional>
#include <string_view>
#include <system_error>
#include <vector>

namespace latchwork::plugin {
namespace {

constexpr std::string_view kSection = ".latchwork";
constexpr std::uint64_t kMaxNames = 1U << 20U;  // bytes of section names; real files have hundreds
constexpr std::size_t kMinRecord = offsetof(sdk::PluginInfo, kind);
#if defined(__x86_64__)
constexpr Elf64_Half kMachine = EM_X86_64;
#elif defined(__aarch64__)
constexpr Elf64_Half kMachine = EM_AARCH64;
#elif defined(__riscv)
constexpr Elf64_Half kMachine = EM_RISCV;
#else
#error "the ELF machine number of this processor is missing here"
#endif
static_assert(std::endian::native == std::endian::little);

/// The bytes of a file or of a memory image.
struct Source {
  std::uint64_t size = 0;
  std::function<bool(std::uint64_t offset, std::span<std::byte> bytes)> read;

  bool Holds(std::uint64_t offset, std::uint64_t count) const {
    return offset <= size && count <= size - offset;
  }
  template <typename T, std::size_t kCount>
  bool Read(std::uint64_t offset, std::span<T, kCount> values) const {
    return Holds(offset, values.size_bytes()) && read(offset, std::as_writable_bytes(values));
  }
};

PluginInfoReading Problem(std::string problem) { return {std::nullopt, std::move(problem)}; }

/// What keeps this header from being that of a shared library of this machine; empty when it is.
std::string CheckHeader(const Elf64_Ehdr& header) {
  if (header.e_ident[EI_CLASS] != ELFCLASS64) return "is not a 64-bit library";
  if (header.e_ident[EI_DATA] != ELFDATA2LSB) return "is big-endian, this machine is little-endian";
  if (header.e_machine != kMachine) {
    return fmt::format("is built for another machine (ELF machine {}, this is {})",
                       header.e_machine, kMachine);
  }
  if (header.e_type != ET_DYN) {
    return fmt::format("is no shared library (ELF type {})", header.e_type);
  }
  if (header.e_shnum == 0) return "has no section table, so its plugin record cannot be found";
  if (header.e_shentsize != sizeof(Elf64_Shdr)) {
    return fmt::format("is damaged: a section header of {} bytes", header.e_shentsize);
  }
  if (header.e_shstrndx >= header.e_shnum) return "is damaged: its section names are missing";
  return {};
}

std::string_view NameAt(const std::vector<char>& names, std::uint64_t offset) {
  if (offset >= names.size()) return {};
  const std::string_view rest(names.data() + offset, names.size() - offset);
  return rest.substr(0, rest.find('\0'));
}

PluginInfoReading ReadRecord(const Source& source, const Elf64_Shdr& section) {
  sdk::PluginInfo info{};
  std::array<std::byte, sizeof(info)> bytes{};
  const std::size_t count = std::min<std::uint64_t>(section.sh_size, bytes.size());
  if (section.sh_type != SHT_PROGBITS || count < kMinRecord) {
    return Problem("is damaged: its section .latchwork holds no plugin record");
  }
  if (!source.Read(section.sh_offset, std::span(bytes).first(count))) {
    return Problem("is truncated: its plugin record lies beyond its end");
  }
  std::memcpy(&info, bytes.data(), bytes.size());
  return {info, {}};
}

PluginInfoReading ReadSections(const Source& source, const Elf64_Ehdr& header) {
  std::vector<Elf64_Shdr> sections(header.e_shnum);
  if (!source.Read(header.e_shoff, std::span(sections))) {
    return Problem("is truncated: its section table lies beyond its end");
  }
  const Elf64_Shdr& names_section = sections[header.e_shstrndx];
  if (names_section.sh_size > kMaxNames) {
    return Problem("is damaged: its section names are too long");
  }
  std::vector<char> names(names_section.sh_size);
  if (!source.Read(names_section.sh_offset, std::span(names))) {
    return Problem("is truncated: its section names lie beyond its end");
  }
  const auto found = std::find_if(sections.begin(), sections.end(), [&](const Elf64_Shdr& section) {
    return NameAt(names, section.sh_name) == kSection;
  });
  if (found == sections.end()) {
    return Problem("holds no plugin record: it was not made with LATCHWORK_PLUGIN");
  }
  return ReadRecord(source, *found);
}

PluginInfoReading ReadElf(const Source& source) {
  if (source.size == 0) return Problem("is empty");
  std::array<char, SELFMAG> magic{};
  if (!source.Read(0, std::span(magic)) || std::memcmp(magic.data(), ELFMAG, SELFMAG) != 0) {
    return Problem("is no shared library (it does not begin like an ELF file)");
  }
  std::array<Elf64_Ehdr, 1> header{};
  if (!source.Read(0, std::span(header))) return Problem("is truncated: its header is incomplete");
  std::string problem = CheckHeader(header[0]);
  return problem.empty() ? ReadSections(source, header[0]) : Problem(std::move(problem));
}

std::string CannotBeRead(const std::error_code& error) {
  return "cannot be read: " + error.message();
}

}  // namespace

PluginInfoReading ReadPluginInfo(std::span<const std::byte> image) {
  return ReadElf({image.size(), [image](std::uint64_t offset, std::span<std::byte> bytes) {
                    std::ranges::copy(image.subspan(offset, bytes.size()), bytes.begin());
                    return true;
                  }});
}

PluginInfoReading ReadPluginInfo(const std::filesystem::path& file) {
  // Asked before the file is opened: opening a pipe would wait for its writer.
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) {
    const std::error_code missing = std::make_error_code(std::errc::no_such_file_or_directory);
    return Problem(CannotBeRead(error ? error : missing));
  }
  if (std::filesystem::is_directory(status)) return Problem("is a directory, not a shared library");
  if (!std::filesystem::is_regular_file(status)) return Problem("is not a regular file");
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) return Problem(CannotBeRead(error));
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return Problem(CannotBeRead({errno, std::generic_category()}));
  return ReadElf({size, [&stream](std::uint64_t offset, std::span<std::byte> bytes) {
                    stream.seekg(static_cast<std::streamoff>(offset));
                    stream.read(reinterpret_cast<char*>(bytes.data()),
                                static_cast<std::streamsize>(bytes.size()));
                    return stream.good();
                  }});
}

std::string TextOf(std::span<const char> text) {
  std::string result(text.begin(), std::find(text.begin(), text.end(), '\0'));
  std::replace_if(
      result.begin(), result.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return result;
}

}  // namespace latchwork::plugin
