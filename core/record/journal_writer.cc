// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/record/journal_writer.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

#include "core/logic/fingerprint.h"
#include "core/record/frame.h"
#include "core/record/header_json.h"
#include "core/record/tick_encoder.h"

namespace latchwork::record {

class JournalWriter::Implementation {
 public:
  Implementation(const std::filesystem::path& file, const JournalHeader& header,
                 const schedule::Agent& agent)
      : name_(file.string()), encoder_(agent), file_(std::fopen(file.c_str(), "wb"), std::fclose) {
    if (file_ == nullptr) {
      Fail("cannot make");
      return;
    }
    // Frames are handed over whole; a second buffer would only delay them.
    std::setvbuf(file_.get(), nullptr, _IONBF, 0);
    const std::string json = HeaderToJson(header);
    Write(json, logic::Fingerprint(json));
  }

  void Tick(const schedule::TickRecord& record) {
    if (problem_.empty()) WriteChained(encoder_.Encode(record));
  }
  void End(const schedule::RunResult& result) {
    if (problem_.empty()) WriteChained(encoder_.EncodeEnd(result));
  }
  const std::string& problem() const { return problem_; }

 private:
  void WriteChained(const std::string& json) {
    chain_ = logic::Fingerprint(json, chain_);
    Write(json, chain_);
  }

  void Write(const std::string& json, std::uint64_t hash) {
    if (json.size() > kMaxFrameBytes) {
      problem_ = fmt::format("the journal {} stops: a tick takes more than {} bytes", name_,
                             kMaxFrameBytes);
      return;
    }
    frame_.clear();
    AppendFrame(json, hash, frame_);
    if (std::fwrite(frame_.data(), 1, frame_.size(), file_.get()) != frame_.size()) {
      Fail("cannot write");
    }
  }

  void Fail(const char* what) {
    const std::error_code reason(errno, std::generic_category());
    problem_ = fmt::format("{} the journal {}: {}", what, name_, reason.message());
  }

  std::string name_;
  std::string problem_;
  TickEncoder encoder_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  std::uint64_t chain_ = logic::kFingerprintStart;
  std::string frame_;
};

JournalWriter::JournalWriter(const std::filesystem::path& file, const JournalHeader& header,
                             const schedule::Agent& agent)
    : implementation_(std::make_unique<Implementation>(file, header, agent)) {}
JournalWriter::~JournalWriter() = default;

bool JournalWriter::OnTick(const schedule::TickRecord& record) {
  implementation_->Tick(record);
  return true;
}

void JournalWriter::OnEnd(const schedule::RunResult& result) { implementation_->End(result); }

const std::string& JournalWriter::problem() const { return implementation_->problem(); }

}  // namespace latchwork::record
