#include "app/run/ResultStore.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <new>
#include <utility>

#include <nlohmann/json.hpp>
#include <sqlite3.h>

#include "app/run/SqlStatement.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kApplicationId = 0x484e4156;  // "HNAV", in the header of the file
constexpr int kFormatVersion = 1;

const char* const kTables =
    "CREATE TABLE experiment(key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;"
    "CREATE TABLE inputs(position INTEGER PRIMARY KEY, path TEXT NOT NULL, sha256 TEXT NOT NULL);"
    "CREATE TABLE runs(run INTEGER PRIMARY KEY, scenario TEXT NOT NULL, seed INTEGER NOT NULL,"
    " value_texts TEXT NOT NULL, status TEXT NOT NULL, reason TEXT NOT NULL,"
    " simulated TEXT NOT NULL, metrics TEXT NOT NULL);";

/// An optional table that older databases lack.
const char* const kMachineTable =
    "CREATE TABLE IF NOT EXISTS machine_failures(run INTEGER PRIMARY KEY);";

std::string textsJson(const std::vector<std::string>& texts) {
  return base::jsonText(Json(texts), -1);
}

/// Empty for other JSON, of a damaged database.
std::vector<std::string> textsOf(const std::string& json) {
  try {
    return Json::parse(base::shallowJson(json)).get<std::vector<std::string>>();
  } catch (const Json::exception&) {
    return {};
  }
}

std::string fieldsText(const ResultRow& row) {
  Json json = Json::object();
  for (const auto& [column, field] : row.fields) {
    json[column] = field;
  }
  return base::jsonText(json, -1);
}

std::size_t countOf(const std::string& text) {
  return static_cast<std::size_t>(std::max(0LL, base::parseInt(text).value_or(0)));
}

/// False: it is not stored.
bool insertInput(sqlite3* database, std::size_t position, const InputHash& input) {
  const SqlStatement statement(database, "INSERT INTO inputs VALUES(?,?,?)",
                               static_cast<long long>(position), input.path, input.sha256);
  statement.step();
  return sqlite3_errcode(database) == SQLITE_DONE;
}

}  // namespace

ResultStore::ResultStore(std::string path) : path_(std::move(path)) {}

ResultStore::~ResultStore() {
  insertion_.reset();
  sqlite3_close(database_);
}

base::Diagnostics ResultStore::sqliteError(const char* code) const {
  if (sqlite3_errcode(database_) == SQLITE_NOMEM) {
    throw std::bad_alloc();
  }
  return {base::error(code, {sqlite3_errmsg(database_)}, path_)};
}

base::Diagnostics ResultStore::endOfRows() const {
  return sqlite3_errcode(database_) == SQLITE_DONE ? base::Diagnostics()
                                                   : sqliteError("batch.damaged");
}

bool ResultStore::run(const char* sql) const {
  return sqlite3_exec(database_, sql, nullptr, nullptr, nullptr) == SQLITE_OK;
}

bool ResultStore::isResultDatabase(const std::string& path) {
  std::array<char, 72> head{};
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) {
    return false;
  }
  std::ifstream file(path, std::ios::binary);
  constexpr std::array<char, 16> kMagic = {"SQLite format 3"};  // with the terminating zero
  if (!file.read(head.data(), head.size()) ||
      !std::equal(kMagic.begin(), kMagic.end(), head.begin())) {
    return false;
  }
  std::uint32_t application = 0;
  for (std::size_t k = 68; k < head.size(); ++k) {  // big-endian
    application = application << 8U | static_cast<unsigned char>(head[k]);
  }
  return application == static_cast<std::uint32_t>(kApplicationId);
}

/// FolderLock excludes other processes, so the exclusive locking mode works without shared memory
/// and therefore on cluster file systems.
base::Diagnostics ResultStore::connect(bool isNew) {
  const int flags = SQLITE_OPEN_READWRITE | (isNew ? SQLITE_OPEN_CREATE : 0) | SQLITE_OPEN_NOMUTEX;
  if (sqlite3_open_v2(path_.c_str(), &database_, flags, nullptr) != SQLITE_OK) {
    return sqliteError(isNew ? "batch.cannot-store" : "batch.damaged");
  }
  sqlite3_extended_result_codes(database_, 1);
  sqlite3_busy_timeout(database_, 10000);
  return {};
}

base::Diagnostics ResultStore::makeTables(const Study& study) {
  const std::string headerPragmas = "PRAGMA application_id=" + std::to_string(kApplicationId) +
                                    ";PRAGMA user_version=" + std::to_string(kFormatVersion) + ";";
  if (!run("PRAGMA locking_mode=EXCLUSIVE;PRAGMA synchronous=FULL;BEGIN IMMEDIATE;") ||
      !run(headerPragmas.c_str()) || !run(kTables)) {
    return sqliteError("batch.cannot-store");
  }
  const std::vector<std::pair<const char*, std::string>> entries = {
      {"version", study.version},
      {"commit", study.commit},
      {"path", study.experimentPath},
      {"text", study.experiment},
      {"sha256", study.inputs.empty() ? std::string() : study.inputs.front().sha256},
      {"columns", textsJson(study.paths)},
      {"drawn", textsJson(study.drawn)},
      {"design", study.design},
      {"runs", std::to_string(study.runs)},
      {"shard", std::to_string(study.shard.number)},
      {"shards", std::to_string(study.shard.count)},
      {"code", study.allowsCode ? "allowed" : ""},
      {"until", study.until},
      {"time_limit", base::formatDouble(study.timeLimit)}};
  for (const auto& [key, value] : entries) {
    const std::string name = key;
    SqlStatement(database_, "INSERT INTO experiment VALUES(?,?)", name, value).step();
  }
  for (std::size_t k = 0; k < study.inputs.size(); ++k) {
    insertInput(database_, k, study.inputs[k]);
  }
  return run("COMMIT") ? base::Diagnostics() : sqliteError("batch.cannot-store");
}

/// Creates the database under a temporary name, so that a killed process leaves no incomplete one.
base::Result<std::unique_ptr<ResultStore>> ResultStore::create(const std::string& path,
                                                               const Study& study) {
  const std::filesystem::path place(path);
  const std::string temporaryPath =
      (place.parent_path() / (".hunavsim-new-" + place.filename().string())).string();
  const auto removeLeftovers = [&temporaryPath] {
    for (const char* ending : {"", "-journal", "-wal"}) {
      std::error_code ignored;
      std::filesystem::remove(temporaryPath + ending, ignored);
    }
  };
  removeLeftovers();  // of a killed process
  base::Diagnostics problems;
  {
    ResultStore made(temporaryPath);
    problems = made.connect(true);
    if (problems.empty()) {
      problems = made.makeTables(study);
    }
  }
  std::error_code error;
  if (problems.empty()) {
    std::filesystem::rename(temporaryPath, path, error);
  }
  if (error) {
    problems = {base::error("batch.cannot-store", {error.message()}, path)};
  }
  removeLeftovers();  // a journal that SQLite did not remove
  return problems.empty() ? open(path) : base::Result<std::unique_ptr<ResultStore>>(problems);
}

base::Result<std::unique_ptr<ResultStore>> ResultStore::open(const std::string& path) {
  std::unique_ptr<ResultStore> store(new ResultStore(path));
  base::Diagnostics problems = store->connect(false);
  for (const auto& step : {&ResultStore::check, &ResultStore::readStudy, &ResultStore::readRuns}) {
    if (problems.empty()) {
      problems = (store.get()->*step)();
    }
  }
  if (!problems.empty()) {
    return problems;
  }
  return store;
}

base::Diagnostics ResultStore::check() {
  if (!run("PRAGMA locking_mode=EXCLUSIVE;PRAGMA synchronous=NORMAL")) {
    return sqliteError("batch.damaged");
  }
  const SqlStatement version(database_, "PRAGMA user_version");
  if (version.step() && version.number(0) > kFormatVersion) {
    return {base::error("batch.newer", {}, path_)};
  }
  const SqlStatement pages(database_, "PRAGMA quick_check(1)");
  if (!pages.step()) {
    return sqliteError("batch.damaged");
  }
  return pages.text(0) == "ok" ? base::Diagnostics()
                               : base::Diagnostics{base::error(
                                     "batch.damaged", {"the database has damaged pages"}, path_)};
}

base::Diagnostics ResultStore::readStudy() {
  std::map<std::string, std::string> entries;
  {
    const SqlStatement statement(database_, "SELECT key, value FROM experiment");
    while (statement.step()) {
      entries[statement.text(0)] = statement.text(1);
    }
    const SqlStatement inputs(database_, "SELECT path, sha256 FROM inputs ORDER BY position");
    while (inputs.step()) {
      study_.inputs.push_back({inputs.text(0), inputs.text(1)});
      hashes_[inputs.text(0)] = inputs.text(1);
    }
  }
  study_.version = entries["version"];
  study_.commit = entries["commit"];
  study_.experimentPath = entries["path"];
  study_.experiment = entries["text"];
  study_.paths = textsOf(entries["columns"]);
  study_.drawn = textsOf(entries["drawn"]);
  study_.design = entries["design"];
  study_.runs = countOf(entries["runs"]);
  study_.allowsCode = entries["code"] == "allowed";
  study_.timeLimit = base::parseDouble(entries["time_limit"]).value_or(0.0);
  study_.until = entries["until"];
  study_.enoughSeeds = countOf(entries["enough_seeds"]);
  study_.shard = {countOf(entries["shard"]), countOf(entries["shards"])};
  const bool isWhole = study_.runs > 0 && study_.shard.number >= 1 &&
                       study_.shard.number <= study_.shard.count && !study_.inputs.empty();
  return isWhole ? base::Diagnostics()
                 : base::Diagnostics{
                       base::error("batch.damaged", {"its tables are incomplete"}, path_)};
}

base::Diagnostics ResultStore::readRuns() {
  has_.assign(study_.runs, false);
  finished_ = failed_ = 0;
  machineFailures_.clear();
  firstFailure_.reset();
  if (base::Diagnostics problems = readMachineFailures(); !problems.empty()) {
    return problems;
  }
  const SqlStatement statement(database_, "SELECT run, status, reason FROM runs");
  while (statement.step()) {
    const long long index = statement.number(0);
    if (index < 0 || static_cast<std::size_t>(index) >= study_.runs ||
        !study_.shard.contains(static_cast<std::size_t>(index))) {
      return {base::error("batch.damaged", {"it contains a run that is not part of the experiment"},
                          path_)};
    }
    has_[static_cast<std::size_t>(index)] = true;
    ++finished_;
    if (statement.text(1) != "ok") {
      noteFailure(static_cast<std::size_t>(index), statement.text(2));
    }
  }
  return endOfRows();
}

void ResultStore::noteFailure(std::size_t run, const std::string& reason) {
  ++failed_;
  if (!firstFailure_ || run < firstFailure_->run) {
    firstFailure_ = {run, reason};
  }
}

base::Diagnostics ResultStore::readMachineFailures() {
  const SqlStatement table(database_, "SELECT 1 FROM sqlite_master WHERE name='machine_failures'");
  if (!table.step()) {
    return {};
  }
  const SqlStatement statement(
      database_,
      "SELECT run FROM machine_failures JOIN runs USING(run) WHERE status<>'ok' AND run>=0");
  while (statement.step()) {
    machineFailures_.insert(static_cast<std::size_t>(statement.number(0)));
  }
  return endOfRows();
}

base::Diagnostics ResultStore::removeFailed(bool all) {
  if (all ? failed_ == 0 : machineFailures_.empty()) {
    return {};
  }
  const std::string which = all ? "" : " AND run IN (SELECT run FROM machine_failures)";
  const std::string change = "BEGIN IMMEDIATE;" + std::string(kMachineTable) +
                             "DELETE FROM runs WHERE status<>'ok'" + which +
                             ";DELETE FROM machine_failures;"
                             "DELETE FROM experiment WHERE key='enough_seeds';COMMIT";
  if (!run(change.c_str())) {
    base::Diagnostics problems = sqliteError("batch.cannot-store");
    run("ROLLBACK");  // no effect outside a transaction
    return problems;
  }
  study_.enoughSeeds = 0;
  return readRuns();
}

base::Diagnostics ResultStore::setEnoughSeeds(std::size_t seeds) {
  const std::string change =
      "INSERT OR REPLACE INTO experiment VALUES('enough_seeds','" + std::to_string(seeds) + "')";
  if (!run(change.c_str())) {
    return sqliteError("batch.cannot-store");
  }
  study_.enoughSeeds = seeds;
  return {};
}

base::Diagnostics ResultStore::setTimeLimit(double seconds) {
  const std::string change = "INSERT OR REPLACE INTO experiment VALUES('time_limit','" +
                             base::formatDouble(seconds) + "')";
  if (seconds != study_.timeLimit && !run(change.c_str())) {
    return sqliteError("batch.cannot-store");
  }
  study_.timeLimit = seconds;
  return {};
}

base::Diagnostics ResultStore::addInputs(const std::vector<InputHash>& inputs) {
  base::Diagnostics problems;
  for (const InputHash& input : inputs) {
    const auto known = hashes_.find(input.path);
    if (known != hashes_.end() && known->second != input.sha256) {
      problems.push_back(base::error("batch.input-changed", {}, input.path));
    }
    if (known != hashes_.end() || input.sha256.empty() || !problems.empty()) {
      continue;  // the run itself reports missing files
    }
    if (!insertInput(database_, study_.inputs.size(), input)) {
      return sqliteError("batch.cannot-store");
    }
    hashes_[input.path] = input.sha256;
    study_.inputs.push_back(input);
  }
  return problems;
}

base::Diagnostics ResultStore::add(const StoredRun& run) {
  if (!insertion_) {  // also after close() in a previous process changed the journal mode
    if (!this->run("PRAGMA journal_mode=WAL")) {
      return sqliteError("batch.cannot-store");
    }
    insertion_ =
        std::make_unique<SqlStatement>(database_, "INSERT INTO runs VALUES(?,?,?,?,?,?,?,?)");
  }
  base::Diagnostics others = addInputs(run.row.inputs);
  if (!others.empty()) {
    return others;
  }
  const SqlStatement& to = *insertion_;
  to.bindAll(static_cast<long long>(run.run), run.scenario, run.seed, textsJson(run.values),
             std::string(run.row.ok ? "ok" : "failed"), run.row.reason, run.row.simulated,
             fieldsText(run.row));
  // The insertion commits itself, unless the run is also marked as ended by the machine or has
  // trees.
  const bool isMarked = !run.row.ok && run.row.failedBy == FailedBy::Machine;
  const bool isTransaction = isMarked || !run.row.trees.empty();
  const std::string mark =
      std::string("BEGIN IMMEDIATE;") +
      (isMarked ? std::string(kMachineTable) + "INSERT OR IGNORE INTO machine_failures VALUES(" +
                      std::to_string(run.run) + ")"
                : std::string());
  bool isStored = !isTransaction || this->run(mark.c_str());
  isStored = isStored && (run.row.trees.empty() || addTrees(run));
  isStored = isStored && sqlite3_step(to.prepared) == SQLITE_DONE;
  base::Diagnostics problems = isStored ? base::Diagnostics() : sqliteError("batch.cannot-store");
  sqlite3_reset(to.prepared);
  if (isTransaction && !this->run(isStored ? "COMMIT" : "ROLLBACK") && isStored) {
    problems = sqliteError("batch.cannot-store");
    isStored = false;
  }
  if (isStored) {
    count(run, isMarked);
  }
  return problems;
}

void ResultStore::count(const StoredRun& run, bool isMarked) {
  if (isMarked) {
    machineFailures_.insert(run.run);
  }
  has_[run.run] = true;
  ++finished_;
  if (!run.row.ok) {
    noteFailure(run.run, run.row.reason);
  }
}

base::Diagnostics ResultStore::forEach(const std::function<void(const StoredRun&)>& visit) const {
  const bool hasTrees =
      SqlStatement(database_, "SELECT 1 FROM sqlite_master WHERE name='tree_results'").step();
  const SqlStatement statement(
      database_,
      "SELECT run, scenario, seed, value_texts, status, reason, simulated, metrics "
      "FROM runs ORDER BY run");
  while (statement.step()) {
    StoredRun stored;
    stored.run = static_cast<std::size_t>(statement.number(0));
    stored.scenario = statement.text(1);
    stored.seed = statement.number(2);
    stored.values = textsOf(statement.text(3));
    stored.values.resize(study_.paths.size());
    stored.row.ok = statement.text(4) == "ok";
    stored.row.failedBy =
        machineFailures_.count(stored.run) > 0 ? FailedBy::Machine : FailedBy::Run;
    stored.row.reason = statement.text(5);
    stored.row.simulated = statement.text(6);
    const Json fields = Json::parse(base::shallowJson(statement.text(7)), nullptr, false);
    for (const auto& [column, field] : fields.items()) {
      stored.row.fields.emplace_back(column, field.is_string() ? field.get<std::string>() : "");
    }
    if (hasTrees) {
      stored.row.trees = treesOf(stored.run);
    }
    visit(stored);
  }
  return endOfRows();
}

base::Diagnostics ResultStore::replacePaths(
    const std::function<std::string(const std::string&)>& replaced) {
  std::vector<std::pair<long long, std::string>> reasons;
  {
    const SqlStatement statement(database_, "SELECT run, reason FROM runs WHERE reason<>''");
    while (statement.step()) {
      reasons.emplace_back(statement.number(0), replaced(statement.text(1)));
    }
  }
  bool isDone = run("BEGIN IMMEDIATE");
  const auto update = [&](const char* sql, const auto&... values) {
    const SqlStatement statement(database_, sql, values...);
    statement.step();
    isDone = isDone && sqlite3_errcode(database_) == SQLITE_DONE;
  };
  for (InputHash& input : study_.inputs) {
    update("UPDATE inputs SET path=? WHERE path=?", replaced(input.path), input.path);
    input.path = replaced(input.path);
  }
  study_.experimentPath = replaced(study_.experimentPath);
  update("UPDATE experiment SET value=? WHERE key='path'", study_.experimentPath);
  for (const auto& [index, reason] : reasons) {
    update("UPDATE runs SET reason=? WHERE run=?", reason, index);
  }
  // VACUUM: no former text stays in unused parts of pages.
  return isDone && run("COMMIT") && run("VACUUM") ? base::Diagnostics()
                                                  : sqliteError("batch.cannot-store");
}

base::Diagnostics ResultStore::close() {
  insertion_.reset();
  const bool isPlain = run("PRAGMA journal_mode=DELETE");
  base::Diagnostics problems = isPlain ? base::Diagnostics() : sqliteError("batch.cannot-store");
  if (sqlite3_close(database_) == SQLITE_OK) {
    database_ = nullptr;
  }
  if (isPlain && database_ == nullptr) {  // the journal of a killed process is empty
    std::error_code ignored;
    std::filesystem::remove(path_ + "-journal", ignored);
  }
  return problems;
}

}  // namespace app
