// SPDX-License-Identifier: BSD-3-Clause
// A page as SVG. Every text says how long it is, so that it fits its place in whatever font the reader has.
#include <fmt/format.h>

#include <cmath>
#include <span>

#include "image.h"
#include "run/text.hpp"
#include "vector_page.h"

namespace hfrac::viz {
using namespace hfrac::run;
namespace {

// Two decimals of a pixel, without the zeros behind them.
std::string decimal(double value) {
  const double rounded = std::round(value * 100) / 100;
  return fmt::to_string(rounded == 0 ? 0.0 : rounded);
}

class SvgCanvas : public VectorCanvas {
 public:
  std::string content;

  SvgCanvas& tag(const char* name) {
    content.append("<").append(name);
    return *this;
  }
  SvgCanvas& with(const char* name, const std::string& value) {
    content.append(" ").append(name).append("=\"").append(value).append("\"");
    return *this;
  }
  SvgCanvas& with(const char* name, double value) { return with(name, decimal(value)); }
  SvgCanvas& with(const Box& box) {
    return with("x", box.left).with("y", box.top).with("width", box.width).with("height", box.height);
  }
  void end(const char* how = "/>\n") { content.append(how); }

  void begin_view(const Box& box) override {
    const std::string name = "view" + std::to_string(views_++);
    tag("clipPath").with("id", name).end(">");
    tag("rect").with(box).end("/></clipPath>\n");
    tag("g").with("clip-path", std::string("url(#").append(name).append(")")).end(">\n");
  }
  void end_view() override { end("</g>\n"); }

  void move_to(Point place) override { go("M", place); }
  void line_to(Point place) override { go("L", place); }
  void close() override { path_.append("Z"); }
  void fill(Colour colour) override {
    tag("path").with("fill", hexadecimal(colour)).with("d", path_).end();
    path_.clear();
  }
  void stroke(Colour colour, double width, double opacity) override {
    tag("path").with("fill", std::string("none")).with("stroke", hexadecimal(colour));
    with("stroke-width", width).with("stroke-opacity", opacity).with("d", path_).end();
    path_.clear();
  }

  void begin_discs(Colour fill, Colour rim, bool own_colours) override {
    own_colours_ = own_colours;
    tag("g");
    if (!own_colours) with("fill", hexadecimal(fill)).with("stroke", hexadecimal(rim));
    end(">\n");
  }
  void disc(Point centre, double radius, double rim_width, Colour fill, Colour rim) override {
    tag("circle").with("cx", centre.x).with("cy", centre.y).with("r", radius).with("stroke-width", rim_width);
    if (own_colours_) with("fill", hexadecimal(fill)).with("stroke", hexadecimal(rim));
    end();
  }
  void end_discs() override { end("</g>\n"); }

  void picture(const Image& image, const Box& box) override {
    tag("image").with(box).with("preserveAspectRatio", std::string("none"));
    std::string address = "data:image/png;base64,";
    const std::vector<std::uint8_t> pixels = png(image);
    append_base64(address, std::as_bytes(std::span(pixels)));
    with("href", address).end();
  }

  void text(const PageText& text, double width) override {
    const TextStyle& style = text.style;
    tag("text").with("x", text.x).with("y", text.y).with("font-size", style.size);
    with("textLength", width).with("lengthAdjust", std::string("spacingAndGlyphs"));
    with("fill", hexadecimal(style.colour));
    if (style.bold) with("font-weight", std::string("bold"));
    if (style.align == Align::centre) with("text-anchor", std::string("middle"));
    if (style.align == Align::right) with("text-anchor", std::string("end"));
    if (style.upwards) {
      with(
          "transform",
          std::string("rotate(-90 ").append(decimal(text.x)).append(" ").append(decimal(text.y)).append(")"));
    }
    end(">");
    content.append(escaped(text.content)).append("</text>\n");
  }

 private:
  void go(const char* how, Point place) {
    path_.append(how).append(decimal(place.x)).append(" ").append(decimal(place.y));
  }

  std::string path_;
  int views_ = 0;
  bool own_colours_ = false;
};

}  // namespace

std::string svg_page(const PageDrawing& drawing) {
  const double width = drawing.page->width();
  const double height = drawing.page->height();
  SvgCanvas canvas;
  canvas.content = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  canvas.tag("svg").with("xmlns", std::string("http://www.w3.org/2000/svg"));
  canvas.with("width", width).with("height", height);
  canvas.with("viewBox", std::string("0 0 ").append(decimal(width)).append(" ").append(decimal(height)));
  canvas.with("font-family", std::string("'DejaVu Sans', Verdana, sans-serif")).end(">\n<title>");
  canvas.content.append(escaped(drawing.title)).append("</title>\n");
  canvas.tag("rect").with("width", std::string("100%")).with("height", std::string("100%"));
  canvas.with("fill", hexadecimal(palette().paper)).end();
  draw_vectors(drawing, canvas);
  canvas.end("</svg>\n");
  return canvas.content;
}

}  // namespace hfrac::viz
