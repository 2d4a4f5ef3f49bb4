#pragma once

#include <array>
#include <vector>

/// The update of MPPI in its information-theoretic form (Williams, Aldrich & Theodorou 2017, "Model
/// predictive path integral control: from theory to parallel computation"; Williams et al. 2017,
/// "Information theoretic MPC for model-based reinforcement learning", algorithm 1). Thread: any.
namespace sim2d {

/// w_k = exp(-(S_k - min S) / temperature), scaled to the sum 1; costs below `count` are finite.
/// Samples that weigh less than e^-30 of the best have the weight 0.
void mppiWeights(const float* costs, int count, double temperature, float* weights);

/// Cost of a step's fresh noise, per unit. The theory adds gamma u' Sigma^-1 epsilon to the cost of
/// u + epsilon, gamma = temperature (1 - alpha). Our noise of one axis is epsilon = sigma L n with
/// n white, epsilon_t = keep epsilon_(t-1) + fresh sigma n_t; so u' Sigma^-1 epsilon = (L^-1 u /
/// sigma)' n, and L^-1 u is u_0, then (u_t - keep u_(t-1)) / fresh.
void mppiPull(const std::vector<float>& mean, double gamma, double deviation, double keep,
              std::vector<float>& pull);

/// The filter of Savitzky & Golay 1964: at each step the quadratic that fits nine of them best.
/// `sent`: the last four commands before the first step, latest last; the last step stands for
/// those behind it.
std::vector<float> savitzkyGolay(const std::vector<float>& sequence,
                                 const std::array<float, 4>& sent);

/// The sequence `steps` >= 0 later, linear between steps, the last one held.
std::vector<float> shifted(const std::vector<float>& sequence, double steps);

}  // namespace sim2d
