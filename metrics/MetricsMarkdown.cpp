#include "metrics/MetricRegistry.h"
#include "metrics/RunResults.h"
#include "sim2d/base/Text.h"

namespace metrics {

namespace {

/// Text of a table cell with escaped bars.
std::string cellOf(const std::string& text) {
  std::string cell;
  for (const char c : text) {
    cell += c == '|' ? std::string("\\|") : std::string(1, c);
  }
  return cell.empty() ? "-" : cell;
}

std::string row(const std::vector<std::string>& cells) {
  std::string text = "|";
  for (const std::string& cell : cells) {
    text += " " + cell + " |";
  }
  return text + "\n";
}

std::string categoryTable(const MetricRegistry& registry, Category category) {
  std::string text = "\n## " + std::string(categoryName(category)) + "\n\n";
  text +=
      row({"#", "key", "meaning", "unit", "formula", "range", "better", "rate", "needs", "source"});
  text += "|---|---|---|---|---|---|---|---|---|---|\n";
  for (const MetricEntry& entry : registry.entries()) {
    const MetricInfo& info = entry.info;
    if (info.category != category) {
      continue;
    }
    text += row({info.hunav > 0 ? std::to_string(info.hunav) : "", "`" + info.key + "`",
                 cellOf(info.name), cellOf(info.unit), cellOf(info.formula), cellOf(info.range),
                 betterName(info.better), base::formatDouble(100.0 * info.rateBound) + " %",
                 needsText(info.needs), cellOf(info.source)});
  }
  return text;
}

std::string parameterTable() {
  std::string text =
      "\n## Parameters\n\nChanged values are in `metrics.parameters` of `trace.json`.\n\n" +
      row({"name", "default", "unit", "meaning"});
  text += "|---|---|---|---|\n";
  for (const ParameterInfo& info : parameterInfos()) {
    const base::ParameterSpec& spec = info.spec;
    text += row({"`" + spec.key + "`", base::formatDouble(std::get<double>(spec.fallback)),
                 cellOf(spec.unit), cellOf(spec.help)});
  }
  return text;
}

constexpr char kIntroduction[] = R"(# Metrics

Written by `hunavsim list metrics --format markdown`; do not edit by hand.

Every value can be recomputed from this page and three files of a run: `trajectory.csv`,
`events.csv`, `trace.json`; those along a shortest path also need `shortest_ways` of
`metrics.json` (of the other robots: below `robots`). Metrics with a number in the first column are
those of HuNavSim's evaluator; the others are defined by this program. SI units, radians, world frame.
Profile `corrected` (default) uses the formulas below. Profile `hunav2` gives the same numbers as the
public HuNavSim 2.0 evaluator, with its peculiarities (section Profile `hunav2`). Names in `code` are
keys, parameters (last section) or names in the files.

A value that is undefined for a record is empty in CSV and `null` in JSON, with the reason; so is an
infinite value, which is `inf` only in the evaluator's own files (`--layout`). Values that are 1 or 0
for yes or no (`completed`, `success`, `timeout`) are `true` or `false` in JSON, `True` or `False` in
CSV.

## Samples

The rows of `trajectory.csv` with the same `step` are a sample i = 0 .. N-1 at the time t_i =
`step` * `dt` of `trace.json`. Recorded steps are the multiples of its `record_every`; one of them
without rows, up to the event `stop`, is a sample without people. If `metrics.frequency` there is
not 0, only some samples are used: the first one (after `metrics.from`), at time t, and then
repeatedly the first one at or after (less 1e-9 s) the next of the times t + k / `frequency` after
the last used sample. dt_i = t_(i+1) - t_i, T = t_(N-1) - t_0.

- Robot (kind `robot`; the first has `id` -1): position p, heading psi, velocity v = (`vx`, `vy`) in
  the world, speed s = |v|, turn rate w = `omega`; from `trace.json` its radius r_r, v_max =
  `max_vel`, `goals` (centre and radius each), `start_time`.
- Person a (kind `human`): position q, heading phi, velocity u; radius r_a, type and parameters from
  `humans` of `trace.json`; `group` (-1: none).
- d = |p - q|, gap = d - r_r - r_a (between the surfaces), c_i = max(0, smallest gap at sample i),
  R = r_r + r_a, C = q - p, closing velocity V = v - u.
- wrap(x) is in (-pi, pi]; cross(a, b) = a_x b_y - a_y b_x.
- Sums, means, minima and maxima "over i, a" run over all samples and the people in each.
- A time is the sum of the dt_i of the samples i at which its condition holds (the state of a sample
  lasts until the next one; the last sample adds nothing); a share of time is this sum * 100 / T, 0 if
  T = 0. A share of samples is 100/N * their number. A time-weighted mean is sum f_i dt_i /
  sum dt_i over the samples that have a value, except the last one.
- People are identified by `id`. A person who is not in the previous sample, has an event `enter`
  since then, or crosses the seam of `wrap_x` (is nearer to the previous position when moved by the
  length of the corridor, the second value of `wrap_x` less the first) has jumped.

`behaviors` of `metrics.json` contains the same keys for each type of person (`behavior` of
`humans`), as if the others were absent; the evaluation interval, the robot's arrival and N do not
change.

## Evaluation interval

Metrics that need a robot use the samples of its evaluation interval (`corrected`): N, T and t_0 are
those of the interval. It begins with the first sample at or after `start_time` and ends with the
robot's arrival; if that is between two samples, with the second. Metrics without `robot` in the
column needs use the whole record.

If `metrics.from` of `trace.json` is not `begin`, or `metrics.until` not `end`, both limits are
replaced: all metrics, also those that need no robot, use only the samples with from <= t_i <= until
(to 1e-9 s), and arrivals later than that do not count. `begin` and `end` are those of the record;
`goal` is `start_time`; `motion` the first sample with s > 0.01 m/s; `time T` the time T;
`event KIND` the first event of that kind, for `until` the first one at or after `from`; `arrival` the
event of the robot's arrival: if it is between two used samples, the second of them is the last. If
the moment of `until` does not occur, the end of the record is used; if that of `from` does not
occur, there is no sample.

All keys, tables and files use the same arrival:

- A robot that the program has simulated (`planner` in `trace.json` is neither empty nor `recorded`)
  arrives at the time of its first event `arrived`: its centre is within the radius of its last
  goal. With the planner `nav2` the navigator decides: the event is at the time when its tree
  returned SUCCESS for the last goal. At the success of each goal the centre must have been at most
  0.5 m outside the radius of that goal (the default tolerance of Nav2's planners), and no goal may
  have been abandoned; otherwise the robot does not arrive. Without that event it has not arrived,
  whatever its distance to the goal. An event `arrived` with the text `order` refers to a position
  to which an external input sent the robot and is not an arrival.
- A recorded robot also arrives by that event, if there is one. Otherwise it has arrived if its last
  sample is in the goal region, |p - g| - radius of g < `goal_tolerance` for some goal g, at the
  first sample of its last stay there. If the robot has moved, then stopped in the region (s <
  `stop_linear_speed` and |w| < `stop_angular_speed`) and stands until the end of the record, its
  evaluation interval ends with the first sample of this stop; otherwise it ends with the record.
- A robot with a goal that does not arrive has failed after `time_limit`: its evaluation interval
  ends with the first sample at which t_i - t_0 >= `time_limit`, or with the record. During a run
  this applies to the run so far.

With several robots each is measured separately, as if the others were absent. The values of the
first are in the same places as those of a single robot; those of the others are in `metrics.json`
below `robots`, in `metrics_<robot>.csv` and `steps_<robot>.csv`, and in columns `<robot>.<key>` of
a batch (`evaluate --robot` measures only one). A `--reference` applies to the first robot; the
reference is the corresponding part of its run, of the same robot, or of its first one.

Without a robot, or if it does not start, all metrics that need one are undefined. Without a goal all
metrics of goals are undefined, except `completed` = 0. Without people in the record counts, times,
shares and sums are 0, `space_compliance` is 100, `min_time_to_collision` infinite; means, minima and
maxima over people or samples with people are undefined. Without map and obstacles clearances,
obstacle forces and `obstacle_collisions` are undefined, O = 0 in `social_work`, and no view is
blocked. Without groups the metrics of groups are 0. A robot that does not move has no value per
metre. A rate of change needs two samples at different times, a second one three.

## Distances and zones

Bands of distance x: intimate 0 <= x < `intimate_distance`, personal from there to x <
`personal_distance`, social from there to x < `social_distance`. The limits are Hall's (1966), but
his distances are between people, and those here, as in HuNavSim, between surfaces: x is c_i, or the
distance of the robot's surface from the centre of a group, so that at the same x the centres are R
farther apart. Only `time_in_personal_space` and `avg_speed_in_personal_space` use centres.

A contact or an entry into a zone begins at sample i for a person whose gap is below the limit at i
and was not at i-1, or who was not present at i-1 (also at the first sample of the evaluation
interval). The cause: with n = C/d at sample i (0 if d = 0), c_r = v n and c_p = -u n; c_r > c_p +
1e-6: the robot, c_p > c_r + 1e-6: the person, else both. v and u are those of sample i-1, as
contact may have stopped the bodies at i; if the person was not present at i-1 or has jumped, both
are those of sample i.

ttc of a pair, on straight courses: 0 if d <= R; else, with b = C V and D = b^2 - |V|^2 (d^2 - R^2),
(b - sqrt(D))/|V|^2 if b > 0 and D > 0, else there is no collision course.

## Walls and obstacles

`obstacles` of `trace.json` are entries of closed outlines (the one named `map` of the map's walls);
the solid lies to the left of each edge. A position is inside an entry if the winding number of its
outlines around it, plus 1 if their signed areas add up to less than 0, is above 0. A door is
present unless it is open: its initial state is `open`, and it changes at each time t of `toggles`
with t <= t_i. The clearance is the distance of the robot's centre from the nearest edge, negative
inside, less r_r; it exists only where that distance is below 5 m.

Obstacle points of a body at x (`obstacle_points`: `boundary`): of each edge from a to b, with e its
unit vector, the foot of the perpendicular from x if it lies between a and b (ends excluded) and
cross(x - a, e) >= 0; of each corner k, with edges e- into and e+ out of it, the corner itself if
(x - k) e+ <= 0, (x - k) e- >= 0 and (cross(e+, x - k) <= 0 or cross(e-, x - k) <= 0); only those
nearer than 5 m, and none whose position 1e-6 m outwards (to the right of the edge; at a corner,
along the sum of the right normals of its two edges) is inside an entry. Then, in the order of
distance (if equal to 1e-9 m: of x, then y), those that are at least 0.3 m from all points selected
before. For x inside an entry instead: only the nearest point of an edge that is not excluded in
this way. With `rays`: the points where 90 rays, 4 degrees apart, starting at +x, first hit an edge
within 4 m.

O(b), the obstacle force on body b (radius r): mean over its points o of `obstacle_factor` * exp(-(|x
- o| - r)/`obstacle_sigma`) * (x - o)/|x - o|; 0 without points; a point within 1e-9 m counts only in
the number of points. For x inside, |x - o| in the exponent and the sign of the whole are negative.

F(j -> k), the social force of body j on body k (Moussaid et al. 2009), with the factor f: with D = |x_j - x_k|,
e = (x_j - x_k)/D, I = `social_lambda` * (v_k - v_j) + e, L = |I|, h = I/L, B = `social_gamma` * L,
theta = wrap(angle of e - angle of h), 0 if |theta| < 1e-6:
F = -f * (exp(-D/B - (`social_n_prime` B theta)^2) h + sign(theta) exp(-D/B - (`social_n` B theta)^2) h'),
h' = h turned left by 90 degrees, sign(0) = 0; 0 if D or L < 1e-9. f = `social_factor` for the force on
the robot; for that on a person `parameters.social_force_factor` of the person in `trace.json`, if they have one and
`person_force_parameters` is 1, else `social_factor` too.

A person sees the robot if theta, the angle between their heading and p - q (0 if d = 0; the arc
cosine of the scalar product of the unit vectors), is <= `field_of_view`/2 and nothing blocks the
view: the line between the centres meets neither an outline nor the interior of any entry except
`map` (doors as above), and all cells of Bresenham's line from the cell of the person to that of the
robot, both included, have values 0 to 50 (-1, unknown, blocks; cells outside the map block
nothing). Cells are `map.cells` (value, repeat, value, repeat ...; row by row from the lower left),
the indices of a cell are the floor of the position in the frame of `map.x`, `map.y`, `map.heading`,
divided by `map.resolution`. The line: width w and height h in cells, error = w - h; at each step
twice = 2 error; if twice > -h: error -= h, one column further; if twice < w: error += w, one row
further.

Shortest paths, whose corner points are in `metrics.json` (`shortest_ways`: `to_goal` from p_0 to
the centre of the first goal, `to_end` from p_0 to p_(N-1)), are those of a disc of the robot's
radius around walls, map and obstacles, with open doors: the straight line if the disc fits along it
(with the clearance of its ends, if that is less). Otherwise: the shortest of all paths over cells,
shortened by string pulling, through unknown cells only if there is no other path, with arcs around
corners as chords, to 2e-4 of its length; the straight line if there is no path. Paths over cells
have 16 directions: a path on another side of some obstacle may be shorter by 3.1 % of the length
and about a cell at each corner, so `path_efficiency`, `spl` and `stl` are too high by at most this
amount. A passage less than a cell wider than the robot may count as closed.

Obstacle points of O follow from the walls, obstacles and closed doors of a run. A recording of another
program that contains points (`closest_obs` of hunav_msgs; in the results of `evaluate` they are in
`obstacle_points.csv`) is measured with them: people if any person has points, the robot if it has points;
its clearance is then the smaller of the distances to the points and to the walls of the map. Without
points, map and obstacles O is undefined, in `hunav2` 0. The factor of F on a person is that of the
recording (`social_force_factor`), else `social_factor`.

## Groups and crowds

Members of a group are the people of one `group` at a sample; fewer than `group_minimum_members` are
not a group. Its centre is the mean over members of q + `group_interaction_distance` * (cos phi, sin
phi), x_i = max(0, min over groups of |p_i - centre| - r_r). The axes of its arrangement: m = mean
of q, angle = atan2(2 Sxy, Sxx - Syy)/2 of the sums of products of q - m; the span along an axis n
is max(n q + r_a) - min(n q - r_a).

Crowd samples are the first sample and each sample at least `crowd_interval` (less 1e-9 s) after the
last crowd sample; a crowd sample without people counts too, and has no value. People walk if |u| >
0.05 m/s. In crowd samples, people and walls have images beyond both ends of `wrap_x`; distances,
forces and times to collision use no images.

## Sampling

Column rate: largest change when a record of smooth motion is sampled twice as often, from 20 Hz on, as a
share of the larger value, which counts as at least 0.1. The sums 25-34 grow with the recording rate; each
is also given divided by N, with `_mean` appended to its key. The behaviour of derivatives when the
sampling interval dt gets shorter:

| key | smooth motion | a step of the acceleration | a step of the speed (a contact) | noise of the record |
|---|---|---|---|---|
| `avg_acceleration` | converges as dt | converges | converges: the step / T | grows as 1/dt |
| `max_acceleration` | converges as dt | the largest acceleration | grows as 1/dt | grows as 1/dt |
| `avg_overacceleration`, `max_jerk` | converges as dt^2 | converges; largest: 15/8 of the step / `jerk_window` | converges; at most 1.45 of the step / H^2 | does not grow: band-limited |
| `heading_change_smoothness` | converges as dt | converges | converges: the step of w / T | grows as 1/dt |
| `cumulative_heading_changes`, `path_length` and what is divided by it | converges as dt^2 | converges | converges | grows as 1/dt |
| `curvature_avg`, `curvature_max` | converges as dt | converges | at a kink of the path: grows as 1/dt | grows as 1/dt^2 |
| `roughness_avg` | proportional to dt | proportional to dt | - | grows |
| `motion_energy`, `failure_to_progress` | sums over samples: grow as 1/dt | same | same | grow |
| `topological_complexity`, `responsibility`, `engagement` | converges as dt | converges | converges | the last two grow |

The jerk at time t, J(t): the second derivative of the parabola that fits the speed, taken as linear between the
samples, best within half a window H = `jerk_window`/2 to each side, J(t) = 15/(2 H^3) * integral over x from -H
to H of s(t + x) (3 x^2/H^2 - 1)/2. J_i = J(t_i), 0 < i < N-1, exists where t_i - H >= t_0 and t_i + H <= t_(N-1);
`max_jerk` also includes J((t_(i-1) + t_i)/2) of these i, if that less H is not before t_0. Where a neighbour is
farther away than H (dt > 0.375 s by default), the sampling itself limits the band: J_i is the second difference,
(a_i - a_(i-1))/((t_(i+1) - t_(i-1))/2) with a_i = (s_(i+1) - s_i)/dt_i, if both dt > 0, and there is no value at
the middle before it. From 12.5 Hz on, halving dt changes both keys by 5 % at most. In `steps.csv` J_i is at
sample i+1.
)";

constexpr char kOriginal[] = R"(
## Profile `hunav2`

N, T and t_0 are those of the whole record for all keys, also those without a number; `metrics.from`
and `metrics.until` apply as above. The robot has arrived if its last sample is in the goal region
(`completed`). A robot that does not start within the record has values too. The metrics below
differ from the formulas of the tables; all others are the same. If the evaluator stops with an
exception, the value is undefined and the exception is the reason. n_i = number of people at sample
i. In `behaviors`, n_i, groups and "without people" refer to the people of that type.

| # | key | in `hunav2` |
|---|---|---|
| 1 | `time_to_reach_goal` | T, whether or not the goal was reached |
| 4 | `avg_distance_to_closest_person` | sum of c_i over the samples with people, divided by N; 0 without people |
| 5, 6 | `minimum_`, `maximum_distance_to_people` | the maximum may be negative; undefined without people (ValueError) |
| 10-12 | `group_..._space_intrusions` | groups are the ids other than -1 at the first sample, also those with one member; undefined if one of them has no member at a later sample (ZeroDivisionError; ValueError if that sample has no people); 0 if there are none at the first, also without people |
| 14, 15 | `..._distance_to_target` | infinite without goal |
| 16, 17 | `robot_on_person_`, `person_on_robot_collision` | number of pairs of sample and person with gap < `contact_distance`: with (x, y) the robot's centre in the frame of the person, (x', y') the person's centre in the frame of the robot, alpha = abs(atan2(y, x)) and beta = abs(atan2(x', y')): 16 counts alpha < beta, 17 alpha > beta, both only if the speeds s and \|u\| differ; alpha = beta with equal speeds counts in both |
| 18 | `time_not_moving` | T/N * number of samples with s < `stop_linear_speed` and w < `stop_angular_speed` (w with its sign) |
| 21 | `avg_acceleration` | divided by N instead of the number of intervals |
| 22 | `avg_overacceleration` | sum of abs((s_(i+1) - s_i)/dt_i^2) over the intervals with dt_i > 0, divided by N |
| - | `max_jerk` | largest abs((a_i - a_(i-1))/((t_(i+1) - t_(i-1))/2)) with a_i and conditions as in Sampling; undefined for N < 3 |
| 23 | `avg_pedestrian_velocity` | sum of \|u\| over i, a, divided by N n_0; undefined for n_0 = 0 (ZeroDivisionError) |
| 24 | `avg_closest_pedestrian_velocity` | of the person with the smallest d; 0 at samples without people; divided by N |
| 25-27 | `social_force_...`, `social_work` | F has the factor `social_factor` for everyone; undefined if d = 0 or L < 1e-9 for some pair |
| 28 | `obstacle_force_on_robot` | 0 without map, obstacles and points |
| 29 | `obstacle_force_on_agents` | undefined if a sample has no people (ZeroDivisionError) |
| 30 | `danger_fear_cost` | sum over i, a with C V > 0 of \|V\|/d |
| 31 | `danger_panic_cost` | sum over i, a with C V > 0 of \|V\|/((m - R) sigma), sigma = abs(cross(C, V))/(d \|V\|), m = d sigma, if m > R and sigma > 1e-6 |
| 32 | `surprise_visibility_cost` | D = d; a person with theta = 0 does not see the robot; only cells of the map block the view, and their indices are truncated towards 0; the other parameters of surprise have no effect. A column from -1 to minus the width, or row from -1 to minus the height, counts from the far end; undefined if a line, up to its first cell that blocks, meets a cell beyond that (IndexError) |
| 33, 34 | `surprise_shock_cost`, `surprise_react_cost` | 0 with any parameters; undefined for N = 1, or where 32 is undefined (IndexError) |
| 30-34 | | undefined if a sample has more people than the first one (IndexError); 32-34 also without map |
| - | `completed`, `success` | by the last sample: \|p - g\| - radius of g < `goal_tolerance` for some goal g; `timeout` by T of the record |
| - | `stl` | T instead of the time of arrival |
)";

std::string listOf(const std::vector<MetricInfo>& infos) {
  std::string text;
  for (const MetricInfo& info : infos) {
    text += "- `" + info.key + "`: " + info.name + " [" + info.unit + "], " + info.formula + "; " +
            info.range + ", " + betterName(info.better) + " is better, source: " + info.source +
            "\n";
  }
  return text;
}

constexpr char kEffects[] =
    "\n## Effects of the robot on people\n\nOnly with `run --counterfactual`: the run compared "
    "with "
    "a run of the same seed without robots. Lengths and\ntimes up to the last goal that both have "
    "in common; `counterfactual.csv` has them per person.\n\n";

constexpr char kPlanning[] =
    "\n## Wall-clock metrics\n\nThey differ from run to run, so they are in the table that `run` "
    "prints and in `manifest.json` (`null`\nwithout robot), not among the metrics, which depend "
    "only on the record.\n\n";

}  // namespace

std::string metricsMarkdown(const MetricRegistry& registry) {
  std::string text = kIntroduction;
  for (int category = 0; category < kCategories; ++category) {
    text += categoryTable(registry, static_cast<Category>(category));
  }
  return text + kOriginal + kEffects + listOf(effectInfos()) + kPlanning +
         listOf(planningTimeInfos()) + parameterTable();
}

}  // namespace metrics
