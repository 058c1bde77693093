// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_REASONERS_CIRCUMSCRIPTION_CIRCUMSCRIBING_MIND_H_
#define LATCHWORK_TESTS_REASONERS_CIRCUMSCRIPTION_CIRCUMSCRIBING_MIND_H_

#include "reasoners/circumscription/circumscription_reasoner.h"
#include "tests/reasoners/pttp/agent_mind.h"

namespace latchwork::circumscription {

using CircumscribingMind = pttp::MindOf<CircumscriptionReasoner>;

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_TESTS_REASONERS_CIRCUMSCRIPTION_CIRCUMSCRIBING_MIND_H_
