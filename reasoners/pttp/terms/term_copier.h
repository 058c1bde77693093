// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_TERM_COPIER_H_
#define LATCHWORK_PTTP_TERM_COPIER_H_

#include <vector>

#include "reasoners/pttp/terms/arena.h"
#include "reasoners/pttp/terms/word.h"

namespace latchwork::pttp {

/// Copies terms into an arena where they last. Unbound variables stay where they are. Allocates
/// nothing but the copies once it has seen terms of that depth.
class TermCopier {
 public:
  Word Copy(Word word, Arena& arena) {
    word = Dereference(word);
    if (TagOf(word) == Tag::kCompound) return CopyCompound(word, arena);
    return CopyAtomic(word, arena);
  }

 private:
  struct Task {
    const Word* from;
    Word* to;
  };

  static Word CopyAtomic(Word word, Arena& arena);
  Word CopyCompound(Word word, Arena& arena);

  std::vector<Task> tasks_;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_TERM_COPIER_H_
