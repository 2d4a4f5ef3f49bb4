#pragma once

#include <array>
#include <vector>

/// The update of MPPI in its information-theoretic form (Williams, Aldrich & Theodorou 2017, "Model
/// predictive path integral control: from theory to parallel computation"; Williams et al. 2017,
/// "Information theoretic MPC for model-based reinforcement learning", algorithm 1). Thread: any.
namespace sim2d {

/// w_k = exp(-(S_k - min S) / temperature), normalised to the sum 1; the first `count` costs must
/// be finite. Weights below e^-30 of the largest become 0.
void mppiWeights(const float* costs, int count, double temperature, float* weights);

/// Cost per unit of a step's fresh noise. The theory adds gamma u' Sigma^-1 epsilon to the cost of
/// u + epsilon, gamma = temperature (1 - alpha). Here the noise of one axis is epsilon = sigma L n
/// with n white, epsilon_t = keep epsilon_(t-1) + fresh sigma n_t; so u' Sigma^-1 epsilon = (L^-1 u
/// / sigma)' n, and L^-1 u is u_0, then (u_t - keep u_(t-1)) / fresh.
void mppiControlCost(const std::vector<float>& mean, double gamma, double deviation, double keep,
                     std::vector<float>& pull);

/// The filter of Savitzky & Golay 1964: at each step the least-squares quadratic over nine steps,
/// or with `order` 1 their mean. `sent`: the last four commands before the first step, oldest
/// first; the last step is repeated beyond the end.
std::vector<float> savitzkyGolay(const std::vector<float>& sequence,
                                 const std::array<float, 4>& sent, int order = 2);

/// The sequence shifted by `steps` >= 0, interpolated linearly, with the last value held.
std::vector<float> shifted(const std::vector<float>& sequence, double steps);

}  // namespace sim2d
