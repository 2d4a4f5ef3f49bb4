#pragma once

#include <QDir>

#include "tests/app/RunFiles.h"

/// Output folders of tune, gate, sensitivity and search, written by hand.
namespace outside {

/// Two objectives; one changed parameter is kept, one is not.
constexpr char kTuneOutput[] = R"({
  "verdict": "not confirmed", "improved": false, "file": "/somewhere/hall.yaml",
  "controller": "pursuit", "scenarios": ["/somewhere/hall.yaml"],
  "held_out": ["/somewhere/hall.yaml"], "search_runs": 15, "evaluation_runs": 6,
  "generations": 1,
  "objectives": [{"key": "time_to_reach_goal", "unit": "s", "weight": 1.0},
                 {"key": "intimate_space_intrusions", "unit": "%", "weight": 1.0}],
  "parameters": [
    {"name": "lookahead", "low": 0.3, "high": 1.5, "logarithmic": false, "before": "0.6",
     "chosen": "0.6"},
    {"name": "slow_distance", "low": 0.5, "high": 4.0, "logarithmic": true, "before": "1.5",
     "chosen": "1.15"},
    {"name": "stop_distance", "low": 0.2, "high": 1.5, "logarithmic": true, "before": "0.5",
     "chosen": "0.5"}],
  "evaluation": {
    "all": {
      "success": {"before": 0.5, "after": 0.75, "difference": 0.25, "low": -0.25, "high": 0.75,
                  "pairs": 4},
      "time_to_reach_goal": {"before": 20.0, "after": 18.0, "difference": -2.0, "low": -4.0,
                             "high": 1.0, "pairs": 3},
      "intimate_space_intrusions": {"before": 4.0, "after": 5.0, "difference": 1.0, "low": null,
                                    "high": null, "pairs": 1}},
    "scenarios": [{"scenario": "/somewhere/hall.yaml", "metrics": {
      "success": {"before": 0.5, "after": 0.75, "difference": 0.25, "low": -0.25, "high": 0.75,
                  "pairs": 4},
      "time_to_reach_goal": {"before": 20.0, "after": 18.0, "difference": -2.0, "low": -8.0,
                             "high": 1.0, "pairs": 3},
      "intimate_space_intrusions": {"before": 4.0, "after": 5.0, "difference": 1.0, "low": null,
                                    "high": null, "pairs": 1}}}],
    "without_seed_effect": ["/somewhere/hall.yaml"],
    "effects": [
      {"parameter": "slow_distance", "value": "1.15", "score": 0.125, "kept": true,
       "time_to_reach_goal": {"before": 19.0, "after": 18.0, "difference": -1.0, "low": -2.0,
                              "high": 0.5, "pairs": 3},
       "intimate_space_intrusions": {"before": 4.0, "after": 4.0, "difference": 0.0, "low": null,
                                     "high": null, "pairs": 1}},
      {"parameter": "lookahead", "value": "0.9", "score": 0.0, "kept": false,
       "time_to_reach_goal": {"before": 18.0, "after": 18.0, "difference": 0.0, "low": -1.0,
                              "high": 1.0, "pairs": 3},
       "intimate_space_intrusions": {"before": 4.0, "after": 4.0, "difference": 0.0, "low": null,
                                     "high": null, "pairs": 1}}]},
  "candidates": [
    {"values": ["0.6", "1.5", "0.5"], "generation": -1, "runs": 3, "score": 1.0,
     "ratios": {"time_to_reach_goal": 1.0, "intimate_space_intrusions": 1.0}, "failures": 0.0,
     "complete": true, "on_front": false},
    {"values": ["1.1", "2.2", "0.3"], "generation": 0, "runs": 1, "score": 2.5,
     "ratios": {"time_to_reach_goal": 3.0, "intimate_space_intrusions": 1.3}, "failures": 0.0,
     "complete": false, "on_front": false},
    {"values": ["0.6", "1.5", "0.3"], "generation": 0, "runs": 3, "score": 0.95,
     "ratios": {"time_to_reach_goal": 1.25, "intimate_space_intrusions": 0.5}, "failures": 0.0,
     "complete": true, "on_front": true},
    {"values": ["0.6", "1.15", "0.5"], "generation": 0, "runs": 3, "score": 0.9,
     "ratios": {"time_to_reach_goal": 0.75, "intimate_space_intrusions": 0.875}, "failures": 0.0,
     "complete": true, "on_front": true}],
  "inputs": []
})";

/// Success passes, the time is worse, a third metric is not measured. The commands are filled in by
/// the tests.
constexpr char kGateOutput[] = R"({
  "verdict": "worse", "base": "pursuit", "candidate": "dwa", "level": 0.05, "pairs": 8,
  "runs": 16, "scenarios": ["yard"],
  "metrics": [
    {"metric": "success", "verdict": "pass", "measured": true, "pairs": 8, "base": 0.875,
     "candidate": 1.0, "unit": "share",
     "difference": {"mean": 12.5, "low": -2.0, "high": 27.0, "margin": 5.0, "unit": "points"}},
    {"metric": "time_to_reach_goal", "verdict": "worse", "measured": true, "pairs": 6,
     "base": 17.5, "candidate": 21.0, "unit": "s",
     "difference": {"mean": 20.0, "low": 10.0, "high": 30.0, "margin": 5.0, "unit": "%"}},
    {"metric": "robot_on_person_collision>2", "verdict": "undecided", "measured": false,
     "pairs": 8, "base": null, "candidate": null, "unit": "share",
     "difference": {"mean": null, "low": null, "high": null, "margin": 5.0, "unit": "points"}}],
  "remarks": ["a remark"],
  "findings": [
    {"scenario": "yard", "seed": 7, "what": "collided with a person",
     "play_candidate": "hunavsim yard.yaml --seed 7 --duration 1 --planner dwa",
     "play_base": "hunavsim yard.yaml --seed 7 --duration 1 --planner pursuit"},
    {"scenario": "yard", "seed": 9, "what": "Time to reach the goal [s]: 16.0 to 24.0",
     "play_candidate": "hunavsim yard.yaml --seed 9 --duration 2 --planner dwa",
     "play_base": "hunavsim yard.yaml --seed 9 --duration 2 --planner pursuit"}],
  "inputs": []
})";

/// Two values, two metrics, one case; the second metric is not certain.
constexpr char kMorrisOutput[] = R"({
  "method": "morris", "points": 4, "seed": 1, "runs": 24, "seeds": 2, "level": 0.95,
  "resamples": 2000,
  "factors": [{"path": "robot1.max_vel", "from": 0.6, "to": 1.2},
              {"path": "anna.radius", "from": 0.25, "to": 0.35}],
  "constant_metrics": ["success"],
  "results": [
    {"metric": "path_length", "case": "yard", "varies": true, "undefined_points": 0,
     "seed_share": 0.1, "too_few_points": {"wide": [], "unordered": [], "required": null},
     "factors": [
       {"path": "robot1.max_vel", "rank": 1, "mu_star": 2.5, "mu_star_low": 1.5,
        "mu_star_high": 4.0, "mu": 2.25, "sigma": 0.75, "effects": 4.0, "order_share": 0.975},
       {"path": "anna.radius", "rank": 2, "mu_star": 0.5, "mu_star_low": 0.25,
        "mu_star_high": 0.75, "mu": -0.5, "sigma": 0.125, "effects": 4.0, "order_share": null}]},
    {"metric": "minimum_distance_to_people", "case": "yard", "varies": true,
     "undefined_points": 3, "seed_share": 0.3,
     "too_few_points": {"wide": ["anna.radius"], "unordered": [["robot1.max_vel", "anna.radius"]],
                        "required": 12.0},
     "factors": [
       {"path": "anna.radius", "rank": 1, "mu_star": 1.0, "mu_star_low": 0.5,
        "mu_star_high": 1.75, "mu": 1.0, "sigma": 0.5, "effects": 4.0, "order_share": 0.625},
       {"path": "robot1.max_vel", "rank": 2, "mu_star": 0.75, "mu_star_low": 0.5,
        "mu_star_high": 1.0, "mu": 0.5, "sigma": 0.25, "effects": 4.0, "order_share": null}]}]
})";

constexpr char kSobolOutput[] = R"({
  "method": "sobol", "points": 64, "seed": 1, "runs": 512, "seeds": 2, "level": 0.95,
  "resamples": 2000, "factors": [{"path": "robot1.max_vel", "from": 0.6, "to": 1.2}],
  "constant_metrics": [],
  "results": [
    {"metric": "path_length", "case": "yard", "varies": true, "undefined_points": 0,
     "seed_share": null, "too_few_points": {"wide": [], "unordered": [], "required": null},
     "factors": [{"path": "robot1.max_vel", "rank": 1, "total": 0.75, "total_low": 0.5,
                  "total_high": 1.0, "first": 0.25, "first_low": 0.0, "first_high": 0.5,
                  "order_share": null}]}]
})";

/// Two failures and a third kind without a file in the archive of 2 × 2 cells.
constexpr char kSearchOutput[] = R"({
  "hunavsim_search": 1, "worst": null, "search_seed": 1, "runs": 31, "not_simulated": 2,
  "unavoidable_contacts": 3,
  "descriptors": [{"key": "final_bearing_to_person", "low": -3.0, "high": 3.0, "cells": 2},
                  {"key": "final_people_near", "low": 0.0, "high": 4.0, "cells": 2}],
  "failures": [
    {"kind": "contact-left-moving", "text": "contact with a moving person on the left",
     "file": "failures/contact-left-moving.yaml",
     "found": {"run": 4, "scenario": "yard", "seed": 2, "values": {}, "reason": "x",
               "simulated": "20", "kind": "contact-left-moving", "value": null, "fitness": 1.5},
     "seed": 2, "set": ["agents=[anna]", "robot1.max_vel=0.9", "variation.preset=none"],
     "reason": "collision: robot1 with anna", "simulated": "4.5", "people_before": 5, "people": 1,
     "removed": ["ben"], "reset": [], "shrink_runs": 9, "minimal": true, "repeated": true},
    {"kind": "standstill-no-person", "text": "standstill, no person near",
     "file": "failures/standstill-no-person.yaml",
     "found": {"run": 9, "scenario": "yard", "seed": 3, "values": {}, "reason": "x",
               "simulated": "20", "kind": "standstill-no-person", "value": null, "fitness": 1.2},
     "seed": 3, "set": [], "reason": "stuck: robot1", "simulated": "30", "people_before": 5,
     "people": 2, "removed": [], "reset": [], "shrink_runs": 400, "minimal": false,
     "repeated": false}],
  "worst_run": null,
  "cells": [
    {"cell": [-1, 0], "descriptors": [null, 0.0], "run": 1, "scenario": "yard", "seed": 1,
     "values": {}, "reason": "goal", "simulated": "10", "kind": null, "value": null,
     "fitness": 0.5},
    {"cell": [1, 1], "descriptors": [1.0, 3.0], "run": 4, "scenario": "yard", "seed": 2,
     "values": {}, "reason": "collision: robot1 with anna", "simulated": "20",
     "kind": "contact-left-moving", "value": null, "fitness": 1.5}]
})";

constexpr char kWorstOutput[] = R"({
  "hunavsim_search": 1, "worst": "minimum_distance_to_people", "search_seed": 1, "runs": 5,
  "not_simulated": 0, "unavoidable_contacts": 0,
  "descriptors": [{"key": "final_bearing_to_person", "low": -3.0, "high": 3.0, "cells": 2},
                  {"key": "final_people_near", "low": 0.0, "high": 4.0, "cells": 2}],
  "failures": [],
  "worst_run": {"run": 3, "scenario": "yard", "seed": 8, "values": {"robot1.max_vel": "0.7"},
                "reason": "goal", "simulated": "12.5", "kind": null, "value": 0.25,
                "fitness": -0.25, "file": "failures/worst.yaml", "repeated": true},
  "cells": []
})";

/// Two trees; a node of the first is missing, one cannot be reached.
constexpr char kCoverOutput[] = R"({
  "hunavsim_search": 1, "cover": true, "search_seed": 1, "runs": 12, "not_simulated": 0,
  "nodes": 8, "reached": 6, "unreachable": 1, "complete": false,
  "trees": [
    {"tree": 1, "owners": "anna, ben", "scenarios": ["yard"], "runs": 12, "nodes": 5,
     "reached": 3, "never_reached": ["Main/Fallback/Run"], "unreachable": ["Main/Never"]},
    {"tree": 2, "owners": "robot1", "scenarios": ["yard"], "runs": 12, "nodes": 3, "reached": 3,
     "never_reached": [], "unreachable": []}],
  "archive": [
    {"run": 4, "scenario": "yard", "seed": 5, "values": {}, "reason": "duration",
     "simulated": "1", "new_nodes": 2,
     "nodes": [{"tree": 1, "node": "Main"}, {"tree": 2, "node": "Nav"}],
     "play": "hunavsim yard.yaml --seed 5 --duration 1",
     "command": "hunavsim run yard.yaml --seed 5 --duration 1"}]
})";

/// Writes a folder as the commands do.
inline QString writeOutput(const QString& folder, const char* file, const QByteArray& json) {
  QDir().mkpath(folder);
  writeText(folder + QStringLiteral("/manifest.json"), "{}");
  writeText(QDir(folder).filePath(QString::fromLatin1(file)), json);
  return folder;
}

}  // namespace outside
