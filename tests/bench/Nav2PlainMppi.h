#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

#include "tests/nav/Nav2MppiScenes.h"

/// A cycle of Nav2's MPPI (Jazzy, differential drive, critics of the bringup, each asked) as one
/// would write it without vectors: single precision, one trajectory after the other, nothing
/// allocated on the way, libm's sine and cosine. What the vector code is measured against.
class Nav2PlainMppi {
 public:
  using HandScene = nav2test::HandScene;

  Nav2PlainMppi(const sim2d::nav2::MppiConfiguration& mppi, const HandScene& scene)
      : mppi_(mppi),
        scene_(scene),
        samples_(static_cast<std::size_t>(mppi.settings.batchSize)),
        steps_(static_cast<std::size_t>(mppi.settings.timeSteps)),
        dt_(single(mppi.settings.modelDt)) {
    for (std::vector<float>* column :
         {&vxNoise, &wzNoise, &cvx_, &cwz_, &vx_, &wz_, &x_, &y_, &yaw_}) {
      column->assign(samples_ * steps_, 0.0F);
    }
    costs.assign(samples_, 0.0F);
    vxMean.assign(steps_, 0.0F);
    wzMean.assign(steps_, 0.0F);
    for (const sim2d::nav2::Pose2& pose : scene.path) {
      pathX_.push_back(single(pose.position.x()));
      pathY_.push_back(single(pose.position.y()));
      const std::size_t i = pathX_.size() - 1;
      way_.push_back(i == 0 ? 0.0F : way_[i - 1] + gap(i, pathX_[i - 1], pathY_[i - 1]));
      const auto cell = scene.costmap.worldToCell(pose.position);
      valid_.push_back(cell && scene.costmap.at(*cell) < 253);
    }
  }

  /// As Nav2 draws: the library's generator and its normal distribution.
  void drawNoise() {
    std::normal_distribution<float> vx(0.0F, single(mppi_.settings.vxStd));
    std::normal_distribution<float> wz(0.0F, single(mppi_.settings.wzStd));
    std::generate(vxNoise.begin(), vxNoise.end(), [&] { return vx(generator_); });
    std::generate(wzNoise.begin(), wzNoise.end(), [&] { return wz(generator_); });
  }

  void cycle() {
    for (std::size_t k = 0; k < samples_; ++k) {
      roll(k * steps_);
    }
    findFurthest();
    for (std::size_t k = 0; k < samples_; ++k) {
      costs[k] = costOf(k * steps_);
    }
    update();
  }

  std::vector<float> vxNoise, wzNoise;  // sample by sample
  std::vector<float> vxMean, wzMean, costs;

 private:
  static float single(double value) { return static_cast<float>(value); }
  float gap(std::size_t point, float x, float y) const {
    const float dx = pathX_[point] - x;
    const float dy = pathY_[point] - y;
    return std::sqrt(dx * dx + dy * dy);
  }
  static float reach(float wanted, float now, float least, float most) {
    return now > 0.0F ? std::min(std::max(wanted, now + least), now + most)
                      : std::min(std::max(wanted, now - most), now - least);
  }

  void roll(std::size_t from) {
    const auto& set = mppi_.settings;
    const float most = dt_ * single(set.axMax);
    const float least = dt_ * single(set.axMin);
    const float turn = dt_ * single(set.azMax);
    float x = single(scene_.robot.position.x());
    float y = single(scene_.robot.position.y());
    float yaw = single(scene_.robot.heading);
    vx_[from] = single(scene_.speed.linear);
    wz_[from] = single(scene_.speed.angular);
    for (std::size_t i = 0; i < steps_; ++i) {
      const std::size_t at = from + i;
      cvx_[at] = vxMean[i] + vxNoise[at];
      cwz_[at] = wzMean[i] + wzNoise[at];
      if (i > 0) {
        vx_[at] = cvx_[at - 1] = reach(cvx_[at - 1], vx_[at - 1], least, most);
        wz_[at] = cwz_[at - 1] = reach(cwz_[at - 1], wz_[at - 1], -turn, turn);
      }
      x_[at] = x += vx_[at] * std::cos(yaw) * dt_;
      y_[at] = y += vx_[at] * std::sin(yaw) * dt_;
      yaw_[at] = yaw += wz_[at] * dt_;
    }
  }

  void findFurthest() {
    furthest_ = 0;
    for (std::size_t k = 0; k < samples_; ++k) {
      const std::size_t end = k * steps_ + steps_ - 1;
      std::size_t best = 0;
      float least = std::numeric_limits<float>::max();
      for (std::size_t i = 0; i < pathX_.size(); ++i) {
        const float dx = pathX_[i] - x_[end];
        const float dy = pathY_[i] - y_[end];
        const float distance2 = dx * dx + dy * dy;
        if (distance2 < least) {
          least = distance2;
          best = i;
        }
      }
      furthest_ = std::max(furthest_, best);
    }
  }

  float costOf(std::size_t from) const {
    const auto& set = mppi_.settings;
    const auto& critics = mppi_.critics;
    const std::size_t end = from + steps_ - 1;
    const float high = single(std::hypot(set.vxMax, set.vyMax));  // so before Lyrical
    const float low = -single(std::hypot(set.vxMin, set.vyMax));
    float excess = 0.0F;
    float back = 0.0F;
    for (std::size_t at = from; at <= end; ++at) {
      excess += std::max(0.0F, vx_[at] - high) + std::max(0.0F, low - vx_[at]);
      back += std::max(0.0F, -vx_[at]);
    }
    const std::size_t last = pathX_.size() - 1;
    std::size_t point =
        std::min(furthest_ + static_cast<std::size_t>(critics.pathFollow.offsetFromFurthest), last);
    while (point + 1 < last && !valid_[point]) {
      ++point;
    }
    const std::size_t ahead =
        std::min(furthest_ + static_cast<std::size_t>(critics.pathAngle.offsetFromFurthest), last);
    const float direction = std::atan2(pathY_[ahead] - y_[end], pathX_[ahead] - x_[end]);
    const float turn = std::remainder(direction - yaw_[end], single(2.0 * M_PI));
    return single(critics.constraint.weight) * excess * dt_ +
           single(critics.cost.weight / 254.0) * collision(from) +
           single(critics.pathAlign.weight) * align(from) +
           single(critics.pathFollow.weight) * gap(point, x_[end], y_[end]) +
           single(critics.pathAngle.weight) * std::fabs(turn) +
           single(critics.preferForward.weight) * back * dt_;
  }

  float collision(std::size_t from) const {
    const auto& costmap = scene_.costmap;
    const float left = single(costmap.origin().x());
    const float low = single(costmap.origin().y());
    const float resolution = single(costmap.resolution());
    float sum = 0.0F;
    float count = 0.0F;
    bool hits = false;
    for (std::size_t i = 0; i < steps_ && !hits; i += 2) {
      const float column = (x_[from + i] - left) / resolution;
      const float row = (y_[from + i] - low) / resolution;
      const bool isOn = column >= 0.0F && row >= 0.0F && column < single(costmap.width()) &&
                        row < single(costmap.height());
      const int cost = isOn ? costmap.at({static_cast<int>(column), static_cast<int>(row)}) : 255;
      hits = cost >= 253;
      sum += single(cost);
      count += 1.0F;
    }
    return hits ? 1e6F / single(static_cast<double>((steps_ + 1) / 2)) : sum / count;
  }

  float align(std::size_t from) const {
    float driven = 0.0F;
    float sum = 0.0F;
    float count = 0.0F;
    std::size_t at = 0;
    for (std::size_t i = 4; i < steps_; i += 4) {
      const float dx = x_[from + i] - x_[from + i - 4];
      const float dy = y_[from + i] - y_[from + i - 4];
      driven += std::sqrt(dx * dx + dy * dy);
      while (at + 1 < furthest_ && way_[at + 1] <= driven) {
        ++at;
      }
      if (at + 1 < furthest_ && driven - way_[at] >= way_[at + 1] - driven) {
        ++at;
      }
      if (valid_[at]) {
        sum += gap(at, x_[from + i], y_[from + i]);
        count += 1.0F;
      }
    }
    return count > 0.0F ? sum / count : 0.0F;
  }

  void update() {
    const auto& set = mppi_.settings;
    const float vxPull = single(set.gamma / (set.vxStd * set.vxStd));
    const float wzPull = single(set.gamma / (set.wzStd * set.wzStd));
    for (std::size_t k = 0; k < samples_; ++k) {
      float vx = 0.0F;
      float wz = 0.0F;
      for (std::size_t i = 0; i < steps_; ++i) {
        vx += vxMean[i] * (cvx_[k * steps_ + i] - vxMean[i]);
        wz += wzMean[i] * (cwz_[k * steps_ + i] - wzMean[i]);
      }
      costs[k] += vxPull * vx + wzPull * wz;
    }
    const float least = *std::min_element(costs.begin(), costs.end());
    float total = 0.0F;
    vxMean.assign(steps_, 0.0F);
    wzMean.assign(steps_, 0.0F);
    for (std::size_t k = 0; k < samples_; ++k) {
      const float weight = std::exp((least - costs[k]) / single(set.temperature));
      if (weight < 1e-13F) {  // and what is no normal float would take ten times as long
        continue;
      }
      total += weight;
      for (std::size_t i = 0; i < steps_; ++i) {
        vxMean[i] += weight * cvx_[k * steps_ + i];
        wzMean[i] += weight * cwz_[k * steps_ + i];
      }
    }
    for (std::size_t i = 0; i < steps_; ++i) {
      vxMean[i] /= total;
      wzMean[i] /= total;
    }
  }

  const sim2d::nav2::MppiConfiguration mppi_;
  const HandScene scene_;
  const std::size_t samples_, steps_;
  const float dt_;
  std::vector<float> cvx_, cwz_, vx_, wz_, x_, y_, yaw_;
  std::vector<float> pathX_, pathY_, way_;
  std::vector<bool> valid_;
  std::size_t furthest_ = 0;
  std::default_random_engine generator_;
};
