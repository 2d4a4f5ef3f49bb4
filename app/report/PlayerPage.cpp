#include "app/report/PlayerPage.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <nlohmann/json.hpp>

#include "app/report/Markup.h"
#include "app/report/RunPictures.h"
#include "app/run/DataPaths.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

namespace report {

namespace {

constexpr double kFineStep = 0.1;  // [s], sample interval of a single-run page

}  // namespace

std::string htmlPage(const std::string& title, const std::string& body, bool withPlayer) {
  return filled(kPageText, {{"title", escaped(title)},
                            {"style", kStyleText},
                            {"script", std::string(kReportText) + (withPlayer ? kPlayerText : "")},
                            {"body", body}});
}

std::string playerMarkup(const std::vector<std::string>& runs) {
  std::string data;
  for (const std::string& run : runs) {
    data += (data.empty() ? "" : ",\n") + scriptSafe(run);
  }
  return filled(kPlayerPageText, {{"runs", data}});
}

std::string playerPage(const sim2d::Trace& trace,
                       const std::vector<metrics::RobotContact>& contacts,
                       const std::string& title) {
  const std::size_t people = trace.header.humans.size();
  const double seconds = trace.frames.empty() ? 0.0 : trace.frames.back().time;
  const std::string about = (people == 1 ? "1 person" : std::to_string(people) + " people") + ", " +
                            counted(trace.header.robots.size(), "robot") + ", " +
                            numberText(seconds, 1) + " s, seed " +
                            std::to_string(trace.header.seed) + ".";
  const std::string body =
      filled(kRunText, {{"title", escaped(title)},
                        {"about", escaped(about)},
                        {"player", playerMarkup({playerJson(trace, contacts, {title}, kFineStep)})},
                        {"version", escaped(app::programVersion() + " " + app::programCommit())}});
  return htmlPage(title, body, true);
}

namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr int kCustomTreeLook = 7;  // after the six behaviours; the colour --p7 of report.css

int centimetres(double metres) {
  return static_cast<int>(std::lround(100.0 * metres));
}

OrderedJson outlinesJson(const std::vector<sim2d::Outline>& outlines) {
  OrderedJson all = OrderedJson::array();
  for (const sim2d::Outline& outline : outlines) {
    OrderedJson points = OrderedJson::array();
    for (const base::Vec2& point : outline.points) {
      points.push_back(centimetres(point.x()));
      points.push_back(centimetres(point.y()));
    }
    all.push_back(std::move(points));
  }
  return all;
}

/// The track of one body: continuous intervals, each with its first sample and the differences of
/// the following ones.
class BodyTrack {
 public:
  void add(std::size_t sample, double x, double y, double heading) {
    const int now[3] = {centimetres(x), centimetres(y), centimetres(heading)};
    if (stays_.empty() || last_ + 1 != sample) {
      stays_.push_back({sample, OrderedJson::array()});
      std::fill(std::begin(before_), std::end(before_), 0);
    }
    for (int k = 0; k < 3; ++k) {
      stays_.back().second.push_back(now[k] - before_[k]);
      before_[k] = now[k];
    }
    last_ = sample;
  }
  OrderedJson json() const {
    OrderedJson stays = OrderedJson::array();
    for (const auto& [from, differences] : stays_) {
      stays.push_back({{"from", from}, {"d", differences}});
    }
    return stays;
  }

 private:
  std::vector<std::pair<std::size_t, OrderedJson>> stays_;
  std::size_t last_ = 0;
  int before_[3] = {};
};

std::map<int, BodyTrack> bodyTracks(const std::vector<const sim2d::Frame*>& samples) {
  std::map<int, BodyTrack> tracks;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const auto add = [&tracks, k](const sim2d::BodyColumns& bodies) {
      for (std::size_t row = 0; row < bodies.size(); ++row) {
        tracks[bodies.id[row]].add(k, bodies.x[row], bodies.y[row], bodies.heading[row]);
      }
    };
    add(samples[k]->humans);
    add(samples[k]->robots);
  }
  return tracks;
}

OrderedJson bodiesJson(const sim2d::TraceHeader& header,
                       const std::vector<const sim2d::Frame*>& samples) {
  const std::map<int, BodyTrack> tracks = bodyTracks(samples);
  OrderedJson bodies = OrderedJson::array();
  for (const auto& [id, track] : tracks) {
    OrderedJson body = {{"id", id}, {"name", std::to_string(id)}, {"look", 1}, {"r", 35}};
    if (const sim2d::TraceHuman* human = header.human(id)) {
      body["name"] = human->name;
      body["look"] = human->customTree ? kCustomTreeLook : human->behavior;
      body["r"] = centimetres(human->radius);
    }
    for (const sim2d::TraceRobot& robot : header.robots) {
      if (robot.id == id) {
        body["name"] = robot.name;
        body["look"] = 0;  // robot
        body["r"] = centimetres(robot.radius);
        for (const base::Vec2& corner : robot.footprint) {
          body["shape"].push_back(centimetres(corner.x()));
          body["shape"].push_back(centimetres(corner.y()));
        }
      }
    }
    body["stays"] = track.json();
    bodies.push_back(std::move(body));
  }
  return bodies;
}

OrderedJson goalsJson(const sim2d::TraceHeader& header) {
  OrderedJson goals = OrderedJson::array();
  std::set<int> known;
  for (const sim2d::TraceHuman& human : header.humans) {
    for (const sim2d::TraceGoal& goal : human.goals) {
      if (known.insert(goal.id).second) {
        goals.push_back({centimetres(goal.position.x()), centimetres(goal.position.y()), 0});
      }
    }
  }
  for (const sim2d::TraceRobot& robot : header.robots) {
    for (const sim2d::TraceGoal& goal : robot.goals) {
      goals.push_back({centimetres(goal.position.x()), centimetres(goal.position.y()), 1});
    }
  }
  return goals;
}

/// Whether the event is relevant for a failure; single goals of people are not.
bool isRelevant(const sim2d::Event& event) {
  switch (event.kind) {
    case sim2d::EventKind::Contact:
    case sim2d::EventKind::Stuck:
    case sim2d::EventKind::NavigationSucceeded:
    case sim2d::EventKind::NavigationFailed:
    case sim2d::EventKind::Door:
    case sim2d::EventKind::Stop:
      return true;
    case sim2d::EventKind::Arrived:
    case sim2d::EventKind::Replan:
    case sim2d::EventKind::Dock:
    case sim2d::EventKind::Battery:
      return event.hasId && event.id < 0;
    default:
      return false;
  }
}

/// Whether the trace has an event for this contact within 0.5 s.
bool hasContactEvent(const sim2d::Trace& trace, const metrics::RobotContact& contact, int robot) {
  constexpr double kMoment = 0.5;  // [s]
  return std::any_of(trace.events.begin(), trace.events.end(), [&](const auto& entries) {
    const auto& [step, event] = entries;
    const double time = static_cast<double>(step) * trace.header.dt;
    return event.kind == sim2d::EventKind::Contact && event.hasId && event.id == robot &&
           std::abs(time - contact.time) <= kMoment &&
           event.hasOther == contact.person.has_value() &&
           (!event.hasOther || event.other == *contact.person);
  });
}

/// The text of an event. For a contact, "closing at 0.37 m/s, robot ahead" instead of a leading
/// number.
std::string eventText(const sim2d::Event& event) {
  const std::size_t end = std::min(event.text.find(' '), event.text.size());
  const std::optional<double> speed = base::parseDouble(event.text.substr(0, end));
  if (event.kind != sim2d::EventKind::Contact || !speed) {
    return event.text;
  }
  const std::string rest = end < event.text.size() ? ", " + event.text.substr(end + 1) : "";
  return "closing speed " + numberText(*speed, 2) + " m/s" + rest;
}

OrderedJson eventsJson(const sim2d::Trace& trace,
                       const std::vector<metrics::RobotContact>& contacts) {
  constexpr std::size_t kMostEvents = 200;
  std::vector<std::pair<double, OrderedJson>> entries;
  const auto addEntry = [&entries](double time, const char* kind, OrderedJson who,
                                   OrderedJson other, const std::string& text) {
    entries.emplace_back(time, OrderedJson{std::round(time * 100.0) / 100.0, kind, std::move(who),
                                           std::move(other), text});
  };
  for (const auto& [step, event] : trace.events) {
    if (isRelevant(event)) {
      addEntry(static_cast<double>(step) * trace.header.dt, sim2d::eventKindName(event.kind),
               event.hasId ? OrderedJson(event.id) : OrderedJson(),
               event.hasOther ? OrderedJson(event.other) : OrderedJson(), eventText(event));
    }
  }
  const int robot = trace.header.robots.empty() ? -1 : trace.header.robots.front().id;
  for (const metrics::RobotContact& contact : contacts) {
    if (!hasContactEvent(trace, contact, robot)) {
      addEntry(contact.time, sim2d::eventKindName(sim2d::EventKind::Contact), robot,
               contact.person ? OrderedJson(*contact.person) : OrderedJson(), "");
    }
  }
  std::stable_sort(entries.begin(), entries.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  OrderedJson events = OrderedJson::array();
  for (std::size_t k = 0; k < std::min(entries.size(), kMostEvents); ++k) {
    events.push_back(std::move(entries[k].second));
  }
  return events;
}

}  // namespace

std::string playerJson(const sim2d::Trace& trace,
                       const std::vector<metrics::RobotContact>& contacts,
                       const PlayerLabels& words, double every) {
  const double recorded = trace.header.dt * std::max(1, trace.header.recordEvery);
  const auto stride =
      static_cast<std::size_t>(std::max(1.0, std::round(every / std::max(recorded, 1e-9))));
  std::vector<const sim2d::Frame*> samples;
  for (std::size_t k = 0; k < trace.frames.size(); k += stride) {
    samples.push_back(&trace.frames[k]);
  }
  const FloorPlan floorPlan = floorPlanOf(trace);
  const std::string about =
      words.about.empty() ? trace.header.scenario + ", seed " + std::to_string(trace.header.seed)
                          : words.about;
  const OrderedJson json = {{"title", words.title},
                            {"about", about},
                            {"outcome", words.outcome},
                            {"scenario", trace.header.scenario},
                            {"seed", trace.header.seed},
                            {"dt", recorded * static_cast<double>(stride)},
                            {"samples", samples.size()},
                            {"box",
                             {centimetres(floorPlan.low.x()), centimetres(floorPlan.low.y()),
                              centimetres(floorPlan.high.x()), centimetres(floorPlan.high.y())}},
                            {"walls", outlinesJson(floorPlan.walls)},
                            {"shapes", outlinesJson(floorPlan.shapes)},
                            {"goals", goalsJson(trace.header)},
                            {"bodies", bodiesJson(trace.header, samples)},
                            {"events", eventsJson(trace, contacts)}};
  return base::jsonText(json, -1);
}

}  // namespace report
