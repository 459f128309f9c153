// An object that rays meet only where they pass through every one of some regions: `bounded_by` in SDL.
// World space. Immutable while rendering. Source: reference manual 3.7, "Bounded By".
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "core/object/object.h"

namespace lentray::core {

/// A ray that misses a gate, and does not begin inside it, misses the content. One that meets all of them
/// shows the content beyond them, too. What is inside the content does not depend on them.
class Gated final : public Object {
 public:
  /// Has the content's material; those of its surfaces are the content's.
  Gated(std::unique_ptr<Object> content, Regions gates);
  std::string_view name() const override { return m_content->name(); }
  /// Where the content's are infinite, the gates': these may hold less than is seen through them.
  Bounds bounds() const override;
  Bounds solid_bounds() const override { return m_content->solid_bounds(); }
  Bounds void_bounds() const override { return m_content->void_bounds(); }
  Ball solid_ball() const override { return m_content->solid_ball(); }
  bool nearest(const Ray&, double t_min, double t_max, Hit&, const RayQuery&) const override;
  void all(const Ray&, double t_min, double t_max, std::vector<Hit>&,
           const RayQuery&) const override;
  bool any(const Ray&, double t_min, double t_max, const RayQuery&) const override;
  bool inside(const Vec3& p) const override { return m_content->inside(p); }
  void leaves(std::vector<const Leaf*>& out) const override { m_content->leaves(out); }
  void set_inverse(bool inverse) override;

  Object& content() const { return *m_content; }
  const Regions& gates() const { return m_gates; }

 private:
  bool lets_pass(const Ray& ray, const RayQuery& query) const;
  void take_after_content();

  std::unique_ptr<Object> m_content;
  Regions m_gates;
};

/// The content of a Gated, or the object itself.
Object& ungated(Object& object);

}  // namespace lentray::core
