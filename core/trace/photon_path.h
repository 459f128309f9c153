// The way of a photon from its light: on to a target, through and off surfaces that send photons on, and
// what it leaves where it arrives. At each surface all of it is reflected and all of it refracted, by what
// the surface says; chance has no part. World space; power linear. One a thread.
// Source: reference manual 3.7, "Photons"; replays stock's files of photons
// (tests/image/photon_file_test.cpp). What the manual leaves open is in docs/global/method.md.
#pragma once

#include "core/photon/photon_maps.h"
#include "core/photon/settings.h"
#include "core/trace/photon_media.h"
#include "core/trace/photon_shot.h"
#include "core/trace/ray_state.h"
#include "core/trace/start_interiors.h"
#include "core/trace/surface_layers.h"
#include "core/trace/thread_context.h"

namespace lentray::core {

class PhotonPath {
 public:
  /// Of a scene with photons.
  explicit PhotonPath(ThreadContext& context);

  /// Appends what the photon leaves. True if it met its target.
  bool shoot(const PhotonShot& shot, MediaDraws& draws, PhotonMaps& out);

 private:
  struct Leg;
  struct Meeting;

  void follow(const Leg& leg);
  /// Whether photons go on from what a leg meets; `passes`: they only pass it.
  bool is_wanted(const Leg& leg, const PassFlags& flags, bool& passes);
  void arrive(const Meeting& at, const LayeredTexture& texture, const TexturePlace& place, Leg leg);
  Rgb faded(const Meeting& at, const Leg& leg) const;
  /// Both are true on total internal reflection.
  bool refract(const Meeting& at, Layers layers, const Leg& leg);
  bool bend(const Meeting& at, Layers layers, double ior, const Leg& before, Leg onward);
  void mirror(const Meeting& at, const Vec3& normal, Leg onward);
  void mirror_layers(const Meeting& at, Layers layers, bool total_reflection, const Leg& leg);

  ThreadContext& m_context;
  const Scene& m_scene;
  const PhotonSettings& m_settings;
  const double m_min_distance;
  StartInteriors m_start_interiors;
  PhotonMedia m_media;
  const SurfaceLayers m_layers;
  const PhotonShot* m_shot = nullptr;
  MediaDraws* m_draws = nullptr;
  PhotonMaps* m_out = nullptr;
  bool m_met_target = false;
};

}  // namespace lentray::core
