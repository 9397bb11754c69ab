// SPDX-License-Identifier: BSD-3-Clause
// A page as PDF, by cairo: real letters of an embedded font, circles and paths.
#include <cairo-ft.h>
#include <cairo-pdf.h>
#include <unistd.h>

#include <memory>
#include <numbers>

#include "failure.h"
#include "page.h"
#include "vector_page.h"

namespace hfrac::viz {
namespace {

using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;
using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using FontFace = std::unique_ptr<cairo_font_face_t, decltype(&cairo_font_face_destroy)>;

// cairo may keep a face after the page is done: the file is closed when it lets go of it.
struct FontFile {
  FT_Library library = nullptr;
  FT_Face face = nullptr;
  ~FontFile() {
    if (face != nullptr) FT_Done_Face(face);
    if (library != nullptr) FT_Done_FreeType(library);
  }
};

FontFace face_of(bool bold) {
  const std::string path = font_file(bold);
  auto file = std::make_unique<FontFile>();
  if (path.empty() || FT_Init_FreeType(&file->library) != 0 ||
      FT_New_Face(file->library, path.c_str(), 0, &file->face) != 0) {
    return {cairo_toy_font_face_create("sans-serif", CAIRO_FONT_SLANT_NORMAL,
                                       bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL),
            cairo_font_face_destroy};
  }
  static const cairo_user_data_key_t key{};
  FontFace face(cairo_ft_font_face_create_for_ft_face(file->face, 0), cairo_font_face_destroy);
  const auto close = [](void* kept) { delete static_cast<FontFile*>(kept); };
  if (cairo_font_face_set_user_data(face.get(), &key, file.get(), close) == CAIRO_STATUS_SUCCESS)
    static_cast<void>(file.release());
  return face;
}

cairo_status_t append(void* content, const unsigned char* bytes, unsigned int count) {
  auto* all = static_cast<std::vector<std::uint8_t>*>(content);
  try {
    all->insert(all->end(), bytes, bytes + count);
  } catch (const std::bad_alloc&) {
    return CAIRO_STATUS_NO_MEMORY;
  }
  return CAIRO_STATUS_SUCCESS;
}

class PdfCanvas : public VectorCanvas {
 public:
  explicit PdfCanvas(cairo_t* context) : context_(context), plain_(face_of(false)), bold_(face_of(true)) {}

  void begin_view(const Box& box) override {
    cairo_save(context_);
    cairo_rectangle(context_, box.left, box.top, box.width, box.height);
    cairo_clip(context_);
  }
  void end_view() override { cairo_restore(context_); }

  void move_to(Point place) override { cairo_move_to(context_, place.x, place.y); }
  void line_to(Point place) override { cairo_line_to(context_, place.x, place.y); }
  void close() override { cairo_close_path(context_); }
  void fill(Colour colour) override {
    take(colour, 1.0);
    cairo_fill(context_);
  }
  void stroke(Colour colour, double width, double opacity) override {
    take(colour, opacity);
    cairo_set_line_width(context_, width);
    cairo_stroke(context_);
  }

  void begin_discs(Colour, Colour, bool) override {}
  void disc(Point centre, double radius, double rim_width, Colour fill, Colour rim) override {
    cairo_new_sub_path(context_);
    cairo_arc(context_, centre.x, centre.y, radius, 0.0, 2.0 * std::numbers::pi);
    take(fill, 1.0);
    if (!(rim_width > 0)) {
      cairo_fill(context_);
      return;
    }
    cairo_fill_preserve(context_);
    stroke(rim, rim_width, 1.0);
  }
  void end_discs() override {}

  void picture(const Image& image, const Box& box) override {
    const int stride = cairo_format_stride_for_width(CAIRO_FORMAT_RGB24, image.width);
    std::vector<std::uint8_t> rows(static_cast<std::size_t>(stride) * image.height);
    for (int y = 0; y < image.height; ++y) {
      auto* to = reinterpret_cast<std::uint32_t*>(rows.data() + static_cast<std::size_t>(y) * stride);
      const std::uint8_t* from = image.row(y);
      for (int x = 0; x < image.width; ++x, from += 3)
        to[x] =
            static_cast<std::uint32_t>(from[0]) << 16 | static_cast<std::uint32_t>(from[1]) << 8 | from[2];
    }
    const Surface pixels(cairo_image_surface_create_for_data(rows.data(), CAIRO_FORMAT_RGB24, image.width,
                                                             image.height, stride),
                         cairo_surface_destroy);
    cairo_save(context_);
    cairo_translate(context_, box.left, box.top);
    cairo_scale(context_, box.width / image.width, box.height / image.height);
    cairo_set_source_surface(context_, pixels.get(), 0, 0);
    cairo_paint(context_);
    cairo_restore(context_);
    // The file takes its copy now: the pixels go with this call.
    cairo_surface_finish(pixels.get());
  }

  void text(const PageText& text, double width) override {
    const TextStyle& style = text.style;
    cairo_save(context_);
    cairo_set_font_face(context_, style.bold ? bold_.get() : plain_.get());
    cairo_set_font_size(context_, style.size);
    take(style.colour, 1.0);
    cairo_translate(context_, text.x, text.y);
    if (style.upwards) cairo_rotate(context_, -std::numbers::pi / 2);
    const double before = style.align == Align::centre  ? width / 2
                          : style.align == Align::right ? width
                                                        : 0.0;
    cairo_move_to(context_, -before, 0.0);
    cairo_show_text(context_, text.content.c_str());
    cairo_new_path(context_);
    cairo_restore(context_);
  }

 private:
  void take(Colour colour, double opacity) {
    cairo_set_source_rgba(context_, colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0, opacity);
  }

  cairo_t* context_;
  FontFace plain_;
  FontFace bold_;
};

}  // namespace

std::vector<std::uint8_t> pdf_page(const PageDrawing& drawing, int dots_per_inch) {
  constexpr double points_per_inch = 72;
  constexpr int screen = 96;
  const double scale = points_per_inch / (dots_per_inch > 0 ? dots_per_inch : screen);
  const Page& page = *drawing.page;
  std::vector<std::uint8_t> content;
  const Surface surface(
      cairo_pdf_surface_create_for_stream(append, &content, page.width() * scale, page.height() * scale),
      cairo_surface_destroy);
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, drawing.title.c_str());
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATOR, "hfrac");
  {
    const Context context(cairo_create(surface.get()), cairo_destroy);
    cairo_scale(context.get(), scale, scale);
    PdfCanvas canvas(context.get());
    canvas.move_to({0, 0});
    canvas.line_to({static_cast<double>(page.width()), 0});
    canvas.line_to({static_cast<double>(page.width()), static_cast<double>(page.height())});
    canvas.line_to({0, static_cast<double>(page.height())});
    canvas.close();
    canvas.fill(palette().paper);
    draw_vectors(drawing, canvas);
    cairo_show_page(context.get());
    if (const auto status = cairo_status(context.get()); status != CAIRO_STATUS_SUCCESS)
      fail_drawing(std::string("the PDF cannot be drawn: ") + cairo_status_to_string(status));
  }
  cairo_surface_finish(surface.get());
  if (const auto status = cairo_surface_status(surface.get()); status != CAIRO_STATUS_SUCCESS)
    fail_drawing(std::string("the PDF cannot be drawn: ") + cairo_status_to_string(status));
  return content;
}

}  // namespace hfrac::viz
