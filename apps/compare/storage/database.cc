// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/storage/database.h"

#include <sqlite3.h>

#include <cstdint>
#include <string_view>
#include <system_error>

namespace latchwork::compare {
namespace {

/// A database that is written once, in one transaction. The first error stays.
class Writer {
 public:
  explicit Writer(const std::filesystem::path& file) {
    std::error_code error;
    std::filesystem::remove(file, error);
    Check(sqlite3_open(file.c_str(), &database_));
    Execute("PRAGMA page_size=4096; PRAGMA journal_mode=OFF; PRAGMA synchronous=OFF; BEGIN");
  }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  ~Writer() {
    sqlite3_finalize(statement_);
    sqlite3_close(database_);
  }

  void Execute(const char* sql) {
    if (problem_.empty()) Check(sqlite3_exec(database_, sql, nullptr, nullptr, nullptr));
  }
  /// The row that Put fills from its first column on.
  void Prepare(const char* sql) {
    sqlite3_finalize(statement_);
    statement_ = nullptr;
    if (problem_.empty()) Check(sqlite3_prepare_v2(database_, sql, -1, &statement_, nullptr));
    column_ = 0;
  }
  Writer& Put(std::string_view text) {
    return Bound(sqlite3_bind_text64(statement_, ++column_, text.data(), text.size(),
                                     SQLITE_TRANSIENT, SQLITE_UTF8));
  }
  Writer& Put(std::uint64_t number) {
    return Bound(sqlite3_bind_int64(statement_, ++column_, static_cast<sqlite3_int64>(number)));
  }
  Writer& Put(double number) { return Bound(sqlite3_bind_double(statement_, ++column_, number)); }
  Writer& Put(const RunKey& key) { return Put(key.scenario).Put(key.contender).Put(key.seed); }
  void Insert() {
    if (problem_.empty() && sqlite3_step(statement_) != SQLITE_DONE) Check(SQLITE_ERROR);
    sqlite3_reset(statement_);
    column_ = 0;
  }

  std::string Finish() {
    Execute("COMMIT");
    return problem_;
  }

 private:
  void Check(int code) {
    if (code != SQLITE_OK && problem_.empty()) problem_ = sqlite3_errmsg(database_);
  }
  Writer& Bound(int code) {
    if (problem_.empty()) Check(code);
    return *this;
  }

  sqlite3* database_ = nullptr;
  sqlite3_stmt* statement_ = nullptr;
  int column_ = 0;
  std::string problem_;
};

}  // namespace

std::string WriteResults(const std::filesystem::path& file,
                         const std::map<RunKey, RunRecord>& records) {
  Writer writer(file);
  writer.Execute(
      "CREATE TABLE runs(scenario TEXT, agent TEXT, seed INTEGER, outcome TEXT, message TEXT,"
      " time_s REAL, distance_m REAL, collisions INTEGER, command TEXT,"
      " PRIMARY KEY(scenario, agent, seed)) WITHOUT ROWID;"
      "CREATE TABLE trajectories(scenario TEXT, agent TEXT, seed INTEGER, places TEXT,"
      " PRIMARY KEY(scenario, agent, seed)) WITHOUT ROWID;"
      "CREATE TABLE layers(scenario TEXT, agent TEXT, seed INTEGER, layer TEXT, reasoner TEXT,"
      " decisions INTEGER, inferences REAL, budget_hits INTEGER, assumed_by_bound INTEGER,"
      " faults INTEGER, PRIMARY KEY(scenario, agent, seed, layer)) WITHOUT ROWID");
  writer.Prepare("INSERT INTO runs VALUES(?,?,?,?,?,?,?,?,?)");
  for (const auto& [key, run] : records) {
    writer.Put(key).Put(Name(run.outcome)).Put(run.message).Put(run.time_s).Put(run.distance_m);
    writer.Put(run.collisions).Put(run.command).Insert();
  }
  writer.Prepare("INSERT INTO trajectories VALUES(?,?,?,?)");
  for (const auto& [key, run] : records) {
    if (!run.trajectory.empty()) writer.Put(key).Put(run.trajectory).Insert();
  }
  writer.Prepare("INSERT INTO layers VALUES(?,?,?,?,?,?,?,?,?,?)");
  for (const auto& [key, run] : records) {
    for (const LayerRecord& layer : run.layers) {
      writer.Put(key).Put(layer.name).Put(layer.reasoner).Put(layer.decisions);
      writer.Put(layer.inferences).Put(layer.budget_hits).Put(layer.assumed_by_bound);
      writer.Put(layer.faults).Insert();
    }
  }
  return writer.Finish();
}

std::string WriteTimings(const std::filesystem::path& file,
                         const std::map<RunKey, RunRecord>& records) {
  Writer writer(file);
  writer.Execute(
      "CREATE TABLE run_times(scenario TEXT, agent TEXT, seed INTEGER, wall_s REAL, cpu_s REAL,"
      " PRIMARY KEY(scenario, agent, seed)) WITHOUT ROWID;"
      "CREATE TABLE layer_times(scenario TEXT, agent TEXT, seed INTEGER, layer TEXT,"
      " mean_us REAL, p50_us REAL, p99_us REAL, PRIMARY KEY(scenario, agent, seed, layer)) WITHOUT "
      "ROWID");
  writer.Prepare("INSERT INTO run_times VALUES(?,?,?,?,?)");
  for (const auto& [key, run] : records) writer.Put(key).Put(run.wall_s).Put(run.cpu_s).Insert();
  writer.Prepare("INSERT INTO layer_times VALUES(?,?,?,?,?,?,?)");
  for (const auto& [key, run] : records) {
    for (const LayerRecord& layer : run.layers) {
      writer.Put(key)
          .Put(layer.name)
          .Put(layer.mean_us)
          .Put(layer.p50_us)
          .Put(layer.p99_us)
          .Insert();
    }
  }
  return writer.Finish();
}

}  // namespace latchwork::compare
