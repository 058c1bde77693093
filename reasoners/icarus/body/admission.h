// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_ADMISSION_H_
#define LATCHWORK_ICARUS_ADMISSION_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "latchwork/sdk/reasoner.h"
#include "reasoners/icarus/body/attachment_host.h"
#include "reasoners/icarus/body/latch_facts.h"
#include "reasoners/icarus/machine/interpreter.h"

namespace latchwork::icarus {

/// Which facts a program lets into its latches: not those with which something becomes True that
/// it says is never to be. Asked in a memory of its own, of the program's initial facts, the
/// parameters and the latches; what the program noted in its cycles is not in it.
class Admission {
 public:
  /// All but `options` are kept. `program` has no errors.
  Admission(const sdk::Body& body, TermBridge& bridge, NamePool& names, const Program& program,
            RunOptions options);

  /// What the host lacks, of what is never to be.
  const Findings& findings() const { return findings_; }
  /// As sdk::Reasoner::Admit.
  void Admit(std::span<const sdk::Latch> latches, std::size_t port,
             std::span<const logic::Fact> batch, const sdk::Budget& budget,
             std::vector<sdk::Refusal>& refused);

 private:
  /// Something that is never to be.
  struct Never {
    std::size_t top = 0;
    std::size_t known = 0;  ///< In how many ways it is True all the same.
    std::string reason;
  };

  void SetLatches(std::span<const sdk::Latch> latches, std::size_t port);
  std::size_t Count(const Never& never);
  const Never* FirstNew();

  TermBridge& bridge_;
  AttachmentHost host_;
  Interpreter interpreter_;
  Findings findings_;
  std::vector<Never> nevers_;
  std::vector<std::size_t> counts_;
  LatchFacts parameters_;
  std::vector<LatchFacts> latch_facts_;
  std::vector<std::uint64_t> versions_;
  std::vector<logic::Fact> admitted_;
  CycleLimits limits_;
};

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_ADMISSION_H_
