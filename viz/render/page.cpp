// SPDX-License-Identifier: BSD-3-Clause
#include "page.h"

#include <unistd.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkStdString.h>
#include <vtkTextActor.h>
#include <vtkTextRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "failure.h"
#include "image.h"
#include "vector_page.h"

namespace hfrac::viz {

namespace {

bool readable(const char* path) {
  return path[0] != 0 && ::access(path, R_OK) == 0;
}

}  // namespace

std::string font_file(bool bold) {
  const char* file = bold && readable(HFRAC_VIZ_BOLD_FONT) ? HFRAC_VIZ_BOLD_FONT : HFRAC_VIZ_FONT;
  return readable(file) ? file : "";
}

void set_font(vtkTextProperty* property, bool bold, double size, Colour colour) {
  const std::string file = font_file(bold);
  if (!file.empty()) {
    property->SetFontFamily(VTK_FONT_FILE);
    property->SetFontFile(file.c_str());
    property->SetBold(0);
  } else {  // VTK's own, without Greek letters
    property->SetFontFamilyToArial();
    property->SetBold(bold ? 1 : 0);
  }
  property->SetFontSize(std::max(4, static_cast<int>(std::lround(size))));
  property->SetColor(colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
}

namespace {

constexpr int drawn_at_once = 4'000'000;  // [drawn pixel]
constexpr int fewest_rows = 64;           // [pixel]
constexpr int margin = 8;                 // [pixel] OpenGL cuts thick lines off askew at the window's edge

}  // namespace

Image drawn_in_bands(OffscreenWindow* window, int width, int height, int factor,
                     const std::function<void(const PageBand&)>& show) {
  const int most = std::max(fewest_rows, drawn_at_once / (width * factor * factor));
  const int count = (height + most - 1) / most;
  const int rows = (height + count - 1) / count;
  const int drawn_rows = rows + 2 * margin;
  window->SetSize(width * factor, drawn_rows * factor);
  Image image{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(width) * height * 3)};
  vtkNew<vtkUnsignedCharArray> pixels;
  for (int low = 0; low < height; low += rows) {
    show({low - margin, drawn_rows});
    const int read = window->GetPixelData(0, 0, width * factor - 1, drawn_rows * factor - 1, 1, pixels, 0);
    if (read == VTK_ERROR ||
        pixels->GetNumberOfValues() != vtkIdType{3} * width * factor * drawn_rows * factor) {
      fail_drawing("the picture cannot be read back from the off-screen window");
    }
    const Image band = reduced(pixels->GetPointer(0), width, drawn_rows, factor);
    const int wanted = std::min(rows, height - low);
    const int first = margin + rows - wanted;
    std::copy(band.row(first), band.row(first + wanted), image.row(height - low - wanted));
  }
  return image;
}

namespace {

constexpr int largest_drawn = 16384;  // [pixel] OSMesa's largest framebuffer
constexpr int text_resolution = 72;   // one point of a font is one drawn pixel

void look_down(vtkRenderer* renderer, double centre_x, double centre_y, double height) {
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(centre_x, centre_y, 0.0);
  camera->SetPosition(centre_x, centre_y, 10.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetParallelScale(height / 2);
  camera->SetClippingRange(1.0, 12.0);
}

void set_paper(vtkRenderer* renderer) {
  const Colour paper = palette().paper;
  renderer->SetBackground(paper.red / 255.0, paper.green / 255.0, paper.blue / 255.0);
}

}  // namespace

Page::Page(OffscreenWindow* window, int width, int height, int factor)
    : window_(window),
      width_(width),
      height_(height),
      factor_(std::clamp(largest_drawn / std::max(width, height), 1, factor)) {
  window_->SetNumberOfLayers(2);
  overlay_ = vtkSmartPointer<vtkRenderer>::New();
  overlay_->SetLayer(1);
  overlay_->InteractiveOff();
  // A sheet of paper below everything: views cover only their boxes.
  auto sheet = vtkSmartPointer<vtkRenderer>::New();
  set_paper(sheet);
  window_->AddRenderer(sheet);
  renderers_.push_back(sheet);
}

Page::~Page() {
  for (const auto& renderer : renderers_) window_->RemoveRenderer(renderer);
  window_->RemoveRenderer(overlay_);
}

View Page::view(const Box& room, const Extent& extent) {
  View view;
  view.extent = extent;
  view.metres_per_pixel = std::max(extent.width / room.width, extent.height / room.height);
  // Whole pixels, so that the view's edge is the frame's edge.
  view.box = {std::round(room.left), std::round(room.top), std::round(extent.width / view.metres_per_pixel),
              std::round(extent.height / view.metres_per_pixel)};
  view.renderer = vtkSmartPointer<vtkRenderer>::New();
  set_paper(view.renderer);
  window_->AddRenderer(view.renderer);
  renderers_.push_back(view.renderer);
  views_.push_back(view);
  return view;
}

void Page::line(double x0, double y0, double x1, double y1, double width, Colour colour) {
  shapes_.band({place(x0, y0), place(x1, y1)}, width * factor_ / 2, width * factor_ / 2, colour);
}

void Page::rectangle(const Box& box, Colour colour) {
  shapes_.rectangle(place(box.left, box.bottom()), place(box.right(), box.top), colour);
}

void Page::outline(const Box& box, double width, Colour colour) {
  line(box.left, box.top, box.right(), box.top, width, colour);
  line(box.left, box.bottom(), box.right(), box.bottom(), width, colour);
  line(box.left, box.top, box.left, box.bottom(), width, colour);
  line(box.right(), box.top, box.right(), box.bottom(), width, colour);
}

void Page::circle(double x, double y, double radius, Colour colour) {
  shapes_.circle(place(x, y), radius * factor_, colour);
}

void Page::polygon(const std::vector<Point>& corners, Colour colour) {
  std::vector<Point> placed;
  placed.reserve(corners.size());
  for (const Point& corner : corners) placed.push_back(place(corner.x, corner.y));
  shapes_.polygon(placed, colour);
}

vtkSmartPointer<vtkTextProperty> Page::text_property(const TextStyle& style) const {
  auto property = vtkSmartPointer<vtkTextProperty>::New();
  set_font(property, style.bold, style.size * factor_, style.colour);
  property->SetVerticalJustificationToBottom();
  property->SetUseTightBoundingBox(0);
  return property;
}

void Page::text(double x, double y, const std::string& content, const TextStyle& style) {
  if (content.empty()) return;
  texts_.push_back({x, y, content, style});
  const auto property = text_property(style);
  if (style.align == Align::centre) property->SetJustificationToCentered();
  if (style.align == Align::right) property->SetJustificationToRight();
  if (style.upwards) property->SetOrientation(90.0);
  vtkNew<vtkTextActor> actor;
  actor->SetTextScaleModeToNone();
  actor->SetTextProperty(property);
  actor->SetInput(content.c_str());
  // VTK places the line's box, which reaches below the baseline by the letters' descent.
  const double descent = 0.236 * style.size;
  const Point at = style.upwards ? place(x + descent, y) : place(x, y + descent);
  letters_.push_back({actor, at});
  overlay_->AddActor2D(actor);
}

double Page::text_width(const std::string& content, const TextStyle& style) const {
  if (content.empty()) return 0;
  int bounds[4] = {0, 0, 0, 0};
  vtkTextRenderer* renderer = vtkTextRenderer::GetInstance();
  if (renderer == nullptr ||
      !renderer->GetBoundingBox(text_property(style), content, bounds, text_resolution)) {
    return 0.6 * style.size * static_cast<double>(content.size());
  }
  return static_cast<double>(bounds[1] - bounds[0] + 1) / factor_;
}

vtkSmartPointer<vtkActor> Page::overlay_shapes() const {
  return shapes_.empty() ? nullptr : shapes_.actor(0.0);
}

std::string Page::svg(const std::string& title) const {
  return svg_page({this, title, views_, overlay_shapes(), texts_});
}

std::vector<std::uint8_t> Page::pdf(const std::string& title, int dots_per_inch) const {
  return pdf_page({this, title, views_, overlay_shapes(), texts_}, dots_per_inch);
}

// The part of a view between two heights of the page, as if it were all of it.
void Page::show_part(const View& view, const PageBand& band) const {
  const double below = height_ - view.box.bottom();
  const double from = std::max(below, static_cast<double>(band.bottom));
  const double to = std::min(below + view.box.height, static_cast<double>(band.bottom + band.rows));
  view.renderer->SetDraw(to > from ? 1 : 0);
  if (!(to > from)) return;
  view.renderer->SetViewport(view.box.left / width_, (from - band.bottom) / band.rows,
                             view.box.right() / width_, (to - band.bottom) / band.rows);
  const double metres = view.extent.height / view.box.height;  // per pixel
  look_down(view.renderer, view.extent.left + view.extent.width / 2,
            view.extent.bottom + ((from + to) / 2 - below) * metres, (to - from) * metres);
}

Image Page::draw() {
  if (!shapes_.empty()) overlay_->AddActor(shapes_.actor(0.0));
  window_->AddRenderer(overlay_);
  window_->SetDPI(text_resolution);
  return drawn_in_bands(window_, width_, height_, factor_, [this](const PageBand& band) {
    for (const View& view : views_) show_part(view, band);
    const double bottom = static_cast<double>(band.bottom) * factor_;
    const double rows = static_cast<double>(band.rows) * factor_;
    look_down(overlay_, width_ * factor_ / 2.0, bottom + rows / 2, rows);
    for (const Letters& one : letters_) one.actor->SetPosition(one.at.x, one.at.y - bottom);
    window_->Render();
  });
}

std::string picture_ending(const std::filesystem::path& target) {
  std::string ending = target.extension().string();
  if (ending != ".png" && ending != ".svg" && ending != ".pdf") {
    fail_argument("'" + target.string() + "' ends neither in .png, .svg nor .pdf");
  }
  return ending;
}

std::vector<std::uint8_t> page_content(Page& page, const std::string& ending, const std::string& title,
                                       int dots_per_inch) {
  if (ending == ".pdf") return page.pdf(title, dots_per_inch);
  if (ending == ".png") return png(page.draw(), dots_per_inch);
  const std::string text = page.svg(title);
  return {text.begin(), text.end()};
}

}  // namespace hfrac::viz
