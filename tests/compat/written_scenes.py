"""Scenes as people and their programs write them, for tests/compat/ways.py.

Each function writes one way of writing a scene; `r` is a random.Random that chooses numbers and words, so that one
way gives many scenes. A function returns the scene's text, or its bytes where the encoding is the point. What is not
rendered yet (media, radiosity, photons) and jitter are not used; some stones of stones.inc have a crand of 0.03.
"""

COLOURS = ["Red", "Green", "Blue", "Yellow", "Cyan", "Magenta", "White", "Gray60", "Orange", "Firebrick", "SkyBlue",
           "ForestGreen", "Gold", "Orchid", "Tan", "Coral", "MediumSlateBlue", "NeonPink"]
STONES = ["T_Stone1", "T_Stone8", "T_Stone12", "T_Stone24", "T_Stone31", "T_Stone41"]
WOODS = ["T_Wood1", "T_Wood7", "T_Wood13", "T_Wood21", "T_Wood28", "T_Wood34"]
METALS = ["T_Brass_3C", "T_Chrome_2B", "T_Copper_4A", "T_Gold_1C", "T_Silver_5D"]


def num(r, low, high, digits=3):
    return f"{r.uniform(low, high):.{digits}g}"


def vec(r, low, high):
    return "<" + ", ".join(num(r, low, high) for _ in range(3)) + ">"


def rgb(r):
    return "<" + ", ".join(num(r, 0.05, 1) for _ in range(3)) + ">"


def head(r, version="3.7", gamma="1.0"):
    return (f"#version {version};\nglobal_settings {{ assumed_gamma {gamma} }}\n" +
            f"camera {{ location <{num(r, -4, 4)}, {num(r, 1.5, 5)}, {num(r, -9, -6)}> look_at <0, 0.8, 0> "
            f"angle {r.randint(35, 60)} }}\n" +
            f"light_source {{ <{num(r, -9, 9)}, {num(r, 6, 12)}, -8> color rgb {num(r, .7, 1.2)} }}\n")


FLOOR = "plane { y, 0 pigment { checker rgb 0.9 rgb 0.4 } finish { ambient 0.15 diffuse 0.7 } }\n"


def version_one(r):
    """POV-Ray 1.0: no hash signs, colour by components, no braces' help."""
    return f"""// A scene of 1993
#version 1.0
#include "colors.inc"
#include "shapes.inc"
#include "textures.inc"
declare Ball = sphere {{ <0 0 0> {num(r, .7, 1.2)} }}
#declare Shiny = texture {{ phong 1 phong_size {r.randint(20, 90)} reflection {num(r, .1, .3)} ambient 0.2 diffuse
  0.6 }}
camera {{
   location <0 {num(r, 2, 4)} -8>
   direction <0 0 1.4>
   up <0 1 0>
   right <1.3333 0 0>
   look_at <0 1 0>
}}
object {{
   light_source {{ <{num(r, -9, 9)} 10 -9> colour White }}
}}
object {{
   union {{
      object {{ Ball translate <-1.2 1 0> }}
      object {{ Ball scale <1 {num(r, .5, 1.5)} 1> translate <1.2 1 0.3> }}
   }}
   texture {{ Shiny colour {r.choice(["Red", "Green", "Yellow", "Orange"])} }}
}}
object {{
   plane {{ <0 1 0> -0.2 }}
   texture {{ checker colour red 0.8 green {num(r, .3, .9)} blue 0.2 colour red 0.1 green 0.1 blue 0.5 scale 1.5 }}
}}
"""


def version_two(r):
    """POV-Ray 2: #declare without semicolons, color names, bounded_by, old metallic."""
    return f"""// persistence of vision raytracer 2.2
#version 2.0
#include "colors.inc"
#include "textures.inc"
#include "stones.inc"
#declare R = {num(r, .6, 1)}
#declare Post = union {{
  cylinder {{ <0, 0, 0>, <0, 2, 0>, 0.25 }}
  sphere {{ <0, 2.2, 0>, R*0.5 }}
  box {{ <-0.4, 0, -0.4>, <0.4, 0.2, 0.4> }}
  bounded_by {{ box {{ <-1, -0.1, -1>, <1, 3.2, 1> }} }}
}}
camera {{ location <{num(r, -3, 3)}, 3, -7> look_at <0, 1, 0> }}
light_source {{ <-8, 10, -6> color White }}
light_source {{ <9, 4, -9> color Gray40 }}
object {{ Post texture {{ T_Stone{r.randint(1, 20)} }} translate <-1.5, 0, 0> }}
object {{ Post texture {{ pigment {{ color {r.choice(COLOURS[:7])} }} finish {{ metallic phong {num(r, .3, 1)} }} }}
  translate <0, 0, 1> }}
object {{ Post pigment {{ DMFWood{r.randint(1, 5)} scale 0.4 }} translate <1.5, 0, 0> }}
plane {{ y, 0 pigment {{ Jade scale 2 }} finish {{ reflection {num(r, 0, .3)} }} }}
fog {{ color Gray70 distance {r.randint(20, 60)} }}
"""


def version_three(r):
    """POV-Ray 3.0 and 3.1 with loops, #switch, hollow glass, and 'texture' before everything."""
    n = r.randint(8, 16)
    return f"""#version 3.1;
#include "colors.inc"
#include "glass.inc"
#include "metals.inc"
#include "math.inc"
global_settings {{ max_trace_level 6 }}
camera {{ location <0, 5, -9> look_at <0, 0.5, 0> angle 48 }}
light_source {{ <-10, 14, -12> color rgb 1 }}
#declare Count = 0;
#while (Count < {n})
  #declare Angle = Count*360/{n};
  object {{
    #switch (mod(Count, 3))
      #case (0) sphere {{ 0, 0.5 }} #break
      #case (1) cone {{ -0.5*y, 0.6, 0.6*y, 0.1 }} #break
      #else torus {{ 0.4, 0.15 rotate 90*x }}
    #end
    #if (even(Count))
      texture {{ {r.choice(METALS)} }}
    #else
      texture {{ pigment {{ color rgbf <{num(r, .6, 1)}, 0.95, {num(r, .6, 1)}, 0.85> }} finish {{ F_Glass1 }} }}
        interior {{ ior {num(r, 1.1, 1.6)} }}
    #end
    translate <{num(r, 2, 3)}, 0.6, 0>
    rotate y*Angle
  }}
  #declare Count = Count + 1;
#end
plane {{ y, 0 texture {{ pigment {{ hexagon color {r.choice(COLOURS)} color White color {r.choice(COLOURS)} scale
  0.8 }} }} }}
sky_sphere {{ pigment {{ gradient y color_map {{ [0 color Blue*0.4] [1 color White] }} }} }}
"""


def windows(r):
    """CR LF, tabs, a byte-order mark, includes without .inc, drive letters in comments, DOS's end mark."""
    text = f"""// Erstellt mit POV-Ray f\u00fcr Windows - C:\\Szenen\\k\u00fcche.pov
#version 3.6;
#include "colors.inc"
#include "textures"
#include "woods.inc"
global_settings {{ assumed_gamma 2.2 }}
camera\t{{ location\t<{num(r, -3, 3)}, 3, -7>\tlook_at\t<0, 1, 0>\tright\tx*image_width/image_height }}
light_source\t{{ <{num(r, -9, 9)}, 9, -9>, 1 }}
#declare H\u00f6he = 2;
""".replace("H\u00f6he", "Hoehe") + f"""
#declare Tisch = union {{
\tbox {{ <-2, 1, -1>, <2, 1.15, 1> texture {{ {r.choice(WOODS)} rotate 90*y scale 0.6 }} }}
\t#declare I = -1; #while (I <= 1) #declare J = -1; #while (J <= 1)
\t\tcylinder {{ <I*1.8, 0, J*0.8>, <I*1.8, 1, J*0.8>, 0.1 texture {{ {r.choice(WOODS)} }} }}
\t#declare J = J + 2; #end #declare I = I + 2; #end
}}
object {{ Tisch rotate {r.randint(-40, 40)}*y }}
sphere {{ <0, {num(r, 1.4, 1.7)}, 0>, 0.35 texture {{ pigment {{ {r.choice(COLOURS[:7])} }} finish {{ Shiny }} }} }}
plane {{ y, 0 pigment {{ Gray75 }} normal {{ bumps {num(r, .1, .5)} scale 0.1 }} }}
"""
    data = text.replace("\n", "\r\n")
    choice = r.randint(0, 2)
    if choice == 0:
        return b"\xef\xbb\xbf" + data.encode("utf-8") + b"\x1a"
    return data.encode("latin-1" if choice == 1 else "utf-8") + (b"\x1a" if choice == 2 else b"")


def other_scripts(r):
    """Comments and strings in other scripts; text beyond ASCII."""
    word = r.choice(["\u00dcbergr\u00f6\u00dfe", "Caf\u00e9", "\u00c5ngstr\u00f6m",
                     "Se\u00f1or", "na\u00efve", "Stra\u00dfe"])
    comment = r.choice(["\u7403\u4f53\u3068\u5e73\u9762",
                        "\u0428\u0430\u0440 \u0438 \u043f\u043b\u043e\u0441\u043a\u043e\u0441\u0442\u044c",
                        "\u0643\u0631\u0629", "\u03c3\u03c6\u03b1\u03af\u03c1\u03b1"])
    return (head(r) + f"""
global_settings {{ charset utf8 }}
/* {comment} */
#declare Nom = "{word}"; // {comment}
#debug concat("{comment} ", Nom, "\\n")
text {{ ttf "timrom.ttf" Nom {num(r, .2, .6)}, 0
  pigment {{ rgb {rgb(r)} }} finish {{ phong 0.6 }} scale {num(r, .9, 1.4)} translate <-2.2, 0.3, 0> rotate
    {r.randint(-20, 20)}*y }}
text {{ ttf "cyrvetic.ttf" "{r.choice(["POV-Ray", "Scene", "2026", "lens & print"])}" 0.3, <0.05, 0, 0>
  pigment {{ rgb {rgb(r)} }} scale 0.7 translate <-1.8, 1.6, 0.5> }}
""" + FLOOR)


def huge_sky(r):
    """Sky as a sphere of 1e9 (beyond what stock sees), 1e6 or a plane of clouds; water below."""
    size = r.choice(["1e9", "1e8", "9e6", "1e5", "10000"])
    return (head(r) + f"""
#include "colors.inc"
#include "skies.inc"
sphere {{ 0, {size} hollow on inverse
  texture {{ pigment {{ bozo turbulence {num(r, .3, 1)} octaves 6 omega 0.6 lambda 2
      color_map {{ [0 rgb <0.85, 0.87, 0.9>] [0.4 rgb 0.95] [0.7 rgb <0.25, 0.45, 0.8>] [1 rgb <0.15, 0.3, 0.7>] }}
      scale <{size}*0.2, {size}*0.05, {size}*0.2> }} finish {{ ambient 1 diffuse 0 }} }} }}
plane {{ y, {r.choice(["1e7", "500", "200"])} hollow pigment {{ bozo color_map {{ [0 rgbt 1] [1 rgbt <1, 1, 1, 0.3>]
  }} scale 80 }}
  finish {{ ambient 0.9 diffuse 0 }} }}
sky_sphere {{ {r.choice(["S_Cloud1", "S_Cloud2", "S_Cloud3"])} }}
plane {{ y, 0 pigment {{ rgb <0.1, 0.2, 0.3> }} normal {{ ripples {num(r, .1, .4)} frequency 3 scale {num(r, 1, 4)}
  }} finish {{ reflection 0.35 ambient 0.1 }} }}
sphere {{ <0, 1, 0>, 1 pigment {{ rgb {rgb(r)} }} finish {{ phong 0.8 reflection 0.1 }} }}
box {{ <-3, 0, 2>, <-2, {num(r, 1, 3)}, 3> pigment {{ brick rgb 0.8 rgb <0.6, 0.2, 0.1> scale 0.08 }} rotate
  {r.randint(0, 40)}*y }}
""")


def picture_maps(r):
    """GIF, Targa and PNG maps, with every interpolation and mapping."""
    file = r.choice(['tga "map8.tga"', 'tga "map24.tga"', 'tga "map32.tga"', 'gif "map.gif"', 'png "map.png"'])
    other = r.choice(['tga "map24.tga"', 'gif "map.gif"', 'png "map.png"'])
    return (head(r) + f"""
#declare Picture = pigment {{ image_map {{ {file} map_type 0 {r.choice(["", "interpolate 2", "interpolate 4"])}
  {r.choice(["once", ""])} }} translate <-0.5, -0.5, 0> scale 2.6 }};
box {{ <-1.3, 0, 0>, <1.3, 2.6, 0.1> pigment {{ Picture translate 1.3*y }} finish {{ ambient 0.4 }} rotate
  {r.randint(-25, 25)}*y translate <-1, 0, 1.5> }}
sphere {{ 0, 1 pigment {{ image_map {{ {file} map_type 1 interpolate 2 }} }} rotate {r.randint(0, 360)}*y translate
  <1.6, 1, 0> }}
cylinder {{ 0, y, 0.7 pigment {{ image_map {{ {other} map_type 2 }} }} translate <-1.8, 0, -1.4> }}
torus {{ 0.7, 0.25 pigment {{ image_map {{ {other} map_type 5 interpolate 4 }} }} rotate {r.randint(0, 90)}*x
  translate <0.4, 0.6, -2> }}
plane {{ y, 0 pigment {{ rgb {rgb(r)} }} normal {{ bump_map {{ {other} bump_size {num(r, .5, 3)} interpolate 2 }}
  rotate 90*x scale {num(r, 1, 3)} }} }}
disc {{ <2.6, 2.2, 2>, -z, 0.9 texture {{ material_map {{ gif "map.gif" texture {{ pigment {{ rgb x }} }} texture {{
  pigment {{ rgb y }} finish {{ phong 1 }} }} texture {{ pigment {{ rgb z }} }} }} translate -0.5 scale 2 }} }}
""")


def uv_normals(r):
    """uv mapping with normals, on things that are turned and stretched afterwards."""
    return (head(r) + f"""
#declare Skin = texture {{
  uv_mapping
  pigment {{ checker rgb {rgb(r)} rgb {rgb(r)} scale <{num(r, .05, .2)}, {num(r, .05, .2)}, 1> }}
  normal {{ {r.choice(["bumps 0.4", "gradient x 0.5", "ripples 0.3", "quilted 0.6", "leopard 0.4"])} scale
    <{num(r, .02, .2)}, {num(r, .02, .2)}, 1> }}
  finish {{ phong 0.5 phong_size 30 }}
}}
sphere {{ 0, 1 texture {{ Skin }} rotate <{r.randint(0, 90)}, {r.randint(0, 90)}, 0> scale <1, {num(r, .6, 1.3)}, 1>
  translate <-1.8, 1, 0> }}
torus {{ 0.7, 0.3 texture {{ Skin }} rotate {r.randint(20, 80)}*x translate <0.3, 1, 0.6> }}
lathe {{ cubic_spline 6 <0, -0.2>, <0.4, 0>, <0.8, 0.5>, <0.3, 1.2>, <0.5, 1.7>, <0.4, 2> texture {{ Skin }} rotate
  {r.randint(0, 90)}*y translate <2, 0, 0> }}
mesh2 {{
  vertex_vectors {{ 4, <-1, 0, 0>, <1, 0, 0>, <1, 1.5, 0.3>, <-1, 1.5, -0.2> }}
  uv_vectors {{ 4, <0, 0>, <1, 0>, <1, 1>, <0, 1> }}
  face_indices {{ 2, <0, 1, 2>, <0, 2, 3> }}
  texture {{ Skin }} rotate {r.randint(-60, 60)}*y scale <{num(r, .6, 1.2)}, 1, 1> translate <0, 0, 2.5>
}}
box {{ -0.4, 0.4 texture {{ Skin }} rotate {vec(r, 0, 90)} translate <-0.2, 0.6, -2> }}
""" + FLOOR)


def splines(r):
    """Paths along splines, with times that are equal or out of order."""
    kind = r.choice(["linear_spline", "quadratic_spline", "cubic_spline", "natural_spline"])
    twice = r.choice(["0.5", "0.25"])
    return (head(r) + f"""
#declare Path = spline {{
  {kind}
  -0.25, <-4, 0.3, 2>
  0.00, <-3, {num(r, .3, 1)}, 1>
  {twice}, <-1, {num(r, 1, 2)}, 0>
  0.50, <0, {num(r, .5, 2)}, -1>
  0.75, <{num(r, .5, 2)}, 1, 0>
  1.00, <3, 0.5, 1>
  1.25, <4, 0.3, 2>
}}
#declare Colours = spline {{ linear_spline 0, x 0.5, y 0.5, <1, 1, 0> 1, z }}
#declare I = 0;
#while (I <= 1.001)
  sphere {{ Path(I), {num(r, .12, .25)} pigment {{ rgb Colours(I) }} finish {{ phong 0.7 }} }}
  #declare I = I + 1/{r.randint(20, 40)};
#end
cylinder {{ Path(0), Path(1), 0.05 pigment {{ rgb 0.3 }} }}
sphere_sweep {{ {r.choice(["linear_spline", "b_spline"])} 5, <-3, 0.2, -1>, 0.1 <-1, {num(r, .2, 1)}, -2>, 0.2 <0,
  0.6, -2.4>, 0.15 <1, 0.4, -2>, 0.2 <3, 0.3, -1>, 0.1
  pigment {{ rgb {rgb(r)} }} }}
""" + FLOOR)


def clipped_unions(r):
    """Open shells: unions, spheres and boxes cut by clipped_by, with insides of their own."""
    return (head(r) + f"""
#declare Shell = union {{
  sphere {{ <-0.6, 1, 0>, 1 }}
  sphere {{ <0.6, 1, 0>, {num(r, .7, 1)} }}
  cylinder {{ <-1.5, 0.4, 0>, <1.5, 0.4, 0>, 0.3 open }}
}}
union {{
  object {{ Shell }}
  clipped_by {{ plane {{ <{num(r, -.6, .6)}, 1, -0.7>, {num(r, .5, 1.1)} }} }}
  texture {{ pigment {{ rgb {rgb(r)} }} finish {{ phong 0.4 }} }}
  interior_texture {{ pigment {{ rgb {rgb(r)} }} finish {{ ambient 0.3 }} }}
  rotate {r.randint(0, 60)}*y
}}
box {{ <-1, 0, -1>, <1, 1.4, 1> clipped_by {{ sphere {{ <0, 0.7, 0>, {num(r, 1, 1.3)} }} }} pigment {{ brick }}
  scale 0.7 translate <-2.6, 0, 0.5> }}
difference {{
  sphere {{ <2.6, 1, 0.4>, 1 }}
  box {{ <2.6, 0.5, -2>, <4, 3, 3> pigment {{ rgb {rgb(r)} }} }}
  cylinder {{ <2.6, 1, -3>, <2.6, 1, 3>, {num(r, .2, .5)} }}
  clipped_by {{ plane {{ z, {num(r, .2, .8)} }} }}
  pigment {{ rgb {rgb(r)} }}
}}
cone {{ <0, 0, -2.4>, 0.8, <0, 1.2, -2.4>, 0.2 open clipped_by {{ plane {{ x, {num(r, -.2, .4)} }} }} pigment {{ rgb
  {rgb(r)} }} hollow }}
""" + FLOOR)


def heights_in_csg(r):
    """Height fields cut to plinths, islands and relief maps."""
    file = r.choice(['tga "map24.tga"', 'gif "map.gif"', 'png "map.png"', 'png "heights16.png"'])
    return (head(r) + f"""
#declare Land = height_field {{ {file} {r.choice(["smooth", ""])} water_level {num(r, 0, .2)} translate <-0.5, 0,
  -0.5> scale <4, {num(r, .6, 1.4)}, 4> }}
intersection {{
  object {{ Land rotate {r.randint(0, 90)}*y }}
  {r.choice(["cylinder { -y, 3*y, 1.7 }", "box { <-1.4, -1, -1.4>, <1.4, 3, 1.4> }", "sphere { 0, 1.8 }"])}
  pigment {{ gradient y color_map {{ [0 rgb <0.2, 0.3, 0.1>] [0.5 rgb <0.5, 0.4, 0.3>] [1 rgb 1] }} scale
    {num(r, .6, 1.4)} }}
}}
difference {{
  box {{ <-1, 0, -1>, <1, {num(r, .4, .9)}, 1> }}
  height_field {{ {file} translate <-0.5, 0, -0.5> scale <1.8, 0.5, 1.8> rotate 180*x translate {num(r, .6, 1)}*y }}
  pigment {{ rgb {rgb(r)} }}
  translate <2.8, 0, 0.5>
}}
union {{
  object {{ Land scale 0.4 }}
  box {{ <-0.8, -0.3, -0.8>, <0.8, 0.02, 0.8> }}
  pigment {{ rgb {rgb(r)} }}
  rotate {r.randint(0, 60)}*y translate <-2.8, 0.3, -0.4>
}}
plane {{ y, -0.01 pigment {{ rgb <0.2, 0.3, 0.5> }} finish {{ reflection 0.2 }} }}
""")


def exporter_mesh(r):
    """What a modelling program writes: one mesh2 with long lists, a camera by matrix, numbers with many digits."""
    side = r.randint(8, 14)
    points, normals, faces = [], [], []
    for j in range(side + 1):
        for i in range(side + 1):
            x, z = 4 * i / side - 2, 4 * j / side - 2
            height = 0.8 + 0.5 * ((i * 7 + j * 3) % 5) / 5 * r.uniform(.8, 1.2)
            points.append(f"<{x:.6f}, {height:.6f}, {z:.6f}>")
            normals.append(f"<{r.uniform(-.3, .3):.6f}, 1.000000, {r.uniform(-.3, .3):.6f}>")
    for j in range(side):
        for i in range(side):
            k = j * (side + 1) + i
            faces += [f"<{k}, {k + 1}, {k + side + 2}>", f"<{k}, {k + side + 2}, {k + side + 1}>"]
    n = len(points)
    return f"""// POV-Ray 3.7 Scene File " written by an exporter"
#version 3.7;
global_settings {{
    assumed_gamma 1
    max_trace_level 5
}}
background {{ rgbt <{num(r, .03, .2)}, {num(r, .03, .2)}, {num(r, .03, .2)}, 0> }}
#declare camera_Camera =
camera {{
    perspective
    location  <0, 0, 0>
    look_at  <0, 0, -1>
    right <-1.33333, 0, 0>
    up <0, 1, 0>
    angle  {num(r, 45, 60, 6)}
    matrix <0.685881, 0.727634, -0.010817, -0.317370, 0.312469, 0.895343, 0.654862, -0.610666, 0.445245,
      {num(r, 5, 6)}, {num(r, -7, -6)}, {num(r, 5, 6)}>
}}
camera {{ camera_Camera }}
light_source {{
    < 0,0,0 >
    color rgb<1, 1, 1>
    fade_distance {num(r, 20, 30)}
    fade_power 2
    matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, {num(r, -4, 4)}, 9.0, {num(r, -5, -2)}>
}}
#declare shader_Material_diffuse_with_specular = finish {{ phong {num(r, .1, .9)} phong_size 55 ambient rgb<0.1,
  0.1, 0.1> diffuse {num(r, .5, .9)} }}
mesh2 {{
    vertex_vectors {{
        {n},
        {", ".join(points)}
    }}
    normal_vectors {{
        {n},
        {", ".join(normals)}
    }}
    texture_list {{ 2
        texture {{ pigment {{ rgbft<{num(r, 0, 1)}, 0.8, {num(r, 0, 1)}, 0, 0> }} finish {{
          shader_Material_diffuse_with_specular }} }}
        texture {{ pigment {{ rgbft<0.8, {num(r, 0, 1)}, 0.2, 0, 0> }} finish {{
          shader_Material_diffuse_with_specular }} }}
    }}
    face_indices {{
        {len(faces)},
        {", ".join(face + "," + str(k % 2) for k, face in enumerate(faces))}
    }}
    inside_vector <0, 0, 1>
}}
"""


def molecules(r):
    """What programs of chemists write: #default, macros for atoms and bonds, no shadows, orthographic."""
    atoms, bonds = [], []
    last = None
    for _ in range(r.randint(18, 30)):
        p = (r.uniform(-2.4, 2.4), r.uniform(-1.8, 1.8), r.uniform(-1, 1))
        text = "<{:8.4f},{:8.4f},{:8.4f}>".format(*p)
        atoms.append(f"atom({text}, {num(r, .2, .45)}, rgb {rgb(r)}, 0.0, jmol) // #{len(atoms)}")
        if last:
            bonds.append(f"cylinder {{{last}, {text}, Rbond texture{{pigment {{color rgb<{num(r, .2, 1)}, 0.5, 0.5> "
                         "transmit 0.0} finish{jmol}}}")
        last = text
    return f"""#version 3.6;
#include "colors.inc"
#include "finish.inc"
global_settings {{assumed_gamma 1 max_trace_level 6}}
background {{color White}}
camera {{orthographic
  right -6.40*x up 4.80*y
  direction 1.00*z
  location <0,0,{num(r, 20, 50)}> look_at <0,0,0>}}
light_source {{<  2.00,   3.00,  40.00> color White
  area_light <0.70, 0, 0>, <0, 0.70, 0>, 3, 3
  adaptive 1}}
#declare simple = finish {{phong 0.7}}
#declare pale = finish {{ambient .5 diffuse .85 roughness .001 specular 0.200 }}
#declare jmol = finish {{ambient .2 diffuse .6 specular 1 roughness .001 metallic}}
#declare Rcell = 0.020;
#declare Rbond = {num(r, .06, .12)};
#macro atom(LOC, R, COL, TRANS, FIN)
  sphere{{LOC, R texture{{pigment{{color COL transmit TRANS}} finish{{FIN}}}}}}
#end
#macro constrain(LOC, R, COL, TRANS FIN)
union{{torus{{R, Rcell rotate 45*z texture{{pigment{{color COL transmit TRANS}} finish{{FIN}}}}}}
     torus{{R, Rcell rotate -45*z texture{{pigment{{color COL transmit TRANS}} finish{{FIN}}}}}}
     translate LOC}}
#end
{chr(10).join(bonds)}
{chr(10).join(atoms)}
constrain(<0, 0, 1>, 0.5, {r.choice(["Green", "Red"])}, 0.0, pale)
"""


def plots(r):
    """A surface of a function as triangles in a loop, with axes and labels."""
    n = r.randint(14, 24)
    height = r.choice(["sin(x*2)*cos(z*2)*0.5", "exp(-(x*x + z*z)/2)*cos(3*x)", "0.3*(x*x - z*z)/2",
                       "sin(sqrt(x*x + z*z + 0.01)*4)*0.3"])
    return (head(r) + f"""
#declare F = function(x, z) {{
  {height} + 1 }}
#macro P(I, J) #local X = -2 + 4*I/{n}; #local Z = -2 + 4*J/{n}; <X, F(X, Z), Z> #end
mesh {{
  #declare I = 0;
  #while (I < {n}) #declare J = 0; #while (J < {n})
    triangle {{ P(I, J), P(I+1, J), P(I+1, J+1) }}
    triangle {{ P(I, J), P(I+1, J+1), P(I, J+1) }}
  #declare J = J + 1; #end #declare I = I + 1; #end
  pigment {{ gradient y color_map {{ [0 rgb z] [0.4 rgb y] [0.7 rgb <1, 1, 0>] [1 rgb x] }} scale {num(r, 1.4, 2)} }}
  finish {{ ambient 0.2 diffuse 0.8 }}
}}
#macro Axis(D, C) union {{ cylinder {{ 0, D*2.6, 0.03 }} cone {{ D*2.6, 0.08, D*2.9, 0 }} pigment {{ rgb C }}
  translate <-2.2, 0, -2.2> }} #end
Axis(x, <1, 0, 0>) Axis(y, <0, 1, 0>) Axis(z, <0, 0, 1>)
text {{ ttf "timrom.ttf" concat("n = ", str({n}, 0, 0)) 0.05, 0 scale 0.5 pigment {{ rgb 0.1 }} translate <-1, 0.05,
  -3> }}
plane {{ y, -0.01 pigment {{ rgb 0.9 }} }}
""")


def recursion(r):
    """A tree or a fractal of macros."""
    return (head(r) + f"""
#declare Seed = seed({r.randint(1, 9999)});
#macro Tree(Level, Length)
  #if (Level > 0)
    union {{
      cone {{ 0, Length*0.12, Length*y, Length*0.08 }}
      #local K = 0;
      #while (K < 3)
        object {{ Tree(Level - 1, Length*{num(r, .6, .72)}) rotate (20 + 25*rand(Seed))*z rotate (K*120 +
          30*rand(Seed))*y translate Length*y }}
        #local K = K + 1;
      #end
    }}
  #else
    sphere {{ 0, {num(r, .08, .16)} pigment {{ rgb <0.2 + 0.3*rand(Seed), 0.7, 0.2> }} }}
  #end
#end
object {{ Tree({r.randint(3, 4)}, {num(r, .9, 1.2)}) pigment {{ rgb <0.5, 0.35, 0.2> }} translate -1.6*x }}
#macro Sponge(C, S, N)
  #if (N = 0) box {{ C - S/2, C + S/2 }}
  #else
    #local A = -1; #while (A <= 1) #local B = -1; #while (B <= 1) #local D = -1; #while (D <= 1)
      #if (abs(A) + abs(B) + abs(D) > 1) Sponge(C + <A, B, D>*S/3, S/3, N - 1) #end
    #local D = D + 1; #end #local B = B + 1; #end #local A = A + 1; #end
  #end
#end
union {{ Sponge(0, 1.8, {r.randint(1, 2)}) pigment {{ rgb {rgb(r)} }} rotate <{r.randint(0, 30)},
  {r.randint(0, 60)}, 0> translate <1.7, 1.2, 0> }}
""" + FLOOR)


def still_life(r):
    """Glass, metal and stone on a table, area light, mirror."""
    return f"""#include "colors.inc"
#include "textures.inc"
#include "metals.inc"
#include "stones.inc"
#include "glass.inc"
#include "woods.inc"
#version 3.7;
global_settings {{ assumed_gamma 1.0 max_trace_level {r.randint(5, 12)} }}
camera {{ location <0, 3, -7> direction 1.5*z right x*image_width/image_height look_at <0, 0.9, 0> }}
light_source {{ <-6, 8, -5> color White*0.9 area_light <1.5, 0, 0>, <0, 0, 1.5>, {r.randint(3, 5)},
  {r.randint(3, 5)} adaptive {r.randint(0, 1)} circular orient }}
light_source {{ <6, 5, -6> color rgb <0.3, 0.3, 0.4> shadowless }}
#declare Glass = lathe {{ quadratic_spline 8, <0, 0>, <0.5, 0>, <0.1, 0.15>, <0.08, 0.8>, <0.5, 1.1>, <0.6, 1.6>,
  <0.52, 1.6>, <0.4, 1.15>
  pigment {{ rgbf <0.97, 0.99, 0.98, 0.93> }} finish {{ specular 0.8 roughness 0.005 reflection {{ 0.05, 0.6 fresnel
    on }} conserve_energy }} interior {{ ior {num(r, 1.3, 1.55)} fade_distance 1 fade_power 2 }} }}
object {{ Glass translate <-1.6, 0, -0.3> }}
object {{ Glass scale {num(r, .7, .9)} translate <-0.6, 0, 1> }}
sphere {{ <0.4, 0.5, -0.6>, 0.5 texture {{ {r.choice(METALS)} }} }}
box {{ <-0.5, 0, -0.5>, <0.5, 0.9, 0.5> texture {{ {r.choice(STONES)} scale 0.6 }} rotate {r.randint(0, 80)}*y
  translate <1.6, 0, 0.2> }}
superellipsoid {{ <{num(r, .2, .8)}, {num(r, .2, .8)}> scale 0.4 texture {{ pigment {{ color {r.choice(COLOURS)} }}
  finish {{ Shiny }} }} translate <1.6, 1.3, 0.2> }}
plane {{ y, 0 texture {{ {r.choice(WOODS)} scale 2 rotate <0, 90, 3> }} }}
plane {{ z, 5 pigment {{ rgb <0.8, 0.75, 0.7> }} normal {{ wrinkles 0.3 scale 0.5 }} hollow }}
"""


def shapes_of_manual(r):
    """One of each of the rarer shapes, as in tutorials."""
    points = "<0.2, -0.9>, <0.9, -0.2>, <0.6, 0.6>, <0, 0.9>, <-0.7, 0.5>, <-0.9, -0.2>, <0.2, -0.9>"
    outline = r.choice([f"linear_spline 0, 0.8, 7, {points}", f"quadratic_spline 0, 0.8, 8, <-0.9, -0.2>, {points}",
                        f"cubic_spline 0, 0.8, 9, <-0.9, -0.2>, {points}, <0.9, -0.2>"])
    return (head(r) + f"""
#include "functions.inc"
blob {{ threshold {num(r, .4, .7)} sphere {{ <-0.5, 0, 0>, 1, 1 }} sphere {{ <0.5, 0, 0>, 1, {num(r, .8, 1.4)} }}
  cylinder {{ <0, -0.5, 0>, <0, 1, 0>, 0.5, {num(r, .5, 1)} }}
  pigment {{ rgb {rgb(r)} }} finish {{ phong 1 }} scale 0.8 translate <-2.4, 1, 0> }}
isosurface {{ function {{ sqrt(x*x + y*y + z*z) - 0.8 + f_noise3d(x*{num(r, 2, 5)}, y*3, z*3)*{num(r, .1, .3)} }}
  contained_by {{ sphere {{ 0, 1.1 }} }} max_gradient 3 accuracy 0.001
  pigment {{ rgb {rgb(r)} }} translate <-0.4, 1, 0.8> }}
prism {{ {outline}
  pigment {{ rgb {rgb(r)} }} scale 0.7 rotate {r.randint(-30, 30)}*x translate <1.2, 0.2, -1.4> }}
julia_fractal {{ <-0.083, 0, {num(r, -.85, -.75)}, -0.025> quaternion sqr max_iteration 6 precision 20 pigment {{
  rgb {rgb(r)} }} scale 0.7 translate <2.4, 1, 0.4> }}
sor {{ 6, <0, -0.3>, <0.4, 0>, <{num(r, .3, .7)}, 0.5>, <0.2, 1>, <0.4, 1.3>, <0.5, 1.5> pigment {{ rgb {rgb(r)} }}
  scale 0.8 translate <-1.4, 0, -1.6> }}
bicubic_patch {{ type 1 flatness 0.01 u_steps 3 v_steps 3
  <0, 0, 2>, <1, 0, 0>, <2, 0, 0>, <3, 0, -2>, <0, 1, 0>, <1, 1, {num(r, -2, 2)}>, <2, 1, 0>, <3, 1, 0>,
  <0, 2, 0>, <1, 2, 0>, <2, 2, {num(r, -2, 2)}>, <3, 2, 0>, <0, 3, 2>, <1, 3, 0>, <2, 3, 0>, <3, 3, -2>
  pigment {{ rgb {rgb(r)} }} scale 0.6 translate <0.4, 1.4, 3> }}
poly {{ 4, <1, 0, 0, 0, 2, 0, 0, 2, 0, -2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, -2, 0, 0, 0, 0, 1, 0, -2, 0,
  {num(r, .5, .9)}> sturm pigment {{ rgb {rgb(r)} }} scale 0.5 translate <0, 0.6, -2.4> }}
""" + FLOOR)


def patterns(r):
    """Textures out of many patterns, layered and mapped."""
    kinds = ["agate", "bozo", "crackle", "dents", "granite", "leopard", "marble", "onion", "radial", "spiral1 4",
             "spotted", "waves", "wood", "wrinkles", "cells", "spherical", "cylindrical", "boxed", "planar",
             "mandel 40", "ripples", "gradient <1,1,0>"]
    waves = ["", "frequency 2", "phase 0.3", "sine_wave", "triangle_wave", "poly_wave 2"]

    def pigment():
        return (f"pigment {{ {r.choice(kinds)} turbulence {num(r, 0, .7)} {r.choice(waves)} "
                f"color_map {{ [0 rgb {rgb(r)}] [{num(r, .3, .6)} rgb {rgb(r)}] "
                f"[1 rgbt <{num(r, 0, 1)}, 0.5, 0.5, {num(r, 0, .6)}>] }} "
                f"scale {num(r, .2, .9)} rotate {vec(r, 0, 90)} }}")

    things = []
    for k in range(6):
        place = f"translate <{-3 + 1.2 * k:.2f}, 0.6, {num(r, -1, 1)}>"
        shape = r.choice(["sphere { 0, 0.6 ", "box { -0.5, 0.5 ", "cylinder { -0.6*y, 0.6*y, 0.45 "])
        things.append(f"{shape}texture {{ pigment {{ rgb {rgb(r)} }} }} "
                      f"texture {{ {pigment()} finish {{ phong 0.3 }} }} rotate {r.randint(0, 90)}*y {place} }}")
    return (head(r) + "\n".join(things) + f"""
sphere {{ <0, 2, 2.5>, 1 texture {{ {r.choice(["crackle", "bozo", "gradient y", "checker", "wood"])} texture_map {{
  [0.3 {pigment()} finish {{ reflection 0.2 }}] [0.7 {pigment()} normal {{ bumps 0.5 scale 0.1 }}] }} scale 0.5 }} }}
""".replace("checker texture_map", "leopard texture_map") + FLOOR)


def city(r):
    """Loops, random numbers, arrays and #if in numbers: blocks of houses."""
    return (head(r) + f"""
#declare R1 = seed({r.randint(1, 99999)});
#declare Paint = array[4] {{ rgb {rgb(r)}, rgb {rgb(r)}, rgb {rgb(r)}, rgb {rgb(r)} }}
#declare Roof = array[2][2] {{ {{ 0.2, 0.5 }}, {{ 0.3, {num(r, .2, .8)} }} }}
#for (X, -4, 4)
  #for (Z, -1, 5)
    #local H = 0.3 + rand(R1)*{num(r, 1, 2)}*(rand(R1) > 0.4 ? 1 : 0.4);
    union {{
      box {{ <-0.35, 0, -0.35>, <0.35, H, 0.35> }}
      #if (rand(R1) < 0.5)
        prism {{ conic_sweep linear_spline 0, 1, 5, <0.4, 0.4>, <-0.4, 0.4>, <-0.4, -0.4>, <0.4, -0.4>, <0.4, 0.4>
          rotate 180*x translate y scale <1, Roof[mod(abs(X), 2)][mod(abs(Z), 2)], 1> translate H*y }}
      #else
        cylinder {{ H*y, (H + 0.2)*y, 0.1 }}
      #end
      pigment {{ Paint[int(rand(R1)*4)] }}
      translate <X, 0, Z>
    }}
  #end
#end
light_source {{ <0, 6, -4> rgb <0.5, 0.4, 0.3> spotlight point_at <0, 0, 2> radius {r.randint(10, 20)} falloff
  {r.randint(25, 40)} tightness {r.randint(0, 10)} }}
fog {{ fog_type 2 distance {r.randint(20, 60)} rgb <0.6, 0.7, 0.8> fog_offset 0 fog_alt {num(r, .5, 2)} turbulence 0 }}
""" + FLOOR)


def planting(r):
    """Things set on a landscape with trace(), inside() and extents."""
    return (head(r) + f"""
#include "transforms.inc"
#declare Hill = union {{ sphere {{ <-1, -2, 0>, 3 }} sphere {{ <2, -3, 1>, {num(r, 3.3, 3.8)} }} torus {{ 1.5, 0.5
  translate <0, 0.4, -2> }} }}
object {{ Hill pigment {{ rgb <0.3, 0.6, 0.2> }} }}
#declare S = seed({r.randint(1, 999)});
#declare N = 0;
#while (N < {r.randint(30, 60)})
  #declare From = <-4 + 8*rand(S), 5, -3 + 5*rand(S)>;
  #declare Norm = <0, 0, 0>;
  #declare Hit = trace(Hill, From, -y, Norm);
  #if (vlength(Norm) > 0)
    cone {{ 0, 0.08, {num(r, .3, .6)}*y, 0 pigment {{ rgb <rand(S), 0.5, 0.1> }} Reorient_Trans(y, Norm) translate
      Hit }}
  #end
  #declare N = N + 1;
#end
#declare Low = min_extent(Hill); #declare High = max_extent(Hill);
cylinder {{ <High.x, 0, 0>, <High.x, 2, 0>, 0.05 pigment {{ rgb x }} }}
#if (inside(Hill, <0, 0.5, 0>)) sphere {{ <0, 2.2, 0>, 0.2 pigment {{ rgb y }} }} #else sphere {{ <0, 2.2, 0>, 0.2
  pigment {{ rgb x }} }} #end
plane {{ y, -0.3 pigment {{ rgb <0.2, 0.3, 0.5> }} finish {{ reflection 0.3 }} }}
sky_sphere {{ pigment {{ gradient y color_map {{ [0 rgb <0.9, 0.8, 0.7>] [0.5 rgb <0.3, 0.5, 0.9>] }} }} }}
""")


def csg_machine(r):
    """Machine parts: nested differences, intersections of turned parts, textures of parts, inverse."""
    return (head(r) + f"""
#declare Bolt = difference {{
  union {{
    intersection {{ #local K = 0; #while (K < 3) box {{ <-2, 0, -0.5>, <2, 0.4, 0.5> rotate K*60*y }} #local K = K +
      1; #end }}
    cylinder {{ <0, -1.5, 0>, <0, 0, 0>, 0.3 }}
  }}
  torus {{ 0.3, 0.06 translate -0.4*y }}
  torus {{ 0.3, 0.06 translate -0.8*y }}
  cylinder {{ <0, 0.2, 0>, <0, 1, 0>, {num(r, .1, .25)} pigment {{ rgb x }} }}
}}
#declare Gear = difference {{
  cylinder {{ -0.2*z, 0.2*z, 1 }}
  #declare T = 0; #while (T < {r.randint(8, 14)}) cylinder {{ <1, 0, -1>, <1, 0, 1>, 0.14 rotate
    T*360/{r.randint(8, 14)}*z }} #declare T = T + 1; #end
  box {{ <-0.15, -0.15, -1>, <0.15, 0.15, 1> rotate {r.randint(0, 45)}*z }}
}}
object {{ Bolt pigment {{ rgb 0.7 }} finish {{ metallic specular 0.6 reflection 0.2 }} rotate <{r.randint(10, 60)},
  0, {r.randint(0, 40)}> translate <-1.8, 1.4, 0> }}
object {{ Gear pigment {{ rgb {rgb(r)} }} rotate {r.randint(-50, 50)}*y translate <0.6, 1.05, 0.4> }}
merge {{ object {{ Gear scale 0.6 }} sphere {{ 0, 0.4 }} pigment {{ rgbt <{num(r, .5, 1)}, 1, 1, 0.6> }} interior {{
  ior {num(r, 1, 1.3)} }} rotate 30*y translate <2.4, 0.8, -0.5> }}
intersection {{ sphere {{ 0, 1 }} box {{ -0.75, 0.75 pigment {{ rgb {rgb(r)} }} }} plane {{ <1, 1, -1>,
  {num(r, .5, .9)} pigment {{ rgb {rgb(r)} }} }} pigment {{ rgb {rgb(r)} }} rotate {r.randint(0, 90)}*y translate
  <0, 0.9, -2.2> scale 0.8 }}
""" + FLOOR)


def parameters(r):
    """Parameters by #ifndef, macros with defaults, #range, strings, include of own file, #default."""
    return (head(r) + f"""
#ifndef (Amount) #declare Amount = {r.randint(3, 9)}; #end
#ifdef (Debugging) #debug "debugging\\n" #end
#default {{ pigment {{ rgb {rgb(r)} }} finish {{ ambient 0.1 diffuse 0.8 specular {num(r, 0, .5)} }} }}
#macro Ring(Count, Radius, Item)
  union {{ #local N = 0; #while (N < Count) object {{ Item translate Radius*x rotate y*360*N/Count }} #local N = N +
    1; #end }}
#end
#macro Shade(V)
  #switch (V) #range (0, 0.33) rgb <1, V, 0> #break #range (0.33, 0.66) rgb <V, 1, 0> #break #else rgb <0, V, 1> #end
#end
Ring(Amount, {num(r, 1.5, 2.4)}, sphere {{ 0.4*y, 0.4 }})
object {{ Ring(Amount*2, 1, box {{ -0.15, <0.15, {num(r, .4, 1)}, 0.15> }}) pigment {{ color Shade({num(r, 0, 1)}) }} }}
#local Name = concat("V", str(Amount, 0, 0), "-", strupr("abc"), substr("xyz", 2, 1));
#if (strlen(Name) > 3 & strcmp(Name, "V") != 0)
  text {{ ttf "crystal.ttf" Name 0.2, 0 scale 0.8 translate <-1.2, 1.2, -1> }}
#end
#local V = vaxis_rotate(<1, 0, 0>, <0, 1, 1>, {r.randint(0, 360)});
cylinder {{ 0, V*2 + y, 0.08 pigment {{ rgb <V.x*0.5 + 0.5, V.y*0.5 + 0.5, V.z*0.5 + 0.5> }} }}
plane {{ y, 0 pigment {{ rgb {num(r, .5, .9)} }} }}
""")


def cameras(r):
    """Other cameras and old ways to say where they look."""
    kind = r.choice(["camera { fisheye angle 150 location <0, 2, -2> look_at <0, 1, 2> }",
                     "camera { panoramic location <0, 2, -4> look_at y angle 140 }",
                     "camera { spherical location <0, 1.5, -3> look_at y }",
                     "camera { orthographic location <5, 5, -5> look_at y*0.5 right x*6 up y*4.5 }",
                     "camera { ultra_wide_angle location <0, 2, -4> look_at y angle 130 }",
                     "camera { cylinder 1 location <0, 1, -3> look_at y angle 160 }",
                     "camera { location <0, 0, -7> up y right x*1.33 direction z*1.5 rotate <25, 30, 0> translate y }",
                     "camera { sky <0.3, 1, 0> location <3, 3, -6> look_at <0, 1, 0> angle 50 }",
                     "camera { right -x*1.33 location <3, 3, -6> look_at <0, 1, 0> }",
                     "camera { omnimax location <0, 2, -3> look_at <0, 1, 0> angle 160 }"])
    return f"""#version 3.7; global_settings {{ assumed_gamma 1 ambient_light rgb {num(r, .5, 2)} }}
#include "colors.inc"
{kind}
light_source {{ <{num(r, -5, 5)}, 8, -6>, color {r.choice(["White", "Wheat", "LightBlue"])} cylinder radius 6
  falloff 9 point_at 0 }}
light_source {{ <4, 6, 4>, rgb 0.5 parallel point_at <0, 0, 0> fade_distance {r.randint(5, 20)} fade_power 1 }}
#declare I = -4;
#while (I <= 4)
  sphere {{ <I, 0.5, mod(I*I, 5) - 2>, 0.5 pigment {{ rgb <abs(I)/4, 0.5, 1 - abs(I)/4> }} finish {{ reflection
    {num(r, 0, .4)} }} }}
  box {{ <-0.2, 0, -0.2>, <0.2, 1 + abs(I)/4, 0.2> rotate 45*y translate <I, 0, 3> pigment {{ color
    {r.choice(COLOURS)} }} }}
  #declare I = I + 1;
#end
plane {{ y, 0 pigment {{ checker White, Gray50 }} }}
sky_sphere {{ pigment {{ gradient y color_map {{ [0 White] [1 {r.choice(["SkyBlue", "Navy"])} ] }} }} }}
rainbow {{ angle 42 width 5 distance 1e4 direction <-0.2, -0.2, 1> color_map {{ [0 rgbt <1, 0, 0, 0.9>] [0.5 rgbt
  <0, 1, 0, 0.9>] [1 rgbt <0, 0, 1, 0.9>] }} }}
"""


def untidy(r):
    """Habits: everything on few lines, no version, old names, stray semicolons, commented code, #declare twice."""
    return f"""/* test /* nested */ scene */ #include "colors.inc" // no version
#declare a=1;#declare b=a*{num(r, 1, 3)};#declare c=<a,b,a>;#declare Tex=texture{{pigment{{color Red}}finish{{phong
  .9 ambient .2}}}}
#declare Tex=texture{{pigment{{color {r.choice(COLOURS)}}}finish{{phong .9 ambient .2}}}}
camera{{location<0,2,-6>look_at<0,1,0>}}light_source{{<2,6,-5>color White}}light_source{{<-20,6,-5>color Gray30}}
sphere{{<-1,1,0>,1 texture{{Tex}}}}sphere{{<1,1,0>,b/3 texture{{Tex pigment{{color {r.choice(COLOURS)}}}}}}}
//box{{-1,1 texture{{Tex}}}}
box{{-c/4,c/4 texture{{pigment{{color rgb<{num(r, 0, 1)},.5,{num(r, 0, 1)}>filter
  .3}}}}rotate<10,{r.randint(0, 90)},0>translate<0,.9,-2>}}
plane{{y,0 pigment{{checker color White color Black scale {num(r, .5, 2)}}}finish{{reflection .25}}}}
#if(0)this is not read #end
#declare q=0;#while(q<{r.randint(5, 12)})cylinder{{<q-4,0,3><q-4,1+q*.1,3>.2
  pigment{{rgb<q/12,1-q/12,.4>}}}}#declare q=q+1;#end
#ifdef(View_{r.randint(1, 9)})camera{{location y*9 look_at 0}}#end
cone{{<2.5,0,1>.7<2.5,1.5,1>0 open pigment{{color Yellow}}}}disc{{<-2.6,1,1>,<.2,.4,-1>,.8,.3 pigment{{color Cyan}}}}
triangle{{<-3,0,-1>,<-2,0,-1>,<-2.5,1,-.6>pigment{{color Green}}}}
"""


WAYS = [version_one, version_two, version_three, windows, other_scripts, huge_sky, picture_maps, uv_normals, splines,
        clipped_unions, heights_in_csg, exporter_mesh, molecules, plots, recursion, still_life, shapes_of_manual,
        patterns, city, planting, csg_machine, parameters, cameras, untidy]
