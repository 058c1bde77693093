// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>
#include <unordered_set>
#include <utility>

#include "core/logic/tptp_parser.h"
#include "core/logic/tptp_types.h"
#include "latchwork/logic/tptp.h"

namespace latchwork::logic {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kDeepestInclude = 64;
constexpr std::size_t kMostIncludes = 1000;

/// Reads a text and what it includes.
class Reader {
 public:
  Reader(SymbolTable& symbols, const TptpOptions& options) : symbols_(symbols), options_(options) {}

  TptpFile ReadText(std::string_view text, std::string_view name) {
    if (text.size() > options_.max_bytes) {
      result_.diagnostics.push_back({{std::string(name)}, TooLarge(), {}, {}});
    } else {
      Parse(text, name, {});
    }
    return Finished();
  }

  TptpFile ReadFile(const fs::path& file) {
    if (auto fault = Include(file)) {
      result_.diagnostics.push_back(
          {{file.string()}, std::move(fault->message), std::move(fault->hint), {}});
    }
    return Finished();
  }

 private:
  using Fault = std::optional<TptpIncludeFault>;

  TptpFile Finished() {
    const bool typed = std::any_of(types_.variables.begin(), types_.variables.end(),
                                   [](const auto& types) { return types.has_value(); });
    if (result_.diagnostics.empty() && typed) KeepTypes(result_, types_, symbols_);
    return std::move(result_);
  }

  std::string TooLarge() const {
    return "larger than the " + std::to_string(options_.max_bytes) + " bytes that may be read";
  }

  void Parse(std::string_view text, std::string_view name, const fs::path& folder) {
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
    TptpParser(text, name, symbols_, options_, result_, types_, [&](const TptpInclude& include) {
      return HandleInclude(include, folder);
    }).Read();
  }

  static bool IsReadable(const fs::path& file) {
    std::error_code error;
    return fs::is_regular_file(file, error);
  }

  Fault HandleInclude(const TptpInclude& include, const fs::path& folder) {
    fs::path file = folder / include.file;
    std::string tried = file.string();
    if (!IsReadable(file) && !options_.include_root.empty()) {
      file = options_.include_root / include.file;
      tried += " and " + file.string();
    }
    if (!IsReadable(file)) {
      return TptpIncludeFault{"included file '" + include.file + "' is not found",
                              "looked for " + tried};
    }
    const std::size_t before = result_.formulas.size();
    if (auto fault = Include(file)) {
      fault->message = "included file '" + include.file + "': " + fault->message;
      return fault;
    }
    return include.selection ? Select(*include.selection, before, include.file) : std::nullopt;
  }

  Fault Include(const fs::path& file) {
    std::error_code error;
    const fs::path canonical = fs::weakly_canonical(file, error);
    if (std::find(open_.begin(), open_.end(), canonical) != open_.end()) {
      return TptpIncludeFault{"it includes itself", "take one include of the circle away"};
    }
    if (open_.size() >= kDeepestInclude || ++included_ > kMostIncludes) {
      return TptpIncludeFault{"too many includes", "at most 1000, and 64 inside each other"};
    }
    std::string text;
    if (auto fault = Load(file, text)) return fault;
    open_.push_back(canonical);
    Parse(text, file.string(), file.parent_path());
    open_.pop_back();
    return std::nullopt;
  }

  Fault Load(const fs::path& file, std::string& text) {
    std::error_code error;
    if (!fs::exists(file, error)) return TptpIncludeFault{"no such file", {}};
    if (!IsReadable(file)) return TptpIncludeFault{"not a file", {}};
    const auto size = fs::file_size(file, error);
    if (!error && size > options_.max_bytes) return TptpIncludeFault{TooLarge(), {}};
    std::ifstream stream(file, std::ios::binary);
    text.resize(error ? 0 : static_cast<std::size_t>(size));
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (error || !stream) return TptpIncludeFault{"cannot be read", "check its permissions"};
    bytes_read_ += text.size();
    if (bytes_read_ / 4 > options_.max_bytes) {
      return TptpIncludeFault{"too many bytes are included altogether", {}};
    }
    return std::nullopt;
  }

  /// Of the formulas from `first` on, keeps those that are named.
  Fault Select(const std::vector<std::string>& names, std::size_t first, const std::string& file) {
    const std::unordered_set<std::string> wanted(names.begin(), names.end());
    std::unordered_set<std::string> seen;
    std::size_t kept = first;
    for (std::size_t i = first; i < result_.formulas.size(); ++i) {
      if (!wanted.contains(result_.formulas[i].name)) continue;
      seen.insert(result_.formulas[i].name);
      if (options_.keep_sources) std::swap(result_.sources[kept], result_.sources[i]);
      if (options_.keep_texts) std::swap(result_.texts[kept], result_.texts[i]);
      std::swap(types_.variables[kept], types_.variables[i]);
      std::swap(result_.formulas[kept++], result_.formulas[i]);
    }
    result_.formulas.resize(kept);
    types_.variables.resize(kept);
    if (options_.keep_sources) result_.sources.resize(kept);
    if (options_.keep_texts) result_.texts.resize(kept);
    for (const std::string& name : names) {
      if (seen.contains(name)) continue;
      std::string message = "included file '";
      message += file;
      message += "' has no formula named '";
      message += name;
      message += "'";
      return TptpIncludeFault{std::move(message), {}};
    }
    return std::nullopt;
  }

  SymbolTable& symbols_;
  const TptpOptions& options_;
  TptpFile result_;
  TptpTypes types_;
  std::vector<fs::path> open_;
  std::size_t included_ = 0;
  std::size_t bytes_read_ = 0;
};

}  // namespace

TptpFile ReadTptpFile(const fs::path& file, SymbolTable& symbols, const TptpOptions& options) {
  return Reader(symbols, options).ReadFile(file);
}

TptpFile ReadTptp(std::string_view text, std::string_view name, SymbolTable& symbols,
                  const TptpOptions& options) {
  return Reader(symbols, options).ReadText(text, name);
}

TptpAtom ReadTptpAtom(std::string_view text, std::string_view name, SymbolTable& symbols) {
  TptpAtom result;
  TptpCursor cursor(text, name, TptpOptions().max_tokens, result.diagnostics);
  TptpTermParser parser(cursor, symbols);
  parser.Begin(true);
  const SourcePlace place = cursor.place();
  const auto formula = parser.ReadAtom();
  if (!formula) return result;
  if (formula->kind() != Formula::Kind::kAtom) {
    cursor.FailAt(place, "expected an atom", "an atom reads p(a, X), or a = b");
  } else if (!cursor.Is(TptpToken::Kind::kEnd)) {
    cursor.FailExpected("the end of the atom");
  } else {
    result.atom = formula->atom();
    result.variable_names = parser.scope().Names();
  }
  return result;
}

}  // namespace latchwork::logic
