// Lines with smooth borders.

#ifdef FRAGMENT_STAGE
// How much of a pixel a line covers whose middle is so many pixels away: lines thinner than a pixel are paler instead.
float line_coverage(float from_middle, float half_width) {
    return clamp(half_width + 0.5 - from_middle, 0.0, min(2.0 * half_width, 1.0));
}
#endif
