/* city generator: houses by hash of their place, streets left free, windows by one texture */
#include "colors.inc"
#declare seed1=seed(40); #declare NX=9; #declare NZ=9; #declare night=0;
#declare Windows=texture{pigment{gradient y color_map{[.5 Gray70][.5 rgbt 1]} scale .4}}
#declare Facade=texture{pigment{gradient x color_map{[.4 rgb <.3,.4,.6>][.4 Gray60]} scale .35} finish{reflection .1}} texture{Windows} 
#declare i=0;
#while(i<NX) #declare j=0; #while(j<NZ)
 #declare h=.5+pow(rand(seed1),2)*5*exp(-pow(i-4,2)/9-pow(j-4,2)/9);
 #if(mod(i,3)!=2&mod(j,4)!=3)
  #switch(int(rand(seed1)*3))
   #case(0) box{<-.45,0,-.45>,<.45,h,.45> texture{Facade} translate<i-4,0,j-4>} #break
   #case(1) union{box{<-.4,0,-.4>,<.4,h*.8,.4>} box{<-.25,0,-.25>,<.25,h,.25>} texture{Facade} translate<i-4,0,j-4>} #break
   #case(2) cylinder{0,h*y,.4 pigment{Wheat*(.5+rand(seed1)/2)} translate<i-4,0,j-4>} #break
  #end
 #else #if(rand(seed1)>.5) sphere{<i-4,.2,j-4>,.2 pigment{ForestGreen}} #end
 #end
#declare j=j+1; #end #declare i=i+1; #end
plane{y,0 pigment{Gray30}}
#if(night) background{Black} #else sky_sphere{pigment{gradient y color_map{[0 White][.5 SkyBlue]}}} #end
light_source{<-40,50,-30> rgb<1,.95,.85>}
camera{location<5,5.5,-9>look_at<0,.8,0>angle 50}
