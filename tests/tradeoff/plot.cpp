// The picture of a study: error against time, both logarithmic.
#include <algorithm>
#include <cmath>

#include "support/gnuplot.h"
#include "support/text.h"
#include "tradeoff/report.h"

namespace tradeoff {

namespace {

struct Series {
  const char* title;
  const char* style;  // of gnuplot, for lines and points
  bool (*holds)(const Configuration&);
};

bool plain(const Configuration& configuration) {
  return is_implicit(configuration) && configuration.method.newton == 1 &&
         configuration.method.jacobian == Jacobian::definite;
}

const std::vector<Series> all_series = {
    {"explicit", "lt 2", is_explicit},
    {"implicit, direct solver", "lt 1",
     [](const Configuration& configuration) {
       return plain(configuration) && configuration.step == 3;
     }},
    {"implicit, conjugate gradients", "lt 3",
     [](const Configuration& configuration) {
       return plain(configuration) && configuration.step > 3;
     }},
    {"implicit, matrix of BW98", "lt 6",
     [](const Configuration& configuration) {
       return is_implicit(configuration) && configuration.method.newton == 1 &&
              configuration.method.jacobian == Jacobian::bw98;
     }},
    {"implicit, Newton's method", "lt 4",
     [](const Configuration& configuration) {
       return is_implicit(configuration) && configuration.method.newton > 1;
     }},
    {"XPBD, in no step", "lt 5",
     [](const Configuration& configuration) { return configuration.scheme == Scheme::xpbd; }},
    {"VBD, in no step", "lt 7",
     [](const Configuration& configuration) { return configuration.scheme == Scheme::vbd; }},
};

std::string data_block(const std::string& name, const Study& study,
                       const std::vector<Score>& scores) {
  std::string block = "$" + name + " << EOD\n";
  for (const Score& s : scores) block += format("%.6g,%.6g\n", study.seconds(s), s.judged());
  return block + "EOD\n";
}

// A triangle whose lower left corner is (x, y). Along its hypotenuse the error falls by `order`
// decades per decade of time.
std::string slope_triangle(double x, double y, int order, int tag) {
  const double right = x * std::sqrt(10.0), top = y * std::pow(10.0, order / 2.0);
  const char* side = "set arrow %d from %g,%g to %g,%g nohead lw 1.5 lc rgb '#888888'\n";
  return format(side, tag, x, top, right, y) + format(side, tag + 1, x, y, x, top) +
         format(side, tag + 2, x, y, right, y) +
         format("set label %d 'order %d' at %g,%g center textcolor rgb '#666666' offset 0,-0.8\n",
                tag, order, std::sqrt(x * right), y);
}

// Labels at both ends of the front, and where explicit steps replace implicit ones.
std::string labels(const Study& study, const std::vector<Score>& front) {
  std::vector<Score> marked = {front.front()};
  if (const auto turn = crossover(front)) marked.push_back(turn->second);
  if (front.back().judged() < marked.back().judged()) marked.push_back(front.back());
  std::string text;
  for (size_t i = 0; i < marked.size(); ++i)
    text += format(
        "set label %d \"%s\\nh = %.3g h_{crit}\" at %g,%g right offset -1.2,-0.4 font ',11'\n",
        int(100 + i), name_of(marked[i].trial.configuration).c_str(),
        marked[i].h / study.h_crit_of(marked[i]), study.seconds(marked[i]), marked[i].judged());
  return text;
}

// Every trial is a dot. Lines show the front of each series and the front of all trials.
std::string series_and_front(const Study& study, const std::vector<Score>& front,
                             std::string& data) {
  data += data_block("front", study, front);
  std::string plot = "plot $front using 1:2 with lines lw 14 lc rgb \"#dddddd\" notitle, \\\n",
              lines;
  for (size_t i = 0; i < all_series.size(); ++i) {
    const auto& [title, style, holds] = all_series[i];
    std::vector<Score> kept;
    for (const Score& s : study.scores)
      if (s.is_answer() && holds(s.trial.configuration)) kept.push_back(s);
    if (kept.empty()) continue;
    const std::string name = "series" + std::to_string(i);
    data += data_block(name, study, kept) + data_block(name + "_front", study, pareto_front(kept));
    plot += "$" + name + " using 1:2 with points " + style + " ps 0.5 notitle, \\\n";
    lines += "$" + name + "_front using 1:2 with linespoints " + style + " title \"" + title +
             "\", \\\n";
  }
  return plot + lines +
         "1/0 with lines lw 14 lc rgb \"#dddddd\" title \"Pareto front of the steps\"\n";
}

std::string script(const Study& study) {
  double fastest = 1e300, slowest = 0, best = 1e300, worst = 0;
  for (const Score& s : study.scores)
    if (s.is_answer()) {
      fastest = std::min(fastest, study.seconds(s)), slowest = std::max(slowest, study.seconds(s));
      best = std::min(best, s.judged()), worst = std::max(worst, s.judged());
    }
  const std::vector<Score> front = pareto_front(offered(study.scores));
  const StudyScene& mesh = study.meshes.front();
  std::string text = gnuplot_style;
  const std::string plot = series_and_front(study, front, text);
  text += format("set xrange [%g:%g]\nset yrange [%g:%g]\n", fastest / 10, 3 * slowest, best / 3,
                 3 * worst);
  text += slope_triangle(fastest / 6, 4 * best, 1, 1) + slope_triangle(fastest, 4 * best, 2, 11);
  text += labels(study, distinct(front));
  text +=
      "set terminal pngcairo size 1100,720 font \"sans,13\"\n"
      "set output \"work_precision.png\"\nset logscale xy\nset key top right\n"
      "set xlabel \"time, s\"\nset ylabel \"error at the end: RMS distance / size\"\n";
  text +=
      "set title \"" + mesh.name +
      format(", k = %g N/m: what accuracy costs\"\n",
             mesh.scene.cloth.term<StretchTerm>() ? mesh.scene.cloth.term<StretchTerm>()->k : 0.0);
  return text + plot;
}

}  // namespace

void draw_plot(const Study& study) {
  if (study.can_judge() && !pareto_front(offered(study.scores)).empty())
    draw(study.out, "work_precision", script(study));
}

}  // namespace tradeoff
