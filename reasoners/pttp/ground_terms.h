// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_GROUND_TERMS_H_
#define LATCHWORK_PTTP_GROUND_TERMS_H_

#include "reasoners/pttp/arena.h"
#include "reasoners/pttp/word.h"

namespace latchwork::pttp {

/// A copy of a term in another arena; its unbound variables stay where they are.
Word CopyTerm(Word word, Arena& arena);

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_GROUND_TERMS_H_
