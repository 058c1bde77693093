// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/ompl/layers/job.h"
#include "reasoners/ompl/layers/traveller.h"

namespace latchwork::planning {
namespace {

class ItineraryJob final : public Job {
 public:
  ItineraryJob(const JobSetup& setup, logic::SymbolTable& symbols)
      : traveller_(setup, symbols),
        curr_landmark_(symbols.Intern("curr_landmark")),
        goal_(symbols.Intern("goal")),
        target_landmark_(symbols.Intern("target_landmark")) {}

  Verdict Decide(const LatchFacts& latches, Effort& effort) override {
    const logic::Fact* const place = latches.First({curr_landmark_, 1});
    const logic::Fact* const goal = latches.First({goal_, 1});
    if (place == nullptr || goal == nullptr) return {};
    const logic::Symbol here = place->argument(0).symbol();
    const logic::Symbol target = goal->argument(0).symbol();
    for (const logic::Symbol landmark : {here, target}) {
      std::string message = traveller_.Unknown(landmark);
      if (!message.empty()) return {FoundPath::State::kNone, {}, std::move(message)};
    }
    const Outlook outlook = traveller_.Look(latches, here, target, effort);
    if (outlook.state != FoundPath::State::kFound) return {outlook.state, {}, {}};
    return {
        outlook.state, {logic::Fact(target_landmark_, {logic::Term::Constant(outlook.next)})}, {}};
  }

 private:
  Traveller traveller_;
  logic::Symbol curr_landmark_, goal_, target_landmark_;
};

}  // namespace

std::unique_ptr<Job> MakeItineraryJob(const JobSetup& setup, logic::SymbolTable& symbols) {
  return std::make_unique<ItineraryJob>(setup, symbols);
}

}  // namespace latchwork::planning
