// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_EXPLANATION_H_
#define LATCHWORK_ICARUS_EXPLANATION_H_

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "latchwork/sdk/decision.h"
#include "reasoners/icarus/body/term_bridge.h"
#include "reasoners/icarus/language/program.h"
#include "reasoners/icarus/machine/event.h"
#include "reasoners/icarus/machine/interpreter.h"

namespace latchwork::icarus {

/// Follows a cycle up to the act that was chosen, and tells how it came about: the skills from the
/// top to the action, and before each the facts, answers and True skills that led on from it.
class Explanation final : public EventSink {
 public:
  /// `wanted`: a call of the act, which `conclusion` stands for.
  Explanation(const Program& program, TermBridge& bridge, const NamePool& names,
              const ActCall& wanted, std::string conclusion);

  void OnEvent(const Event& event) override;
  /// Empty when the cycle did not choose such an act.
  sdk::Derivation Take() { return std::move(chosen_); }

 private:
  using Kind = sdk::DerivationStep::Kind;

  /// What was found True in a call of a skill.
  struct Found {
    FormId form = kNoForm;
    Kind kind = Kind::kClause;
    std::string text;
    std::string source;
    std::uint32_t call = 0;      ///< Of a skill that was True; 0: none.
    std::vector<Found> answers;  ///< Of the host, that it rests on.
  };
  struct Call {
    std::uint32_t in = 0;
    std::uint32_t skill = kNoSkill;
    FormId form = kNoForm;
    std::string text;
    std::vector<Found> found;
  };

  void AddCall(const Event& event);
  void AddFound(const Event& event, Kind kind, std::string text);
  void AddAnswer(const Event& event);
  bool IsWanted(const Act& act) const;
  sdk::Derivation Derive(std::uint32_t action);
  std::vector<std::size_t> AddSteps(const std::vector<Found>& found, sdk::Derivation& derivation,
                                    unsigned depth);
  std::size_t AddStep(Kind kind, std::string text, std::string source, FormId form,
                      std::vector<std::size_t> premises, sdk::Derivation& derivation) const;
  std::string ClauseText(const Event& event) const;
  std::string Text(const Term& term, std::span<const Value> frame) const;
  std::string Text(const Value& value) const;

  const Program& program_;
  TermBridge& bridge_;
  const NamePool& names_;
  const ActCall& wanted_;
  std::string conclusion_;
  std::map<std::uint32_t, Call> calls_;  ///< By the numbers of their events.
  std::vector<Found> answers_;           ///< Of the clause that is being asked.
  std::map<const Act*, sdk::Derivation> acts_;
  sdk::Derivation chosen_;
};

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_EXPLANATION_H_
