// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_ARENA_H_
#define LATCHWORK_PTTP_ARENA_H_

#include <cstddef>
#include <new>
#include <type_traits>
#include <vector>

#include "reasoners/pttp/terms/word.h"

namespace latchwork::pttp {

/// Memory that grows at one end, shrinks to marks and never moves. What was once obtained from the
/// system is kept, so a cycle like the one before allocates nothing.
class Arena {
 public:
  struct Mark {
    std::size_t chunk = 0;
    Word* top = nullptr;  ///< Null: the beginning.
  };

  Word* Allocate(std::size_t words) {
    if (words < static_cast<std::size_t>(limit_ - top_)) {
      Word* result = top_;
      top_ += words;
      return result;
    }
    return AllocateInNextChunk(words);
  }

  /// An object that is forgotten, not destroyed.
  template <typename Object>
  Object* Make(const Object& value) {
    static_assert(std::is_trivially_destructible_v<Object> && alignof(Object) <= alignof(Word));
    void* memory = Allocate((sizeof(Object) + sizeof(Word) - 1) / sizeof(Word));
    return new (memory) Object(value);
  }

  Mark mark() const { return {chunk_, top_}; }
  void Release(Mark mark) {
    if (mark.chunk == chunk_ && mark.top != nullptr) {
      top_ = mark.top;
    } else {
      ReleaseChunks(mark);
    }
  }
  void Clear() { Release({}); }
  std::size_t reserved_words() const { return reserved_; }

 private:
  static constexpr std::size_t kFirstChunk = std::size_t{1} << 10U;
  static constexpr std::size_t kLargestChunk = std::size_t{1} << 18U;

  Word* AllocateInNextChunk(std::size_t words);
  void ReleaseChunks(Mark mark);

  std::vector<std::vector<Word>> chunks_;
  std::size_t chunk_ = 0;
  Word* top_ = nullptr;    ///< In the chunk.
  Word* limit_ = nullptr;  ///< Its end.
  std::size_t reserved_ = 0;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_ARENA_H_
