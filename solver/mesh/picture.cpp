#include "solver/mesh/picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "solver/mesh/words.hpp"

namespace sunder::mesh {
namespace {

constexpr double width = 400.0, margin = 16.0, line_height = 20.0;

struct Stroke {
  const char *colour, *dash;
};

/// Okabe and Ito's palette for boundaries; the dashes tell them apart without colour.
constexpr std::array<Stroke, 6> boundary_strokes = {{{"#0072b2", ""},
                                                     {"#d55e00", "9 4"},
                                                     {"#009e73", "3 3"},
                                                     {"#cc79a7", "12 3 3 3"},
                                                     {"#e69f00", "6 2"},
                                                     {"#56b4e9", "2 5"}}};
/// Light fills of the materials, ordered by lightness.
constexpr std::array<const char*, 5> material_fills = {"#f4f4f4", "#dbe9f4", "#f7e3c0", "#cfe8dc", "#d9d9d9"};

std::string fixed(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f", value == 0.0 ? 0.0 : value);
  return text.data();
}

std::string escaped(const std::string& words) {
  std::string text;
  for (const char c : words) {
    switch (c) {
      case '&':
        text += "&amp;";
        break;
      case '<':
        text += "&lt;";
        break;
      case '>':
        text += "&gt;";
        break;
      case '"':
        text += "&quot;";
        break;
      default:
        text += c;
    }
  }
  return text;
}

/// Places of the body on the sheet: y upwards becomes y downwards, the longer side is fitted.
struct Sheet {
  Point low = Point::Zero();
  double scale = 1.0, top = 0.0, left = margin, body_height = 0.0;

  Sheet(const PolygonMesh& mesh, double title_height) : top(title_height + margin) {
    Point high = Point::Zero();
    if (!mesh.vertices.empty()) low = high = mesh.vertices[0];
    for (const Point& p : mesh.vertices) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    const Point span = high - low;
    const double fit = std::max(span.x() / (width - 2.0 * margin), span.y() / (1.5 * width));
    scale = fit > 0.0 ? 1.0 / fit : 1.0;
    left = 0.5 * (width - span.x() * scale);
    body_height = span.y() * scale;
  }
  std::string at(const Point& x) const {
    return fixed(left + (x.x() - low.x()) * scale) + " " + fixed(top + body_height - (x.y() - low.y()) * scale);
  }
  std::string centre(const Point& x) const {
    return "cx=\"" + fixed(left + (x.x() - low.x()) * scale) + "\" cy=\"" +
           fixed(top + body_height - (x.y() - low.y()) * scale) + "\"";
  }
};

std::string polygons_of(const PolygonMesh& mesh, const Sheet& sheet, int material) {
  std::string path;
  for (const Polygon& p : mesh.polygons) {
    if (p.material != material || p.vertices.empty()) continue;
    const char* step = "M";
    for (const int v : p.vertices) {
      path += step + sheet.at(mesh.vertices[v]);
      step = "L";
    }
    if (p.open) path += "L" + sheet.at(p.scaling_centre);
    path += "Z";
  }
  return path;
}

/// Edges one after another as few lines as possible: each starts where the last one ended, if it does.
std::string edges_of(const PolygonMesh& mesh, const Sheet& sheet, const std::vector<Edge>& edges) {
  std::vector<Edge> sorted = edges;  // chained by their first vertex
  std::sort(sorted.begin(), sorted.end());
  std::vector<char> drawn(sorted.size(), 0);
  const auto behind = [&](int v) {
    const auto at = std::lower_bound(sorted.begin(), sorted.end(), Edge{v, -1});
    return at != sorted.end() && (*at)[0] == v ? at - sorted.begin() : -1;
  };
  std::vector<int> ends;
  for (const Edge& e : sorted) ends.push_back(e[1]);
  std::sort(ends.begin(), ends.end());
  std::string path;
  const auto draw_from = [&](long i) {
    path += "M" + sheet.at(mesh.vertices[sorted[i][0]]);
    for (; i >= 0 && !drawn[i]; i = behind(sorted[i][1])) {
      path += "L" + sheet.at(mesh.vertices[sorted[i][1]]);
      drawn[i] = 1;
    }
  };
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (!std::binary_search(ends.begin(), ends.end(), sorted[i][0])) draw_from(static_cast<long>(i));
  }
  for (std::size_t i = 0; i < sorted.size(); ++i) {  // what is left runs round in a ring
    if (!drawn[i]) draw_from(static_cast<long>(i));
  }
  return path;
}

std::string crack_line(const PolygonMesh& mesh, const Sheet& sheet, const CrackFaces& crack) {
  std::string path;
  for (const auto* face : {&crack.lower, &crack.upper}) {
    const char* step = "M";
    for (const int v : *face) {
      path += step + sheet.at(mesh.vertices[v]);
      step = "L";
    }
    if (crack.tip_polygon >= 0) path += "L" + sheet.at(mesh.polygons[crack.tip_polygon].scaling_centre);
  }
  return path;
}

/// Lines of the legend below the body: a sample at the left, words beside it.
class Legend {
 public:
  explicit Legend(double top) : y_(top) {}

  void line(const std::string& stroke, const std::string& words) {
    entry("<path d=\"M" + fixed(margin) + " " + fixed(y_ + 0.5 * line_height) + "h36\" " + stroke + "/>", words);
  }
  void fill(const std::string& colour, const std::string& words) {
    entry("<rect x=\"" + fixed(margin) + "\" y=\"" + fixed(y_ + 4.0) + "\" width=\"36\" height=\"12\" fill=\"" +
              colour + "\" stroke=\"#555\"/>",
          words);
  }
  void dot(const std::string& look, const std::string& words) {
    entry("<circle cx=\"" + fixed(margin + 18.0) + "\" cy=\"" + fixed(y_ + 0.5 * line_height) + "\" " + look + "/>",
          words);
  }
  void crack(const std::string& words) {
    const std::string place = "<path d=\"M" + fixed(margin) + " " + fixed(y_ + 0.5 * line_height) + "h36\" ";
    entry(place + "stroke=\"#000\" stroke-width=\"4\"/>" + place + "stroke=\"#fff\" stroke-width=\"1.6\"/>", words);
  }
  void words(const std::string& text) { entry("", text, margin); }

  double bottom() const { return y_; }
  const std::string& text() const { return text_; }

 private:
  void entry(const std::string& sample, const std::string& words, double x = margin + 46.0) {
    text_ += sample + "<text x=\"" + fixed(x) + "\" y=\"" + fixed(y_ + 15.0) + "\">" + escaped(words) + "</text>\n";
    y_ += line_height;
  }
  double y_;
  std::string text_;
};

std::string stroke_of(std::size_t boundary) {
  const Stroke& s = boundary_strokes[boundary % boundary_strokes.size()];
  return std::string("fill=\"none\" stroke=\"") + s.colour + "\" stroke-width=\"3\"" +
         (*s.dash == '\0' ? std::string() : " stroke-dasharray=\"" + std::string(s.dash) + "\"");
}

std::string draw_polygons(const PolygonMesh& mesh, const PictureOptions& options, const Sheet& sheet, Legend& legend) {
  int materials = 1;
  for (const Polygon& p : mesh.polygons) materials = std::max(materials, p.material + 1);
  const double thin = std::clamp(40.0 / std::sqrt(1.0 + static_cast<double>(mesh.polygons.size())), 0.05, 0.8);
  std::string text;
  for (int m = 0; m < materials; ++m) {
    const std::string fill = material_fills[m % material_fills.size()];
    text += "<path d=\"" + polygons_of(mesh, sheet, m) + "\" fill=\"" + fill + "\" stroke=\"#555\" stroke-width=\"" +
            fixed(thin) + "\" stroke-linejoin=\"round\"/>\n";
    if (materials == 1) continue;
    const bool named = m < static_cast<int>(options.materials.size());
    legend.fill(fill, named ? options.materials[m] : "material " + std::to_string(m));
  }
  return text;
}

std::string draw_dots(const PolygonMesh& mesh, const PictureOptions& options, const Sheet& sheet, Legend& legend) {
  std::string text;
  const std::string centre_look = "r=\"1.2\" fill=\"#999\"", node_look = "r=\"1.4\" fill=\"#000\"";
  if (static_cast<int>(mesh.polygons.size()) <= options.most_dots) {
    for (const Polygon& p : mesh.polygons)
      text += "<circle " + sheet.centre(p.scaling_centre) + " " + centre_look + "/>\n";
    legend.dot("r=\"2\" fill=\"#999\"", "scaling centres");
  }
  if (options.nodes != nullptr && options.nodes->node_count() <= options.most_dots) {
    for (int n = 0; n < options.nodes->node_count(); ++n) {
      text += "<circle " + sheet.centre(options.nodes->coordinates().col(n)) + " " + node_look + "/>\n";
    }
    legend.dot("r=\"2\" fill=\"#000\"", "nodes");
  }
  return text;
}

}  // namespace

std::string picture(const PolygonMesh& mesh, const PictureOptions& options) {
  const Sheet sheet(mesh, options.title.empty() ? 0.0 : line_height);
  Legend legend(sheet.top + sheet.body_height + margin);
  std::string body = draw_polygons(mesh, options, sheet, legend);
  std::size_t number_of_boundary = 0;
  for (const auto& [name, edges] : mesh.boundaries) {
    const std::string stroke = stroke_of(number_of_boundary++);
    body += "<path d=\"" + edges_of(mesh, sheet, edges) + "\" " + stroke + "/>\n";
    legend.line(stroke, name);
  }
  for (const CrackFaces& crack : mesh.cracks) {
    const std::string path = crack_line(mesh, sheet, crack);
    body += "<path d=\"" + path + "\" fill=\"none\" stroke=\"#000\" stroke-width=\"4\"/>\n";
    body += "<path d=\"" + path + "\" fill=\"none\" stroke=\"#fff\" stroke-width=\"1.6\"/>\n";
    if (crack.tip_polygon < 0) continue;  // has come out at a face
    body += "<circle " + sheet.centre(mesh.polygons[crack.tip_polygon].scaling_centre) +
            " r=\"3\" fill=\"#fff\" stroke=\"#000\" stroke-width=\"1.2\"/>\n";
  }
  if (!mesh.cracks.empty()) legend.crack("crack faces, tip ringed");
  body += draw_dots(mesh, options, sheet, legend);
  legend.words(
      std::to_string(mesh.polygons.size()) + " polygons, " + std::to_string(mesh.vertices.size()) + " vertices" +
      (options.nodes == nullptr ? std::string() : ", " + std::to_string(options.nodes->node_count()) + " nodes"));

  const std::string height = fixed(legend.bottom() + margin);
  std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + fixed(width) + " " + height +
                     "\" width=\"100%\" style=\"max-width:900px\" font-family=\"sans-serif\" font-size=\"14\">\n";
  text += "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
  if (!options.title.empty()) {
    text += "<title>" + escaped(options.title) + "</title>\n<text x=\"" + fixed(margin) + "\" y=\"" +
            fixed(line_height) + "\" font-weight=\"bold\">" + escaped(options.title) + "</text>\n";
  }
  return text + body + legend.text() + "</svg>\n";
}

}  // namespace sunder::mesh
