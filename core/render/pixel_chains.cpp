#include "core/render/pixel_chains.h"

#include <tuple>

namespace lentray::core {
namespace {

/// A pixel is visited after all that change its upper neighbour: it and those whose left neighbour it is.
std::size_t lag_of(const PixelChain& chain) {
  std::size_t most = 0;
  for (std::size_t i = 0; i < chain.columns.size(); ++i) {
    if (chain.left[i] != PixelChain::kOutside) most = std::max(most, i - chain.left[i]);
  }
  for (std::size_t i = 0; i < chain.ahead.size(); ++i) {
    most = std::max(most, chain.columns.size() + i - chain.ahead[i].first);
  }
  return most + 1;
}

}  // namespace

std::vector<PixelChain> chains_of_tile(const PixelLattice& lattice, std::uint32_t begin,
                                       std::uint32_t end) {
  std::vector<PixelChain> chains;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> at(end - begin);  // chain, place in it
  for (std::uint32_t k = begin; k < lattice.width(); ++k) {
    const std::int32_t left = lattice.left[k];
    const bool joins = left >= static_cast<std::int32_t>(begin);
    if (k >= end) {
      if (left >= static_cast<std::int32_t>(end)) break;
      if (!joins) continue;
      const auto& [chain, place] = at[static_cast<std::uint32_t>(left) - begin];
      chains[chain].ahead.emplace_back(place, k);
      continue;
    }
    std::uint32_t chain = static_cast<std::uint32_t>(chains.size());
    std::uint32_t neighbour = PixelChain::kOutside;
    if (joins) {
      std::tie(chain, neighbour) = at[static_cast<std::uint32_t>(left) - begin];
    } else {
      chains.emplace_back();
    }
    at[k - begin] = {chain, static_cast<std::uint32_t>(chains[chain].columns.size())};
    chains[chain].columns.push_back(k);
    chains[chain].left.push_back(neighbour);
  }
  for (PixelChain& chain : chains) chain.lag = lag_of(chain);
  return chains;
}

}  // namespace lentray::core
