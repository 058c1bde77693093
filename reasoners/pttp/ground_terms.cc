// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/ground_terms.h"

#include <vector>

namespace latchwork::pttp {

Word CopyTerm(Word word, Arena& arena) {
  struct Task {
    Word from;
    Word* to;
  };
  Word result = 0;
  std::vector<Task> tasks = {{word, &result}};
  while (!tasks.empty()) {
    const Task task = tasks.back();
    tasks.pop_back();
    const Word from = Dereference(task.from);
    *task.to = from;
    if (IsNumber(from)) {
      Word* box = arena.Allocate(1);
      *box = *AddressOf(from);
      *task.to = Tagged(TagOf(from), box);
    } else if (TagOf(from) == Tag::kCompound) {
      const Word* block = AddressOf(from);
      const std::size_t arity = ArityOf(block[0]);
      Word* copy = arena.Allocate(arity + 1);
      copy[0] = block[0];
      *task.to = Tagged(Tag::kCompound, copy);
      for (std::size_t i = arity; i > 0; --i) tasks.push_back({block[i], copy + i});
    }
  }
  return result;
}

}  // namespace latchwork::pttp
