// Notes what surfaces ask instead of answering: a ray can then be traced before it is known what light its
// surfaces get. Of a gather's ray that light is added later, by the shares it has in the first surface's;
// a ray that goes on from there and asks again must be traced anew. World space. One a thread.
#pragma once

#include <vector>

#include "core/trace/gather_ray.h"
#include "core/trace/indirect_light.h"
#include "core/trace/sample_lookup.h"

namespace lentray::core {

struct RecordedQuery {
  IndirectQuery query;
  Rgb share;         ///< of the answer in the ray's light
  EarlyReuse early;  ///< the samples that it would be answered with
};

/// What a ray brings without indirect light, and what it asked.
struct GatherRecord {
  GatheredRay seen;
  std::vector<RecordedQuery> queries;
  bool is_whole = true;  ///< false: the shares are not all
};

class QueryRecorder final : public IndirectLight {
 public:
  /// What follows goes there, behind what is there; `wanted`: whether surfaces are to ask at all;
  /// `lookup`: for samples that serve what they ask, or null.
  void record_to(GatherRecord& record, bool wanted, const SampleLookup* lookup = nullptr) {
    m_record = &record;
    m_wanted = wanted;
    m_lookup = lookup;
    record.queries.clear();
    record.is_whole = true;
  }
  void begin(Pixel, bool, std::uint64_t) override {}
  bool is_wanted() const override { return m_wanted; }
  IndirectAnswer at(const IndirectQuery& query) override {
    m_record->queries.push_back(
        {query, Rgb(), m_lookup ? m_lookup->find_early(query) : EarlyReuse()});
    return {Rgb(), static_cast<std::uint32_t>(m_record->queries.size() - 1)};
  }
  void take_share(std::uint32_t number, const Rgb& share, bool is_first) override {
    m_record->queries[number].share += share;
    if (!is_first) m_record->is_whole = false;
  }

 private:
  GatherRecord* m_record = nullptr;
  const SampleLookup* m_lookup = nullptr;
  bool m_wanted = false;
};

}  // namespace lentray::core
