// SPDX-License-Identifier: BSD-3-Clause
#include "core/plugin/plugin_info_reader.h"

#include <elf.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstddef>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/core/plugin/plugin_folders.h"
#include "tests/temporary_folder.h"

namespace latchwork::plugin {
namespace {

using test::TemporaryFolder;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::string BytesOf(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

PluginInfoReading ReadText(std::string_view image) {
  return ReadPluginInfo(std::as_bytes(std::span(image)));
}

/// A real plugin whose ELF header was changed by `change`.
template <typename Change>
PluginInfoReading ReadChanged(Change change) {
  std::string image = BytesOf(kSamples / "plain.so");
  Elf64_Ehdr header{};
  std::memcpy(&header, image.data(), sizeof(header));
  change(header);
  std::memcpy(image.data(), &header, sizeof(header));
  return ReadText(image);
}

TEST(PluginInfoReaderTest, ReadsTheRecordOfAPlugin) {
  const PluginInfoReading reading = ReadPluginInfo(kSamples / "plain.so");
  ASSERT_TRUE(reading.info) << reading.problem;
  EXPECT_EQ(reading.info->magic, sdk::kPluginMagic);
  EXPECT_EQ(reading.info->kind, sdk::PluginKind::kReasoner);
  EXPECT_EQ(TextOf(reading.info->name), "sample");
  EXPECT_EQ(TextOf(reading.info->version), "1.2");
  EXPECT_EQ(TextOf(reading.info->summary), "does as it should");
}

TEST(PluginInfoReaderTest, ReadsTheRecordOfAStrippedPlugin) {
  const PluginInfoReading reading = ReadPluginInfo(kSamples / "stripped.so");
  ASSERT_TRUE(reading.info) << reading.problem;
  EXPECT_EQ(TextOf(reading.info->name), "sample");
}

TEST(PluginInfoReaderTest, NoPrefixOfAPluginIsAPlugin) {
  const std::string image = BytesOf(kSamples / "plain.so");
  ASSERT_TRUE(ReadText(image).info);
  const std::string_view whole = image;
  for (std::size_t size = 0; size < image.size(); size += (size < 128 ? 1 : 37)) {
    const PluginInfoReading reading = ReadText(whole.substr(0, size));
    ASSERT_FALSE(reading.info) << size;
    ASSERT_THAT(reading.problem, Not(IsEmpty())) << size;
  }
}

TEST(PluginInfoReaderTest, TruncatedFile_SaysSo) {
  const TemporaryFolder folder;
  const std::string image = BytesOf(kSamples / "plain.so");
  const std::string_view whole = image;
  const auto file = folder.Write("half.so", whole.substr(0, image.size() / 2));
  EXPECT_THAT(ReadPluginInfo(file).problem, HasSubstr("truncated"));
}

TEST(PluginInfoReaderTest, TextFile_IsNoSharedLibrary) {
  const TemporaryFolder folder;
  const auto file = folder.Write("text.so", "INPUT(libc.so.6)\n");
  EXPECT_THAT(ReadPluginInfo(file).problem, HasSubstr("does not begin like an ELF file"));
}

TEST(PluginInfoReaderTest, EmptyFile_SaysSo) {
  const TemporaryFolder folder;
  EXPECT_EQ(ReadPluginInfo(folder.Write("empty.so", "")).problem, "is empty");
}

TEST(PluginInfoReaderTest, LibraryWithoutRecord_IsNoPlugin) {
  const auto file = std::filesystem::path(LATCHWORK_BINARY_DIR) / "lib" / "liblatchwork.so";
  EXPECT_THAT(ReadPluginInfo(file).problem, HasSubstr("not made with LATCHWORK_PLUGIN"));
}

TEST(PluginInfoReaderTest, Directory_SaysSo) {
  const TemporaryFolder folder;
  EXPECT_THAT(ReadPluginInfo(folder.path()).problem, HasSubstr("is a directory"));
}

TEST(PluginInfoReaderTest, Pipe_IsNotWaitedFor) {
  const TemporaryFolder folder;
  const auto pipe = folder.path() / "pipe.so";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(ReadPluginInfo(pipe).problem, "is not a regular file");
}

TEST(PluginInfoReaderTest, DanglingLink_GivesTheSystemsReason) {
  const TemporaryFolder folder;
  const auto link = folder.path() / "link.so";
  std::filesystem::create_symlink("nowhere", link);
  EXPECT_EQ(ReadPluginInfo(link).problem, "cannot be read: No such file or directory");
}

/// Root may read everything, so it becomes somebody else for a while.
class NotAsRoot {
 public:
  NotAsRoot() : was_root_(geteuid() == 0) {
    if (was_root_) {
      EXPECT_EQ(seteuid(kNobody), 0);
    }
  }
  ~NotAsRoot() {
    if (was_root_) {
      EXPECT_EQ(seteuid(0), 0);
    }
  }
  NotAsRoot(const NotAsRoot&) = delete;
  NotAsRoot& operator=(const NotAsRoot&) = delete;

 private:
  static constexpr uid_t kNobody = 65534;
  bool was_root_;
};

TEST(PluginInfoReaderTest, UnreadableFile_GivesTheSystemsReason) {
  const TemporaryFolder folder;
  const auto file = folder.Copy(kSamples / "plain.so", "secret.so");
  std::filesystem::permissions(file, std::filesystem::perms::none);
  const NotAsRoot somebody;
  EXPECT_EQ(ReadPluginInfo(file).problem, "cannot be read: Permission denied");
}

TEST(PluginInfoReaderTest, ForeignHeaders_AreRefusedInWords) {
  EXPECT_EQ(ReadChanged([](Elf64_Ehdr& h) { h.e_ident[EI_CLASS] = ELFCLASS32; }).problem,
            "is not a 64-bit library");
  EXPECT_THAT(ReadChanged([](Elf64_Ehdr& h) { h.e_ident[EI_DATA] = ELFDATA2MSB; }).problem,
              HasSubstr("big-endian"));
  EXPECT_THAT(ReadChanged([](Elf64_Ehdr& h) { h.e_machine = EM_PPC64; }).problem,
              HasSubstr("another machine (ELF machine 21"));
  EXPECT_THAT(ReadChanged([](Elf64_Ehdr& h) { h.e_type = ET_REL; }).problem,
              HasSubstr("no shared library"));
}

TEST(PluginInfoReaderTest, DamagedHeaders_AreRefusedInWords) {
  EXPECT_THAT(ReadChanged([](Elf64_Ehdr& h) { h.e_shnum = 0; }).problem,
              HasSubstr("no section table"));
  EXPECT_THAT(ReadChanged([](Elf64_Ehdr& h) { h.e_shentsize = 40; }).problem,
              HasSubstr("section header of 40 bytes"));
  EXPECT_THAT(ReadChanged([](Elf64_Ehdr& h) { h.e_shstrndx = 0xffff; }).problem,
              HasSubstr("section names are missing"));
  EXPECT_THAT(ReadChanged([](Elf64_Ehdr& h) { h.e_shoff = ~0ULL; }).problem,
              HasSubstr("truncated"));
  EXPECT_THAT(ReadChanged([](Elf64_Ehdr& h) { h.e_shnum = 0xffff; }).problem,
              HasSubstr("truncated"));
}

TEST(PluginInfoReaderTest, TextOf_MasksControlCharacters) {
  const std::string text("a\x1b[2J\xff\0hidden", 13);
  EXPECT_EQ(TextOf(text), "a?[2J?");
}

}  // namespace
}  // namespace latchwork::plugin
