#include "stoss/table/adaptive_pairs.hpp"

#include <cstddef>
#include <vector>

#include "table/adaptive_grid.hpp"
#include "table/arguments.hpp"
#include "table/axes.hpp"
#include "table/computed_values.hpp"

namespace stoss {
namespace {

constexpr double share_of_pairs = 0.2, share_of_grid = 0.375;  // 1.25 × the first + 2 × the second = 1

}  // namespace

PairTable pair_table(const Mixture& mixture, double slowest, double fastest, double smallest, double largest,
                     const PairTableOptions& options) {
  require_speeds({slowest, fastest});
  require_options(options.error, options.most_values, options.threads, options.beyond);
  const TableRange range{{slowest, fastest}, held_ratios(mixture.alike, {smallest, largest}), true, mixture.alike};
  Contacts contacts(mixture.contact, range);
  AdaptiveGrid grid(range);
  grid.refine("pair_table", {share_of_grid * options.error}, options.most_values,
              [&](const std::vector<AdaptiveGrid::Place>& open) {
                std::vector<Request> requests;
                requests.reserve(open.size());
                for (const auto& [x, z, p] : open) requests.push_back({&contacts.at(p), range.speeds.speed(x)});
                const auto named = [&](std::size_t i) { return range.named(open[i][0], open[i][2]); };
                const std::vector<Estimate> found =
                    computed_values(requests, options.error, share_of_pairs, options.threads, options.poll, named);
                for (std::size_t i = 0; i < open.size(); ++i) grid.set(open[i], {found[i]});
              });
  return PairTable(grid.table(0), options.beyond);
}

}  // namespace stoss
