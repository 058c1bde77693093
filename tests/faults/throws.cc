// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>

#include "tests/faults/fault_reasoner.h"

namespace latchwork::faults {
namespace {

/// Throws in Decide: a std::runtime_error, or an int, which no handler for std::exception catches.
class Throws : public FaultReasoner {
 public:
  Throws()
      : FaultReasoner({{"thrown",
                        sdk::ParameterType::kText,
                        "exception",
                        0,
                        0,
                        "",
                        "what is thrown",
                        {"exception", "int"}}}) {}

 protected:
  void Configure(const sdk::Parameters& parameters) override {
    throws_int_ = parameters.Text("thrown") == "int";
  }
  void DecideFaultily(const sdk::Budget& budget, sdk::Decision& decision) override {
    static_cast<void>(budget), static_cast<void>(decision);
    if (throws_int_) throw 42;
    throw std::runtime_error("thrown on purpose");
  }

 private:
  bool throws_int_ = false;
};

}  // namespace
}  // namespace latchwork::faults

LATCHWORK_PLUGIN(latchwork::faults::Throws, "throws", "1.0", "throws in Decide")
