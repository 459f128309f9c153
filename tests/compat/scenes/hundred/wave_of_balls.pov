// animation of a class; still at clock 0
// Initial_Frame=1 Final_Frame=60
#declare NB=12;
#declare shift=2*pi*clock;
camera{location <0,9,-16> look_at <0,0,0> angle 45}
light_source{<0,20,-15> color rgb<1,1,1>}
#declare i=-NB;
#while(i<=NB)
  #declare j=-NB;
  #while(j<=NB)
    #declare d=sqrt(i*i+j*j)/2.5;
    #declare h=1.4*cos(d+shift)/(1+0.15*d);
    sphere{<i*0.5,h,j*0.5>,0.24
      texture{pigment{color rgb<(h+1.4)/2.8,0.3,1-(h+1.4)/2.8>}finish{phong 0.5}}}
    #declare j=j+1;
  #end
  #declare i=i+1;
#end
plane{y,-2.5 pigment{hexagon color rgb 1 color rgb .7 color rgb .4}}
