#include "video/ffmpeg_palette.h"

extern "C" {
#include <libavfilter/buffersink.h>
#include <libavfilter/buffersrc.h>
}

namespace croquis::video {
namespace {

constexpr const char* what = "cannot choose colours for a GIF";

AVFilterContext* added(AVFilterGraph& graph, const char* filter, const std::string& options = {}) {
    AVFilterContext* made = nullptr;
    checked(avfilter_graph_create_filter(&made, avfilter_get_by_name(filter), filter, options.c_str(), nullptr, &graph),
            what);
    return made;
}

void link(AVFilterContext* from, unsigned output, AVFilterContext* to, unsigned input) {
    checked(avfilter_link(from, output, to, input), what);
}

}  // namespace

// A graph for each picture: in one for them all, a picture would come out only when the next went in.
Owned<AVFrame> with_palette(const AVFrame& picture) {
    const auto graph = owned(avfilter_graph_alloc());
    graph->nb_threads = 1;
    AVFilterContext* const source =
        added(*graph, "buffer",
              fmt::format("video_size={}x{}:pix_fmt={}:time_base=1/1", picture.width, picture.height, picture.format));
    AVFilterContext* const both = added(*graph, "split");
    AVFilterContext* const choose = added(*graph, "palettegen", "stats_mode=single:reserve_transparent=0");
    AVFilterContext* const use = added(*graph, "paletteuse", "new=1:dither=bayer:bayer_scale=4");
    AVFilterContext* const sink = added(*graph, "buffersink");
    link(source, 0, both, 0);
    link(both, 0, use, 0);
    link(both, 1, choose, 0);
    link(choose, 0, use, 1);
    link(use, 0, sink, 0);
    checked(avfilter_graph_config(graph.get(), nullptr), what);

    const auto shared = owned(av_frame_clone(&picture));
    shared->pts = 0;
    checked(av_buffersrc_write_frame(source, shared.get()), what);
    checked(av_buffersrc_close(source, 1, 0), what);
    auto result = owned(av_frame_alloc());
    checked(av_buffersink_get_frame(sink, result.get()), what);
    return result;
}

}  // namespace croquis::video
