#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include <Eigen/Core>

/// Minimisation without derivatives: covariance matrix adaptation evolution strategy (CMA-ES).
/// N. Hansen, The CMA Evolution Strategy: A Tutorial, arXiv:1604.00772; equation numbers refer to
/// it.
namespace app {

using Point = std::vector<double>;

/// One run of the CMA-ES with ask and tell, with weighted recombination, cumulative step-size
/// adaptation and rank-one and rank-mu updates, also with negative weights (active CMA, the default
/// of the tutorial). Only the order of the values matters, except for the stop criteria. Equal
/// options and values give equal points. One thread.
class CmaEs {
 public:
  struct Options {
    Point start;         // initial mean
    double sigma = 0.3;  // initial standard deviation of all coordinates, > 0
    int population = 0;  // points per generation, >= 2; 0: 4 + 3 ln n
    std::uint64_t seed = 1;
    int run = 0;  // distinguishes runs of one seed
  };

  explicit CmaEs(const Options& options);

  /// The points of the next generation. Calls without tell() in between return the same points.
  const std::vector<Point>& ask();
  /// The values of these points, smaller ones are better; infinity is allowed, NaN counts as
  /// infinity. Updates the distribution.
  void tell(const std::vector<double>& values);

  int population() const { return lambda_; }
  int generation() const { return generation_; }
  double sigma() const { return sigma_; }
  double selectionMass() const { return muEff_; }  // variance effective selection mass
  /// The mean of the distribution: with noise the best estimate of the optimum.
  Point mean() const;
  /// Standard deviations of the coordinates, step size included.
  Point deviations() const;
  /// Why the run should end (appendix B.3 of the tutorial: no effect on an axis or a coordinate,
  /// equal function values, condition of the covariance matrix, TolFun 1e-12, TolX 1e-12 of the
  /// first step size, TolXUp 1e4); empty: it should continue.
  std::string reasonToStop() const;

 private:
  using Vector = Eigen::VectorXd;
  using Matrix = Eigen::MatrixXd;

  void setWeights();
  void sample();
  std::vector<std::size_t> ranking(const std::vector<double>& values) const;
  void updateMean(const std::vector<std::size_t>& order);
  void updateCovariance(const std::vector<std::size_t>& order);
  void decompose();
  void note(const std::vector<double>& values);
  bool hasNoEffect() const;
  std::size_t historyLength() const;

  int n_;
  int lambda_;
  std::uint64_t seed_;
  int run_;
  double firstSigma_;
  // Selection and adaptation (table 1 of the tutorial).
  Vector weights_;  // the negative ones last
  int mu_ = 1;
  double muEff_ = 1.0, cSigma_ = 0.0, dSigma_ = 1.0, cc_ = 0.0, c1_ = 0.0, cMu_ = 0.0, chiN_ = 1.0;
  // State.
  int generation_ = 0;
  double sigma_;
  Vector mean_, pathC_, pathSigma_;
  Matrix covariance_, axes_;   // C; B
  Vector scales_;              // D: square roots of the eigenvalues
  int decomposed_ = 0;         // generation of B and D
  Vector step_;                // weighted mean of the selected steps, without step size
  std::vector<Vector> steps_;  // y of the points of this generation
  std::vector<Point> points_;
  std::deque<double> bestValues_;  // of the last generations
  double generationSpread_ = 0.0;  // of the values of the last generation
};

/// Keeps the CMA-ES in the box [0, 1]^n: points are evaluated at the nearest point of the box, and
/// a penalty grows with their squared distance to it. Its weights come from the spread of the
/// values and grow while the mean is far outside (Hansen, Niederberger, Guzzella & Koumoutsakos
/// 2009, IEEE Transactions on Evolutionary Computation 13, section IV.B; here from the first
/// generation on, not only once the mean has left the box).
class BoxPenalty {
 public:
  explicit BoxPenalty(std::size_t dimensions) : weights_(dimensions, 0.0) {}

  /// Adapts the weights to a generation: `values` of its points in the box, not yet penalised.
  void adapt(const CmaEs& cma, const std::vector<double>& values);
  /// The penalty of a point that was sampled from this distribution.
  double of(const Point& point, const CmaEs& cma) const;

 private:
  std::vector<double> weights_;
  std::deque<double> spreads_;  // interquartile ranges of the values of the last generations
  bool isActive_ = false;
};

/// The nearest point of the box [0, 1]^n.
Point nearestInBox(const Point& point);

/// CMA-ES in the box [0, 1]^n with restarts: each one starts at a random point with twice the
/// population (IPOP; Auger & Hansen 2005, CEC, "A restart CMA evolution strategy with increasing
/// population size").
class RestartedCmaEs {
 public:
  struct Options {
    Point start;                 // of the first run, in the box; empty: random
    std::size_t dimensions = 1;  // without a start
    double sigma = 0.3;          // of all runs
    int population = 0;          // of the first run; 0: 4 + 3 ln n
    double growth = 2.0;         // of the population per restart
    std::uint64_t seed = 1;
  };

  explicit RestartedCmaEs(Options options);

  /// Points in the box; restarts first if the current run has ended.
  const std::vector<Point>& ask();
  void tell(const std::vector<double>& values);

  int restarts() const { return run_; }
  std::size_t evaluations() const { return evaluations_; }
  const CmaEs& current() const { return cma_; }
  Point mean() const { return nearestInBox(cma_.mean()); }
  const Point& best() const { return best_; }  // point with the least value so far
  double bestValue() const { return bestValue_; }

 private:
  CmaEs::Options optionsOf(int run) const;

  Options options_;
  int run_ = 0;
  CmaEs cma_;
  BoxPenalty penalty_;
  std::vector<Point> points_;
  std::size_t evaluations_ = 0;
  Point best_;
  double bestValue_;
};

}  // namespace app
