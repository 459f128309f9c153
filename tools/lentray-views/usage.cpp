// The help of lentray-views: manual page and completions are made of it.
#include "tools/lentray-views/arguments.h"

namespace lentray::views {

std::string usage() {
  return R"(usage: lentray-views IMAGE [task] [options]
       lentray-views VIEW... [task] [options]
       lentray-views --interlace VIEW... [options]

Takes integral images for lens sheets apart, and puts them together. IMAGE is a
picture that lentray made with Lenticular=On, or any interlaced picture. What it
says of its sheet is used; options below say what it does not. VIEW... are ready
pictures, rendered or taken with a camera, all of one size. Photographs stand upright as
their files say.

View j is what all lenses show at one place behind them, a pixel a lens. View 0
is seen from the right, the last one from the left. Where the number of pixels a
lens is not whole, a view has the nearest pixel of each lens.

Without a task the sheet of IMAGE is reported.

Tasks:
  --view J               one view
  --views A..B           views A to B, a file each
  --all                  all views
  --lens I               the pixels behind lens I, counted from 0
  --eye ANGLE[,MM]       what an eye sees through the sheet that looks at its
                         middle from ANGLE degrees to the right, from MM before it
                         (the sheet's own viewing distance); ANGLE degrees above,
                         where the lenses lie across
  --quilt CxR            C x R views in one picture, the leftmost camera's lower
                         left, as light-field displays want it
  --stereo               two views side by side, the left eye's on the left
  --anaglyph, --anaglyph=plain
                         two views for red and cyan glasses: colours by Dubois'
                         matrix, or plainly red of one and green and blue of the other
  --wiggle FILE          the views one after another, as FILE.gif or as an animated
                         FILE.png. IMAGE may be a quilt, whose grid its file says or
                         the end of its name, _qs8x6a0.75
  --preview FILE.html    a page for browsers that shows the sheet as eyes see it:
                         tilted with mouse, fingers, keys or the device, in true
                         size, for both eyes. It holds all it needs
  --interlace            the integral image of the pictures, with what is said of the
                         lens sheet in its file

Options:
  --out FILE             the picture: .png, .tif, .exr or .jpg. Of several views
                         each gets its number before the end, or where # stands
  --size WxH             size of each view, or of the integral image: pixels. Of
                         --interlace also the lens sheet's, such as 100x75mm
  --square               views in square pixels instead of a pixel a lens
  --filter NAME          box, triangle, mitchell or lanczos3 where sizes change
                         (lanczos3)
  --count M              M views at equal steps over the lens (the pixels a lens,
                         rounded down; of a quilt all it has)
  --between              --eye: colours between pixels of the print, not the nearest
  --one-zone             --stereo, --anaglyph: both eyes look into one zone of the sheet,
                         moved to the side and closer together as that takes. In two
                         zones depth is reversed, which is warned of
  --eyes MM              --stereo, --anaglyph, --preview: between both eyes (65)
  --pair L,R             instead: the views of the left and of the right eye
  --delay MS             --wiggle: how long a view is shown (100)
  --motion sway|loop     --wiggle: to and fro, or again from the first one, as the
                         phases of an animation (as the file says, else sway);
                         --interlace: what the file says
  --page-limit MB        --preview: how large the page may be (20). Where the pixels
                         as they are do not fit they become JPEG, and then fewer
                         rows; both are reported
  --order natural|given  IMG_1, IMG_10, IMG_2, as shells have them, become IMG_1, IMG_2,
                         IMG_10, which is reported (natural); other orders stay anyway
  --profile srgb|keep    pictures with a colour profile are converted to sRGB (srgb), or
                         stay as they are, and the profile goes into the file
  --from-left            VIEW... begins with the leftmost camera's picture
  --from-top             or with the highest one's, where lenses lie across
  --like IMAGE           --interlace: for the same sheet as IMAGE, and as large
  --take-any             --interlace: integral images too, whose strips are torn

Sheet, in lentray's words and lengths (40cm, 0.9mm; mm without a unit):
  --lens-sheet NAME      a lens sheet by name; list shows all
  --lpi L, --lens-pitch P
                         lenses an inch, or the width of a lens
  --print-lpi L          instead: the number that a pitch test has found
  --lens-thickness T, --lens-radius R, --lens-angle DEGREES
                         other data that the lens follows from
  --dpi D|DxE            pixels an inch of the print: across the lenses, and along
                         them. With the pitch they give the pixels a lens
  --lens-pixels N        pixels a lens
  --lens-focal-length MM
                         from the lens to the print, in the lens's material
  --lens-ior N           refractive index of the material
  --across               the lenses lie across the upright picture: view 0 is seen from
                         below, the last one from above, and angles are up and down
  --lens-slant DEGREES   of the lenses, or its tangent as a fraction (1/6)
  --lens-model NAME      paraxial, pinhole or thick
  --view-distance V      from the sheet to the eye the print is for; inf: infinite
  --aspect N             width of the sheet, or of a quilt's display, by its height
  --help, --version

Examples:
  lentray scene.pov Lenticular=On +W1200 +H900 +Osheet.png
  lentray-views sheet.png
      What the sheet is: lenses, views, sizes.
  lentray-views sheet.png --all --square --out view##.png
      Its 15 views as pictures to look at.
  lentray-views sheet.png --wiggle sheet.gif --square
  lentray-views sheet.png --preview sheet.html
      To look at it in a browser, as through its lenses.
  lentray-views sheet.png --eye 10,400 --out right.png
  lentray-views --interlace front.jpg back.jpg --lens-sheet 40lpi --dpi 600 \
    --size 100x75mm --view-distance 40cm --out flip.png
      A flip print: each picture has half of the pixels behind a lens.

Exit status: 0 done, 1 something is wrong with the pictures or could not be
written.
)";
}

}  // namespace lentray::views
