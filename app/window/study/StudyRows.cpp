#include "app/window/study/StudyRows.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/report/Markup.h"
#include "editor/look/CoreText.h"
#include "editor/look/Form.h"
#include "editor/look/TableExport.h"
#include "metrics/MetricRegistry.h"
#include "metrics/statistics/Summary.h"
#include "sim2d/base/Find.h"

namespace app {

namespace {

/// The first columns; they are followed by values, end reason and metrics.
enum FirstColumn { RunColumn, ScenarioColumn, SeedColumn, FirstColumns };
constexpr int kEndColumns = 1;               // end reason
constexpr std::size_t kMostResampled = 300;  // values; the table is updated twice a second

QString numberText(double value, int decimals) {
  return QString::fromStdString(report::numberText(value, decimals));
}

report::Estimate rateOf(const std::vector<const StudyRow*>& rows, const QString& key) {
  report::Estimate rate;
  int successes = 0;
  int count = 0;
  for (const StudyRow* row : rows) {
    const auto found = row->metrics.find(key);
    const bool isDefined = found != row->metrics.end();
    count += isDefined || !row->isOk ? 1 : 0;
    successes += row->isOk && isDefined && found->second != 0.0 ? 1 : 0;
  }
  if (count > 0) {
    rate.mean = static_cast<double>(successes) / count;
    rate.interval = statistics::wilsonInterval(successes, count);
  }
  return rate;
}

}  // namespace

std::optional<StudyRow> studyRowOf(const QByteArray& line) {
  const QJsonObject json = QJsonDocument::fromJson(line).object();
  if (!json.contains(QLatin1String("run"))) {
    return std::nullopt;
  }
  StudyRow row;
  row.run = json[QLatin1String("run")].toInt();
  row.scenario = json[QLatin1String("scenario")].toString();
  row.seed = static_cast<qlonglong>(json[QLatin1String("seed")].toDouble());
  row.isOk = json[QLatin1String("status")].toString() == QLatin1String("ok");
  row.reason = json[QLatin1String("reason")].toString();
  const QJsonObject values = json[QLatin1String("values")].toObject();
  for (auto each = values.begin(); each != values.end(); ++each) {
    row.values[each.key()] = each.value().toString();
  }
  const QJsonObject metrics = json[QLatin1String("metrics")].toObject();
  for (auto each = metrics.begin(); each != metrics.end(); ++each) {
    if (each.value().isDouble() || each.value().isBool()) {
      row.metrics[each.key()] =
          each.value().isBool() ? (each.value().toBool() ? 1.0 : 0.0) : each.value().toDouble();
    }
  }
  return row;
}

std::optional<StudyHeader> studyHeaderOf(const QByteArray& line) {
  const QJsonObject json = QJsonDocument::fromJson(line).object();
  const QJsonValue runs = json[QLatin1String("runs")];
  return runs.isDouble()
             ? std::optional(StudyHeader{
                   static_cast<std::size_t>(runs.toDouble()),
                   static_cast<std::size_t>(json[QLatin1String("finished")].toDouble())})
             : std::nullopt;
}

QString comparedPath(const Experiment& experiment) {
  QString first;
  for (const ExperimentValue& value : experiment.values) {
    QString path = QString::fromStdString(value.path);
    if (value.isDrawn() || value.texts.size() < 2) {
      continue;
    }
    if (arePlanners(value.path, value.texts)) {
      return path;
    }
    first = first.isEmpty() ? path : first;
  }
  return first;
}

QString pathTitle(const QString& path) {
  return path.endsWith(QLatin1String(".planner")) ? QObject::tr("Planner") : path;
}

const std::vector<StudyMetric>& studyMetrics() {
  static const std::vector<StudyMetric> kAll = [] {
    std::vector<StudyMetric> all;
    for (const char* key :
         {"success", "time_to_reach_goal", "robot_on_person_collision",
          "minimum_distance_to_people", "intimate_space_intrusions", "path_length"}) {
      if (const metrics::MetricEntry* entry = metrics::standardRegistry().find(key)) {
        const QString unit = QString::fromStdString(entry->info.unit);
        all.push_back({QString::fromLatin1(key), QString::fromStdString(entry->info.name),
                       unit == QLatin1String("-") ? QString() : unit, all.empty()});  // success
      }
    }
    return all;
  }();
  return kAll;
}

QString StudyMetric::heading() const {
  const QString shown = editor::coreText(title.toStdString());  // the list is made once
  return unit.isEmpty() ? shown : QStringLiteral("%1 [%2]").arg(shown, unit);
}

report::Estimate estimateOf(const StudyMetric& metric, const std::vector<const StudyRow*>& rows) {
  if (metric.isRate) {
    return rateOf(rows, metric.key);
  }
  report::Estimate estimate;
  for (const StudyRow* row : rows) {
    const auto found = row->metrics.find(metric.key);
    if (row->isOk && found != row->metrics.end()) {
      estimate.values.push_back(found->second);
    }
  }
  estimate.mean = statistics::mean(estimate.values);
  estimate.isConstant = report::areConstant(estimate.values);
  if (estimate.isConstant) {
    return estimate;  // no interval, as in the report
  }
  estimate.interval = estimate.values.size() <= kMostResampled
                          ? statistics::bootstrapMeanInterval(estimate.values)
                          : statistics::meanInterval(estimate.values);
  return estimate;
}

QString estimateText(const StudyMetric& metric, const report::Estimate& estimate) {
  if (std::isnan(estimate.mean)) {
    return {};
  }
  const double scale = metric.isRate ? 100.0 : 1.0;
  const int decimals = metric.isRate ? 0 : report::decimalsFor(estimate.mean, estimate.interval);
  const QString mean =
      numberText(scale * estimate.mean, decimals) + QLatin1String(metric.isRate ? " %" : "");
  return !estimate.interval.isDefined()
             ? mean
             : QStringLiteral("%1 [%2, %3]")
                   .arg(mean, numberText(scale * estimate.interval.low, decimals),
                        numberText(scale * estimate.interval.high, decimals));
}

void StudyRunsModel::begin(const QStringList& paths) {
  beginResetModel();
  paths_ = paths;
  rows_.clear();
  commonFolder_.reset();
  endResetModel();
}

/// Keeps the folder that the scenarios of all rows share.
void StudyRunsModel::takeFolderOf(const QString& scenario) {
  QString folder = scenario.left(scenario.lastIndexOf(QLatin1Char('/')) + 1);
  const QString known = commonFolder_.value_or(folder);
  while (!known.startsWith(folder)) {
    folder.chop(1);
    folder = folder.left(folder.lastIndexOf(QLatin1Char('/')) + 1);
  }
  if (commonFolder_ && folder != *commonFolder_ && !rows_.empty()) {
    Q_EMIT dataChanged(index(0, ScenarioColumn),
                       index(static_cast<int>(rows_.size()) - 1, ScenarioColumn));
  }
  commonFolder_ = folder;
}

QString StudyRunsModel::scenarioName(const QString& scenario) const {
  QString name = scenario.mid(commonFolder_ ? commonFolder_->size() : 0);
  for (const char* ending : {".yaml", ".yml"}) {
    if (name.endsWith(QLatin1String(ending))) {
      name.chop(static_cast<int>(qstrlen(ending)));
      break;
    }
  }
  return name;
}

void StudyRunsModel::add(StudyRow row) {
  takeFolderOf(row.scenario);
  const auto at = std::lower_bound(rows_.begin(), rows_.end(), row.run,
                                   [](const StudyRow& each, int run) { return each.run < run; });
  const int place = static_cast<int>(at - rows_.begin());
  if (at != rows_.end() && at->run == row.run) {
    *at = std::move(row);
    Q_EMIT dataChanged(index(place, 0), index(place, columnCount() - 1));
    return;
  }
  beginInsertRows({}, place, place);
  rows_.insert(at, std::move(row));
  endInsertRows();
}

std::vector<std::pair<QString, std::vector<const StudyRow*>>> StudyRunsModel::byOption(
    const QString& path) const {
  std::vector<std::pair<QString, std::vector<const StudyRow*>>> options;
  for (const StudyRow& row : rows_) {
    const auto value = row.values.find(path);
    const QString option = value == row.values.end() ? row.scenario : value->second;
    auto* known = base::findIf(options, [&](const auto& each) { return each.first == option; });
    if (known != nullptr) {
      known->second.push_back(&row);
    } else {
      options.push_back({option, {&row}});
    }
  }
  std::vector<std::string> texts;
  texts.reserve(options.size());
  for (const auto& [option, rows] : options) {
    texts.push_back(option.toStdString());
  }
  const std::vector<std::string> labels = optionLabels(texts);
  for (std::size_t k = 0; k < options.size(); ++k) {
    auto& [option, rows] = options[k];
    const bool isScenario = rows.front()->values.count(path) == 0;
    option = isScenario ? scenarioName(option) : QString::fromStdString(labels[k]);
  }
  return options;
}

int StudyRunsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int StudyRunsModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid()
             ? 0
             : FirstColumns + paths_.size() + kEndColumns + static_cast<int>(studyMetrics().size());
}

QVariant StudyRunsModel::shown(const StudyRow& row, int column) const {
  switch (column) {
    case RunColumn:
      return row.run;
    case ScenarioColumn:
      return scenarioName(row.scenario);
    case SeedColumn:
      return row.seed;
    default:
      break;
  }
  const int value = column - FirstColumns;
  if (value < paths_.size()) {
    const auto found = row.values.find(paths_[value]);
    return found == row.values.end() ? QVariant() : QVariant(found->second);
  }
  const int metric = value - paths_.size() - kEndColumns;
  if (metric < 0) {
    return row.isOk ? row.reason : tr("failed: %1").arg(row.reason);
  }
  const auto found = row.metrics.find(studyMetrics()[static_cast<std::size_t>(metric)].key);
  return found == row.metrics.end() ? QVariant() : QVariant(found->second);
}

/// The sort role returns numbers as numbers.
QVariant StudyRunsModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) {
    return {};
  }
  const StudyRow& row = rows_[static_cast<std::size_t>(index.row())];
  QVariant value = shown(row, index.column());
  const bool isNumber = value.type() != QVariant::String;
  switch (role) {
    case Qt::UserRole:
    case editor::kExactValueRole:
      return value;
    case Qt::DisplayRole: {
      const int metric = index.column() - FirstColumns - paths_.size() - kEndColumns;
      if (metric < 0 || !value.isValid()) {
        return value;
      }
      const double number = value.toDouble();
      return studyMetrics()[static_cast<std::size_t>(metric)].isRate
                 ? (number != 0.0 ? tr("yes") : tr("no"))
                 : numberText(number, report::decimalsFor(number));
    }
    case Qt::TextAlignmentRole:
      return int((isNumber ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    case Qt::ToolTipRole:
      if (index.column() == ScenarioColumn) {
        return row.scenario;
      }
      return value.type() == QVariant::String ? value : QVariant();
    default:
      return {};
  }
}

QVariant StudyRunsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Horizontal && role == Qt::TextAlignmentRole) {
    const int text = section - FirstColumns;
    const bool isText =
        section == ScenarioColumn || (text >= 0 && text < paths_.size() + kEndColumns);
    return isText ? QVariant(int(Qt::AlignLeft | Qt::AlignVCenter)) : QVariant();
  }
  if (orientation != Qt::Horizontal || (role != Qt::DisplayRole && role != Qt::ToolTipRole)) {
    return {};
  }
  static const QStringList kFirst = {tr("Run"), tr("Scenario"), tr("Seed")};
  if (section < FirstColumns) {
    return kFirst[section];
  }
  const int value = section - FirstColumns;
  if (value < paths_.size()) {
    return pathTitle(paths_[value]);
  }
  const int metric = value - paths_.size() - kEndColumns;
  if (metric < 0) {
    return tr("Ended");
  }
  return studyMetrics()[static_cast<std::size_t>(metric)].heading();
}

QString studyTimeText(double seconds) {
  const auto minutes = static_cast<long long>(seconds / 60.0);
  return seconds < 100.0 ? QObject::tr("%1 s").arg(qRound(seconds))
         : minutes < 100 ? QObject::tr("%1 min").arg(minutes)
                         : QObject::tr("%1 h %2 min").arg(minutes / 60).arg(minutes % 60);
}

QString sizeText(const Experiment& experiment) {
  QStringList parts = {editor::counted(experiment.scenarios.size(), QObject::tr("scenario"),
                                       QObject::tr("scenarios"))};
  for (const ExperimentValue& value : experiment.values) {
    if (!value.isDrawn() && value.texts.size() > 1) {
      const QString path = QString::fromStdString(value.path);
      parts.append(arePlanners(value.path, value.texts)
                       ? QObject::tr("%1 planners").arg(value.texts.size())
                       : QStringLiteral("%1 %2").arg(value.texts.size()).arg(path));
    }
  }
  parts.append(editor::counted(experiment.seeds.size(), QObject::tr("seed"), QObject::tr("seeds")));
  return parts.join(QStringLiteral(" × ")) + QStringLiteral(" = ") +
         editor::counted(experiment.runCount(), QObject::tr("run"), QObject::tr("runs"));
}

QString withoutSeverity(const QString& line) {
  const QString head = QStringLiteral("error: ");
  return editor::capitalized(line.startsWith(head) ? line.mid(head.size()) : line);
}

}  // namespace app
