#version 3.6;

global_settings {
	assumed_gamma 1.0
	max_trace_level 20
}

camera {
	location <0, 2, -15>
	look_at <0, 3, 0>
	right x*image_width/image_height
}

light_source {
	<-9, 12, -14>
	<1, 1, 1>
}

// a clear sheet that bends what is behind it
box {
	<-9, -5, -9.1>
	<9, 12, -9>
	hollow
	pigment { rgbt 1 }
	normal { wrinkles 0.06 scale 2 }
	interior { ior 1.08 }
}

#declare rnd = seed(31);

#macro twig(from, along, thick, hue, depth)
	#local to = from + along;
	cylinder {
		from
		to
		thick
		1.5
		pigment { rgb hue }
	}
	#if (depth > 0)
		#local n = 0;
		#while (n < 2 + (rand(rnd) > 0.6))
			twig(to, vrotate(along*0.8, (rand(rnd)*90 - 45)*x + (rand(rnd)*120 - 60)*z), thick*0.8, hue*<0.9, 1.15, 1>, depth - 1)
			#local n = n + 1;
		#end
	#end
#end

blob {
	threshold 0.6
	twig(<0, -2, 0>, <0, 2, 0>, 0.9, <0.6, 0.25, 0.1>, 5)
	sturm on
}
