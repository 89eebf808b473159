// The pictures of a run: its frames, its still, its film strip, and with --motion its animation.
#pragma once
#include "picture/png.h"
#include "picture/renderer.h"
#include "program/motion.h"
#include "program/options.h"
#include "scene/scene.h"

class Pictures {
 public:
  Pictures(const Options&, const Scene&);

  void frame(int number, const VecX& x, double time);  // frame_0000.png, …
  void still(const VecX& x, double time);              // still.png
  void film();                                         // film.png, motion.png

  bool motion_is_due(long step) const { return motion && motion->is_due(step); }
  void add_to_motion(const VecX& x, double time);
  bool has_motion() const { return motion && !motion->frames().empty(); }

 private:
  Image draw(const VecX& x, double time, int width, int height) const;
  void draw_time(Image&, double time) const;
  PngText about(double time) const;
  bool on_film(int number) const;

  const Options& options;
  const Scene& scene;
  Stage stage;
  mutable Renderer renderer;
  std::vector<Image> strip;  // the moments of the film so far, and the last frame
  double film_end = 0;       // s
  bool last_is_kept = true;  // is the last picture of the strip on the film for good?
  std::optional<Motion> motion;
  double motion_end = 0;  // s
};
