#include "app/studies/CmaEs.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <Eigen/Eigenvalues>

#include "sim2d/base/Rng.h"

namespace app {

namespace {

constexpr double kTolerance = 1e-12;    // TolFun, TolX
constexpr double kMaxGrowth = 1e4;      // TolXUp
constexpr double kMaxCondition = 1e14;  // of the covariance matrix

Eigen::VectorXd vectorOf(const Point& point) {
  return Eigen::Map<const Eigen::VectorXd>(point.data(), static_cast<Eigen::Index>(point.size()));
}

Point pointOf(const Eigen::VectorXd& vector) {
  return {vector.data(), vector.data() + vector.size()};
}

int populationOf(const CmaEs::Options& options) {
  const double n = static_cast<double>(options.start.size());
  return options.population > 0 ? std::max(2, options.population)
                                : 4 + static_cast<int>(std::floor(3.0 * std::log(n)));
}

double spread(const std::deque<double>& values) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return values.empty() || *least == *most ? 0.0 : *most - *least;
}

double sumOf(const Eigen::VectorXd& weights, int first, int last) {
  return weights.segment(first, last - first).sum();
}

double medianOf(const std::deque<double>& values) {
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  return sorted.empty() ? 0.0 : sorted[sorted.size() / 2];
}

/// Zero unless the quartiles are finite.
double interquartileRange(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const double range = values[3 * values.size() / 4] - values[values.size() / 4];
  return std::isfinite(range) ? range : 0.0;
}

/// Variance effective selection mass of these weights.
double effectiveMass(const Eigen::VectorXd& weights, int first, int last) {
  const double sum = sumOf(weights, first, last);
  const double squares = weights.segment(first, last - first).squaredNorm();
  return squares > 0.0 ? sum * sum / squares : 0.0;
}

}  // namespace

CmaEs::CmaEs(const Options& options)
    : n_(static_cast<int>(options.start.size())),
      lambda_(populationOf(options)),
      seed_(options.seed),
      run_(options.run),
      firstSigma_(options.sigma),
      sigma_(options.sigma),
      mean_(vectorOf(options.start)),
      pathC_(Vector::Zero(n_)),
      pathSigma_(Vector::Zero(n_)),
      covariance_(Matrix::Identity(n_, n_)),
      axes_(Matrix::Identity(n_, n_)),
      scales_(Vector::Ones(n_)) {
  assert(n_ > 0 && sigma_ > 0.0);
  setWeights();
}

/// Equations (49) to (58).
void CmaEs::setWeights() {
  const double n = n_;
  weights_.resize(lambda_);
  for (int k = 0; k < lambda_; ++k) {
    weights_[k] = std::log((lambda_ + 1.0) / 2.0) - std::log(k + 1.0);
  }
  mu_ = lambda_ / 2;
  muEff_ = effectiveMass(weights_, 0, mu_);
  const double muEffNegative = effectiveMass(weights_, mu_, lambda_);
  cSigma_ = (muEff_ + 2.0) / (n + muEff_ + 5.0);
  dSigma_ = 1.0 + 2.0 * std::max(0.0, std::sqrt((muEff_ - 1.0) / (n + 1.0)) - 1.0) + cSigma_;
  cc_ = (4.0 + muEff_ / n) / (n + 4.0 + 2.0 * muEff_ / n);
  c1_ = 2.0 / ((n + 1.3) * (n + 1.3) + muEff_);
  cMu_ = std::min(1.0 - c1_,
                  2.0 * (0.25 + muEff_ + 1.0 / muEff_ - 2.0) / ((n + 2.0) * (n + 2.0) + muEff_));
  chiN_ = std::sqrt(n) * (1.0 - 1.0 / (4.0 * n) + 1.0 / (21.0 * n * n));
  const double positive = sumOf(weights_, 0, mu_);
  const double negative = -weights_.cwiseMin(0.0).sum();
  const double limit = std::min({1.0 + c1_ / cMu_, 1.0 + 2.0 * muEffNegative / (muEff_ + 2.0),
                                 (1.0 - c1_ - cMu_) / (n * cMu_)});
  for (double& weight : weights_) {
    weight = weight >= 0.0 ? weight / positive : negative > 0.0 ? weight * limit / negative : 0.0;
  }
}

/// Equations (38) to (40).
void CmaEs::sample() {
  steps_.clear();
  points_.clear();
  const base::AgentRng random(seed_, run_, static_cast<std::uint64_t>(generation_));
  for (int k = 0; k < lambda_; ++k) {
    Vector z(n_);
    for (int d = 0; d < n_; ++d) {
      z[d] = random.normal(0.0, 1.0, base::DrawPurpose::Optimizer,
                           static_cast<std::uint32_t>(k * n_ + d));
    }
    steps_.emplace_back(axes_ * scales_.cwiseProduct(z));
    points_.push_back(pointOf(mean_ + sigma_ * steps_.back()));
  }
}

const std::vector<Point>& CmaEs::ask() {
  if (points_.empty()) {
    sample();
  }
  return points_;
}

/// Indices of the points, the best first; points with equal values keep their order.
std::vector<std::size_t> CmaEs::ranking(const std::vector<double>& values) const {
  const auto comparable = [](double value) {
    return std::isnan(value) ? std::numeric_limits<double>::infinity() : value;
  };
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return comparable(values[a]) < comparable(values[b]);
  });
  return order;
}

void CmaEs::tell(const std::vector<double>& values) {
  assert(values.size() == ask().size());
  ask();
  const std::vector<std::size_t> order = ranking(values);
  updateMean(order);
  updateCovariance(order);
  std::vector<double> sorted;
  sorted.reserve(order.size());
  for (const std::size_t k : order) {
    sorted.push_back(values[k]);
  }
  note(sorted);
  ++generation_;
  points_.clear();
  if (generation_ - decomposed_ > 0.1 / ((c1_ + cMu_) * n_)) {
    decompose();
  }
}

/// Mean, path and step size: equations (41) to (44).
void CmaEs::updateMean(const std::vector<std::size_t>& order) {
  step_ = Vector::Zero(n_);
  for (int k = 0; k < mu_; ++k) {
    step_ += weights_[k] * steps_[order[static_cast<std::size_t>(k)]];
  }
  mean_ += sigma_ * step_;
  const Vector whitened = axes_ * (axes_.transpose() * step_).cwiseQuotient(scales_);  // C^(-1/2) y
  pathSigma_ =
      (1.0 - cSigma_) * pathSigma_ + std::sqrt(cSigma_ * (2.0 - cSigma_) * muEff_) * whitened;
}

/// Equations (45) to (47), then the step size (44).
void CmaEs::updateCovariance(const std::vector<std::size_t>& order) {
  const double decay = 1.0 - std::pow(1.0 - cSigma_, 2.0 * (generation_ + 1));
  const bool isSlow =
      pathSigma_.norm() / std::sqrt(decay) < (1.4 + 2.0 / (n_ + 1.0)) * chiN_;  // h_sigma
  pathC_ = (1.0 - cc_) * pathC_;
  if (isSlow) {
    pathC_ += std::sqrt(cc_ * (2.0 - cc_) * muEff_) * step_;
  }
  const double missing = isSlow ? 0.0 : cc_ * (2.0 - cc_);
  Matrix next = (1.0 + c1_ * missing - c1_ - cMu_ * weights_.sum()) * covariance_ +
                c1_ * pathC_ * pathC_.transpose();
  for (int k = 0; k < lambda_; ++k) {
    const Vector& y = steps_[order[static_cast<std::size_t>(k)]];
    double weight = weights_[k];
    if (weight < 0.0) {
      weight *= n_ / (axes_.transpose() * y).cwiseQuotient(scales_).squaredNorm();
    }
    next += cMu_ * weight * y * y.transpose();
  }
  covariance_ = (next + next.transpose()) / 2.0;
  sigma_ *= std::exp(std::min(1.0, cSigma_ / dSigma_ * (pathSigma_.norm() / chiN_ - 1.0)));
}

void CmaEs::decompose() {
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(covariance_);
  axes_ = solver.eigenvectors();
  scales_ = solver.eigenvalues().cwiseMax(std::numeric_limits<double>::min()).cwiseSqrt();
  decomposed_ = generation_;
}

std::size_t CmaEs::historyLength() const {
  return 10 + static_cast<std::size_t>(std::ceil(30.0 * n_ / lambda_));
}

/// `sorted`: values of a generation, the best first.
void CmaEs::note(const std::vector<double>& sorted) {
  bestValues_.push_back(sorted.front());
  if (bestValues_.size() > historyLength()) {
    bestValues_.pop_front();
  }
  generationSpread_ = sorted.front() == sorted.back() ? 0.0 : sorted.back() - sorted.front();
}

/// Adding 0.1 standard deviations along an axis, or 0.2 in a coordinate, does not change the mean.
bool CmaEs::hasNoEffect() const {
  const int axis = generation_ % n_;
  const Vector along = 0.1 * sigma_ * scales_[axis] * axes_.col(axis);
  bool isUnchanged = true, hasFixedCoordinate = false;
  for (int d = 0; d < n_; ++d) {
    isUnchanged = isUnchanged && mean_[d] + along[d] == mean_[d];
    const double across = 0.2 * sigma_ * std::sqrt(covariance_(d, d));
    hasFixedCoordinate = hasFixedCoordinate || mean_[d] + across == mean_[d];
  }
  return isUnchanged || hasFixedCoordinate;
}

std::string CmaEs::reasonToStop() const {
  if (generation_ == 0) {
    return {};
  }
  const bool hasFullHistory = bestValues_.size() >= historyLength();
  if (hasFullHistory && std::max(spread(bestValues_), generationSpread_) <= kTolerance) {
    return "equal function values";
  }
  if (scales_.maxCoeff() > std::sqrt(kMaxCondition) * scales_.minCoeff()) {
    return "condition of the covariance matrix";
  }
  const double largest = sigma_ * std::sqrt(covariance_.diagonal().maxCoeff());
  if (std::max(largest, sigma_ * pathC_.cwiseAbs().maxCoeff()) < kTolerance * firstSigma_) {
    return "step size";
  }
  if (sigma_ * scales_.maxCoeff() > kMaxGrowth * firstSigma_) {
    return "divergence";
  }
  return hasNoEffect() ? "no effect of a step" : "";
}

Point CmaEs::mean() const {
  return pointOf(mean_);
}

Point CmaEs::deviations() const {
  return pointOf(sigma_ * covariance_.diagonal().cwiseSqrt());
}

Point nearestInBox(const Point& point) {
  Point inside = point;
  for (double& value : inside) {
    value = std::clamp(value, 0.0, 1.0);
  }
  return inside;
}

void BoxPenalty::adapt(const CmaEs& cma, const std::vector<double>& values) {
  const std::size_t n = weights_.size();
  spreads_.push_back(interquartileRange(values));
  if (spreads_.size() > 20 + 3 * n / values.size()) {
    spreads_.pop_front();
  }
  const Point mean = cma.mean(), deviations = cma.deviations();
  if (!isActive_) {
    double squares = 0.0;
    for (const double deviation : deviations) {
      squares += deviation * deviation / static_cast<double>(n);
    }
    std::fill(weights_.begin(), weights_.end(), 2.0 * medianOf(spreads_) / squares);
    isActive_ = medianOf(spreads_) > 0.0;
  }
  const double mass = cma.selectionMass(), size = static_cast<double>(n);
  const double factor = std::pow(1.1, std::min(1.0, mass / (10.0 * size)));
  for (std::size_t d = 0; d < n; ++d) {
    const double distance = std::max({-mean[d], mean[d] - 1.0, 0.0});
    if (distance > 3.0 * deviations[d] * std::max(1.0, std::sqrt(size) / mass)) {
      weights_[d] *= factor;
    }
  }
}

double BoxPenalty::of(const Point& point, const CmaEs& cma) const {
  const Point inside = nearestInBox(point), deviations = cma.deviations();
  const double size = static_cast<double>(point.size());
  double meanLog = 0.0;
  for (const double deviation : deviations) {
    meanLog += 2.0 * std::log(deviation) / size;
  }
  double sum = 0.0;
  for (std::size_t d = 0; d < point.size(); ++d) {
    const double distance = point[d] - inside[d];
    const double scale = std::exp(0.9 * (2.0 * std::log(deviations[d]) - meanLog));
    sum += weights_[d] * distance * distance / scale / size;
  }
  return sum;
}

CmaEs::Options RestartedCmaEs::optionsOf(int run) const {
  CmaEs::Options of;
  of.sigma = options_.sigma;
  of.seed = options_.seed;
  of.run = run;
  Point start = options_.start;
  if (run > 0 || start.empty()) {
    const base::AgentRng random(options_.seed, run);
    start.resize(start.empty() ? options_.dimensions : start.size());
    for (std::size_t d = 0; d < start.size(); ++d) {
      start[d] = random.uniform01(base::DrawPurpose::Restart, static_cast<std::uint32_t>(d));
    }
  }
  of.start = start;
  of.population = static_cast<int>(std::lround(
      populationOf({start, 1.0, options_.population, 1, 0}) * std::pow(options_.growth, run)));
  return of;
}

RestartedCmaEs::RestartedCmaEs(Options options)
    : options_(std::move(options)),
      cma_(optionsOf(0)),
      penalty_(cma_.mean().size()),
      bestValue_(std::numeric_limits<double>::infinity()) {}

const std::vector<Point>& RestartedCmaEs::ask() {
  if (points_.empty()) {
    if (!cma_.reasonToStop().empty()) {
      cma_ = CmaEs(optionsOf(++run_));
      penalty_ = BoxPenalty(cma_.mean().size());
    }
    for (const Point& point : cma_.ask()) {
      points_.push_back(nearestInBox(point));
    }
  }
  return points_;
}

void RestartedCmaEs::tell(const std::vector<double>& values) {
  ask();
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (best_.empty() || values[k] < bestValue_) {
      best_ = points_[k];
      bestValue_ = values[k];
    }
  }
  evaluations_ += values.size();
  penalty_.adapt(cma_, values);
  std::vector<double> penalised = values;
  for (std::size_t k = 0; k < values.size(); ++k) {
    penalised[k] += penalty_.of(cma_.ask()[k], cma_);
  }
  cma_.tell(penalised);
  points_.clear();
}

}  // namespace app
