
// printed by a script from a template: empty lines, commas behind the last item, a matrix of the identity

global_settings {
  ambient_light color <1.0, 1.0, 1.0>
  }

background { color rgb <0.93, 0.95, 1.0> }

camera {
  perspective
  location <-3.6, -4.4, 3.2>
  right <-1.3333, 0, 0>
  sky <0, 0, 1>
  angle 38
  look_at <0.0, 0.0, 0.2>
}

light_source { <-2.0, -6.0, 9.0> color <0.95, 0.95, 0.9> parallel point_at <0.0, 0.0, 0.0> }

mesh2 {
  vertex_vectors {
    7,
    <0.0, 0.0, 1.1>,
    <1.4, 0.0, 0.0>,
    <0.7, 1.212436, 0.2>,
    <-0.7, 1.212436, 0.0>,
    <-1.4, 0.0, 0.3>,
    <-0.7, -1.212436, 0.0>,
    <0.7, -1.212436, 0.1>,

  }
  normal_vectors {
    7,
    <0.0, 0.0, 1.0>, <0.8, 0.0, 0.6>, <0.4, 0.7, 0.6>, <-0.4, 0.7, 0.6>, <-0.8, 0.0, 0.6>, <-0.4, -0.7, 0.6>, <0.4, -0.7, 0.6>,

  }
  texture_list {
    4,
    texture { pigment {color rgbt <0.27, 0.0, 0.33, 0.0> } }
    texture { pigment {color rgbt <0.13, 0.57, 0.55, 0.0> } }
    texture { pigment {color rgbt <0.99, 0.91, 0.14, 0.0> } }
    texture { pigment {color rgbt <0.9, 0.3, 0.2, 0.2> } }

  }
  face_indices {
    6,
    <0, 1, 2>, 2, 0, 1,
    <0, 2, 3>, 2, 1, 0,
    <0, 3, 4>, 2, 0, 3,
    <0, 4, 5>, 2, 3, 0,
    <0, 5, 6>, 2, 0, 1,
    <0, 6, 1>, 2, 1, 0,

  }

  matrix < 1.000000, 0.000000, 0.000000,
  0.000000, 1.000000, 0.000000,
  0.000000, 0.000000, 1.000000,
  0.000000, 0.000000, 0.000000 >

  texture { pigment { color rgbf <0.8, 0.8, 0.8, 0.0> } finish { ambient 0.1 diffuse 0.9 } }
}
