/* forficula, MIT; with three.js and uPlot, MIT: see LICENSES.txt; sources 873485a8035abf2aae3d89673f9f6db822a537cd0ffd2c0082f8997edfb27fbf */
(()=>{function S(n,t={},...e){let i=document.createElement(n);for(let[s,r]of Object.entries(t))s.includes("-")||s==="role"?i.setAttribute(s,r):i[s]=r;return i.append(...e),i}function sl(n){let t="http://www.w3.org/2000/svg",e=document.createElementNS(t,"svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidden","true");let i=document.createElementNS(t,"path");return i.setAttribute("d",n),e.append(i),e}function nr({colour:n,dash:t}){let e="http://www.w3.org/2000/svg",i=document.createElementNS(e,"svg");i.setAttribute("viewBox","0 0 24 8"),i.setAttribute("aria-hidden","true"),i.classList.add("sample");let s=document.createElementNS(e,"path");return s.setAttribute("d","M0 4H24"),s.setAttribute("stroke",n),s.setAttribute("stroke-dasharray",t.join(" ")),i.append(s),i}function ke(n){return`${n[0]?.toUpperCase()??""}${n.slice(1)}`}function $n(n,t){let e=n.toFixed(t);return(Number(e)===0?0 .toFixed(t):e).replace("-","−")}function nh(n,t){return n.replace(/\{(\w+)\}/g,(e,i)=>t[i])}function Pe(n){let t=Number(n.toPrecision(4)),e=Math.abs(t);return(e!==0&&(e>=1e5||e<.001)?n.toExponential(2):String(t)).replaceAll("-","−")}var ih={};function np(n){ih=n}function ip(n,t){let e=ih[n],[i,s]=e.find(([,,r])=>t>=r||t===0)??e.at(-1);return{unit:i,factor:s}}function sp(n){return Object.values(ih).flat().find(([t])=>t===n)[1]}function Or(n,t){let{unit:e,factor:i}=ip(t,Math.abs(n));return`${Pe(i*n)} ${e}`}function qo(n){return ip("s",Math.max(Math.abs(n.start),Math.abs(n.end)))}function ir(n,t){let{unit:e,factor:i}=qo(t),s=Math.ceil(2.7-Math.log10(i*(t.end-t.start)));return`${$n(i*n,Math.min(6,Math.max(0,s)))} ${e}`}var Hs={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Ws={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Fp=0,Nh=1,kp=2;var Ta=1,Bp=2,co=3,$s=0,Yn=1,kn=2,ur=0,uo=1,Dh=2,Uh=3,Oh=4,zp=5;var hr=100,Vp=101,Gp=102,Hp=103,Wp=104,$p=200,Xp=201,qp=202,Yp=203,Fh=204,kh=205,Zp=206,Kp=207,Jp=208,jp=209,Qp=210,tm=211,em=212,nm=213,im=214,Pl=0,Il=1,Ll=2,jr=3,Nl=4,Dl=5,Ul=6,Ol=7,lc=0,sm=1,rm=2,qi=0,Bh=1,zh=2,Vh=3,Gh=4,Hh=5,Wh=6,$h=7;var Xh=300,dr=301,ho=302,cc=303,uc=304,Fl=1e3,Hi=1001,kl=1002,Pn=1003,om=1004;var Ca=1005;var qn=1006,hc=1007;var gs=1008;var Jn=1009,qh=1010,Yh=1011,fo=1012,dc=1013,Ri=1014,yi=1015,Pi=1016,fc=1017,pc=1018,fr=1020,Zh=35902,Kh=35899,Jh=1021,jh=1022,Ii=1023,us=1026,xs=1027,mc=1028,gc=1029,Xs=1030,xc=1031;var _c=1033,Ra=33776,Pa=33777,Ia=33778,La=33779,yc=35840,vc=35841,bc=35842,Sc=35843,Mc=36196,wc=37492,Ac=37496,Ec=37488,Tc=37489,Na=37490,Cc=37491,Rc=37808,Pc=37809,Ic=37810,Lc=37811,Nc=37812,Dc=37813,Uc=37814,Oc=37815,Fc=37816,kc=37817,Bc=37818,zc=37819,Vc=37820,Gc=37821,Hc=36492,Wc=36494,$c=36495,Xc=36283,qc=36284,Da=36285,Yc=36286;var sa=2300,Bl=2301,Cl=2302,Ah=2303,Eh=2400,Th=2401,Ch=2402;var am=3200;var Zc=0,lm=1,_s="",oi="srgb",ra="srgb-linear",oa="linear",Ae="srgb";var Rl=7680,Qh=7681;var td=517;var cm=519,um=512,hm=513,dm=514,ed=515,fm=516,pm=517,nd=518,id=519,mm=35044,Ua=35048;var sd="300 es",_i=2e3,Qr=2001;function cy(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function uy(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function aa(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function gm(){let n=aa("canvas");return n.style.display="block",n}var rp={},to=null;function rd(...n){let t="THREE."+n.shift();to?to("log",t,...n):console.log(t,...n)}function xm(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Xt(...n){n=xm(n);let t="THREE."+n.shift();if(to)to("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function jt(...n){n=xm(n);let t="THREE."+n.shift();if(to)to("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function ea(...n){let t=n.join(" ");t in rp||(rp[t]=!0,Xt(...n))}function _m(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var ym={[Pl]:Pl,[Ll]:Ul,[Nl]:Nl,[jr]:Dl,[Il]:Il,[Ul]:Ll,[Ol]:Ol,[Dl]:jr},Ci=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Un=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],op=1234567,na=Math.PI/180,eo=180/Math.PI;function po(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Un[n&255]+Un[n>>8&255]+Un[n>>16&255]+Un[n>>24&255]+"-"+Un[t&255]+Un[t>>8&255]+"-"+Un[t>>16&15|64]+Un[t>>24&255]+"-"+Un[e&63|128]+Un[e>>8&255]+"-"+Un[e>>16&255]+Un[e>>24&255]+Un[i&255]+Un[i>>8&255]+Un[i>>16&255]+Un[i>>24&255]).toLowerCase()}function fe(n,t,e){return Math.max(t,Math.min(e,n))}function od(n,t){return(n%t+t)%t}function hy(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function dy(n,t,e){return n!==t?(e-n)/(t-n):0}function ia(n,t,e){return(1-e)*n+e*t}function fy(n,t,e,i){return ia(n,t,1-Math.exp(-e*i))}function py(n,t=1){return t-Math.abs(od(n,t*2)-t)}function my(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function gy(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function xy(n,t){return n+Math.floor(Math.random()*(t-n+1))}function _y(n,t){return n+Math.random()*(t-n)}function yy(n){return n*(.5-Math.random())}function vy(n){n!==void 0&&(op=n);let t=op+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function by(n){return n*na}function Sy(n){return n*eo}function My(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function wy(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function ad(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function Ay(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),u=o((t+i)/2),h=r((t-i)/2),d=o((t-i)/2),f=r((i-t)/2),p=o((i-t)/2);switch(s){case"XYX":n.set(a*u,l*h,l*d,a*c);break;case"YZY":n.set(l*d,a*u,l*h,a*c);break;case"ZXZ":n.set(l*h,l*d,a*u,a*c);break;case"XZX":n.set(a*u,l*p,l*f,a*c);break;case"YXY":n.set(l*f,a*u,l*p,a*c);break;case"ZYZ":n.set(l*p,l*f,a*u,a*c);break;default:Xt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function ld(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function vm(n,t){if(t.constructor===Float32Array)return n;let e=ld(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function bm(n,t){if(t.constructor===Float32Array)return n;let e=ld(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var cd={DEG2RAD:na,RAD2DEG:eo,generateUUID:po,clamp:fe,euclideanModulo:od,mapLinear:hy,inverseLerp:dy,lerp:ia,damp:fy,pingpong:py,smoothstep:my,smootherstep:gy,randInt:xy,randFloat:_y,randFloatSpread:yy,seededRandom:vy,degToRad:by,radToDeg:Sy,isPowerOfTwo:My,ceilPowerOfTwo:wy,floorPowerOfTwo:ad,setQuaternionFromProperEuler:Ay,normalize:bm,denormalize:vm},Yt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=fe(this.x,t.x,e.x),this.y=fe(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=fe(this.x,t,e),this.y=fe(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(fe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(fe(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},li=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],d=r[o+0],f=r[o+1],p=r[o+2],x=r[o+3];if(h!==x||l!==d||c!==f||u!==p){let m=l*d+c*f+u*p+h*x;m<0&&(d=-d,f=-f,p=-p,x=-x,m=-m);let g=1-a;if(m<.9995){let _=Math.acos(m),w=Math.sin(_);g=Math.sin(g*_)/w,a=Math.sin(a*_)/w,l=l*g+d*a,c=c*g+f*a,u=u*g+p*a,h=h*g+x*a}else{l=l*g+d*a,c=c*g+f*a,u=u*g+p*a,h=h*g+x*a;let _=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=_,c*=_,u*=_,h*=_}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return t[e]=a*p+u*h+l*f-c*d,t[e+1]=l*p+u*d+c*h-a*f,t[e+2]=c*p+u*f+a*d-l*h,t[e+3]=u*p-a*h-l*d-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),d=l(i/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=d*u*h+c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h-d*f*p;break;case"YXZ":this._x=d*u*h+c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h+d*f*p;break;case"ZXY":this._x=d*u*h-c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h-d*f*p;break;case"ZYX":this._x=d*u*h-c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h+d*f*p;break;case"YZX":this._x=d*u*h+c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h-d*f*p;break;case"XZY":this._x=d*u*h-c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h+d*f*p;break;default:Xt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],h=e[10],d=i+a+h;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>h){let f=2*Math.sqrt(1+i-a-h);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>h){let f=2*Math.sqrt(1+a-i-h);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+h-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(fe(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,e=Math.sin(e*c)/u,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},W=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(ap.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(ap.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),u=2*(a*e-r*s),h=2*(r*i-o*e);return this.x=e+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=fe(this.x,t.x,e.x),this.y=fe(this.y,t.y,e.y),this.z=fe(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=fe(this.x,t,e),this.y=fe(this.y,t,e),this.z=fe(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(fe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return sh.copy(this).projectOnVector(t),this.sub(sh)}reflect(t){return this.sub(sh.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(fe(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},sh=new W,ap=new li,ee=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],d=i[2],f=i[5],p=i[8],x=s[0],m=s[3],g=s[6],_=s[1],w=s[4],v=s[7],E=s[2],A=s[5],y=s[8];return r[0]=o*x+a*_+l*E,r[3]=o*m+a*w+l*A,r[6]=o*g+a*v+l*y,r[1]=c*x+u*_+h*E,r[4]=c*m+u*w+h*A,r[7]=c*g+u*v+h*y,r[2]=d*x+f*_+p*E,r[5]=d*m+f*w+p*A,r[8]=d*g+f*v+p*y,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=u*o-a*c,d=a*l-u*r,f=c*r-o*l,p=e*h+i*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/p;return t[0]=h*x,t[1]=(s*c-u*i)*x,t[2]=(a*i-s*o)*x,t[3]=d*x,t[4]=(u*e-s*l)*x,t[5]=(s*r-a*e)*x,t[6]=f*x,t[7]=(i*l-c*e)*x,t[8]=(o*e-i*r)*x,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return ea("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(rh.makeScale(t,e)),this}rotate(t){return ea("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(rh.makeRotation(-t)),this}translate(t,e){return ea("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(rh.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},rh=new ee,lp=new ee().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),cp=new ee().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Ey(){let n={enabled:!0,workingColorSpace:ra,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ae&&(s.r=cs(s.r),s.g=cs(s.g),s.b=cs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ae&&(s.r=Jr(s.r),s.g=Jr(s.g),s.b=Jr(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===_s?oa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[ra]:{primaries:t,whitePoint:i,transfer:oa,toXYZ:lp,fromXYZ:cp,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:oi},outputColorSpaceConfig:{drawingBufferColorSpace:oi}},[oi]:{primaries:t,whitePoint:i,transfer:Ae,toXYZ:lp,fromXYZ:cp,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:oi}}}),n}var xe=Ey();function cs(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Jr(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Fr,zl=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{Fr===void 0&&(Fr=aa("canvas")),Fr.width=t.width,Fr.height=t.height;let s=Fr.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=Fr}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=aa("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=cs(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(cs(e[i]/255)*255):e[i]=cs(e[i]);return{data:e,width:t.width,height:t.height}}else return Xt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},Ty=0,no=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Ty++}),this.uuid=po(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(oh(s[o].image)):r.push(oh(s[o]))}else r=oh(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function oh(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?zl.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Xt("Texture: Unable to serialize Texture."),{})}var Cy=0,ah=new W,Kn=class n extends Ci{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=Hi,s=Hi,r=qn,o=gs,a=Ii,l=Jn,c=n.DEFAULT_ANISOTROPY,u=_s){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Cy++}),this.uuid=po(),this.name="",this.source=new no(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Yt(0,0),this.repeat=new Yt(1,1),this.center=new Yt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ee,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(ah).x}get height(){return this.source.getSize(ah).y}get depth(){return this.source.getSize(ah).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){Xt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Xt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Xh)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Fl:t.x=t.x-Math.floor(t.x);break;case Hi:t.x=t.x<0?0:1;break;case kl:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Fl:t.y=t.y-Math.floor(t.y);break;case Hi:t.y=t.y<0?0:1;break;case kl:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Kn.DEFAULT_IMAGE=null;Kn.DEFAULT_MAPPING=Xh;Kn.DEFAULT_ANISOTROPY=1;var Ye=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],u=l[4],h=l[8],d=l[1],f=l[5],p=l[9],x=l[2],m=l[6],g=l[10];if(Math.abs(u-d)<.01&&Math.abs(h-x)<.01&&Math.abs(p-m)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+x)<.1&&Math.abs(p+m)<.1&&Math.abs(c+f+g-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let w=(c+1)/2,v=(f+1)/2,E=(g+1)/2,A=(u+d)/4,y=(h+x)/4,M=(p+m)/4;return w>v&&w>E?w<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(w),s=A/i,r=y/i):v>E?v<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(v),i=A/s,r=M/s):E<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(E),i=y/r,s=M/r),this.set(i,s,r,e),this}let _=Math.sqrt((m-p)*(m-p)+(h-x)*(h-x)+(d-u)*(d-u));return Math.abs(_)<.001&&(_=1),this.x=(m-p)/_,this.y=(h-x)/_,this.z=(d-u)/_,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=fe(this.x,t.x,e.x),this.y=fe(this.y,t.y,e.y),this.z=fe(this.z,t.z,e.z),this.w=fe(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=fe(this.x,t,e),this.y=fe(this.y,t,e),this.z=fe(this.z,t,e),this.w=fe(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(fe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Vl=class extends Ci{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:qn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new Ye(0,0,t,e),this.scissorTest=!1,this.viewport=new Ye(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Kn({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:qn,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new no(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},ci=class extends Vl{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},la=class extends Kn{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Pn,this.minFilter=Pn,this.wrapR=Hi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Gl=class extends Kn{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Pn,this.minFilter=Pn,this.wrapR=Hi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var pe=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,l,c,u,h,d,f,p,x,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,u,h,d,f,p,x,m)}set(t,e,i,s,r,o,a,l,c,u,h,d,f,p,x,m){let g=this.elements;return g[0]=t,g[4]=e,g[8]=i,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=u,g[10]=h,g[14]=d,g[3]=f,g[7]=p,g[11]=x,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/kr.setFromMatrixColumn(t,0).length(),r=1/kr.setFromMatrixColumn(t,1).length(),o=1/kr.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(t.order==="XYZ"){let d=o*u,f=o*h,p=a*u,x=a*h;e[0]=l*u,e[4]=-l*h,e[8]=c,e[1]=f+p*c,e[5]=d-x*c,e[9]=-a*l,e[2]=x-d*c,e[6]=p+f*c,e[10]=o*l}else if(t.order==="YXZ"){let d=l*u,f=l*h,p=c*u,x=c*h;e[0]=d+x*a,e[4]=p*a-f,e[8]=o*c,e[1]=o*h,e[5]=o*u,e[9]=-a,e[2]=f*a-p,e[6]=x+d*a,e[10]=o*l}else if(t.order==="ZXY"){let d=l*u,f=l*h,p=c*u,x=c*h;e[0]=d-x*a,e[4]=-o*h,e[8]=p+f*a,e[1]=f+p*a,e[5]=o*u,e[9]=x-d*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let d=o*u,f=o*h,p=a*u,x=a*h;e[0]=l*u,e[4]=p*c-f,e[8]=d*c+x,e[1]=l*h,e[5]=x*c+d,e[9]=f*c-p,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let d=o*l,f=o*c,p=a*l,x=a*c;e[0]=l*u,e[4]=x-d*h,e[8]=p*h+f,e[1]=h,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=f*h+p,e[10]=d-x*h}else if(t.order==="XZY"){let d=o*l,f=o*c,p=a*l,x=a*c;e[0]=l*u,e[4]=-h,e[8]=c*u,e[1]=d*h+x,e[5]=o*u,e[9]=f*h-p,e[2]=p*h-f,e[6]=a*u,e[10]=x*h+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Ry,t,Py)}lookAt(t,e,i){let s=this.elements;return si.subVectors(t,e),si.lengthSq()===0&&(si.z=1),si.normalize(),Is.crossVectors(i,si),Is.lengthSq()===0&&(Math.abs(i.z)===1?si.x+=1e-4:si.z+=1e-4,si.normalize(),Is.crossVectors(i,si)),Is.normalize(),rl.crossVectors(si,Is),s[0]=Is.x,s[4]=rl.x,s[8]=si.x,s[1]=Is.y,s[5]=rl.y,s[9]=si.y,s[2]=Is.z,s[6]=rl.z,s[10]=si.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],d=i[9],f=i[13],p=i[2],x=i[6],m=i[10],g=i[14],_=i[3],w=i[7],v=i[11],E=i[15],A=s[0],y=s[4],M=s[8],P=s[12],L=s[1],I=s[5],F=s[9],k=s[13],D=s[2],V=s[6],X=s[10],H=s[14],lt=s[3],Z=s[7],Q=s[11],it=s[15];return r[0]=o*A+a*L+l*D+c*lt,r[4]=o*y+a*I+l*V+c*Z,r[8]=o*M+a*F+l*X+c*Q,r[12]=o*P+a*k+l*H+c*it,r[1]=u*A+h*L+d*D+f*lt,r[5]=u*y+h*I+d*V+f*Z,r[9]=u*M+h*F+d*X+f*Q,r[13]=u*P+h*k+d*H+f*it,r[2]=p*A+x*L+m*D+g*lt,r[6]=p*y+x*I+m*V+g*Z,r[10]=p*M+x*F+m*X+g*Q,r[14]=p*P+x*k+m*H+g*it,r[3]=_*A+w*L+v*D+E*lt,r[7]=_*y+w*I+v*V+E*Z,r[11]=_*M+w*F+v*X+E*Q,r[15]=_*P+w*k+v*H+E*it,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],h=t[6],d=t[10],f=t[14],p=t[3],x=t[7],m=t[11],g=t[15],_=l*f-c*d,w=a*f-c*h,v=a*d-l*h,E=o*f-c*u,A=o*d-l*u,y=o*h-a*u;return e*(x*_-m*w+g*v)-i*(p*_-m*E+g*A)+s*(p*w-x*E+g*y)-r*(p*v-x*A+m*y)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],u=t[10];return e*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=t[9],d=t[10],f=t[11],p=t[12],x=t[13],m=t[14],g=t[15],_=e*a-i*o,w=e*l-s*o,v=e*c-r*o,E=i*l-s*a,A=i*c-r*a,y=s*c-r*l,M=u*x-h*p,P=u*m-d*p,L=u*g-f*p,I=h*m-d*x,F=h*g-f*x,k=d*g-f*m,D=_*k-w*F+v*I+E*L-A*P+y*M;if(D===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/D;return t[0]=(a*k-l*F+c*I)*V,t[1]=(s*F-i*k-r*I)*V,t[2]=(x*y-m*A+g*E)*V,t[3]=(d*A-h*y-f*E)*V,t[4]=(l*L-o*k-c*P)*V,t[5]=(e*k-s*L+r*P)*V,t[6]=(m*v-p*y-g*w)*V,t[7]=(u*y-d*v+f*w)*V,t[8]=(o*F-a*L+c*M)*V,t[9]=(i*L-e*F-r*M)*V,t[10]=(p*A-x*v+g*_)*V,t[11]=(h*v-u*A-f*_)*V,t[12]=(a*P-o*I-l*M)*V,t[13]=(e*I-i*P+s*M)*V,t[14]=(x*w-p*E-m*_)*V,t[15]=(u*E-h*w+d*_)*V,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,u=o+o,h=a+a,d=r*c,f=r*u,p=r*h,x=o*u,m=o*h,g=a*h,_=l*c,w=l*u,v=l*h,E=i.x,A=i.y,y=i.z;return s[0]=(1-(x+g))*E,s[1]=(f+v)*E,s[2]=(p-w)*E,s[3]=0,s[4]=(f-v)*A,s[5]=(1-(d+g))*A,s[6]=(m+_)*A,s[7]=0,s[8]=(p+w)*y,s[9]=(m-_)*y,s[10]=(1-(d+x))*y,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=kr.set(s[0],s[1],s[2]).length(),a=kr.set(s[4],s[5],s[6]).length(),l=kr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Ai.copy(this);let c=1/o,u=1/a,h=1/l;return Ai.elements[0]*=c,Ai.elements[1]*=c,Ai.elements[2]*=c,Ai.elements[4]*=u,Ai.elements[5]*=u,Ai.elements[6]*=u,Ai.elements[8]*=h,Ai.elements[9]*=h,Ai.elements[10]*=h,e.setFromRotationMatrix(Ai),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=_i,l=!1){let c=this.elements,u=2*r/(e-t),h=2*r/(i-s),d=(e+t)/(e-t),f=(i+s)/(i-s),p,x;if(l)p=r/(o-r),x=o*r/(o-r);else if(a===_i)p=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===Qr)p=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=h,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=_i,l=!1){let c=this.elements,u=2/(e-t),h=2/(i-s),d=-(e+t)/(e-t),f=-(i+s)/(i-s),p,x;if(l)p=1/(o-r),x=o/(o-r);else if(a===_i)p=-2/(o-r),x=-(o+r)/(o-r);else if(a===Qr)p=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=h,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},kr=new W,Ai=new pe,Ry=new W(0,0,0),Py=new W(1,1,1),Is=new W,rl=new W,si=new W,up=new pe,hp=new li,hs=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(fe(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-fe(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(fe(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-fe(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(fe(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-fe(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:Xt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return up.makeRotationFromQuaternion(t),this.setFromRotationMatrix(up,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return hp.setFromEuler(this),this.setFromQuaternion(hp,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};hs.DEFAULT_ORDER="XYZ";var io=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},Iy=0,dp=new W,Br=new li,ss=new pe,ol=new W,Yo=new W,Ly=new W,Ny=new li,fp=new W(1,0,0),pp=new W(0,1,0),mp=new W(0,0,1),gp={type:"added"},Dy={type:"removed"},zr={type:"childadded",child:null},lh={type:"childremoved",child:null},Ln=class n extends Ci{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Iy++}),this.uuid=po(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new W,e=new hs,i=new li,s=new W(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new pe},normalMatrix:{value:new ee}}),this.matrix=new pe,this.matrixWorld=new pe,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new io,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Br.setFromAxisAngle(t,e),this.quaternion.multiply(Br),this}rotateOnWorldAxis(t,e){return Br.setFromAxisAngle(t,e),this.quaternion.premultiply(Br),this}rotateX(t){return this.rotateOnAxis(fp,t)}rotateY(t){return this.rotateOnAxis(pp,t)}rotateZ(t){return this.rotateOnAxis(mp,t)}translateOnAxis(t,e){return dp.copy(t).applyQuaternion(this.quaternion),this.position.add(dp.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(fp,t)}translateY(t){return this.translateOnAxis(pp,t)}translateZ(t){return this.translateOnAxis(mp,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(ss.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?ol.copy(t):ol.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Yo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ss.lookAt(Yo,ol,this.up):ss.lookAt(ol,Yo,this.up),this.quaternion.setFromRotationMatrix(ss),s&&(ss.extractRotation(s.matrixWorld),Br.setFromRotationMatrix(ss),this.quaternion.premultiply(Br.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(jt("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(gp),zr.child=t,this.dispatchEvent(zr),zr.child=null):jt("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Dy),lh.child=t,this.dispatchEvent(lh),lh.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),ss.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),ss.multiply(t.parent.matrixWorld)),t.applyMatrix4(ss),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(gp),zr.child=t,this.dispatchEvent(zr),zr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Yo,t,Ly),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Yo,Ny,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(t.shapes,h)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),h=o(t.shapes),d=o(t.skeletons),f=o(t.animations),p=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Ln.DEFAULT_UP=new W(0,1,0);Ln.DEFAULT_MATRIX_AUTO_UPDATE=!0;Ln.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Fn=class extends Ln{constructor(){super(),this.isGroup=!0,this.type="Group"}},Uy={type:"move"},so=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Fn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Fn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new W,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new W),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Fn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new W,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new W,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let x of t.hand.values()){let m=e.getJointPose(x,i),g=this._getHandJoint(c,x);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,p=.005;c.inputState.pinching&&d>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&d<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Uy)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new Fn;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},Sm={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ls={h:0,s:0,l:0},al={h:0,s:0,l:0};function ch(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var Qt=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=oi){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,xe.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=xe.workingColorSpace){return this.r=t,this.g=e,this.b=i,xe.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=xe.workingColorSpace){if(t=od(t,1),e=fe(e,0,1),i=fe(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=ch(o,r,t+1/3),this.g=ch(o,r,t),this.b=ch(o,r,t-1/3)}return xe.colorSpaceToWorking(this,s),this}setStyle(t,e=oi){function i(r){r!==void 0&&parseFloat(r)<1&&Xt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Xt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);Xt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=oi){let i=Sm[t.toLowerCase()];return i!==void 0?this.setHex(i,e):Xt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=cs(t.r),this.g=cs(t.g),this.b=cs(t.b),this}copyLinearToSRGB(t){return this.r=Jr(t.r),this.g=Jr(t.g),this.b=Jr(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=oi){return xe.workingToColorSpace(On.copy(this),t),Math.round(fe(On.r*255,0,255))*65536+Math.round(fe(On.g*255,0,255))*256+Math.round(fe(On.b*255,0,255))}getHexString(t=oi){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=xe.workingColorSpace){xe.workingToColorSpace(On.copy(this),e);let i=On.r,s=On.g,r=On.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=xe.workingColorSpace){return xe.workingToColorSpace(On.copy(this),e),t.r=On.r,t.g=On.g,t.b=On.b,t}getStyle(t=oi){xe.workingToColorSpace(On.copy(this),t);let e=On.r,i=On.g,s=On.b;return t!==oi?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(Ls),this.setHSL(Ls.h+t,Ls.s+e,Ls.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(Ls),t.getHSL(al);let i=ia(Ls.h,al.h,e),s=ia(Ls.s,al.s,e),r=ia(Ls.l,al.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},On=new Qt;Qt.NAMES=Sm;var ca=class extends Ln{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new hs,this.environmentIntensity=1,this.environmentRotation=new hs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Ei=new W,rs=new W,uh=new W,os=new W,Vr=new W,Gr=new W,xp=new W,hh=new W,dh=new W,fh=new W,ph=new Ye,mh=new Ye,gh=new Ye,Os=class n{constructor(t=new W,e=new W,i=new W){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),Ei.subVectors(t,e),s.cross(Ei);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){Ei.subVectors(s,e),rs.subVectors(i,e),uh.subVectors(t,e);let o=Ei.dot(Ei),a=Ei.dot(rs),l=Ei.dot(uh),c=rs.dot(rs),u=rs.dot(uh),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let d=1/h,f=(c*l-a*u)*d,p=(o*u-a*l)*d;return r.set(1-f-p,p,f)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,os)===null?!1:os.x>=0&&os.y>=0&&os.x+os.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,os)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,os.x),l.addScaledVector(o,os.y),l.addScaledVector(a,os.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return ph.setScalar(0),mh.setScalar(0),gh.setScalar(0),ph.fromBufferAttribute(t,e),mh.fromBufferAttribute(t,i),gh.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(ph,r.x),o.addScaledVector(mh,r.y),o.addScaledVector(gh,r.z),o}static isFrontFacing(t,e,i,s){return Ei.subVectors(i,e),rs.subVectors(t,e),Ei.cross(rs).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Ei.subVectors(this.c,this.b),rs.subVectors(this.a,this.b),Ei.cross(rs).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;Vr.subVectors(s,i),Gr.subVectors(r,i),hh.subVectors(t,i);let l=Vr.dot(hh),c=Gr.dot(hh);if(l<=0&&c<=0)return e.copy(i);dh.subVectors(t,s);let u=Vr.dot(dh),h=Gr.dot(dh);if(u>=0&&h<=u)return e.copy(s);let d=l*h-u*c;if(d<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),e.copy(i).addScaledVector(Vr,o);fh.subVectors(t,r);let f=Vr.dot(fh),p=Gr.dot(fh);if(p>=0&&f<=p)return e.copy(r);let x=f*c-l*p;if(x<=0&&c>=0&&p<=0)return a=c/(c-p),e.copy(i).addScaledVector(Gr,a);let m=u*p-f*h;if(m<=0&&h-u>=0&&f-p>=0)return xp.subVectors(r,s),a=(h-u)/(h-u+(f-p)),e.copy(s).addScaledVector(xp,a);let g=1/(m+x+d);return o=x*g,a=d*g,e.copy(i).addScaledVector(Vr,o).addScaledVector(Gr,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Wi=class{constructor(t=new W(1/0,1/0,1/0),e=new W(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Ti.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Ti.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Ti.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Ti):Ti.fromBufferAttribute(r,o),Ti.applyMatrix4(t.matrixWorld),this.expandByPoint(Ti);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),ll.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),ll.copy(i.boundingBox)),ll.applyMatrix4(t.matrixWorld),this.union(ll)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Ti),Ti.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Zo),cl.subVectors(this.max,Zo),Hr.subVectors(t.a,Zo),Wr.subVectors(t.b,Zo),$r.subVectors(t.c,Zo),Ns.subVectors(Wr,Hr),Ds.subVectors($r,Wr),sr.subVectors(Hr,$r);let e=[0,-Ns.z,Ns.y,0,-Ds.z,Ds.y,0,-sr.z,sr.y,Ns.z,0,-Ns.x,Ds.z,0,-Ds.x,sr.z,0,-sr.x,-Ns.y,Ns.x,0,-Ds.y,Ds.x,0,-sr.y,sr.x,0];return!xh(e,Hr,Wr,$r,cl)||(e=[1,0,0,0,1,0,0,0,1],!xh(e,Hr,Wr,$r,cl))?!1:(ul.crossVectors(Ns,Ds),e=[ul.x,ul.y,ul.z],xh(e,Hr,Wr,$r,cl))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Ti).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Ti).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(as[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),as[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),as[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),as[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),as[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),as[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),as[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),as[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(as),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},as=[new W,new W,new W,new W,new W,new W,new W,new W],Ti=new W,ll=new Wi,Hr=new W,Wr=new W,$r=new W,Ns=new W,Ds=new W,sr=new W,Zo=new W,cl=new W,ul=new W,rr=new W;function xh(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){rr.fromArray(n,r);let a=s.x*Math.abs(rr.x)+s.y*Math.abs(rr.y)+s.z*Math.abs(rr.z),l=t.dot(rr),c=e.dot(rr),u=i.dot(rr);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var pn=new W,hl=new Yt,Oy=0,on=class extends Ci{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Oy++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=mm,this.updateRanges=[],this.gpuType=yi,this.version=0,this._normalizationScale=t!==void 0?ld(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)hl.fromBufferAttribute(this,e),hl.applyMatrix3(t),this.setXY(e,hl.x,hl.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)pn.fromBufferAttribute(this,e),pn.applyMatrix3(t),this.setXYZ(e,pn.x,pn.y,pn.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)pn.fromBufferAttribute(this,e),pn.applyMatrix4(t),this.setXYZ(e,pn.x,pn.y,pn.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)pn.fromBufferAttribute(this,e),pn.applyNormalMatrix(t),this.setXYZ(e,pn.x,pn.y,pn.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)pn.fromBufferAttribute(this,e),pn.transformDirection(t),this.setXYZ(e,pn.x,pn.y,pn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):vm(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):bm(t,this.array)}};var ua=class extends on{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var ha=class extends on{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var en=class extends on{constructor(t,e,i){super(new Float32Array(t),e,i)}},Fy=new Wi,Ko=new W,_h=new W,ds=class{constructor(t=new W,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):Fy.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Ko.subVectors(t,this.center);let e=Ko.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(Ko,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(_h.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Ko.copy(t.center).add(_h)),this.expandByPoint(Ko.copy(t.center).sub(_h))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},ky=0,xi=new pe,yh=new Ln,Xr=new W,ri=new Wi,Jo=new Wi,Rn=new W,_n=class n extends Ci{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:ky++}),this.uuid=po(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(cy(t)?ha:ua)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new ee().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return xi.makeRotationFromQuaternion(t),this.applyMatrix4(xi),this}rotateX(t){return xi.makeRotationX(t),this.applyMatrix4(xi),this}rotateY(t){return xi.makeRotationY(t),this.applyMatrix4(xi),this}rotateZ(t){return xi.makeRotationZ(t),this.applyMatrix4(xi),this}translate(t,e,i){return xi.makeTranslation(t,e,i),this.applyMatrix4(xi),this}scale(t,e,i){return xi.makeScale(t,e,i),this.applyMatrix4(xi),this}lookAt(t){return yh.lookAt(t),yh.updateMatrix(),this.applyMatrix4(yh.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Xr).negate(),this.translate(Xr.x,Xr.y,Xr.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new en(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Xt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Wi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){jt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new W(-1/0,-1/0,-1/0),new W(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];ri.setFromBufferAttribute(r),this.morphTargetsRelative?(Rn.addVectors(this.boundingBox.min,ri.min),this.boundingBox.expandByPoint(Rn),Rn.addVectors(this.boundingBox.max,ri.max),this.boundingBox.expandByPoint(Rn)):(this.boundingBox.expandByPoint(ri.min),this.boundingBox.expandByPoint(ri.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&jt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ds);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){jt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new W,1/0);return}if(t){let i=this.boundingSphere.center;if(ri.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Jo.setFromBufferAttribute(a),this.morphTargetsRelative?(Rn.addVectors(ri.min,Jo.min),ri.expandByPoint(Rn),Rn.addVectors(ri.max,Jo.max),ri.expandByPoint(Rn)):(ri.expandByPoint(Jo.min),ri.expandByPoint(Jo.max))}ri.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Rn.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Rn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Rn.fromBufferAttribute(a,c),l&&(Xr.fromBufferAttribute(t,c),Rn.add(Xr)),s=Math.max(s,i.distanceToSquared(Rn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&jt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){jt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new on(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let P=0;P<i.count;P++)a[P]=new W,l[P]=new W;let u=new W,h=new W,d=new W,f=new Yt,p=new Yt,x=new Yt,m=new W,g=new W;function _(P,L,I){c[P]=c[L]=c[I]=1,u.fromBufferAttribute(i,P),h.fromBufferAttribute(i,L),d.fromBufferAttribute(i,I),f.fromBufferAttribute(r,P),p.fromBufferAttribute(r,L),x.fromBufferAttribute(r,I),h.sub(u),d.sub(u),p.sub(f),x.sub(f);let F=1/(p.x*x.y-x.x*p.y);isFinite(F)&&(m.copy(h).multiplyScalar(x.y).addScaledVector(d,-p.y).multiplyScalar(F),g.copy(d).multiplyScalar(p.x).addScaledVector(h,-x.x).multiplyScalar(F),a[P].add(m),a[L].add(m),a[I].add(m),l[P].add(g),l[L].add(g),l[I].add(g))}let w=this.groups;w.length===0&&(w=[{start:0,count:t.count}]);for(let P=0,L=w.length;P<L;++P){let I=w[P],F=I.start,k=I.count;for(let D=F,V=F+k;D<V;D+=3)_(t.getX(D+0),t.getX(D+1),t.getX(D+2))}let v=new W,E=new W,A=new W,y=new W;function M(P){A.fromBufferAttribute(s,P),y.copy(A);let L=a[P];v.copy(L),v.sub(A.multiplyScalar(A.dot(L))).normalize(),E.crossVectors(y,L);let F=E.dot(l[P])<0?-1:1;o.setXYZW(P,v.x,v.y,v.z,F)}for(let P=0,L=i.count;P<L;++P)c[P]&&M(P);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new on(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let s=new W,r=new W,o=new W,a=new W,l=new W,c=new W,u=new W,h=new W;if(t)for(let d=0,f=t.count;d<f;d+=3){let p=t.getX(d+0),x=t.getX(d+1),m=t.getX(d+2);s.fromBufferAttribute(e,p),r.fromBufferAttribute(e,x),o.fromBufferAttribute(e,m),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,p),l.fromBufferAttribute(i,x),c.fromBufferAttribute(i,m),a.add(u),l.add(u),c.add(u),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(x,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(d+0,u.x,u.y,u.z),i.setXYZ(d+1,u.x,u.y,u.z),i.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)Rn.fromBufferAttribute(t,e),Rn.normalize(),t.setXYZ(e,Rn.x,Rn.y,Rn.z)}toNonIndexed(){function t(a,l){let c=a.array,u=a.itemSize,h=a.normalized,d=new c.constructor(l.length*u),f=0,p=0;for(let x=0,m=l.length;x<m;x++){a.isInterleavedBufferAttribute?f=l[x]*a.data.stride+a.offset:f=l[x]*u;for(let g=0;g<u;g++)d[p++]=c[f++]}return new on(d,u,h)}if(this.index===null)return Xt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let d=c[u],f=t(d,i);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,d=c.length;h<d;h++){let f=c[h];u.push(f.toJSON(t.data))}u.length>0&&(s[l]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(e))}let r=t.morphAttributes;for(let c in r){let u=[],h=r[c];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var vh=new W,By=new W,zy=new ee,ai=class{constructor(t=new W(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=vh.subVectors(i,e).cross(By.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(vh),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||zy.getNormalMatrix(t),s=this.coplanarPoint(vh).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},Vy=0,fs=class extends Ci{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Vy++}),this.uuid=po(),this.name="",this.type="Material",this.blending=uo,this.side=$s,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Fh,this.blendDst=kh,this.blendEquation=hr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Qt(0,0,0),this.blendAlpha=0,this.depthFunc=jr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=cm,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Rl,this.stencilZFail=Rl,this.stencilZPass=Rl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){Xt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Xt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new Qt().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new ai().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Yt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Yt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var ls=new W,bh=new W,dl=new W,fl=new W,Fs=class{constructor(t=new W,e=new W(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,ls)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=ls.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(ls.copy(this.origin).addScaledVector(this.direction,e),ls.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){bh.copy(t).add(e).multiplyScalar(.5),dl.copy(e).sub(t).normalize(),fl.copy(this.origin).sub(bh);let r=t.distanceTo(e)*.5,o=-this.direction.dot(dl),a=fl.dot(this.direction),l=-fl.dot(dl),c=fl.lengthSq(),u=Math.abs(1-o*o),h,d,f,p;if(u>0)if(h=o*l-a,d=o*a-l,p=r*u,h>=0)if(d>=-p)if(d<=p){let x=1/u;h*=x,d*=x,f=h*(h+o*d+2*a)+d*(o*h+d+2*l)+c}else d=r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d=-r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d<=-p?(h=Math.max(0,-(-o*r+a)),d=h>0?-r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c):d<=p?(h=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(h=Math.max(0,-(o*r+a)),d=h>0?r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c);else d=o>0?-r:r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(bh).addScaledVector(dl,d),f}intersectSphere(t,e){if(t.radius<0)return null;ls.subVectors(t.center,this.origin);let i=ls.dot(this.direction),s=ls.dot(ls)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return c>=0?(i=(t.min.x-d.x)*c,s=(t.max.x-d.x)*c):(i=(t.max.x-d.x)*c,s=(t.min.x-d.x)*c),u>=0?(r=(t.min.y-d.y)*u,o=(t.max.y-d.y)*u):(r=(t.max.y-d.y)*u,o=(t.min.y-d.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(t.min.z-d.z)*h,l=(t.max.z-d.z)*h):(a=(t.max.z-d.z)*h,l=(t.min.z-d.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,ls)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=t.x-o.x,d=t.y-o.y,f=t.z-o.z,p=e.x-o.x,x=e.y-o.y,m=e.z-o.z,g=i.x-o.x,_=i.y-o.y,w=i.z-o.z,v=Math.abs(l),E=Math.abs(c),A=Math.abs(u),y,M,P,L,I,F,k,D,V,X,H,lt;if(v>=E&&v>=A?(P=l,F=h,V=p,lt=g,l>=0?(y=c,M=u,L=d,I=f,k=x,D=m,X=_,H=w):(y=u,M=c,L=f,I=d,k=m,D=x,X=w,H=_)):E>=A?(P=c,F=d,V=x,lt=_,c>=0?(y=u,M=l,L=f,I=h,k=m,D=p,X=w,H=g):(y=l,M=u,L=h,I=f,k=p,D=m,X=g,H=w)):(P=u,F=f,V=m,lt=w,u>=0?(y=l,M=c,L=h,I=d,k=p,D=x,X=g,H=_):(y=c,M=l,L=d,I=h,k=x,D=p,X=_,H=g)),P===0)return null;let Z=y/P,Q=M/P,it=1/P,ft=L-Z*F,dt=I-Q*F,tt=k-Z*V,ht=D-Q*V,gt=X-Z*lt,St=H-Q*lt,Mt=gt*ht-St*tt,Ht=ft*St-dt*gt,se=tt*dt-ht*ft;if(s){if(Mt<0||Ht<0||se<0)return null}else if((Mt<0||Ht<0||se<0)&&(Mt>0||Ht>0||se>0))return null;let Vt=Mt+Ht+se;if(Vt===0)return null;let ue=it*(Mt*F+Ht*V+se*lt);return(Vt>0?ue<0:ue>0)?null:this.at(ue/Vt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},lr=class extends fs{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Qt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new hs,this.combine=lc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},_p=new pe,or=new Fs,pl=new ds,yp=new W,ml=new W,gl=new W,xl=new W,Sh=new W,_l=new W,vp=new W,yl=new W,Nn=class extends Ln{constructor(t=new _n,e=new lr){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){_l.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(Sh.fromBufferAttribute(h,t),o?_l.addScaledVector(Sh,u):_l.addScaledVector(Sh.sub(e),u))}e.add(_l)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),pl.copy(i.boundingSphere),pl.applyMatrix4(r),or.copy(t.ray).recast(t.near),!(pl.containsPoint(or.origin)===!1&&(or.intersectSphere(pl,yp)===null||or.origin.distanceToSquared(yp)>(t.far-t.near)**2))&&(_p.copy(r).invert(),or.copy(t.ray).applyMatrix4(_p),!(i.boundingBox!==null&&or.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,or)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let m=d[p],g=o[m.materialIndex],_=Math.max(m.start,f.start),w=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let v=_,E=w;v<E;v+=3){let A=a.getX(v),y=a.getX(v+1),M=a.getX(v+2);s=vl(this,g,t,i,c,u,h,A,y,M),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(a.count,f.start+f.count);for(let m=p,g=x;m<g;m+=3){let _=a.getX(m),w=a.getX(m+1),v=a.getX(m+2);s=vl(this,o,t,i,c,u,h,_,w,v),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let m=d[p],g=o[m.materialIndex],_=Math.max(m.start,f.start),w=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let v=_,E=w;v<E;v+=3){let A=v,y=v+1,M=v+2;s=vl(this,g,t,i,c,u,h,A,y,M),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(l.count,f.start+f.count);for(let m=p,g=x;m<g;m+=3){let _=m,w=m+1,v=m+2;s=vl(this,o,t,i,c,u,h,_,w,v),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function Gy(n,t,e,i,s,r,o,a){let l;if(t.side===Yn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===$s,a),l===null)return null;yl.copy(a),yl.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(yl);return c<e.near||c>e.far?null:{distance:c,point:yl.clone(),object:n}}function vl(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,ml),n.getVertexPosition(l,gl),n.getVertexPosition(c,xl);let u=Gy(n,t,e,i,ml,gl,xl,vp);if(u){let h=new W;Os.getBarycoord(vp,ml,gl,xl,h),s&&(u.uv=Os.getInterpolatedAttribute(s,a,l,c,h,new Yt)),r&&(u.uv1=Os.getInterpolatedAttribute(r,a,l,c,h,new Yt)),o&&(u.normal=Os.getInterpolatedAttribute(o,a,l,c,h,new W),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new W,materialIndex:0};Os.getNormal(ml,gl,xl,d.normal),u.face=d,u.barycoord=h}return u}var da=class extends Kn{constructor(t=null,e=1,i=1,s,r,o,a,l,c=Pn,u=Pn,h,d){super(null,o,a,l,c,u,s,r,h,d),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var fa=class extends on{constructor(t,e,i,s=1){super(t,e,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},qr=new pe,bp=new pe,bl=[],Sp=new Wi,Hy=new pe,jo=new Nn,Qo=new ds,ui=class extends Nn{constructor(t,e,i){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new fa(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,Hy)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new Wi),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,qr),Sp.copy(t.boundingBox).applyMatrix4(qr),this.boundingBox.union(Sp)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new ds),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,qr),Qo.copy(t.boundingSphere).applyMatrix4(qr),this.boundingSphere.union(Qo)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let i=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=t*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(t,e){let i=this.matrixWorld,s=this.count;if(jo.geometry=this.geometry,jo.material=this.material,jo.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Qo.copy(this.boundingSphere),Qo.applyMatrix4(i),t.ray.intersectsSphere(Qo)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,qr),bp.multiplyMatrices(i,qr),jo.matrixWorld=bp,jo.raycast(t,bl);for(let o=0,a=bl.length;o<a;o++){let l=bl[o];l.instanceId=r,l.object=this,e.push(l)}bl.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new fa(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let i=e.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new da(new Float32Array(s*this.count),s,this.count,mc,yi));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*t;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},ar=new ds,Wy=new Yt(.5,.5),Sl=new W,ks=class{constructor(t=new ai,e=new ai,i=new ai,s=new ai,r=new ai,o=new ai){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=_i,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],d=r[6],f=r[7],p=r[8],x=r[9],m=r[10],g=r[11],_=r[12],w=r[13],v=r[14],E=r[15];if(s[0].setComponents(c-o,f-u,g-p,E-_).normalize(),s[1].setComponents(c+o,f+u,g+p,E+_).normalize(),s[2].setComponents(c+a,f+h,g+x,E+w).normalize(),s[3].setComponents(c-a,f-h,g-x,E-w).normalize(),i)s[4].setComponents(l,d,m,v).normalize(),s[5].setComponents(c-l,f-d,g-m,E-v).normalize();else if(s[4].setComponents(c-l,f-d,g-m,E-v).normalize(),e===_i)s[5].setComponents(c+l,f+d,g+m,E+v).normalize();else if(e===Qr)s[5].setComponents(l,d,m,v).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),ar.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),ar.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(ar)}intersectsSprite(t){ar.center.set(0,0,0);let e=Wy.distanceTo(t.center);return ar.radius=.7071067811865476+e,ar.applyMatrix4(t.matrixWorld),this.intersectsSphere(ar)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(Sl.x=s.normal.x>0?t.max.x:t.min.x,Sl.y=s.normal.y>0?t.max.y:t.min.y,Sl.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Sl)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Mp=new pe,Hl=class n{constructor(){this.coordinateSystem=_i,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];Mp.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new ks),i[s].setFromProjectionMatrix(Mp,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new ks),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var Bs=class extends fs{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Qt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Wl=new W,$l=new W,wp=new pe,ta=new Fs,Ml=new ds,Mh=new W,Ap=new W,Xl=class extends Ln{constructor(t=new _n,e=new Bs){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)Wl.fromBufferAttribute(e,s-1),$l.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=Wl.distanceTo($l);t.setAttribute("lineDistance",new en(i,1))}else Xt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Ml.copy(i.boundingSphere),Ml.applyMatrix4(s),Ml.radius+=r,t.ray.intersectsSphere(Ml)===!1)return;wp.copy(s).invert(),ta.copy(t.ray).applyMatrix4(wp);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,d=i.attributes.position;if(u!==null){let f=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let x=f,m=p-1;x<m;x+=c){let g=u.getX(x),_=u.getX(x+1),w=wl(this,t,ta,l,g,_,x);w&&e.push(w)}if(this.isLineLoop){let x=u.getX(p-1),m=u.getX(f),g=wl(this,t,ta,l,x,m,p-1);g&&e.push(g)}}else{let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let x=f,m=p-1;x<m;x+=c){let g=wl(this,t,ta,l,x,x+1,x);g&&e.push(g)}if(this.isLineLoop){let x=wl(this,t,ta,l,p-1,f,p-1);x&&e.push(x)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function wl(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(Wl.fromBufferAttribute(a,s),$l.fromBufferAttribute(a,r),e.distanceSqToSegment(Wl,$l,Mh,Ap)>i)return;Mh.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Mh);if(!(c<t.near||c>t.far))return{distance:c,point:Ap.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var Ep=new W,Tp=new W,cr=class extends Xl{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)Ep.fromBufferAttribute(e,s),Tp.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+Ep.distanceTo(Tp);t.setAttribute("lineDistance",new en(i,1))}else Xt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var pa=class extends Kn{constructor(t=[],e=dr,i,s,r,o,a,l,c,u){super(t,e,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var ps=class extends Kn{constructor(t,e,i=Ri,s,r,o,a=Pn,l=Pn,c,u=us,h=1){if(u!==us&&u!==xs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:h};super(d,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new no(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},ma=class extends ps{constructor(t,e=Ri,i=dr,s,r,o=Pn,a=Pn,l,c=us){let u={width:t,height:t,depth:1},h=[u,u,u,u,u,u];super(t,t,e,i,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},ga=class extends Kn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},ro=class n extends _n{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],d=0,f=0;p("z","y","x",-1,-1,i,e,t,o,r,0),p("z","y","x",1,-1,i,e,-t,o,r,1),p("x","z","y",1,1,t,i,e,s,o,2),p("x","z","y",1,-1,t,i,-e,s,o,3),p("x","y","z",1,-1,t,e,i,s,r,4),p("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new en(c,3)),this.setAttribute("normal",new en(u,3)),this.setAttribute("uv",new en(h,2));function p(x,m,g,_,w,v,E,A,y,M,P){let L=v/y,I=E/M,F=v/2,k=E/2,D=A/2,V=y+1,X=M+1,H=0,lt=0,Z=new W;for(let Q=0;Q<X;Q++){let it=Q*I-k;for(let ft=0;ft<V;ft++){let dt=ft*L-F;Z[x]=dt*_,Z[m]=it*w,Z[g]=D,c.push(Z.x,Z.y,Z.z),Z[x]=0,Z[m]=0,Z[g]=A>0?1:-1,u.push(Z.x,Z.y,Z.z),h.push(ft/y),h.push(1-Q/M),H+=1}}for(let Q=0;Q<M;Q++)for(let it=0;it<y;it++){let ft=d+it+V*Q,dt=d+it+V*(Q+1),tt=d+(it+1)+V*(Q+1),ht=d+(it+1)+V*Q;l.push(ft,dt,ht),l.push(dt,tt,ht),lt+=6}a.addGroup(f,lt,P),f+=lt,d+=H}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var $i=class n extends _n{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],d=[],f=[],p=0,x=[],m=i/2,g=0;_(),o===!1&&(t>0&&w(!0),e>0&&w(!1)),this.setIndex(u),this.setAttribute("position",new en(h,3)),this.setAttribute("normal",new en(d,3)),this.setAttribute("uv",new en(f,2));function _(){let v=new W,E=new W,A=0,y=(e-t)/i;for(let M=0;M<=r;M++){let P=[],L=M/r,I=L*(e-t)+t;for(let F=0;F<=s;F++){let k=F/s,D=k*l+a,V=Math.sin(D),X=Math.cos(D);E.x=I*V,E.y=-L*i+m,E.z=I*X,h.push(E.x,E.y,E.z),v.set(V,y,X).normalize(),d.push(v.x,v.y,v.z),f.push(k,1-L),P.push(p++)}x.push(P)}for(let M=0;M<s;M++)for(let P=0;P<r;P++){let L=x[P][M],I=x[P+1][M],F=x[P+1][M+1],k=x[P][M+1];(t>0||P!==0)&&(u.push(L,I,k),A+=3),(e>0||P!==r-1)&&(u.push(I,F,k),A+=3)}c.addGroup(g,A,0),g+=A}function w(v){let E=p,A=new Yt,y=new W,M=0,P=v===!0?t:e,L=v===!0?1:-1;for(let F=1;F<=s;F++)h.push(0,m*L,0),d.push(0,L,0),f.push(.5,.5),p++;let I=p;for(let F=0;F<=s;F++){let D=F/s*l+a,V=Math.cos(D),X=Math.sin(D);y.x=P*X,y.y=m*L,y.z=P*V,h.push(y.x,y.y,y.z),d.push(0,L,0),A.x=V*.5+.5,A.y=X*.5*L+.5,f.push(A.x,A.y),p++}for(let F=0;F<s;F++){let k=E+F,D=I+F;v===!0?u.push(D,D+1,k):u.push(D+1,D,k),M+=3}c.addGroup(g,M,v===!0?1:2),g+=M}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},xa=class n extends $i{constructor(t=1,e=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new n(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var _a=class n extends _n{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=t/a,d=e/l,f=[],p=[],x=[],m=[];for(let g=0;g<u;g++){let _=g*d-o;for(let w=0;w<c;w++){let v=w*h-r;p.push(v,-_,0),x.push(0,0,1),m.push(w/a),m.push(1-g/l)}}for(let g=0;g<l;g++)for(let _=0;_<a;_++){let w=_+c*g,v=_+c*(g+1),E=_+1+c*(g+1),A=_+1+c*g;f.push(w,v,A),f.push(v,E,A)}this.setIndex(f),this.setAttribute("position",new en(p,3)),this.setAttribute("normal",new en(x,3)),this.setAttribute("uv",new en(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var oo=class n extends _n{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new W,d=new W,f=[],p=[],x=[],m=[];for(let g=0;g<=i;g++){let _=[],w=g/i,v=o+w*a,E=t*Math.cos(v),A=Math.sqrt(t*t-E*E),y=0;g===0&&o===0?y=.5/e:g===i&&l===Math.PI&&(y=-.5/e);for(let M=0;M<=e;M++){let P=M/e,L=s+P*r;h.x=-A*Math.cos(L),h.y=E,h.z=A*Math.sin(L),p.push(h.x,h.y,h.z),d.copy(h).normalize(),x.push(d.x,d.y,d.z),m.push(P+y,1-w),_.push(c++)}u.push(_)}for(let g=0;g<i;g++)for(let _=0;_<e;_++){let w=u[g][_+1],v=u[g][_],E=u[g+1][_],A=u[g+1][_+1];(g!==0||o>0)&&f.push(w,v,A),(g!==i-1||l<Math.PI)&&f.push(v,E,A)}this.setIndex(f),this.setAttribute("position",new en(p,3)),this.setAttribute("normal",new en(x,3)),this.setAttribute("uv",new en(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};function pr(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(Cp(s))s.isRenderTargetTexture?(Xt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(Cp(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function Bn(n){let t={};for(let e=0;e<n.length;e++){let i=pr(n[e]);for(let s in i)t[s]=i[s]}return t}function Cp(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function $y(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function ud(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:xe.workingColorSpace}var Mm={clone:pr,merge:Bn},Xy=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,qy=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Xi=class extends fs{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Xy,this.fragmentShader=qy,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=pr(t.uniforms),this.uniformsGroups=$y(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new Qt().setHex(s.value);break;case"v2":this.uniforms[i].value=new Yt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new W().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Ye().fromArray(s.value);break;case"m3":this.uniforms[i].value=new ee().fromArray(s.value);break;case"m4":this.uniforms[i].value=new pe().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},ql=class extends Xi{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var ms=class extends fs{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Qt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Qt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Zc,this.normalScale=new Yt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new hs,this.combine=lc,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},Yl=class extends fs{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=am,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Zl=class extends fs{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Yr(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function Al(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var zs=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Kl=class extends zs{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Eh,endingEnd:Eh}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Th:r=t,a=2*e-i;break;case Ch:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Th:o=t,l=2*i-e;break;case Ch:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,u=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(i-e)/(s-e),x=p*p,m=x*p,g=-d*m+2*d*x-d*p,_=(1+d)*m+(-1.5-2*d)*x+(-.5+d)*p+1,w=(-1-f)*m+(1.5+f)*x+.5*p,v=f*m-f*x;for(let E=0;E!==a;++E)r[E]=g*o[u+E]+_*o[c+E]+w*o[l+E]+v*o[h+E];return r}},Jl=class extends zs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=(i-e)/(s-e),h=1-u;for(let d=0;d!==a;++d)r[d]=o[c+d]*h+o[l+d]*u;return r}},jl=class extends zs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Ql=class extends zs{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let p=(i-e)/(s-e),x=1-p;for(let m=0;m!==a;++m)r[m]=o[c+m]*x+o[l+m]*p;return r}let d=a*2,f=t-1;for(let p=0;p!==a;++p){let x=o[c+p],m=o[l+p],g=f*d+p*2,_=h[g],w=h[g+1],v=t*d+p*2,E=u[v],A=u[v+1],y=Zy(i,e,_,E,s);r[p]=wm(y,x,w,A,m)}return r}};function wm(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function Yy(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function Zy(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=wm(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=Yy(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var hi=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Yr(e,this.TimeBufferType),this.values=Yr(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:Yr(t.times,Array),values:Yr(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),Al(t.settings)&&(i.settings={inTangents:Yr(t.settings.inTangents,Array),outTangents:Yr(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new jl(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Jl(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Kl(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Ql(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case sa:e=this.InterpolantFactoryMethodDiscrete;break;case Bl:e=this.InterpolantFactoryMethodLinear;break;case Cl:e=this.InterpolantFactoryMethodSmooth;break;case Ah:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Xt("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return sa;case this.InterpolantFactoryMethodLinear:return Bl;case this.InterpolantFactoryMethodSmooth:return Cl;case this.InterpolantFactoryMethodBezier:return Ah}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;Al(this.settings)&&(Rp(this.settings.inTangents,t),Rp(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;Al(this.settings)&&(Pp(this.settings.inTangents,t),Pp(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(jt("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(jt("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){jt("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){jt("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&uy(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){jt("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Cl,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],u=t[a+1];if(c!==u&&(a!==1||c!==t[0]))if(s)l=!0;else{let h=a*i,d=h-i,f=h+i;for(let p=0;p!==i;++p){let x=e[h+p];if(x!==e[d+p]||x!==e[f+p]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let h=a*i,d=o*i;for(let f=0;f!==i;++f)e[d+f]=e[h+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,Al(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Rp(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function Pp(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}hi.prototype.ValueTypeName="";hi.prototype.TimeBufferType=Float32Array;hi.prototype.ValueBufferType=Float32Array;hi.prototype.DefaultInterpolation=Bl;var Vs=class extends hi{constructor(t,e,i){super(t,e,i)}};Vs.prototype.ValueTypeName="bool";Vs.prototype.ValueBufferType=Array;Vs.prototype.DefaultInterpolation=sa;Vs.prototype.InterpolantFactoryMethodLinear=void 0;Vs.prototype.InterpolantFactoryMethodSmooth=void 0;var tc=class extends hi{constructor(t,e,i,s){super(t,e,i,s)}};tc.prototype.ValueTypeName="color";var ec=class extends hi{constructor(t,e,i,s){super(t,e,i,s)}};ec.prototype.ValueTypeName="number";var nc=class extends zs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let u=c+a;c!==u;c+=4)li.slerpFlat(r,0,o,c-a,o,c,l);return r}},ya=class extends hi{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new nc(this.times,this.values,this.getValueSize(),t)}};ya.prototype.ValueTypeName="quaternion";ya.prototype.InterpolantFactoryMethodSmooth=void 0;var Gs=class extends hi{constructor(t,e,i){super(t,e,i)}};Gs.prototype.ValueTypeName="string";Gs.prototype.ValueBufferType=Array;Gs.prototype.DefaultInterpolation=sa;Gs.prototype.InterpolantFactoryMethodLinear=void 0;Gs.prototype.InterpolantFactoryMethodSmooth=void 0;var ic=class extends hi{constructor(t,e,i,s){super(t,e,i,s)}};ic.prototype.ValueTypeName="vector";var sc=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,d=c.length;h<d;h+=2){let f=c[h],p=c[h+1];if(f.global&&(f.lastIndex=0),f.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Am=new sc,rc=class{constructor(t){this.manager=t!==void 0?t:Am,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};rc.DEFAULT_MATERIAL_NAME="__DEFAULT";var va=class extends Ln{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new Qt(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},ba=class extends va{constructor(t,e,i){super(t,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Ln.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Qt(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},wh=new pe,Ip=new W,Lp=new W,oc=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Yt(512,512),this.mapType=Jn,this.map=null,this.mapPass=null,this.matrix=new pe,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new ks,this._frameExtents=new Yt(1,1),this._viewportCount=1,this._viewports=[new Ye(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;Ip.setFromMatrixPosition(t.matrixWorld),e.position.copy(Ip),Lp.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(Lp),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,i,s){wh.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),i.setFromProjectionMatrix(wh,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===Qr||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(wh)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},El=new W,Tl=new li,Gi=new W,Sa=class extends Ln{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new pe,this.projectionMatrix=new pe,this.projectionMatrixInverse=new pe,this.coordinateSystem=_i,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(El,Tl,Gi),Gi.x===1&&Gi.y===1&&Gi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(El,Tl,Gi.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(El,Tl,Gi),Gi.x===1&&Gi.y===1&&Gi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(El,Tl,Gi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Us=new W,Np=new Yt,Dp=new Yt,Xn=class extends Sa{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=eo*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(na*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return eo*2*Math.atan(Math.tan(na*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){Us.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Us.x,Us.y).multiplyScalar(-t/Us.z),Us.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Us.x,Us.y).multiplyScalar(-t/Us.z)}getViewSize(t,e){return this.getViewBounds(t,Np,Dp),e.subVectors(Dp,Np)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(na*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Ma=class extends Sa{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Rh=class extends oc{constructor(){super(new Ma(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},wa=class extends va{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Ln.DEFAULT_UP),this.updateMatrix(),this.target=new Ln,this.shadow=new Rh}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}};var Zr=-90,Kr=1,ao=class extends Ln{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Xn(Zr,Kr,t,e);s.layers=this.layers,this.add(s);let r=new Xn(Zr,Kr,t,e);r.layers=this.layers,this.add(r);let o=new Xn(Zr,Kr,t,e);o.layers=this.layers,this.add(o);let a=new Xn(Zr,Kr,t,e);a.layers=this.layers,this.add(a);let l=new Xn(Zr,Kr,t,e);l.layers=this.layers,this.add(l);let c=new Xn(Zr,Kr,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===_i)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===Qr)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let x=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=x,t.setRenderTarget(i,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,u),t.setRenderTarget(h,d,f),t.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},ac=class extends Xn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var hd="\\[\\]\\.:\\/",Ky=new RegExp("["+hd+"]","g"),dd="[^"+hd+"]",Jy="[^"+hd.replace("\\.","")+"]",jy=/((?:WC+[\/:])*)/.source.replace("WC",dd),Qy=/(WCOD+)?/.source.replace("WCOD",Jy),tv=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",dd),ev=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",dd),nv=new RegExp("^"+jy+Qy+tv+ev+"$"),iv=["material","materials","bones","map"],Ph=class{constructor(t,e,i){let s=i||We.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},We=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(Ky,"")}static parseTrackName(t){let e=nv.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);iv.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Xt("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){jt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){jt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){jt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let u=0;u<t.length;u++)if(t[u].name===c){c=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){jt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){jt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){jt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){jt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;jt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){jt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){jt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};We.Composite=Ph;We.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};We.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};We.prototype.GetterByBindingType=[We.prototype._getValue_direct,We.prototype._getValue_array,We.prototype._getValue_arrayElement,We.prototype._getValue_toArray];We.prototype.SetterByBindingTypeAndVersioning=[[We.prototype._setValue_direct,We.prototype._setValue_direct_setNeedsUpdate,We.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[We.prototype._setValue_array,We.prototype._setValue_array_setNeedsUpdate,We.prototype._setValue_array_setMatrixWorldNeedsUpdate],[We.prototype._setValue_arrayElement,We.prototype._setValue_arrayElement_setNeedsUpdate,We.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[We.prototype._setValue_fromArray,We.prototype._setValue_fromArray_setNeedsUpdate,We.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var sP=new Float32Array(1);var Up=new pe,Aa=class{constructor(t,e,i=0,s=1/0){this.ray=new Fs(t,e),this.near=i,this.far=s,this.camera=null,this.layers=new io,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):jt("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return Up.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Up),this}intersectObject(t,e=!0,i=[]){return Ih(t,this,i,e),i.sort(Op),i}intersectObjects(t,e=!0,i=[]){for(let s=0,r=t.length;s<r;s++)Ih(t[s],this,i,e);return i.sort(Op),i}};function Op(n,t){return n.distance-t.distance}function Ih(n,t,e,i){let s=!0;if(n.layers.test(t.layers)&&n.raycast(t,e)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)Ih(r[o],t,e,!0)}}var lo=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=fe(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(fe(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Lh=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var Ea=class extends Ci{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function fd(n,t,e,i){let s=sv(i);switch(e){case Jh:return n*t;case mc:return n*t/s.components*s.byteLength;case gc:return n*t/s.components*s.byteLength;case Xs:return n*t*2/s.components*s.byteLength;case xc:return n*t*2/s.components*s.byteLength;case jh:return n*t*3/s.components*s.byteLength;case Ii:return n*t*4/s.components*s.byteLength;case _c:return n*t*4/s.components*s.byteLength;case Ra:case Pa:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Ia:case La:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case vc:case Sc:return Math.max(n,16)*Math.max(t,8)/4;case yc:case bc:return Math.max(n,8)*Math.max(t,8)/2;case Mc:case wc:case Ec:case Tc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Ac:case Na:case Cc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Rc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Pc:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case Ic:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case Lc:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case Nc:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case Dc:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case Uc:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case Oc:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case Fc:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case kc:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case Bc:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case zc:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case Vc:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case Gc:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case Hc:case Wc:case $c:return Math.ceil(n/4)*Math.ceil(t/4)*16;case Xc:case qc:return Math.ceil(n/4)*Math.ceil(t/4)*8;case Da:case Yc:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function sv(n){switch(n){case Jn:case qh:return{byteLength:1,components:1};case fo:case Yh:case Pi:return{byteLength:2,components:1};case fc:case pc:return{byteLength:2,components:4};case Ri:case dc:case yi:return{byteLength:4,components:1};case Zh:case Kh:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Xt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function qm(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function ov(n){let t=new WeakMap;function e(a,l){let c=a.array,u=a.usage,h=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<h.length;f++){let p=h[d],x=h[f];x.start<=p.start+p.count+1?p.count=Math.max(p.count,x.start+x.count-p.start):(++d,h[d]=x)}h.length=d+1;for(let f=0,p=h.length;f<p;f++){let x=h[f];n.bufferSubData(c,x.start*u.BYTES_PER_ELEMENT,u,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var av=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,lv=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,cv=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,uv=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,hv=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,dv=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,fv=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,pv=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,mv=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,gv=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,xv=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,_v=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,yv=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,vv=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,bv=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,Sv=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,Mv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,wv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Av=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Ev=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Tv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Cv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Rv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,Pv=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,Iv=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,Lv=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Nv=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Dv=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Uv=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Ov="gl_FragColor = linearToOutputTexel( gl_FragColor );",Fv=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,kv=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,Bv=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,zv=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,Vv=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Gv=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,Hv=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Wv=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,$v=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Xv=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,qv=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,Yv=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Zv=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Kv=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Jv=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,jv=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,Qv=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,tb=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,eb=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,nb=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,ib=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,sb=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,rb=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,ob=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,ab=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,lb=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,cb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,ub=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,hb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,db=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,fb=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,pb=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,mb=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,gb=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,xb=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,_b=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,yb=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,vb=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,bb=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Sb=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,Mb=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,wb=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,Ab=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,Eb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Tb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Cb=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Rb=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,Pb=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Ib=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Lb=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Nb=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Db=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Ub=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,Ob=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Fb=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,kb=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Bb=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,zb=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Vb=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Gb=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,Hb=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,Wb=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,$b=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,Xb=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,qb=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,Yb=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Zb=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,Kb=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Jb=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,jb=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Qb=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,tS=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,eS=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,nS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,iS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,sS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,rS=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,oS=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,aS=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,lS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,cS=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,uS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,hS=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,dS=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,fS=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,pS=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,mS=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,gS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,xS=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,_S=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,yS=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,vS=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,bS=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,SS=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,MS=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,wS=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,AS=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,ES=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,TS=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,CS=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,RS=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,PS=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,IS=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,LS=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,NS=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,DS=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,US=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,OS=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,FS=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,kS=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,BS=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,ce={alphahash_fragment:av,alphahash_pars_fragment:lv,alphamap_fragment:cv,alphamap_pars_fragment:uv,alphatest_fragment:hv,alphatest_pars_fragment:dv,aomap_fragment:fv,aomap_pars_fragment:pv,batching_pars_vertex:mv,batching_vertex:gv,begin_vertex:xv,beginnormal_vertex:_v,bsdfs:yv,iridescence_fragment:vv,bumpmap_pars_fragment:bv,clipping_planes_fragment:Sv,clipping_planes_pars_fragment:Mv,clipping_planes_pars_vertex:wv,clipping_planes_vertex:Av,color_fragment:Ev,color_pars_fragment:Tv,color_pars_vertex:Cv,color_vertex:Rv,common:Pv,defaultnormal_vertex:Iv,displacementmap_pars_vertex:Lv,displacementmap_vertex:Nv,emissivemap_fragment:Dv,emissivemap_pars_fragment:Uv,colorspace_fragment:Ov,colorspace_pars_fragment:Fv,envmap_fragment:kv,envmap_common_pars_fragment:Bv,envmap_pars_fragment:zv,envmap_pars_vertex:Vv,envmap_physical_pars_fragment:jv,envmap_vertex:Gv,fog_vertex:Hv,fog_pars_vertex:Wv,fog_fragment:$v,fog_pars_fragment:Xv,gradientmap_pars_fragment:qv,lightmap_pars_fragment:Yv,lights_lambert_fragment:Zv,lights_lambert_pars_fragment:Kv,lights_pars_begin:Jv,lights_toon_fragment:Qv,lights_toon_pars_fragment:tb,lights_phong_fragment:eb,lights_phong_pars_fragment:nb,lights_physical_fragment:ib,lights_physical_pars_fragment:sb,lights_fragment_begin:rb,lights_fragment_maps:ob,lights_fragment_end:ab,lightprobes_pars_fragment:lb,logdepthbuf_fragment:cb,logdepthbuf_pars_fragment:ub,logdepthbuf_pars_vertex:hb,logdepthbuf_vertex:db,map_fragment:fb,map_pars_fragment:pb,map_particle_fragment:mb,map_particle_pars_fragment:gb,metalnessmap_fragment:xb,metalnessmap_pars_fragment:_b,morphinstance_vertex:yb,morphcolor_vertex:vb,morphnormal_vertex:bb,morphtarget_pars_vertex:Sb,morphtarget_vertex:Mb,normal_fragment_begin:wb,normal_fragment_maps:Ab,normal_pars_fragment:Eb,normal_pars_vertex:Tb,normal_vertex:Cb,normalmap_pars_fragment:Rb,clearcoat_normal_fragment_begin:Pb,clearcoat_normal_fragment_maps:Ib,clearcoat_pars_fragment:Lb,iridescence_pars_fragment:Nb,opaque_fragment:Db,packing:Ub,premultiplied_alpha_fragment:Ob,project_vertex:Fb,dithering_fragment:kb,dithering_pars_fragment:Bb,roughnessmap_fragment:zb,roughnessmap_pars_fragment:Vb,shadowmap_pars_fragment:Gb,shadowmap_pars_vertex:Hb,shadowmap_vertex:Wb,shadowmask_pars_fragment:$b,skinbase_vertex:Xb,skinning_pars_vertex:qb,skinning_vertex:Yb,skinnormal_vertex:Zb,specularmap_fragment:Kb,specularmap_pars_fragment:Jb,tonemapping_fragment:jb,tonemapping_pars_fragment:Qb,transmission_fragment:tS,transmission_pars_fragment:eS,uv_pars_fragment:nS,uv_pars_vertex:iS,uv_vertex:sS,worldpos_vertex:rS,background_vert:oS,background_frag:aS,backgroundCube_vert:lS,backgroundCube_frag:cS,cube_vert:uS,cube_frag:hS,depth_vert:dS,depth_frag:fS,distance_vert:pS,distance_frag:mS,equirect_vert:gS,equirect_frag:xS,linedashed_vert:_S,linedashed_frag:yS,meshbasic_vert:vS,meshbasic_frag:bS,meshlambert_vert:SS,meshlambert_frag:MS,meshmatcap_vert:wS,meshmatcap_frag:AS,meshnormal_vert:ES,meshnormal_frag:TS,meshphong_vert:CS,meshphong_frag:RS,meshphysical_vert:PS,meshphysical_frag:IS,meshtoon_vert:LS,meshtoon_frag:NS,points_vert:DS,points_frag:US,shadow_vert:OS,shadow_frag:FS,sprite_vert:kS,sprite_frag:BS},Lt={common:{diffuse:{value:new Qt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ee},alphaMap:{value:null},alphaMapTransform:{value:new ee},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ee}},envmap:{envMap:{value:null},envMapRotation:{value:new ee},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ee}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ee}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ee},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ee},normalScale:{value:new Yt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ee},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ee}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ee}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ee}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Qt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Qt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ee},alphaTest:{value:0},uvTransform:{value:new ee}},sprite:{diffuse:{value:new Qt(16777215)},opacity:{value:1},center:{value:new Yt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ee},alphaMap:{value:null},alphaMapTransform:{value:new ee},alphaTest:{value:0}}},Zi={basic:{uniforms:Bn([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.fog]),vertexShader:ce.meshbasic_vert,fragmentShader:ce.meshbasic_frag},lambert:{uniforms:Bn([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,Lt.lights,{emissive:{value:new Qt(0)},envMapIntensity:{value:1}}]),vertexShader:ce.meshlambert_vert,fragmentShader:ce.meshlambert_frag},phong:{uniforms:Bn([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,Lt.lights,{emissive:{value:new Qt(0)},specular:{value:new Qt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ce.meshphong_vert,fragmentShader:ce.meshphong_frag},standard:{uniforms:Bn([Lt.common,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.roughnessmap,Lt.metalnessmap,Lt.fog,Lt.lights,{emissive:{value:new Qt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ce.meshphysical_vert,fragmentShader:ce.meshphysical_frag},toon:{uniforms:Bn([Lt.common,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.gradientmap,Lt.fog,Lt.lights,{emissive:{value:new Qt(0)}}]),vertexShader:ce.meshtoon_vert,fragmentShader:ce.meshtoon_frag},matcap:{uniforms:Bn([Lt.common,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,{matcap:{value:null}}]),vertexShader:ce.meshmatcap_vert,fragmentShader:ce.meshmatcap_frag},points:{uniforms:Bn([Lt.points,Lt.fog]),vertexShader:ce.points_vert,fragmentShader:ce.points_frag},dashed:{uniforms:Bn([Lt.common,Lt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ce.linedashed_vert,fragmentShader:ce.linedashed_frag},depth:{uniforms:Bn([Lt.common,Lt.displacementmap]),vertexShader:ce.depth_vert,fragmentShader:ce.depth_frag},normal:{uniforms:Bn([Lt.common,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,{opacity:{value:1}}]),vertexShader:ce.meshnormal_vert,fragmentShader:ce.meshnormal_frag},sprite:{uniforms:Bn([Lt.sprite,Lt.fog]),vertexShader:ce.sprite_vert,fragmentShader:ce.sprite_frag},background:{uniforms:{uvTransform:{value:new ee},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ce.background_vert,fragmentShader:ce.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ee}},vertexShader:ce.backgroundCube_vert,fragmentShader:ce.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ce.cube_vert,fragmentShader:ce.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ce.equirect_vert,fragmentShader:ce.equirect_frag},distance:{uniforms:Bn([Lt.common,Lt.displacementmap,{referencePosition:{value:new W},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ce.distance_vert,fragmentShader:ce.distance_frag},shadow:{uniforms:Bn([Lt.lights,Lt.fog,{color:{value:new Qt(0)},opacity:{value:1}}]),vertexShader:ce.shadow_vert,fragmentShader:ce.shadow_frag}};Zi.physical={uniforms:Bn([Zi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ee},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ee},clearcoatNormalScale:{value:new Yt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ee},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ee},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ee},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ee},sheen:{value:0},sheenColor:{value:new Qt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ee},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ee},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ee},transmissionSamplerSize:{value:new Yt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ee},attenuationDistance:{value:0},attenuationColor:{value:new Qt(0)},specularColor:{value:new Qt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ee},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ee},anisotropyVector:{value:new Yt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ee}}]),vertexShader:ce.meshphysical_vert,fragmentShader:ce.meshphysical_frag};var Kc={r:0,b:0,g:0},zS=new pe,Ym=new ee;Ym.set(-1,0,0,0,1,0,0,0,1);function VS(n,t,e,i,s,r){let o=new Qt(0),a=s===!0?0:1,l,c,u=null,h=0,d=null;function f(_){let w=_.isScene===!0?_.background:null;if(w&&w.isTexture){let v=_.backgroundBlurriness>0;w=t.get(w,v)}return w}function p(_){let w=!1,v=f(_);v===null?m(o,a):v&&v.isColor&&(m(v,1),w=!0);let E=n.xr.getEnvironmentBlendMode();E==="additive"?e.buffers.color.setClear(0,0,0,1,r):E==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||w)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function x(_,w){let v=f(w);v&&v.isCubeTexture?(c===void 0&&(c=new Nn(new ro(1,1,1),new Xi({name:"BackgroundCubeMaterial",uniforms:pr(Zi.backgroundCube.uniforms),vertexShader:Zi.backgroundCube.vertexShader,fragmentShader:Zi.backgroundCube.fragmentShader,side:Yn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(E,A,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=v,c.material.uniforms.backgroundBlurriness.value=w.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(zS.makeRotationFromEuler(w.backgroundRotation)).transpose(),v.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Ym),c.material.toneMapped=xe.getTransfer(v.colorSpace)!==Ae,(u!==v||h!==v.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,u=v,h=v.version,d=n.toneMapping),c.layers.enableAll(),_.unshift(c,c.geometry,c.material,0,0,null)):v&&v.isTexture&&(l===void 0&&(l=new Nn(new _a(2,2),new Xi({name:"BackgroundMaterial",uniforms:pr(Zi.background.uniforms),vertexShader:Zi.background.vertexShader,fragmentShader:Zi.background.fragmentShader,side:$s,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=v,l.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,l.material.toneMapped=xe.getTransfer(v.colorSpace)!==Ae,v.matrixAutoUpdate===!0&&v.updateMatrix(),l.material.uniforms.uvTransform.value.copy(v.matrix),(u!==v||h!==v.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,u=v,h=v.version,d=n.toneMapping),l.layers.enableAll(),_.unshift(l,l.geometry,l.material,0,0,null))}function m(_,w){_.getRGB(Kc,ud(n)),e.buffers.color.setClear(Kc.r,Kc.g,Kc.b,w,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(_,w=1){o.set(_),a=w,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(_){a=_,m(o,a)},render:p,addToRenderList:x,dispose:g}}function GS(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(I,F,k,D,V){let X=!1,H=h(I,D,k,F);r!==H&&(r=H,c(r.object)),X=f(I,D,k,V),X&&p(I,D,k,V),V!==null&&t.update(V,n.ELEMENT_ARRAY_BUFFER),(X||o)&&(o=!1,v(I,F,k,D),V!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(V).buffer))}function l(){return n.createVertexArray()}function c(I){return n.bindVertexArray(I)}function u(I){return n.deleteVertexArray(I)}function h(I,F,k,D){let V=D.wireframe===!0,X=i[F.id];X===void 0&&(X={},i[F.id]=X);let H=I.isInstancedMesh===!0?I.id:0,lt=X[H];lt===void 0&&(lt={},X[H]=lt);let Z=lt[k.id];Z===void 0&&(Z={},lt[k.id]=Z);let Q=Z[V];return Q===void 0&&(Q=d(l()),Z[V]=Q),Q}function d(I){let F=[],k=[],D=[];for(let V=0;V<e;V++)F[V]=0,k[V]=0,D[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:F,enabledAttributes:k,attributeDivisors:D,object:I,attributes:{},index:null}}function f(I,F,k,D){let V=r.attributes,X=F.attributes,H=0,lt=k.getAttributes();for(let Z in lt)if(lt[Z].location>=0){let it=V[Z],ft=X[Z];if(ft===void 0&&(Z==="instanceMatrix"&&I.instanceMatrix&&(ft=I.instanceMatrix),Z==="instanceColor"&&I.instanceColor&&(ft=I.instanceColor)),it===void 0||it.attribute!==ft||ft&&it.data!==ft.data)return!0;H++}return r.attributesNum!==H||r.index!==D}function p(I,F,k,D){let V={},X=F.attributes,H=0,lt=k.getAttributes();for(let Z in lt)if(lt[Z].location>=0){let it=X[Z];it===void 0&&(Z==="instanceMatrix"&&I.instanceMatrix&&(it=I.instanceMatrix),Z==="instanceColor"&&I.instanceColor&&(it=I.instanceColor));let ft={};ft.attribute=it,it&&it.data&&(ft.data=it.data),V[Z]=ft,H++}r.attributes=V,r.attributesNum=H,r.index=D}function x(){let I=r.newAttributes;for(let F=0,k=I.length;F<k;F++)I[F]=0}function m(I){g(I,0)}function g(I,F){let k=r.newAttributes,D=r.enabledAttributes,V=r.attributeDivisors;k[I]=1,D[I]===0&&(n.enableVertexAttribArray(I),D[I]=1),V[I]!==F&&(n.vertexAttribDivisor(I,F),V[I]=F)}function _(){let I=r.newAttributes,F=r.enabledAttributes;for(let k=0,D=F.length;k<D;k++)F[k]!==I[k]&&(n.disableVertexAttribArray(k),F[k]=0)}function w(I,F,k,D,V,X,H){H===!0?n.vertexAttribIPointer(I,F,k,V,X):n.vertexAttribPointer(I,F,k,D,V,X)}function v(I,F,k,D){x();let V=D.attributes,X=k.getAttributes(),H=F.defaultAttributeValues;for(let lt in X){let Z=X[lt];if(Z.location>=0){let Q=V[lt];if(Q===void 0&&(lt==="instanceMatrix"&&I.instanceMatrix&&(Q=I.instanceMatrix),lt==="instanceColor"&&I.instanceColor&&(Q=I.instanceColor)),Q!==void 0){let it=Q.normalized,ft=Q.itemSize,dt=t.get(Q);if(dt===void 0)continue;let tt=dt.buffer,ht=dt.type,gt=dt.bytesPerElement,St=ht===n.INT||ht===n.UNSIGNED_INT||Q.gpuType===dc;if(Q.isInterleavedBufferAttribute){let Mt=Q.data,Ht=Mt.isInterleavedBuffer===!0?Mt.stride:Mt.itemSize,se=Q.offset;if(Mt.isInstancedInterleavedBuffer||Mt.isInstancedBufferAttribute){for(let Vt=0;Vt<Z.locationSize;Vt++)g(Z.location+Vt,Mt.meshPerAttribute);I.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=Mt.meshPerAttribute*Mt.count)}else for(let Vt=0;Vt<Z.locationSize;Vt++)m(Z.location+Vt);n.bindBuffer(n.ARRAY_BUFFER,tt);for(let Vt=0;Vt<Z.locationSize;Vt++)w(Z.location+Vt,ft/Z.locationSize,ht,it,Ht*gt,(se+ft/Z.locationSize*Vt)*gt,St)}else{if(Q.isInstancedBufferAttribute){for(let Mt=0;Mt<Z.locationSize;Mt++)g(Z.location+Mt,Q.meshPerAttribute);I.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let Mt=0;Mt<Z.locationSize;Mt++)m(Z.location+Mt);n.bindBuffer(n.ARRAY_BUFFER,tt);for(let Mt=0;Mt<Z.locationSize;Mt++)w(Z.location+Mt,ft/Z.locationSize,ht,it,ft*gt,ft/Z.locationSize*Mt*gt,St)}}else if(H!==void 0){let it=H[lt];if(it!==void 0)switch(it.length){case 2:n.vertexAttrib2fv(Z.location,it);break;case 3:n.vertexAttrib3fv(Z.location,it);break;case 4:n.vertexAttrib4fv(Z.location,it);break;default:n.vertexAttrib1fv(Z.location,it)}}}}_()}function E(){P();for(let I in i){let F=i[I];for(let k in F){let D=F[k];for(let V in D){let X=D[V];for(let H in X)u(X[H].object),delete X[H];delete D[V]}}delete i[I]}}function A(I){if(i[I.id]===void 0)return;let F=i[I.id];for(let k in F){let D=F[k];for(let V in D){let X=D[V];for(let H in X)u(X[H].object),delete X[H];delete D[V]}}delete i[I.id]}function y(I){for(let F in i){let k=i[F];for(let D in k){let V=k[D];if(V[I.id]===void 0)continue;let X=V[I.id];for(let H in X)u(X[H].object),delete X[H];delete V[I.id]}}}function M(I){for(let F in i){let k=i[F],D=I.isInstancedMesh===!0?I.id:0,V=k[D];if(V!==void 0){for(let X in V){let H=V[X];for(let lt in H)u(H[lt].object),delete H[lt];delete V[X]}delete k[D],Object.keys(k).length===0&&delete i[F]}}}function P(){L(),o=!0,r!==s&&(r=s,c(r.object))}function L(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:P,resetDefaultState:L,dispose:E,releaseStatesOfGeometry:A,releaseStatesOfObject:M,releaseStatesOfProgram:y,initAttributes:x,enableAttribute:m,disableUnusedAttributes:_}}function HS(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),e.update(c,i,u))}function a(l,c,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let d=0;for(let f=0;f<u;f++)d+=c[f];e.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function WS(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let y=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==Ii&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let M=y===Pi&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(y!==Jn&&y!==yi&&!M&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",u=l(c);u!==c&&(Xt("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&h===!1;e.reversedDepthBuffer===!0&&h===!1&&Xt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&h===!0&&Xt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),_=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),w=n.getParameter(n.MAX_VARYING_VECTORS),v=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),E=n.getParameter(n.MAX_SAMPLES),A=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:p,maxTextureSize:x,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:_,maxVaryings:w,maxFragmentUniforms:v,maxSamples:E,samples:A}}function $S(n){let t=this,e=null,i=0,s=!1,r=!1,o=new ai,a=new ee,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){let f=h.length!==0||d||i!==0||s;return s=d,i=h.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,d){e=u(h,d,0)},this.setState=function(h,d,f){let p=h.clippingPlanes,x=h.clipIntersection,m=h.clipShadows,g=n.get(h);if(!s||p===null||p.length===0||r&&!m)r?u(null):c();else{let _=r?0:i,w=_*4,v=g.clippingState||null;l.value=v,v=u(p,d,w,f);for(let E=0;E!==w;++E)v[E]=e[E];g.clippingState=v,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=_}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function u(h,d,f,p){let x=h!==null?h.length:0,m=null;if(x!==0){if(m=l.value,p!==!0||m===null){let g=f+x*4,_=d.matrixWorldInverse;a.getNormalMatrix(_),(m===null||m.length<g)&&(m=new Float32Array(g));for(let w=0,v=f;w!==x;++w,v+=4)o.copy(h[w]).applyMatrix4(_,a),o.normal.toArray(m,v),m[v+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=x,t.numIntersection=0,m}}var ka=class extends ci{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new pa(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new ro(5,5,5),r=new Xi({name:"CubemapFromEquirect",uniforms:pr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Yn,blending:ur});r.uniforms.tEquirect.value=e;let o=new Nn(s,r),a=e.minFilter;return e.minFilter===gs&&(e.minFilter=qn),new ao(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},Em=256,XS=3,qS=20,Zm=256,Km=16,YS=3,ZS=new W,KS=new Qt,jc=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new ao(1,10,null),this._boxMesh=new Nn(new ro(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=ZS}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);e>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,x=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(t.background=l.getClearColor(KS));let m=new ao(i,s,u);return m.position.copy(a),m.update(l,t),l.autoClear=h,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=p,t.background=x,e>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Rm(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Cm(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Em,ad(t))}_fromTexture(t,e){t.mapping===dr||t.mapping===ho?this._setSize(t.image.length===0?Em:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=Tm(t,!1,!1),i=Math.log2(t)-XS;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Tm(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===dr||t.mapping===ho?(this._cubemapMaterial===null&&(this._cubemapMaterial=Rm()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Cm()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=JS(),this._integrationMaterial=jS());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/Km);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-YS)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(Zm*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=QS());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function Tm(n,t,e){return new ka(n,{minFilter:gs,generateMipmaps:t,type:Pi,colorSpace:ra,depthBuffer:e})}function Ba(n,t,e){return new Xi({name:n,uniforms:t,vertexShader:ce.cube_vert,fragmentShader:e,side:Yn,blending:ur,depthTest:!1,depthWrite:!1})}function JS(){return Ba("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Zm}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function jS(){return Ba("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Km}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function QS(){return Ba("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${qS}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function Cm(){return Ba("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Rm(){return Ba("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function tM(n){let t=new WeakMap,e=new WeakMap,i=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===cc||f===uc)if(t.has(d)){let p=t.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let x=new ka(p.height);return x.fromEquirectangularTexture(n,d),t.set(d,x),d.addEventListener("dispose",c),a(x.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===cc||f===uc,x=f===dr||f===ho;if(p||x){let m=e.get(d),g=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==g)return i===null&&(i=new jc(n)),m=p?i.fromEquirectangular(d,m):i.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),m.texture;if(m!==void 0)return m.texture;{let _=d.image;return p&&_&&_.height>0||x&&_&&l(_)?(i===null&&(i=new jc(n)),m=p?i.fromEquirectangular(d):i.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),d.addEventListener("dispose",u),m.texture):null}}}return d}function a(d,f){return f===cc?d.mapping=dr:f===uc&&(d.mapping=ho),d}function l(d){let f=0,p=6;for(let x=0;x<p;x++)d[x]!==void 0&&f++;return f===p}function c(d){let f=d.target;f.removeEventListener("dispose",c);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function u(d){let f=d.target;f.removeEventListener("dispose",u);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function h(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function eM(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&ea("WebGLRenderer: "+i+" extension not supported."),s}}}function nM(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&t.remove(p.index);for(let m in p.attributes)t.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let x=r.get(p);x&&(t.remove(x),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function c(p,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),e.memory.geometries++),x}function u(p){let x=p.attributes;for(let m in x)t.update(x[m],n.ARRAY_BUFFER)}function h(p){let x=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let _=x!==null?x.array.length:m.array.length/3-1,w=m.count>=65535?ha:ua,v=new w(Math.ceil(_/3)*6,1),E=v.array;if(x!==null){let y=x.array;g=x.version;for(let M=0,P=0;M<_;M+=3){let L=y[M+0],I=y[M+1],F=y[M+2];E[P++]=L,E[P++]=I,E[P++]=I,E[P++]=F,E[P++]=F,E[P++]=L}}else{g=m.version;for(let y=0,M=0;y<_;y+=3){let P=y+0,L=y+1,I=y+2;E[M++]=P,E[M++]=L,E[M++]=L,E[M++]=I,E[M++]=I,E[M++]=P}}v.version=g;let A=r.get(p);A&&t.remove(A),r.set(p,v)}function d(p){let x=r.get(p);if(x){let m=p.index;m!==null&&x.version<m.version&&h(p)}else h(p);return r.get(p)}function f(){for(let p in s){let x=s[p].deref();x!==void 0&&l(x)}}return{get:c,update:u,getWireframeAttribute:d,dispose:f}}function iM(n,t,e){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,d){n.drawElements(i,d,r,h*o),e.update(d,i,1)}function c(h,d,f){f!==0&&(n.drawElementsInstanced(i,d,r,h*o,f),e.update(d,i,f))}function u(h,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,h,0,f);let x=0;for(let m=0;m<f;m++)x+=d[m];e.update(x,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function sM(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:jt("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function rM(n,t,e){let i=new WeakMap,s=new Ye;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,d=i.get(a);if(d===void 0||d.count!==h){let P=function(){y.dispose(),i.delete(a),a.removeEventListener("dispose",P)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],_=a.morphAttributes.color||[],w=0;f===!0&&(w=1),p===!0&&(w=2),x===!0&&(w=3);let v=a.attributes.position.count*w,E=1;v>t.maxTextureSize&&(E=Math.ceil(v/t.maxTextureSize),v=t.maxTextureSize);let A=new Float32Array(v*E*4*h),y=new la(A,v,E,h);y.type=yi,y.needsUpdate=!0;let M=w*4;for(let L=0;L<h;L++){let I=m[L],F=g[L],k=_[L],D=v*E*4*L;for(let V=0;V<I.count;V++){let X=V*M;f===!0&&(s.fromBufferAttribute(I,V),A[D+X+0]=s.x,A[D+X+1]=s.y,A[D+X+2]=s.z,A[D+X+3]=0),p===!0&&(s.fromBufferAttribute(F,V),A[D+X+4]=s.x,A[D+X+5]=s.y,A[D+X+6]=s.z,A[D+X+7]=0),x===!0&&(s.fromBufferAttribute(k,V),A[D+X+8]=s.x,A[D+X+9]=s.y,A[D+X+10]=s.z,A[D+X+11]=k.itemSize===4?s.w:1)}}d={count:h,texture:y,size:new Yt(v,E)},i.set(a,d),a.addEventListener("dispose",P)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let f=0;for(let x=0;x<c.length;x++)f+=c[x];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function oM(n,t,e,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,d=t.get(c,h);if(r.get(d)!==u&&(t.update(d),r.set(d,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return d}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),e.remove(u.instanceMatrix),u.instanceColor!==null&&e.remove(u.instanceColor)}return{update:o,dispose:a}}var aM={[Bh]:"LINEAR_TONE_MAPPING",[zh]:"REINHARD_TONE_MAPPING",[Vh]:"CINEON_TONE_MAPPING",[Gh]:"ACES_FILMIC_TONE_MAPPING",[Wh]:"AGX_TONE_MAPPING",[$h]:"NEUTRAL_TONE_MAPPING",[Hh]:"CUSTOM_TONE_MAPPING"};function lM(n,t,e,i,s,r){let o=new ci(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new _n;u.setAttribute("position",new en([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new en([0,2,0,0,2,0],2));let h=new ql({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new Nn(u,h),f=new Ma(-1,1,1,-1,0,1),p=null,x=null,m=!1,g,_=null,w=[],v=!1;this.setSize=function(E,A){o.setSize(E,A),a!==null&&a.setSize(E,A),l!==null&&l.setSize(E,A);for(let y=0;y<w.length;y++){let M=w[y];M.setSize&&M.setSize(E,A)}},this.setEffects=function(E){w=E,v=w.length>0&&w[0].isRenderPass===!0;let A=o.width,y=o.height;w.length>0&&a===null&&(a=new ci(A,y,{type:Pi,depthBuffer:!1,stencilBuffer:!1}),l=new ci(A,y,{type:Pi,depthBuffer:!1,stencilBuffer:!1}));let M=s===!0&&w.some(P=>P.needsDepthTexture===!0);M!==(o.depthTexture!==null)&&(M===!0&&c===null&&(c=new ps(A,y),r===!0&&(c.format=xs,c.type=fr)),o.dispose(),o.depthTexture=M?c:null,o.resolveDepthBuffer=M,o.storeMultisampledDepthBuffer=M);for(let P=0;P<w.length;P++){let L=w[P];L.setSize&&L.setSize(A,y),M&&L.needsDepthTexture===!0&&L.setDepthTexture&&L.setDepthTexture(c)}},this.begin=function(E,A){if(m||E.toneMapping===qi&&w.length===0)return!1;if(_=A,A!==null){let y=A.width,M=A.height;(o.width!==y||o.height!==M)&&this.setSize(y,M)}return v===!1&&E.setRenderTarget(o),g=E.toneMapping,E.toneMapping=qi,!0},this.hasRenderPass=function(){return v},this.end=function(E,A){E.toneMapping=g,m=!0;let y=o,M=a;for(let P=0;P<w.length;P++){let L=w[P];L.enabled!==!1&&(L.render(E,M,y,A),L.needsSwap!==!1&&(y=M,M=M===a?l:a))}if(p!==E.outputColorSpace||x!==E.toneMapping){p=E.outputColorSpace,x=E.toneMapping,h.defines={},xe.getTransfer(p)===Ae&&(h.defines.SRGB_TRANSFER="");let P=aM[x];P&&(h.defines[P]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=y.texture,E.setRenderTarget(_),E.render(d,f),_=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var Jm=new Kn,jm=new ps(1,1),Qm=new ma(1),tg=new la,eg=new Gl,ng=new pa,Pm=[],Im=[],Lm=new Float32Array(16),Nm=new Float32Array(9),Dm=new Float32Array(4);function go(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=Pm[s];if(r===void 0&&(r=new Float32Array(s),Pm[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function yn(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function vn(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function tu(n,t){let e=Im[t];e===void 0&&(e=new Int32Array(t),Im[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function cM(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function uM(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(yn(e,t))return;n.uniform2fv(this.addr,t),vn(e,t)}}function hM(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(yn(e,t))return;n.uniform3fv(this.addr,t),vn(e,t)}}function dM(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(yn(e,t))return;n.uniform4fv(this.addr,t),vn(e,t)}}function fM(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(yn(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),vn(e,t)}else{if(yn(e,i))return;Dm.set(i),n.uniformMatrix2fv(this.addr,!1,Dm),vn(e,i)}}function pM(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(yn(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),vn(e,t)}else{if(yn(e,i))return;Nm.set(i),n.uniformMatrix3fv(this.addr,!1,Nm),vn(e,i)}}function mM(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(yn(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),vn(e,t)}else{if(yn(e,i))return;Lm.set(i),n.uniformMatrix4fv(this.addr,!1,Lm),vn(e,i)}}function gM(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function xM(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(yn(e,t))return;n.uniform2iv(this.addr,t),vn(e,t)}}function _M(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(yn(e,t))return;n.uniform3iv(this.addr,t),vn(e,t)}}function yM(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(yn(e,t))return;n.uniform4iv(this.addr,t),vn(e,t)}}function vM(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function bM(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(yn(e,t))return;n.uniform2uiv(this.addr,t),vn(e,t)}}function SM(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(yn(e,t))return;n.uniform3uiv(this.addr,t),vn(e,t)}}function MM(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(yn(e,t))return;n.uniform4uiv(this.addr,t),vn(e,t)}}function eu(n){return n.version===0&&(n.compareFunction=id,n.needsUpdate=!0),n}function wM(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=eu(jm):r=Jm,e.setTexture2D(t||r,s)}function AM(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||eg,s)}function EM(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=eu(Qm):r=ng,e.setTextureCube(t||r,s)}function TM(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||tg,s)}function CM(n){switch(n){case 5126:return cM;case 35664:return uM;case 35665:return hM;case 35666:return dM;case 35674:return fM;case 35675:return pM;case 35676:return mM;case 5124:case 35670:return gM;case 35667:case 35671:return xM;case 35668:case 35672:return _M;case 35669:case 35673:return yM;case 5125:return vM;case 36294:return bM;case 36295:return SM;case 36296:return MM;case 35678:case 36198:case 36298:case 36306:case 35682:return wM;case 35679:case 36299:case 36307:return AM;case 35680:case 36300:case 36308:case 36293:return EM;case 36289:case 36303:case 36311:case 36292:return TM}}function RM(n,t){n.uniform1fv(this.addr,t)}function PM(n,t){let e=go(t,this.size,2);n.uniform2fv(this.addr,e)}function IM(n,t){let e=go(t,this.size,3);n.uniform3fv(this.addr,e)}function LM(n,t){let e=go(t,this.size,4);n.uniform4fv(this.addr,e)}function NM(n,t){let e=go(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function DM(n,t){let e=go(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function UM(n,t){let e=go(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function OM(n,t){n.uniform1iv(this.addr,t)}function FM(n,t){n.uniform2iv(this.addr,t)}function kM(n,t){n.uniform3iv(this.addr,t)}function BM(n,t){n.uniform4iv(this.addr,t)}function zM(n,t){n.uniform1uiv(this.addr,t)}function VM(n,t){n.uniform2uiv(this.addr,t)}function GM(n,t){n.uniform3uiv(this.addr,t)}function HM(n,t){n.uniform4uiv(this.addr,t)}function WM(n,t,e){let i=this.cache,s=t.length,r=tu(e,s);yn(i,r)||(n.uniform1iv(this.addr,r),vn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=eu(jm):o=Jm;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function $M(n,t,e){let i=this.cache,s=t.length,r=tu(e,s);yn(i,r)||(n.uniform1iv(this.addr,r),vn(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||eg,r[o])}function XM(n,t,e){let i=this.cache,s=t.length,r=tu(e,s);yn(i,r)||(n.uniform1iv(this.addr,r),vn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=eu(Qm):o=ng;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function qM(n,t,e){let i=this.cache,s=t.length,r=tu(e,s);yn(i,r)||(n.uniform1iv(this.addr,r),vn(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||tg,r[o])}function YM(n){switch(n){case 5126:return RM;case 35664:return PM;case 35665:return IM;case 35666:return LM;case 35674:return NM;case 35675:return DM;case 35676:return UM;case 5124:case 35670:return OM;case 35667:case 35671:return FM;case 35668:case 35672:return kM;case 35669:case 35673:return BM;case 5125:return zM;case 36294:return VM;case 36295:return GM;case 36296:return HM;case 35678:case 36198:case 36298:case 36306:case 35682:return WM;case 35679:case 36299:case 36307:return $M;case 35680:case 36300:case 36308:case 36293:return XM;case 36289:case 36303:case 36311:case 36292:return qM}}var gd=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=CM(e.type)}},xd=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=YM(e.type)}},_d=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},pd=/(\w+)(\])?(\[|\.)?/g;function Um(n,t){n.seq.push(t),n.map[t.id]=t}function ZM(n,t,e){let i=n.name,s=i.length;for(pd.lastIndex=0;;){let r=pd.exec(i),o=pd.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Um(e,c===void 0?new gd(a,n,t):new xd(a,n,t));break}else{let h=e.map[a];h===void 0&&(h=new _d(a),Um(e,h)),e=h}}}var mo=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);ZM(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function Om(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var KM=37297,JM=0;function jM(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var Fm=new ee;function QM(n){xe._getMatrix(Fm,xe.workingColorSpace,n);let t=`mat3( ${Fm.elements.map(e=>e.toFixed(4))} )`;switch(xe.getTransfer(n)){case oa:return[t,"LinearTransferOETF"];case Ae:return[t,"sRGBTransferOETF"];default:return Xt("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function km(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+jM(n.getShaderSource(t),a)}else return r}function tw(n,t){let e=QM(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var ew={[Bh]:"Linear",[zh]:"Reinhard",[Vh]:"Cineon",[Gh]:"ACESFilmic",[Wh]:"AgX",[$h]:"Neutral",[Hh]:"Custom"};function nw(n,t){let e=ew[t];return e===void 0?(Xt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Jc=new W;function iw(){xe.getLuminanceCoefficients(Jc);let n=Jc.x.toFixed(4),t=Jc.y.toFixed(4),e=Jc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function sw(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Fa).join(`
`)}function rw(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function ow(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function Fa(n){return n!==""}function Bm(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function zm(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var aw=/^[ \t]*#include +<([\w\d./]+)>/gm;function yd(n){return n.replace(aw,lw)}function lw(n,t){let e=ce[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return yd(e)}var cw=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Vm(n){return n.replace(cw,uw)}function uw(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Gm(n){let t=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?t+=`
#define HIGH_PRECISION`:n.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var hw={[Ta]:"SHADOWMAP_TYPE_PCF",[co]:"SHADOWMAP_TYPE_VSM"};function dw(n){return hw[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var fw={[ho]:"ENVMAP_MODE_REFRACTION"};function pw(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":fw[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var mw={[lc]:"ENVMAP_BLENDING_MULTIPLY",[sm]:"ENVMAP_BLENDING_MIX",[rm]:"ENVMAP_BLENDING_ADD"};function gw(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":mw[n.combine]||"ENVMAP_BLENDING_NONE"}function xw(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=dw(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=pw(e),h=gw(e),d=sw(e),f=rw(r),p=s.createProgram(),x,m,g=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(x=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Fa).join(`
`),x.length>0&&(x+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Fa).join(`
`),m.length>0&&(m+=`
`)):(x=[Gm(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Fa).join(`
`),m=[Gm(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+h:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==qi?"#define TONE_MAPPING":"",e.toneMapping!==qi?ce.tonemapping_pars_fragment:"",e.toneMapping!==qi?nw("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",ce.colorspace_pars_fragment,tw("linearToOutputTexel",e.outputColorSpace),iw(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Fa).join(`
`)),o=yd(o),o=Bm(o,e),o=zm(o,e),a=yd(a),a=Bm(a,e),a=zm(a,e),o=Vm(o),a=Vm(a),e.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,x=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,m=["#define varying in",e.glslVersion===sd?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===sd?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let _=g+x+o,w=g+m+a,v=Om(s,s.VERTEX_SHADER,_),E=Om(s,s.FRAGMENT_SHADER,w);s.attachShader(p,v),s.attachShader(p,E),e.index0AttributeName!==void 0?s.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function A(L){if(n.debug.checkShaderErrors){let I=s.getProgramInfoLog(p)||"",F=s.getShaderInfoLog(v)||"",k=s.getShaderInfoLog(E)||"",D=I.trim(),V=F.trim(),X=k.trim(),H=!0,lt=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(H=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,v,E);else{let Z=km(s,v,"vertex"),Q=km(s,E,"fragment");jt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+L.name+`
Material Type: `+L.type+`

Program Info Log: `+D+`
`+Z+`
`+Q)}else D!==""?Xt("WebGLProgram: Program Info Log:",D):(V===""||X==="")&&(lt=!1);lt&&(L.diagnostics={runnable:H,programLog:D,vertexShader:{log:V,prefix:x},fragmentShader:{log:X,prefix:m}})}s.deleteShader(v),s.deleteShader(E),y=new mo(s,p),M=ow(s,p)}let y;this.getUniforms=function(){return y===void 0&&A(this),y};let M;this.getAttributes=function(){return M===void 0&&A(this),M};let P=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return P===!1&&(P=s.getProgramParameter(p,KM)),P},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=JM++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=v,this.fragmentShader=E,this}var _w=0,vd=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new bd(t),e.set(t,i)),i}},bd=class{constructor(t){this.id=_w++,this.code=t,this.usedTimes=0}};function yw(n){return n===Xs||n===Na||n===Da}function vw(n,t,e,i,s,r){let o=new io,a=new vd,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(y){return l.add(y),y===0?"uv":`uv${y}`}function p(y,M,P,L,I,F){let k=L.fog,D=I.geometry,V=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?L.environment:null,X=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,H=t.get(y.envMap||V,X),lt=d[y.type],Z=i.precision;y.precision!==null&&(Z=i.getMaxPrecision(y.precision),Z!==y.precision&&Xt("WebGLProgram.getParameters:",y.precision,"not supported, using",Z,"instead."));let Q=D.morphAttributes.position||D.morphAttributes.normal||D.morphAttributes.color,it=Q!==void 0?Q.length:0,ft=0;D.morphAttributes.position!==void 0&&(ft=1),D.morphAttributes.normal!==void 0&&(ft=2),D.morphAttributes.color!==void 0&&(ft=3);let dt,tt,ht,gt;if(lt){let Ct=Zi[lt];dt=Ct.vertexShader,tt=Ct.fragmentShader}else{dt=y.vertexShader,tt=y.fragmentShader;let Ct=a.getVertexShaderStage(y),oe=a.getFragmentShaderStage(y);a.update(y,Ct,oe),ht=Ct.id,gt=oe.id}let St=n.getRenderTarget(),Mt=n.state.buffers.depth.getReversed(),Ht=I.isInstancedMesh===!0,se=I.isBatchedMesh===!0,Vt=!!y.map,ue=!!y.matcap,ae=!!H,ne=ae&&H.isPMREMTexture===!0,Xe=!!y.aoMap,Fe=!!y.lightMap,ln=!!y.bumpMap&&y.wireframe===!1,Le=!!y.normalMap,wn=!!y.displacementMap,ye=!!y.emissiveMap,gn=!!y.metalnessMap,Ke=!!y.roughnessMap,cn=y.anisotropy>0,z=y.clearcoat>0,Rt=y.diffuseRoughness>0,qt=y.dispersion>0,re=y.retroreflectivity>0,wt=y.iridescence>0,De=y.sheen>0,zt=y.transmission>0,$t=cn&&!!y.anisotropyMap,N=z&&!!y.clearcoatMap,T=z&&!!y.clearcoatNormalMap,q=z&&!!y.clearcoatRoughnessMap,ut=Rt&&!!y.diffuseRoughnessMap,ot=wt&&!!y.iridescenceMap,_t=wt&&!!y.iridescenceThicknessMap,yt=De&&!!y.sheenColorMap,et=De&&!!y.sheenRoughnessMap,st=!!y.specularMap,mt=!!y.specularColorMap,B=!!y.specularIntensityMap,rt=zt&&!!y.transmissionMap,nt=zt&&!!y.thicknessMap,At=!!y.gradientMap,xt=!!y.alphaMap,bt=y.alphaTest>0,Gt=!!y.alphaHash,Kt=!!y.extensions,ct=qi;y.toneMapped&&(St===null||St.isXRRenderTarget===!0)&&(ct=n.toneMapping);let Ft=ne?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,Jt={shaderID:lt,shaderType:y.type,shaderName:y.name,vertexShader:dt,fragmentShader:tt,defines:y.defines,customVertexShaderID:ht,customFragmentShaderID:gt,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:Z,batching:se,batchingColor:se&&I._colorsTexture!==null,instancing:Ht,instancingColor:Ht&&I.instanceColor!==null,instancingMorph:Ht&&I.morphTexture!==null,outputColorSpace:St===null?n.outputColorSpace:St.isXRRenderTarget===!0?St.texture.colorSpace:xe.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:Vt,matcap:ue,envMap:ae,envMapMode:ae&&H.mapping,envMapPMREM:ne,envMapMaxLod:ne?Ft.length-1:null,envMapSize:ne?Ft[0].width:null,aoMap:Xe,lightMap:Fe,bumpMap:ln,normalMap:Le,displacementMap:wn,emissiveMap:ye,normalMapObjectSpace:Le&&y.normalMapType===lm,normalMapTangentSpace:Le&&y.normalMapType===Zc,packedNormalMap:Le&&y.normalMapType===Zc&&yw(y.normalMap.format),metalnessMap:gn,roughnessMap:Ke,anisotropy:cn,anisotropyMap:$t,clearcoat:z,clearcoatMap:N,clearcoatNormalMap:T,clearcoatRoughnessMap:q,diffuseRoughness:Rt,diffuseRoughnessMap:ut,dispersion:qt,retroreflection:re,iridescence:wt,iridescenceMap:ot,iridescenceThicknessMap:_t,sheen:De,sheenColorMap:yt,sheenRoughnessMap:et,specularMap:st,specularColorMap:mt,specularIntensityMap:B,transmission:zt,transmissionMap:rt,thicknessMap:nt,gradientMap:At,opaque:y.transparent===!1&&y.blending===uo&&y.alphaToCoverage===!1,alphaMap:xt,alphaTest:bt,alphaHash:Gt,combine:y.combine,mapUv:Vt&&f(y.map.channel),aoMapUv:Xe&&f(y.aoMap.channel),lightMapUv:Fe&&f(y.lightMap.channel),bumpMapUv:ln&&f(y.bumpMap.channel),normalMapUv:Le&&f(y.normalMap.channel),displacementMapUv:wn&&f(y.displacementMap.channel),emissiveMapUv:ye&&f(y.emissiveMap.channel),metalnessMapUv:gn&&f(y.metalnessMap.channel),roughnessMapUv:Ke&&f(y.roughnessMap.channel),anisotropyMapUv:$t&&f(y.anisotropyMap.channel),clearcoatMapUv:N&&f(y.clearcoatMap.channel),clearcoatNormalMapUv:T&&f(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&f(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ut&&f(y.diffuseRoughnessMap.channel),iridescenceMapUv:ot&&f(y.iridescenceMap.channel),iridescenceThicknessMapUv:_t&&f(y.iridescenceThicknessMap.channel),sheenColorMapUv:yt&&f(y.sheenColorMap.channel),sheenRoughnessMapUv:et&&f(y.sheenRoughnessMap.channel),specularMapUv:st&&f(y.specularMap.channel),specularColorMapUv:mt&&f(y.specularColorMap.channel),specularIntensityMapUv:B&&f(y.specularIntensityMap.channel),transmissionMapUv:rt&&f(y.transmissionMap.channel),thicknessMapUv:nt&&f(y.thicknessMap.channel),alphaMapUv:xt&&f(y.alphaMap.channel),vertexTangents:!!D.attributes.tangent&&(Le||cn),vertexNormals:!!D.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!D.attributes.color&&D.attributes.color.itemSize===4,pointsUvs:I.isPoints===!0&&!!D.attributes.uv&&(Vt||xt),fog:!!k,useFog:y.fog===!0,fogExp2:!!k&&k.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||D.attributes.normal===void 0&&Le===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:Mt,skinning:I.isSkinnedMesh===!0,hasPositionAttribute:D.attributes.position!==void 0,morphTargets:D.morphAttributes.position!==void 0,morphNormals:D.morphAttributes.normal!==void 0,morphColors:D.morphAttributes.color!==void 0,morphTargetsCount:it,morphTextureStride:ft,numSunLights:M.sun.length,numDirLights:M.directional.length,numPointLights:M.point.length,numSpotLights:M.spot.length,numSpotLightMaps:M.spotLightMap.length,numRectAreaLights:M.rectArea.length,numHemiLights:M.hemi.length,numSunLightShadows:M.sunShadowMap.length,numDirLightShadows:M.directionalShadowMap.length,numPointLightShadows:M.pointShadowMap.length,numSpotLightShadows:M.spotShadowMap.length,numSpotLightShadowsWithMaps:M.numSpotLightShadowsWithMaps,numLightProbes:M.numLightProbes,numLightProbeGrids:F.filter(Ct=>Ct.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:n.shadowMap.enabled&&P.length>0,shadowMapType:n.shadowMap.type,toneMapping:ct,decodeVideoTexture:Vt&&y.map.isVideoTexture===!0&&xe.getTransfer(y.map.colorSpace)===Ae,decodeVideoTextureEmissive:ye&&y.emissiveMap.isVideoTexture===!0&&xe.getTransfer(y.emissiveMap.colorSpace)===Ae,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===kn,flipSided:y.side===Yn,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:Kt&&y.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Kt&&y.extensions.multiDraw===!0||se)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return Jt.vertexUv1s=l.has(1),Jt.vertexUv2s=l.has(2),Jt.vertexUv3s=l.has(3),l.clear(),Jt}function x(y){let M=[];if(y.shaderID?M.push(y.shaderID):(M.push(y.customVertexShaderID),M.push(y.customFragmentShaderID)),y.defines!==void 0)for(let P in y.defines)M.push(P),M.push(y.defines[P]);return y.isRawShaderMaterial===!1&&(m(M,y),g(M,y),M.push(n.outputColorSpace)),M.push(y.customProgramCacheKey),M.join()}function m(y,M){y.push(M.precision),y.push(M.outputColorSpace),y.push(M.envMapMode),y.push(M.envMapPMREM),y.push(M.envMapMaxLod),y.push(M.envMapSize),y.push(M.mapUv),y.push(M.alphaMapUv),y.push(M.lightMapUv),y.push(M.aoMapUv),y.push(M.bumpMapUv),y.push(M.normalMapUv),y.push(M.displacementMapUv),y.push(M.emissiveMapUv),y.push(M.metalnessMapUv),y.push(M.roughnessMapUv),y.push(M.anisotropyMapUv),y.push(M.clearcoatMapUv),y.push(M.clearcoatNormalMapUv),y.push(M.clearcoatRoughnessMapUv),y.push(M.diffuseRoughnessMapUv),y.push(M.iridescenceMapUv),y.push(M.iridescenceThicknessMapUv),y.push(M.sheenColorMapUv),y.push(M.sheenRoughnessMapUv),y.push(M.specularMapUv),y.push(M.specularColorMapUv),y.push(M.specularIntensityMapUv),y.push(M.transmissionMapUv),y.push(M.thicknessMapUv),y.push(M.combine),y.push(M.fogExp2),y.push(M.sizeAttenuation),y.push(M.morphTargetsCount),y.push(M.numSunLights),y.push(M.numDirLights),y.push(M.numPointLights),y.push(M.numSpotLights),y.push(M.numSpotLightMaps),y.push(M.numHemiLights),y.push(M.numRectAreaLights),y.push(M.numSunLightShadows),y.push(M.numDirLightShadows),y.push(M.numPointLightShadows),y.push(M.numSpotLightShadows),y.push(M.numSpotLightShadowsWithMaps),y.push(M.numLightProbes),y.push(M.numLightProbeGrids),y.push(M.shadowMapType),y.push(M.toneMapping),y.push(M.numClippingPlanes),y.push(M.numClipIntersection),y.push(M.depthPacking)}function g(y,M){o.disableAll(),M.instancing&&o.enable(0),M.instancingColor&&o.enable(1),M.instancingMorph&&o.enable(2),M.matcap&&o.enable(3),M.envMap&&o.enable(4),M.normalMapObjectSpace&&o.enable(5),M.normalMapTangentSpace&&o.enable(6),M.clearcoat&&o.enable(7),M.iridescence&&o.enable(8),M.alphaTest&&o.enable(9),M.vertexColors&&o.enable(10),M.vertexAlphas&&o.enable(11),M.vertexUv1s&&o.enable(12),M.vertexUv2s&&o.enable(13),M.vertexUv3s&&o.enable(14),M.vertexTangents&&o.enable(15),M.anisotropy&&o.enable(16),M.alphaHash&&o.enable(17),M.batching&&o.enable(18),M.dispersion&&o.enable(19),M.retroreflection&&o.enable(24),M.diffuseRoughness&&o.enable(25),M.batchingColor&&o.enable(20),M.gradientMap&&o.enable(21),M.packedNormalMap&&o.enable(22),M.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),M.fog&&o.enable(0),M.useFog&&o.enable(1),M.flatShading&&o.enable(2),M.logarithmicDepthBuffer&&o.enable(3),M.reversedDepthBuffer&&o.enable(4),M.skinning&&o.enable(5),M.morphTargets&&o.enable(6),M.morphNormals&&o.enable(7),M.morphColors&&o.enable(8),M.premultipliedAlpha&&o.enable(9),M.shadowMapEnabled&&o.enable(10),M.doubleSided&&o.enable(11),M.flipSided&&o.enable(12),M.useDepthPacking&&o.enable(13),M.dithering&&o.enable(14),M.transmission&&o.enable(15),M.sheen&&o.enable(16),M.opaque&&o.enable(17),M.pointsUvs&&o.enable(18),M.decodeVideoTexture&&o.enable(19),M.decodeVideoTextureEmissive&&o.enable(20),M.alphaToCoverage&&o.enable(21),M.numLightProbeGrids>0&&o.enable(22),M.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function _(y){let M=d[y.type],P;if(M){let L=Zi[M];P=Mm.clone(L.uniforms)}else P=y.uniforms;return P}function w(y,M){let P=u.get(M);return P!==void 0?++P.usedTimes:(P=new xw(n,M,y,s),c.push(P),u.set(M,P)),P}function v(y){if(--y.usedTimes===0){let M=c.indexOf(y);c[M]=c[c.length-1],c.pop(),u.delete(y.cacheKey),y.destroy()}}function E(y){a.remove(y)}function A(){a.dispose()}return{getParameters:p,getProgramCacheKey:x,getUniforms:_,acquireProgram:w,releaseProgram:v,releaseShaderCache:E,programs:c,dispose:A}}function bw(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function Sw(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function Hm(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function Wm(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,x,m,g){let _=n[t];return _===void 0?(_={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:x,renderOrder:d.renderOrder,z:m,group:g},n[t]=_):(_.id=d.id,_.object=d,_.geometry=f,_.material=p,_.materialVariant=o(d),_.groupOrder=x,_.renderOrder=d.renderOrder,_.z=m,_.group=g),t++,_}function l(d,f,p,x,m,g,_){_.reversedDepth===!0&&(m=-m);let w=a(d,f,p,x,m,g);p.transmission>0?i.push(w):p.transparent===!0?s.push(w):e.push(w)}function c(d,f,p,x,m,g){let _=a(d,f,p,x,m,g);p.transmission>0?i.unshift(_):p.transparent===!0?s.unshift(_):e.unshift(_)}function u(d,f){e.length>1&&e.sort(d||Sw),i.length>1&&i.sort(f||Hm),s.length>1&&s.sort(f||Hm)}function h(){for(let d=t,f=n.length;d<f;d++){let p=n[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function Mw(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new Wm,n.set(i,[o])):s>=r.length?(o=new Wm,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function ww(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new W,color:new Qt};break;case"SpotLight":e={position:new W,direction:new W,color:new Qt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new W,color:new Qt,distance:0,decay:0};break;case"HemisphereLight":e={direction:new W,skyColor:new Qt,groundColor:new Qt};break;case"RectAreaLight":e={color:new Qt,position:new W,halfWidth:new W,halfHeight:new W};break}return n[t.id]=e,e}}}function Aw(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Yt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Yt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Yt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var Ew=0;function Tw(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function Cw(n){let t=new ww,e=Aw(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new W);let s=new W,r=new pe,o=new pe;function a(c){let u=0,h=0,d=0;for(let F=0;F<9;F++)i.probe[F].set(0,0,0);let f=0,p=0,x=0,m=0,g=0,_=0,w=0,v=0,E=0,A=0,y=0,M=0,P=0,L=0;c.sort(Tw);for(let F=0,k=c.length;F<k;F++){let D=c[F],V=D.color,X=D.intensity,H=D.distance,lt=null;if(D.shadow&&D.shadow.map&&(D.shadow.map.texture.format===Xs?lt=D.shadow.map.texture:lt=D.shadow.map.depthTexture||D.shadow.map.texture),D.isAmbientLight)u+=V.r*X,h+=V.g*X,d+=V.b*X;else if(D.isLightProbe){for(let Z=0;Z<9;Z++)i.probe[Z].addScaledVector(D.sh.coefficients[Z],X);L++}else if(D.isSunLight){let Z=t.get(D);if(Z.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let Q=D.shadow,it=e.get(D);it.shadowIntensity=Q.intensity,it.shadowBias=Q.bias,it.shadowNormalBias=Q.normalBias,it.shadowRadius=Q.radius,it.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[p]=it,i.sunShadowMap[p]=lt;let ft=Q.getViewportCount();for(let dt=0;dt<ft;dt++)i.sunShadowMatrix[x+dt]=Q.getMatrix(dt),i.sunShadowCascade[x+dt]=Q._cascadeData[dt];x+=ft,p++}i.sun[f]=Z,f++}else if(D.isDirectionalLight){let Z=t.get(D);if(Z.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let Q=D.shadow,it=e.get(D);it.shadowIntensity=Q.intensity,it.shadowBias=Q.bias,it.shadowNormalBias=Q.normalBias,it.shadowRadius=Q.radius,it.shadowMapSize=Q.mapSize,i.directionalShadow[m]=it,i.directionalShadowMap[m]=lt,i.directionalShadowMatrix[m]=D.shadow.matrix,E++}i.directional[m]=Z,m++}else if(D.isSpotLight){let Z=t.get(D);Z.position.setFromMatrixPosition(D.matrixWorld),Z.color.copy(V).multiplyScalar(X),Z.distance=H,Z.coneCos=Math.cos(D.angle),Z.penumbraCos=Math.cos(D.angle*(1-D.penumbra)),Z.decay=D.decay,i.spot[_]=Z;let Q=D.shadow;if(D.map&&(i.spotLightMap[M]=D.map,M++,Q.updateMatrices(D),D.castShadow&&P++),i.spotLightMatrix[_]=Q.matrix,D.castShadow){let it=e.get(D);it.shadowIntensity=Q.intensity,it.shadowBias=Q.bias,it.shadowNormalBias=Q.normalBias,it.shadowRadius=Q.radius,it.shadowMapSize=Q.mapSize,i.spotShadow[_]=it,i.spotShadowMap[_]=lt,y++}_++}else if(D.isRectAreaLight){let Z=t.get(D);Z.color.copy(V).multiplyScalar(X),Z.halfWidth.set(D.width*.5,0,0),Z.halfHeight.set(0,D.height*.5,0),i.rectArea[w]=Z,w++}else if(D.isPointLight){let Z=t.get(D);if(Z.color.copy(D.color).multiplyScalar(D.intensity),Z.distance=D.distance,Z.decay=D.decay,D.castShadow){let Q=D.shadow,it=e.get(D);it.shadowIntensity=Q.intensity,it.shadowBias=Q.bias,it.shadowNormalBias=Q.normalBias,it.shadowRadius=Q.radius,it.shadowMapSize=Q.mapSize,it.shadowCameraNear=Q.camera.near,it.shadowCameraFar=Q.camera.far,i.pointShadow[g]=it,i.pointShadowMap[g]=lt,i.pointShadowMatrix[g]=D.shadow.matrix,A++}i.point[g]=Z,g++}else if(D.isHemisphereLight){let Z=t.get(D);Z.skyColor.copy(D.color).multiplyScalar(X),Z.groundColor.copy(D.groundColor).multiplyScalar(X),i.hemi[v]=Z,v++}}w>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Lt.LTC_FLOAT_1,i.rectAreaLTC2=Lt.LTC_FLOAT_2):(i.rectAreaLTC1=Lt.LTC_HALF_1,i.rectAreaLTC2=Lt.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=d;let I=i.hash;(I.sunLength!==f||I.directionalLength!==m||I.pointLength!==g||I.spotLength!==_||I.rectAreaLength!==w||I.hemiLength!==v||I.numSunShadows!==p||I.numDirectionalShadows!==E||I.numPointShadows!==A||I.numSpotShadows!==y||I.numSpotMaps!==M||I.numLightProbes!==L)&&(i.sun.length=f,i.directional.length=m,i.spot.length=_,i.rectArea.length=w,i.point.length=g,i.hemi.length=v,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=x,i.sunShadowCascade.length=x,i.directionalShadow.length=E,i.directionalShadowMap.length=E,i.directionalShadowMatrix.length=E,i.pointShadow.length=A,i.pointShadowMap.length=A,i.pointShadowMatrix.length=A,i.spotShadow.length=y,i.spotShadowMap.length=y,i.spotLightMatrix.length=y+M-P,i.spotLightMap.length=M,i.numSpotLightShadowsWithMaps=P,i.numLightProbes=L,I.sunLength=f,I.directionalLength=m,I.pointLength=g,I.spotLength=_,I.rectAreaLength=w,I.hemiLength=v,I.numSunShadows=p,I.numDirectionalShadows=E,I.numPointShadows=A,I.numSpotShadows=y,I.numSpotMaps=M,I.numLightProbes=L,i.version=Ew++)}function l(c,u){let h=0,d=0,f=0,p=0,x=0,m=0,g=u.matrixWorldInverse;for(let _=0,w=c.length;_<w;_++){let v=c[_];if(v.isSunLight){let E=i.sun[h];E.direction.setFromMatrixPosition(v.matrixWorld),E.direction.transformDirection(g),h++}else if(v.isDirectionalLight){let E=i.directional[d];E.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),E.direction.sub(s),E.direction.transformDirection(g),d++}else if(v.isSpotLight){let E=i.spot[p];E.position.setFromMatrixPosition(v.matrixWorld),E.position.applyMatrix4(g),E.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),E.direction.sub(s),E.direction.transformDirection(g),p++}else if(v.isRectAreaLight){let E=i.rectArea[x];E.position.setFromMatrixPosition(v.matrixWorld),E.position.applyMatrix4(g),o.identity(),r.copy(v.matrixWorld),r.premultiply(g),o.extractRotation(r),E.halfWidth.set(v.width*.5,0,0),E.halfHeight.set(0,v.height*.5,0),E.halfWidth.applyMatrix4(o),E.halfHeight.applyMatrix4(o),x++}else if(v.isPointLight){let E=i.point[f];E.position.setFromMatrixPosition(v.matrixWorld),E.position.applyMatrix4(g),f++}else if(v.isHemisphereLight){let E=i.hemi[m];E.direction.setFromMatrixPosition(v.matrixWorld),E.direction.transformDirection(g),m++}}}return{setup:a,setupView:l,state:i}}function $m(n){let t=new Cw(n),e=[],i=[],s=[];function r(h){u.camera=h,e.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):e.push(h)}function a(h){i.push(h)}function l(){t.setup(e),s.sort((h,d)=>h.priority-d.priority||h.id-d.id)}function c(h){t.setupView(e,h)}let u={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function Rw(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new $m(n),t.set(s,[a])):r>=o.length?(a=new $m(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var Pw=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,Iw=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,Lw=[new W(1,0,0),new W(-1,0,0),new W(0,1,0),new W(0,-1,0),new W(0,0,1),new W(0,0,-1)],Nw=[new W(0,-1,0),new W(0,-1,0),new W(0,0,1),new W(0,0,-1),new W(0,-1,0),new W(0,-1,0)],Xm=new pe,Oa=new W,md=new W;function Dw(n,t,e){let i=new ks,s=new Yt,r=new Yt,o=new Ye,a=new Yl,l=new Zl,c={},u=e.maxTextureSize,h={[$s]:Yn,[Yn]:$s,[kn]:kn},d=new Xi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Yt},radius:{value:4}},vertexShader:Pw,fragmentShader:Iw}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new _n;p.setAttribute("position",new on(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new Nn(p,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Ta;let g=this.type;this.render=function(A,y,M){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||A.length===0)return;this.type===Bp&&(Xt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Ta);let P=n.getRenderTarget(),L=n.getActiveCubeFace(),I=n.getActiveMipmapLevel(),F=n.state;F.setBlending(ur),F.buffers.depth.getReversed()===!0?F.buffers.color.setClear(0,0,0,0):F.buffers.color.setClear(1,1,1,1),F.buffers.depth.setTest(!0),F.setScissorTest(!1);let k=g!==this.type;k&&y.traverse(function(D){D.material&&(Array.isArray(D.material)?D.material.forEach(V=>V.needsUpdate=!0):D.material.needsUpdate=!0)});for(let D=0,V=A.length;D<V;D++){let X=A[D],H=X.shadow;if(H===void 0){Xt("WebGLShadowMap:",X,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let lt=H.getFrameExtents();s.multiply(lt),r.copy(H.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/lt.x),s.x=r.x*lt.x,H.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/lt.y),s.y=r.y*lt.y,H.mapSize.y=r.y));let Z=n.state.buffers.depth.getReversed();if(H.camera._reversedDepth=Z,H.map===null||k===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===co){if(X.isPointLight){Xt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new ci(s.x,s.y,{format:Xs,type:Pi,minFilter:qn,magFilter:qn,generateMipmaps:!1}),H.map.texture.name=X.name+".shadowMap",H.map.depthTexture=new ps(s.x,s.y,yi),H.map.depthTexture.name=X.name+".shadowMapDepth",H.map.depthTexture.format=us,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Pn,H.map.depthTexture.magFilter=Pn}else X.isPointLight?(H.map=new ka(s.x),H.map.depthTexture=new ma(s.x,Ri)):(H.map=new ci(s.x,s.y),H.map.depthTexture=new ps(s.x,s.y,Ri)),H.map.depthTexture.name=X.name+".shadowMap",H.map.depthTexture.format=us,this.type===Ta?(H.map.depthTexture.compareFunction=Z?nd:ed,H.map.depthTexture.minFilter=qn,H.map.depthTexture.magFilter=qn):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Pn,H.map.depthTexture.magFilter=Pn);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==s.x||H.map.height!==s.y)&&H.map.setSize(s.x,s.y);let Q=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();X.isPointLight!==!0&&H.updateMatrices(X,M);let it=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:M.layers;for(let ft=0;ft<Q;ft++){let dt=H.getCamera(ft);if(X.isPointLight){let tt=H.camera,ht=H.matrix,gt=X.distance||tt.far;gt!==tt.far&&(tt.far=gt,tt.updateProjectionMatrix()),Oa.setFromMatrixPosition(X.matrixWorld),tt.position.copy(Oa),md.copy(tt.position),md.add(Lw[ft]),tt.up.copy(Nw[ft]),tt.lookAt(md),tt.updateMatrixWorld(),ht.makeTranslation(-Oa.x,-Oa.y,-Oa.z),Xm.multiplyMatrices(tt.projectionMatrix,tt.matrixWorldInverse),H._frustum.setFromProjectionMatrix(Xm,tt.coordinateSystem,tt.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)n.setRenderTarget(H.map,ft),n.clear();else{ft===0&&(n.setRenderTarget(H.map),n.clear());let tt=H.getViewport(ft);o.set(r.x*tt.x,r.y*tt.y,r.x*tt.z,r.y*tt.w),F.viewport(o)}i=H.getFrustum(ft),v(y,M,dt,X,it,this.type)}H.isPointLightShadow!==!0&&this.type===co&&_(H,M),H.needsUpdate=!1}g=this.type,m.needsUpdate=!1,n.setRenderTarget(P,L,I)};function _(A,y){let M=t.update(x);d.defines.VSM_SAMPLES!==A.blurSamples&&(d.defines.VSM_SAMPLES=A.blurSamples,f.defines.VSM_SAMPLES=A.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),A.mapPass===null?A.mapPass=new ci(s.x,s.y,{format:Xs,type:Pi}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),d.uniforms.shadow_pass.value=A.map.depthTexture,d.uniforms.resolution.value.set(A.map.width,A.map.height),d.uniforms.radius.value=A.radius,n.setRenderTarget(A.mapPass),n.clear(),n.renderBufferDirect(y,null,M,d,x,null),f.uniforms.shadow_pass.value=A.mapPass.texture,f.uniforms.resolution.value.set(A.map.width,A.map.height),f.uniforms.radius.value=A.radius,n.setRenderTarget(A.map),n.clear(),n.renderBufferDirect(y,null,M,f,x,null)}function w(A,y,M,P){let L=null,I=M.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(I!==void 0)L=I;else if(L=M.isPointLight===!0?l:a,n.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let F=L.uuid,k=y.uuid,D=c[F];D===void 0&&(D={},c[F]=D);let V=D[k];V===void 0&&(V=L.clone(),D[k]=V,y.addEventListener("dispose",E)),L=V}if(L.visible=y.visible,L.wireframe=y.wireframe,P===co?L.side=y.shadowSide!==null?y.shadowSide:y.side:L.side=y.shadowSide!==null?y.shadowSide:h[y.side],L.alphaMap=y.alphaMap,L.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,L.map=y.map,L.clipShadows=y.clipShadows,L.clippingPlanes=y.clippingPlanes,L.clipIntersection=y.clipIntersection,L.displacementMap=y.displacementMap,L.displacementScale=y.displacementScale,L.displacementBias=y.displacementBias,L.wireframeLinewidth=y.wireframeLinewidth,L.linewidth=y.linewidth,M.isPointLight===!0&&L.isMeshDistanceMaterial===!0){let F=n.properties.get(L);F.light=M}return L}function v(A,y,M,P,L,I){if(A.visible===!1)return;if(A.layers.test(L)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&I===co)&&(!A.frustumCulled||A.intersectsFrustum(i))){A.modelViewMatrix.multiplyMatrices(M.matrixWorldInverse,A.matrixWorld);let D=t.update(A),V=A.material;if(Array.isArray(V)){let X=D.groups;for(let H=0,lt=X.length;H<lt;H++){let Z=X[H],Q=V[Z.materialIndex];if(Q&&Q.visible){let it=w(A,Q,P,I);A.onBeforeShadow(n,A,y,M,D,it,Z),n.renderBufferDirect(M,null,D,it,A,Z),A.onAfterShadow(n,A,y,M,D,it,Z)}}}else if(V.visible){let X=w(A,V,P,I);A.onBeforeShadow(n,A,y,M,D,X,null),n.renderBufferDirect(M,null,D,X,A,null),A.onAfterShadow(n,A,y,M,D,X,null)}}let k=A.children;for(let D=0,V=k.length;D<V;D++)v(k[D],y,M,P,L,I)}function E(A){A.target.removeEventListener("dispose",E);for(let M in c){let P=c[M],L=A.target.uuid;L in P&&(P[L].dispose(),delete P[L])}}}function Uw(n,t){function e(){let B=!1,rt=new Ye,nt=null,At=new Ye(0,0,0,0);return{setMask:function(xt){nt!==xt&&!B&&(n.colorMask(xt,xt,xt,xt),nt=xt)},setLocked:function(xt){B=xt},setClear:function(xt,bt,Gt,Kt,ct){ct===!0&&(xt*=Kt,bt*=Kt,Gt*=Kt),rt.set(xt,bt,Gt,Kt),At.equals(rt)===!1&&(n.clearColor(xt,bt,Gt,Kt),At.copy(rt))},reset:function(){B=!1,nt=null,At.set(-1,0,0,0)}}}function i(){let B=!1,rt=!1,nt=null,At=null,xt=null;return{setReversed:function(bt){if(rt!==bt){let Gt=t.get("EXT_clip_control");bt?Gt.clipControlEXT(Gt.LOWER_LEFT_EXT,Gt.ZERO_TO_ONE_EXT):Gt.clipControlEXT(Gt.LOWER_LEFT_EXT,Gt.NEGATIVE_ONE_TO_ONE_EXT),rt=bt;let Kt=xt;xt=null,this.setClear(Kt)}},getReversed:function(){return rt},setTest:function(bt){bt?Mt(n.DEPTH_TEST):Ht(n.DEPTH_TEST)},setMask:function(bt){nt!==bt&&!B&&(n.depthMask(bt),nt=bt)},setFunc:function(bt){if(rt&&(bt=ym[bt]),At!==bt){switch(bt){case Pl:n.depthFunc(n.NEVER);break;case Il:n.depthFunc(n.ALWAYS);break;case Ll:n.depthFunc(n.LESS);break;case jr:n.depthFunc(n.LEQUAL);break;case Nl:n.depthFunc(n.EQUAL);break;case Dl:n.depthFunc(n.GEQUAL);break;case Ul:n.depthFunc(n.GREATER);break;case Ol:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}At=bt}},setLocked:function(bt){B=bt},setClear:function(bt){xt!==bt&&(xt=bt,rt&&(bt=1-bt),n.clearDepth(bt))},reset:function(){B=!1,nt=null,At=null,xt=null,rt=!1}}}function s(){let B=!1,rt=null,nt=null,At=null,xt=null,bt=null,Gt=null,Kt=null,ct=null;return{setTest:function(Ft){B||(Ft?Mt(n.STENCIL_TEST):Ht(n.STENCIL_TEST))},setMask:function(Ft){rt!==Ft&&!B&&(n.stencilMask(Ft),rt=Ft)},setFunc:function(Ft,Jt,Ct){(nt!==Ft||At!==Jt||xt!==Ct)&&(n.stencilFunc(Ft,Jt,Ct),nt=Ft,At=Jt,xt=Ct)},setOp:function(Ft,Jt,Ct){(bt!==Ft||Gt!==Jt||Kt!==Ct)&&(n.stencilOp(Ft,Jt,Ct),bt=Ft,Gt=Jt,Kt=Ct)},setLocked:function(Ft){B=Ft},setClear:function(Ft){ct!==Ft&&(n.clearStencil(Ft),ct=Ft)},reset:function(){B=!1,rt=null,nt=null,At=null,xt=null,bt=null,Gt=null,Kt=null,ct=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,u={},h={},d={},f=new WeakMap,p=[],x=null,m=!1,g=null,_=null,w=null,v=null,E=null,A=null,y=null,M=new Qt(0,0,0),P=0,L=!1,I=null,F=null,k=null,D=null,V=null,X=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,lt=0,Z=n.getParameter(n.VERSION);Z.indexOf("WebGL")!==-1?(lt=parseFloat(/^WebGL (\d)/.exec(Z)[1]),H=lt>=1):Z.indexOf("OpenGL ES")!==-1&&(lt=parseFloat(/^OpenGL ES (\d)/.exec(Z)[1]),H=lt>=2);let Q=null,it={},ft=n.getParameter(n.SCISSOR_BOX),dt=n.getParameter(n.VIEWPORT),tt=new Ye().fromArray(ft),ht=new Ye().fromArray(dt);function gt(B,rt,nt,At){let xt=new Uint8Array(4),bt=n.createTexture();n.bindTexture(B,bt),n.texParameteri(B,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(B,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Gt=0;Gt<nt;Gt++)B===n.TEXTURE_3D||B===n.TEXTURE_2D_ARRAY?n.texImage3D(rt,0,n.RGBA,1,1,At,0,n.RGBA,n.UNSIGNED_BYTE,xt):n.texImage2D(rt+Gt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,xt);return bt}let St={};St[n.TEXTURE_2D]=gt(n.TEXTURE_2D,n.TEXTURE_2D,1),St[n.TEXTURE_CUBE_MAP]=gt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),St[n.TEXTURE_2D_ARRAY]=gt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),St[n.TEXTURE_3D]=gt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Mt(n.DEPTH_TEST),o.setFunc(jr),ln(!1),Le(Nh),Mt(n.CULL_FACE),Xe(ur);function Mt(B){u[B]!==!0&&(n.enable(B),u[B]=!0)}function Ht(B){u[B]!==!1&&(n.disable(B),u[B]=!1)}function se(B,rt){return d[B]!==rt?(n.bindFramebuffer(B,rt),d[B]=rt,B===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=rt),B===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=rt),!0):!1}function Vt(B,rt){let nt=p,At=!1;if(B){nt=f.get(rt),nt===void 0&&(nt=[],f.set(rt,nt));let xt=B.textures;if(nt.length!==xt.length||nt[0]!==n.COLOR_ATTACHMENT0){for(let bt=0,Gt=xt.length;bt<Gt;bt++)nt[bt]=n.COLOR_ATTACHMENT0+bt;nt.length=xt.length,At=!0}}else nt[0]!==n.BACK&&(nt[0]=n.BACK,At=!0);At&&n.drawBuffers(nt)}function ue(B){return x!==B?(n.useProgram(B),x=B,!0):!1}let ae={[hr]:n.FUNC_ADD,[Vp]:n.FUNC_SUBTRACT,[Gp]:n.FUNC_REVERSE_SUBTRACT};ae[Hp]=n.MIN,ae[Wp]=n.MAX;let ne={[$p]:n.ZERO,[Xp]:n.ONE,[qp]:n.SRC_COLOR,[Fh]:n.SRC_ALPHA,[Qp]:n.SRC_ALPHA_SATURATE,[Jp]:n.DST_COLOR,[Zp]:n.DST_ALPHA,[Yp]:n.ONE_MINUS_SRC_COLOR,[kh]:n.ONE_MINUS_SRC_ALPHA,[jp]:n.ONE_MINUS_DST_COLOR,[Kp]:n.ONE_MINUS_DST_ALPHA,[tm]:n.CONSTANT_COLOR,[em]:n.ONE_MINUS_CONSTANT_COLOR,[nm]:n.CONSTANT_ALPHA,[im]:n.ONE_MINUS_CONSTANT_ALPHA};function Xe(B,rt,nt,At,xt,bt,Gt,Kt,ct,Ft){if(B===ur){m===!0&&(Ht(n.BLEND),m=!1);return}if(m===!1&&(Mt(n.BLEND),m=!0),B!==zp){if(B!==g||Ft!==L){if((_!==hr||E!==hr)&&(n.blendEquation(n.FUNC_ADD),_=hr,E=hr),Ft)switch(B){case uo:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Dh:n.blendFunc(n.ONE,n.ONE);break;case Uh:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Oh:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:jt("WebGLState: Invalid blending: ",B);break}else switch(B){case uo:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Dh:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Uh:jt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Oh:jt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:jt("WebGLState: Invalid blending: ",B);break}w=null,v=null,A=null,y=null,M.set(0,0,0),P=0,g=B,L=Ft}return}xt=xt||rt,bt=bt||nt,Gt=Gt||At,(rt!==_||xt!==E)&&(n.blendEquationSeparate(ae[rt],ae[xt]),_=rt,E=xt),(nt!==w||At!==v||bt!==A||Gt!==y)&&(n.blendFuncSeparate(ne[nt],ne[At],ne[bt],ne[Gt]),w=nt,v=At,A=bt,y=Gt),(Kt.equals(M)===!1||ct!==P)&&(n.blendColor(Kt.r,Kt.g,Kt.b,ct),M.copy(Kt),P=ct),g=B,L=!1}function Fe(B,rt){B.side===kn?Ht(n.CULL_FACE):Mt(n.CULL_FACE);let nt=B.side===Yn;rt&&(nt=!nt),ln(nt),B.blending===uo&&B.transparent===!1?Xe(ur):Xe(B.blending,B.blendEquation,B.blendSrc,B.blendDst,B.blendEquationAlpha,B.blendSrcAlpha,B.blendDstAlpha,B.blendColor,B.blendAlpha,B.premultipliedAlpha),o.setFunc(B.depthFunc),o.setTest(B.depthTest),o.setMask(B.depthWrite),r.setMask(B.colorWrite);let At=B.stencilWrite;a.setTest(At),At&&(a.setMask(B.stencilWriteMask),a.setFunc(B.stencilFunc,B.stencilRef,B.stencilFuncMask),a.setOp(B.stencilFail,B.stencilZFail,B.stencilZPass)),ye(B.polygonOffset,B.polygonOffsetFactor,B.polygonOffsetUnits),B.alphaToCoverage===!0?Mt(n.SAMPLE_ALPHA_TO_COVERAGE):Ht(n.SAMPLE_ALPHA_TO_COVERAGE)}function ln(B){I!==B&&(B?n.frontFace(n.CW):n.frontFace(n.CCW),I=B)}function Le(B){B!==Fp?(Mt(n.CULL_FACE),B!==F&&(B===Nh?n.cullFace(n.BACK):B===kp?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Ht(n.CULL_FACE),F=B}function wn(B){B!==k&&(H&&n.lineWidth(B),k=B)}function ye(B,rt,nt){B?(Mt(n.POLYGON_OFFSET_FILL),(D!==rt||V!==nt)&&(D=rt,V=nt,o.getReversed()&&(rt=-rt,nt=-nt),n.polygonOffset(rt,nt))):Ht(n.POLYGON_OFFSET_FILL)}function gn(B){B?Mt(n.SCISSOR_TEST):Ht(n.SCISSOR_TEST)}function Ke(B){B===void 0&&(B=n.TEXTURE0+X-1),Q!==B&&(n.activeTexture(B),Q=B)}function cn(B,rt,nt){nt===void 0&&(Q===null?nt=n.TEXTURE0+X-1:nt=Q);let At=it[nt];At===void 0&&(At={type:void 0,texture:void 0},it[nt]=At),(At.type!==B||At.texture!==rt)&&(Q!==nt&&(n.activeTexture(nt),Q=nt),n.bindTexture(B,rt||St[B]),At.type=B,At.texture=rt)}function z(){let B=it[Q];B!==void 0&&B.type!==void 0&&(n.bindTexture(B.type,null),B.type=void 0,B.texture=void 0)}function Rt(){try{n.compressedTexImage2D(...arguments)}catch(B){jt("WebGLState:",B)}}function qt(){try{n.compressedTexImage3D(...arguments)}catch(B){jt("WebGLState:",B)}}function re(){try{n.texSubImage2D(...arguments)}catch(B){jt("WebGLState:",B)}}function wt(){try{n.texSubImage3D(...arguments)}catch(B){jt("WebGLState:",B)}}function De(){try{n.compressedTexSubImage2D(...arguments)}catch(B){jt("WebGLState:",B)}}function zt(){try{n.compressedTexSubImage3D(...arguments)}catch(B){jt("WebGLState:",B)}}function $t(){try{n.texStorage2D(...arguments)}catch(B){jt("WebGLState:",B)}}function N(){try{n.texStorage3D(...arguments)}catch(B){jt("WebGLState:",B)}}function T(){try{n.texImage2D(...arguments)}catch(B){jt("WebGLState:",B)}}function q(){try{n.texImage3D(...arguments)}catch(B){jt("WebGLState:",B)}}function ut(B){return h[B]!==void 0?h[B]:n.getParameter(B)}function ot(B,rt){h[B]!==rt&&(n.pixelStorei(B,rt),h[B]=rt)}function _t(B){tt.equals(B)===!1&&(n.scissor(B.x,B.y,B.z,B.w),tt.copy(B))}function yt(B){ht.equals(B)===!1&&(n.viewport(B.x,B.y,B.z,B.w),ht.copy(B))}function et(B,rt){let nt=c.get(rt);nt===void 0&&(nt=new WeakMap,c.set(rt,nt));let At=nt.get(B);At===void 0&&(At=n.getUniformBlockIndex(rt,B.name),n.uniformBlockBinding(rt,At,At),nt.set(B,At))}function st(B,rt,nt){let xt=c.get(rt).get(B);l[xt]!==nt&&(n.bindBufferBase(n.UNIFORM_BUFFER,xt,nt),l[xt]=nt)}function mt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},Q=null,it={},d={},l={},f=new WeakMap,p=[],x=null,m=!1,g=null,_=null,w=null,v=null,E=null,A=null,y=null,M=new Qt(0,0,0),P=0,L=!1,I=null,F=null,k=null,D=null,V=null,tt.set(0,0,n.canvas.width,n.canvas.height),ht.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Mt,disable:Ht,bindFramebuffer:se,drawBuffers:Vt,useProgram:ue,setBlending:Xe,setMaterial:Fe,setFlipSided:ln,setCullFace:Le,setLineWidth:wn,setPolygonOffset:ye,setScissorTest:gn,activeTexture:Ke,bindTexture:cn,unbindTexture:z,compressedTexImage2D:Rt,compressedTexImage3D:qt,texImage2D:T,texImage3D:q,pixelStorei:ot,getParameter:ut,updateUBOMapping:et,uniformBlockBinding:st,texStorage2D:$t,texStorage3D:N,texSubImage2D:re,texSubImage3D:wt,compressedTexSubImage2D:De,compressedTexSubImage3D:zt,scissor:_t,viewport:yt,reset:mt}}function Ow(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Yt,u=new WeakMap,h=new Set,d,f=new WeakMap,p=new Set,x=new FinalizationRegistry(N=>p.delete(N)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(N,T){return m?new OffscreenCanvas(N,T):aa("canvas")}function _(N,T,q){let ut=1,ot=$t(N);if((ot.width>q||ot.height>q)&&(ut=q/Math.max(ot.width,ot.height)),ut<1)if(typeof HTMLImageElement<"u"&&N instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&N instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&N instanceof ImageBitmap||typeof VideoFrame<"u"&&N instanceof VideoFrame){let _t=Math.floor(ut*ot.width),yt=Math.floor(ut*ot.height);d===void 0&&(d=g(_t,yt));let et=T?g(_t,yt):d;return et.width=_t,et.height=yt,et.getContext("2d").drawImage(N,0,0,_t,yt),Xt("WebGLRenderer: Texture has been resized from ("+ot.width+"x"+ot.height+") to ("+_t+"x"+yt+")."),et}else return"data"in N&&Xt("WebGLRenderer: Image in DataTexture is too big ("+ot.width+"x"+ot.height+")."),N;return N}function w(N){return N.generateMipmaps}function v(N){n.generateMipmap(N)}function E(N){return N.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:N.isWebGL3DRenderTarget?n.TEXTURE_3D:N.isWebGLArrayRenderTarget||N.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function A(N,T,q,ut,ot,_t=!1){if(N!==null){if(n[N]!==void 0)return n[N];Xt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+N+"'")}let yt;ut&&(yt=t.get("EXT_texture_norm16"),yt||Xt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let et=T;if(T===n.RED&&(q===n.FLOAT&&(et=n.R32F),q===n.HALF_FLOAT&&(et=n.R16F),q===n.UNSIGNED_BYTE&&(et=n.R8),q===n.UNSIGNED_SHORT&&yt&&(et=yt.R16_EXT),q===n.SHORT&&yt&&(et=yt.R16_SNORM_EXT)),T===n.RED_INTEGER&&(q===n.UNSIGNED_BYTE&&(et=n.R8UI),q===n.UNSIGNED_SHORT&&(et=n.R16UI),q===n.UNSIGNED_INT&&(et=n.R32UI),q===n.BYTE&&(et=n.R8I),q===n.SHORT&&(et=n.R16I),q===n.INT&&(et=n.R32I)),T===n.RG&&(q===n.FLOAT&&(et=n.RG32F),q===n.HALF_FLOAT&&(et=n.RG16F),q===n.UNSIGNED_BYTE&&(et=n.RG8),q===n.UNSIGNED_SHORT&&yt&&(et=yt.RG16_EXT),q===n.SHORT&&yt&&(et=yt.RG16_SNORM_EXT)),T===n.RG_INTEGER&&(q===n.UNSIGNED_BYTE&&(et=n.RG8UI),q===n.UNSIGNED_SHORT&&(et=n.RG16UI),q===n.UNSIGNED_INT&&(et=n.RG32UI),q===n.BYTE&&(et=n.RG8I),q===n.SHORT&&(et=n.RG16I),q===n.INT&&(et=n.RG32I)),T===n.RGB_INTEGER&&(q===n.UNSIGNED_BYTE&&(et=n.RGB8UI),q===n.UNSIGNED_SHORT&&(et=n.RGB16UI),q===n.UNSIGNED_INT&&(et=n.RGB32UI),q===n.BYTE&&(et=n.RGB8I),q===n.SHORT&&(et=n.RGB16I),q===n.INT&&(et=n.RGB32I)),T===n.RGBA_INTEGER&&(q===n.UNSIGNED_BYTE&&(et=n.RGBA8UI),q===n.UNSIGNED_SHORT&&(et=n.RGBA16UI),q===n.UNSIGNED_INT&&(et=n.RGBA32UI),q===n.BYTE&&(et=n.RGBA8I),q===n.SHORT&&(et=n.RGBA16I),q===n.INT&&(et=n.RGBA32I)),T===n.RGB&&(q===n.UNSIGNED_SHORT&&yt&&(et=yt.RGB16_EXT),q===n.SHORT&&yt&&(et=yt.RGB16_SNORM_EXT),q===n.UNSIGNED_INT_5_9_9_9_REV&&(et=n.RGB9_E5),q===n.UNSIGNED_INT_10F_11F_11F_REV&&(et=n.R11F_G11F_B10F)),T===n.RGBA){let st=_t?oa:xe.getTransfer(ot);q===n.FLOAT&&(et=n.RGBA32F),q===n.HALF_FLOAT&&(et=n.RGBA16F),q===n.UNSIGNED_BYTE&&(et=st===Ae?n.SRGB8_ALPHA8:n.RGBA8),q===n.UNSIGNED_SHORT&&yt&&(et=yt.RGBA16_EXT),q===n.SHORT&&yt&&(et=yt.RGBA16_SNORM_EXT),q===n.UNSIGNED_SHORT_4_4_4_4&&(et=n.RGBA4),q===n.UNSIGNED_SHORT_5_5_5_1&&(et=n.RGB5_A1)}return(et===n.R16F||et===n.R32F||et===n.RG16F||et===n.RG32F||et===n.RGBA16F||et===n.RGBA32F)&&t.get("EXT_color_buffer_float"),et}function y(N,T){let q;return N?T===null||T===Ri||T===fr?q=n.DEPTH24_STENCIL8:T===yi?q=n.DEPTH32F_STENCIL8:T===fo&&(q=n.DEPTH24_STENCIL8,Xt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):T===null||T===Ri||T===fr?q=n.DEPTH_COMPONENT24:T===yi?q=n.DEPTH_COMPONENT32F:T===fo&&(q=n.DEPTH_COMPONENT16),q}function M(N,T){return w(N)===!0||N.isFramebufferTexture&&N.minFilter!==Pn&&N.minFilter!==qn?Math.log2(Math.max(T.width,T.height))+1:N.mipmaps.length>0?N.mipmaps.length:N.isCompressedTexture&&Array.isArray(N.image)?T.mipmaps.length:1}function P(N){let T=new WeakRef(N);i.get(N).__ref=T,p.add(T),x.register(N,T,T)}function L(N){let T=i.get(N).__ref;T!==void 0&&(p.delete(T),x.unregister(T))}function I(N){k(N.target)}function F(N){D(N.target)}function k(N){N.removeEventListener("dispose",I),L(N),X(N),N.isVideoTexture&&u.delete(N),N.isHTMLTexture&&h.delete(N)}function D(N){N.removeEventListener("dispose",F),L(N),lt(N)}function V(){for(let N of p){let T=N.deref();T!==void 0&&(T.isRenderTarget===!0?D(T):k(T))}p.clear(),h.clear()}function X(N){let T=i.get(N);if(T.__webglInit===void 0)return;let q=N.source,ut=f.get(q);if(ut){let ot=ut[T.__cacheKey];ot.usedTimes--,ot.usedTimes===0&&H(N),Object.keys(ut).length===0&&f.delete(q)}i.remove(N)}function H(N){let T=i.get(N);n.deleteTexture(T.__webglTexture);let q=N.source,ut=f.get(q);delete ut[T.__cacheKey],o.memory.textures--}function lt(N){let T=i.get(N);T.__depthDisposeCallback&&T.__depthDisposeCallback();let q=N.depthTexture;if(q&&q.renderTarget===N&&k(q),N.isWebGLCubeRenderTarget)for(let ot=0;ot<6;ot++){if(Array.isArray(T.__webglFramebuffer[ot]))for(let _t=0;_t<T.__webglFramebuffer[ot].length;_t++)n.deleteFramebuffer(T.__webglFramebuffer[ot][_t]);else n.deleteFramebuffer(T.__webglFramebuffer[ot]);T.__webglDepthbuffer&&n.deleteRenderbuffer(T.__webglDepthbuffer[ot])}else{if(Array.isArray(T.__webglFramebuffer))for(let ot=0;ot<T.__webglFramebuffer.length;ot++)n.deleteFramebuffer(T.__webglFramebuffer[ot]);else n.deleteFramebuffer(T.__webglFramebuffer);if(T.__webglDepthbuffer&&n.deleteRenderbuffer(T.__webglDepthbuffer),T.__webglMultisampledFramebuffer&&n.deleteFramebuffer(T.__webglMultisampledFramebuffer),T.__webglColorRenderbuffer)for(let ot=0;ot<T.__webglColorRenderbuffer.length;ot++)T.__webglColorRenderbuffer[ot]&&n.deleteRenderbuffer(T.__webglColorRenderbuffer[ot]);T.__webglDepthRenderbuffer&&n.deleteRenderbuffer(T.__webglDepthRenderbuffer)}let ut=N.textures;for(let ot=0,_t=ut.length;ot<_t;ot++){let yt=i.get(ut[ot]);yt.__webglTexture&&(n.deleteTexture(yt.__webglTexture),o.memory.textures--),i.remove(ut[ot])}i.remove(N)}let Z=0;function Q(){Z=0}function it(){return Z}function ft(N){Z=N}function dt(){let N=Z;return N>=s.maxTextures&&Xt("WebGLTextures: Trying to use "+(N+1)+" texture units while this GPU supports only "+s.maxTextures),Z+=1,N}function tt(N){let T=[];return T.push(N.wrapS),T.push(N.wrapT),T.push(N.wrapR||0),T.push(N.magFilter),T.push(N.minFilter),T.push(N.anisotropy),T.push(N.internalFormat),T.push(N.format),T.push(N.type),T.push(N.generateMipmaps),T.push(N.mipmapsAutoUpdate),T.push(N.premultiplyAlpha),T.push(N.flipY),T.push(N.unpackAlignment),T.push(N.colorSpace),T.join()}function ht(N,T){let q=i.get(N);if(N.isVideoTexture&&De(N),N.isRenderTargetTexture===!1&&N.isExternalTexture!==!0&&N.version>0&&q.__version!==N.version){let ut=N.image;if(ut===null)Xt("WebGLRenderer: Texture marked for update but no image data found.");else if(ut.complete===!1)Xt("WebGLRenderer: Texture marked for update but image is incomplete");else{Fe(q,N,T);return}}else N.isExternalTexture&&(q.__webglTexture=N.sourceTexture?N.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,q.__webglTexture,n.TEXTURE0+T)}function gt(N,T){let q=i.get(N);if(N.isRenderTargetTexture===!1&&N.version>0&&q.__version!==N.version){Fe(q,N,T);return}else N.isExternalTexture&&(q.__webglTexture=N.sourceTexture?N.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,q.__webglTexture,n.TEXTURE0+T)}function St(N,T){let q=i.get(N);if(N.isRenderTargetTexture===!1&&N.version>0&&q.__version!==N.version){Fe(q,N,T);return}e.bindTexture(n.TEXTURE_3D,q.__webglTexture,n.TEXTURE0+T)}function Mt(N,T){let q=i.get(N);if(N.version>0&&q.__version!==N.version){ln(q,N,T);return}e.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture,n.TEXTURE0+T)}let Ht={[Fl]:n.REPEAT,[Hi]:n.CLAMP_TO_EDGE,[kl]:n.MIRRORED_REPEAT},se={[Pn]:n.NEAREST,[om]:n.NEAREST_MIPMAP_NEAREST,[Ca]:n.NEAREST_MIPMAP_LINEAR,[qn]:n.LINEAR,[hc]:n.LINEAR_MIPMAP_NEAREST,[gs]:n.LINEAR_MIPMAP_LINEAR},Vt={[um]:n.NEVER,[id]:n.ALWAYS,[hm]:n.LESS,[ed]:n.LEQUAL,[dm]:n.EQUAL,[nd]:n.GEQUAL,[fm]:n.GREATER,[pm]:n.NOTEQUAL};function ue(N,T){if(T.type===yi&&t.has("OES_texture_float_linear")===!1&&(T.magFilter===qn||T.magFilter===hc||T.magFilter===Ca||T.magFilter===gs||T.minFilter===qn||T.minFilter===hc||T.minFilter===Ca||T.minFilter===gs)&&Xt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(N,n.TEXTURE_WRAP_S,Ht[T.wrapS]),n.texParameteri(N,n.TEXTURE_WRAP_T,Ht[T.wrapT]),(N===n.TEXTURE_3D||N===n.TEXTURE_2D_ARRAY)&&n.texParameteri(N,n.TEXTURE_WRAP_R,Ht[T.wrapR]),n.texParameteri(N,n.TEXTURE_MAG_FILTER,se[T.magFilter]),n.texParameteri(N,n.TEXTURE_MIN_FILTER,se[T.minFilter]),T.compareFunction&&(n.texParameteri(N,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(N,n.TEXTURE_COMPARE_FUNC,Vt[T.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(T.magFilter===Pn||T.minFilter!==Ca&&T.minFilter!==gs||T.type===yi&&t.has("OES_texture_float_linear")===!1)return;if(T.anisotropy>1||i.get(T).__currentAnisotropy){let q=t.get("EXT_texture_filter_anisotropic");n.texParameterf(N,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(T.anisotropy,s.getMaxAnisotropy())),i.get(T).__currentAnisotropy=T.anisotropy}}}function ae(N,T){let q=!1;N.__webglInit===void 0&&(N.__webglInit=!0,T.addEventListener("dispose",I),P(T));let ut=T.source,ot=f.get(ut);ot===void 0&&(ot={},f.set(ut,ot));let _t=tt(T);if(_t!==N.__cacheKey){ot[_t]===void 0&&(ot[_t]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,q=!0),ot[_t].usedTimes++;let yt=ot[N.__cacheKey];yt!==void 0&&(ot[N.__cacheKey].usedTimes--,yt.usedTimes===0&&H(T)),N.__cacheKey=_t,N.__webglTexture=ot[_t].texture}return q}function ne(N,T,q){return Math.floor(Math.floor(N/q)/T)}function Xe(N,T,q,ut){let _t=N.updateRanges;if(_t.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,T.width,T.height,q,ut,T.data);else{_t.sort((B,rt)=>B.start-rt.start);let yt=0;for(let B=1;B<_t.length;B++){let rt=_t[yt],nt=_t[B],At=rt.start+rt.count,xt=ne(nt.start,T.width,4),bt=ne(rt.start,T.width,4);nt.start<=At+1&&xt===bt&&ne(nt.start+nt.count-1,T.width,4)===xt?rt.count=Math.max(rt.count,nt.start+nt.count-rt.start):(++yt,_t[yt]=nt)}_t.length=yt+1;let et=e.getParameter(n.UNPACK_ROW_LENGTH),st=e.getParameter(n.UNPACK_SKIP_PIXELS),mt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,T.width);for(let B=0,rt=_t.length;B<rt;B++){let nt=_t[B],At=Math.floor(nt.start/4),xt=Math.ceil(nt.count/4),bt=At%T.width,Gt=Math.floor(At/T.width),Kt=xt,ct=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,bt),e.pixelStorei(n.UNPACK_SKIP_ROWS,Gt),e.texSubImage2D(n.TEXTURE_2D,0,bt,Gt,Kt,ct,q,ut,T.data)}N.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,et),e.pixelStorei(n.UNPACK_SKIP_PIXELS,st),e.pixelStorei(n.UNPACK_SKIP_ROWS,mt)}}function Fe(N,T,q){let ut=n.TEXTURE_2D;(T.isDataArrayTexture||T.isCompressedArrayTexture)&&(ut=n.TEXTURE_2D_ARRAY),T.isData3DTexture&&(ut=n.TEXTURE_3D);let ot=ae(N,T),_t=T.source;e.bindTexture(ut,N.__webglTexture,n.TEXTURE0+q);let yt=i.get(_t);if(_t.version!==yt.__version||ot===!0){if(e.activeTexture(n.TEXTURE0+q),(typeof ImageBitmap<"u"&&T.image instanceof ImageBitmap)===!1){let ct=xe.getPrimaries(xe.workingColorSpace),Ft=T.colorSpace===_s?null:xe.getPrimaries(T.colorSpace),Jt=T.colorSpace===_s||ct===Ft?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,T.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Jt)}e.pixelStorei(n.UNPACK_ALIGNMENT,T.unpackAlignment);let st=_(T.image,!1,s.maxTextureSize);st=zt(T,st);let mt=r.convert(T.format,T.colorSpace),B=r.convert(T.type),rt=A(T.internalFormat,mt,B,T.normalized,T.colorSpace,T.isVideoTexture);ue(ut,T);let nt,At=T.mipmaps,xt=T.isVideoTexture!==!0,bt=yt.__version===void 0||ot===!0,Gt=_t.dataReady,Kt=M(T,st);if(T.isDepthTexture)rt=y(T.format===xs,T.type),bt&&(xt?e.texStorage2D(n.TEXTURE_2D,1,rt,st.width,st.height):e.texImage2D(n.TEXTURE_2D,0,rt,st.width,st.height,0,mt,B,null));else if(T.isDataTexture)if(At.length>0){xt&&bt&&e.texStorage2D(n.TEXTURE_2D,Kt,rt,At[0].width,At[0].height);for(let ct=0,Ft=At.length;ct<Ft;ct++)nt=At[ct],xt?Gt&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,nt.width,nt.height,mt,B,nt.data):e.texImage2D(n.TEXTURE_2D,ct,rt,nt.width,nt.height,0,mt,B,nt.data);T.generateMipmaps=!1}else xt?(bt&&e.texStorage2D(n.TEXTURE_2D,Kt,rt,st.width,st.height),Gt&&Xe(T,st,mt,B)):e.texImage2D(n.TEXTURE_2D,0,rt,st.width,st.height,0,mt,B,st.data);else if(T.isCompressedTexture)if(T.isCompressedArrayTexture){xt&&bt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Kt,rt,At[0].width,At[0].height,st.depth);for(let ct=0,Ft=At.length;ct<Ft;ct++)if(nt=At[ct],T.format!==Ii)if(mt!==null)if(xt){if(Gt)if(T.layerUpdates.size>0){let Jt=fd(nt.width,nt.height,T.format,T.type);for(let Ct of T.layerUpdates){let oe=nt.data.subarray(Ct*Jt/nt.data.BYTES_PER_ELEMENT,(Ct+1)*Jt/nt.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,Ct,nt.width,nt.height,1,mt,oe)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,0,nt.width,nt.height,st.depth,mt,nt.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ct,rt,nt.width,nt.height,st.depth,0,nt.data,0,0);else Xt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else xt?Gt&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,0,nt.width,nt.height,st.depth,mt,B,nt.data):e.texImage3D(n.TEXTURE_2D_ARRAY,ct,rt,nt.width,nt.height,st.depth,0,mt,B,nt.data);T.layerUpdates.size>0&&T.clearLayerUpdates()}else{xt&&bt&&e.texStorage2D(n.TEXTURE_2D,Kt,rt,At[0].width,At[0].height);for(let ct=0,Ft=At.length;ct<Ft;ct++)nt=At[ct],T.format!==Ii?mt!==null?xt?Gt&&e.compressedTexSubImage2D(n.TEXTURE_2D,ct,0,0,nt.width,nt.height,mt,nt.data):e.compressedTexImage2D(n.TEXTURE_2D,ct,rt,nt.width,nt.height,0,nt.data):Xt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):xt?Gt&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,nt.width,nt.height,mt,B,nt.data):e.texImage2D(n.TEXTURE_2D,ct,rt,nt.width,nt.height,0,mt,B,nt.data)}else if(T.isDataArrayTexture)if(xt){if(bt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Kt,rt,st.width,st.height,st.depth),Gt)if(T.layerUpdates.size>0){let ct=fd(st.width,st.height,T.format,T.type);for(let Ft of T.layerUpdates){let Jt=st.data.subarray(Ft*ct/st.data.BYTES_PER_ELEMENT,(Ft+1)*ct/st.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Ft,st.width,st.height,1,mt,B,Jt)}T.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,st.width,st.height,st.depth,mt,B,st.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,rt,st.width,st.height,st.depth,0,mt,B,st.data);else if(T.isData3DTexture)xt?(bt&&e.texStorage3D(n.TEXTURE_3D,Kt,rt,st.width,st.height,st.depth),Gt&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,st.width,st.height,st.depth,mt,B,st.data)):e.texImage3D(n.TEXTURE_3D,0,rt,st.width,st.height,st.depth,0,mt,B,st.data);else if(T.isFramebufferTexture){if(bt)if(xt)e.texStorage2D(n.TEXTURE_2D,Kt,rt,st.width,st.height);else{let ct=st.width,Ft=st.height;for(let Jt=0;Jt<Kt;Jt++)e.texImage2D(n.TEXTURE_2D,Jt,rt,ct,Ft,0,mt,B,null),ct>>=1,Ft>>=1}}else if(T.isHTMLTexture){if("texElementImage2D"in n){let ct=n.canvas;if(ct.hasAttribute("layoutsubtree")||ct.setAttribute("layoutsubtree","true"),st.parentNode!==ct){ct.appendChild(st),h.add(T),ct.onpaint=Ft=>{let Jt=Ft.changedElements;for(let Ct of h)Jt.includes(Ct.image)&&(Ct.needsUpdate=!0)},ct.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,st);else{let Jt=n.RGBA,Ct=n.RGBA,oe=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,Jt,Ct,oe,st)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(At.length>0){if(xt&&bt){let ct=$t(At[0]);e.texStorage2D(n.TEXTURE_2D,Kt,rt,ct.width,ct.height)}for(let ct=0,Ft=At.length;ct<Ft;ct++)nt=At[ct],xt?Gt&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,mt,B,nt):e.texImage2D(n.TEXTURE_2D,ct,rt,mt,B,nt);T.generateMipmaps=!1}else if(xt){if(bt){let ct=$t(st);e.texStorage2D(n.TEXTURE_2D,Kt,rt,ct.width,ct.height)}Gt&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,mt,B,st)}else e.texImage2D(n.TEXTURE_2D,0,rt,mt,B,st);w(T)&&T.mipmapsAutoUpdate===!0&&v(ut),yt.__version=_t.version,T.onUpdate&&T.onUpdate(T)}N.__version=T.version}function ln(N,T,q){if(T.image.length!==6)return;let ut=ae(N,T),ot=T.source;e.bindTexture(n.TEXTURE_CUBE_MAP,N.__webglTexture,n.TEXTURE0+q);let _t=i.get(ot);if(ot.version!==_t.__version||ut===!0){e.activeTexture(n.TEXTURE0+q);let yt=xe.getPrimaries(xe.workingColorSpace),et=T.colorSpace===_s?null:xe.getPrimaries(T.colorSpace),st=T.colorSpace===_s||yt===et?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,T.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,T.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,st);let mt=T.isCompressedTexture||T.image[0].isCompressedTexture,B=T.image[0]&&T.image[0].isDataTexture,rt=[];for(let Ct=0;Ct<6;Ct++)!mt&&!B?rt[Ct]=_(T.image[Ct],!0,s.maxCubemapSize):rt[Ct]=B?T.image[Ct].image:T.image[Ct],rt[Ct]=zt(T,rt[Ct]);let nt=rt[0],At=r.convert(T.format,T.colorSpace),xt=r.convert(T.type),bt=A(T.internalFormat,At,xt,T.normalized,T.colorSpace),Gt=T.isVideoTexture!==!0,Kt=_t.__version===void 0||ut===!0,ct=ot.dataReady,Ft=M(T,nt);ue(n.TEXTURE_CUBE_MAP,T);let Jt;if(T.isDepthTexture){if(bt=y(T.format===xs,T.type),Kt)if(Gt)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,bt,nt.width,nt.height);else for(let Ct=0;Ct<6;Ct++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,nt.width,nt.height,0,At,xt,null)}else if(mt){Gt&&Kt&&e.texStorage2D(n.TEXTURE_CUBE_MAP,Ft,bt,nt.width,nt.height);for(let Ct=0;Ct<6;Ct++){Jt=rt[Ct].mipmaps;for(let oe=0;oe<Jt.length;oe++){let ze=Jt[oe];T.format!==Ii?At!==null?Gt?ct&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe,0,0,ze.width,ze.height,At,ze.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe,bt,ze.width,ze.height,0,ze.data):Xt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Gt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe,0,0,ze.width,ze.height,At,xt,ze.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe,bt,ze.width,ze.height,0,At,xt,ze.data)}}}else{if(Jt=T.mipmaps,Gt&&Kt){Jt.length>0&&Ft++;let Ct=$t(rt[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,Ft,bt,Ct.width,Ct.height)}for(let Ct=0;Ct<6;Ct++)if(B){Gt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,rt[Ct].width,rt[Ct].height,At,xt,rt[Ct].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,rt[Ct].width,rt[Ct].height,0,At,xt,rt[Ct].data);for(let oe=0;oe<Jt.length;oe++){let zn=Jt[oe].image[Ct].image;Gt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe+1,0,0,zn.width,zn.height,At,xt,zn.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe+1,bt,zn.width,zn.height,0,At,xt,zn.data)}}else{Gt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,At,xt,rt[Ct]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,At,xt,rt[Ct]);for(let oe=0;oe<Jt.length;oe++){let ze=Jt[oe];Gt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe+1,0,0,At,xt,ze.image[Ct]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe+1,bt,At,xt,ze.image[Ct])}}}w(T)&&T.mipmapsAutoUpdate===!0&&v(n.TEXTURE_CUBE_MAP),_t.__version=ot.version,T.onUpdate&&T.onUpdate(T)}N.__version=T.version}function Le(N,T,q,ut,ot,_t){let yt=r.convert(q.format,q.colorSpace),et=r.convert(q.type),st=A(q.internalFormat,yt,et,q.normalized,q.colorSpace),mt=i.get(T),B=i.get(q);if(B.__renderTarget=T,!mt.__hasExternalTextures){let rt=Math.max(1,T.width>>_t),nt=Math.max(1,T.height>>_t);ot===n.TEXTURE_3D||ot===n.TEXTURE_2D_ARRAY?e.texImage3D(ot,_t,st,rt,nt,T.depth,0,yt,et,null):e.texImage2D(ot,_t,st,rt,nt,0,yt,et,null)}e.bindFramebuffer(n.FRAMEBUFFER,N),wt(T)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ut,ot,B.__webglTexture,0,re(T)):(ot===n.TEXTURE_2D||ot>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ot<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ut,ot,B.__webglTexture,_t),e.bindFramebuffer(n.FRAMEBUFFER,null)}function wn(N,T,q){if(n.bindRenderbuffer(n.RENDERBUFFER,N),T.depthBuffer){let ut=T.depthTexture,ot=ut&&ut.isDepthTexture?ut.type:null,_t=y(T.stencilBuffer,ot),yt=T.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;wt(T)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,re(T),_t,T.width,T.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,re(T),_t,T.width,T.height):n.renderbufferStorage(n.RENDERBUFFER,_t,T.width,T.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,yt,n.RENDERBUFFER,N)}else{let ut=T.textures;for(let ot=0;ot<ut.length;ot++){let _t=ut[ot],yt=r.convert(_t.format,_t.colorSpace),et=r.convert(_t.type),st=A(_t.internalFormat,yt,et,_t.normalized,_t.colorSpace);wt(T)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,re(T),st,T.width,T.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,re(T),st,T.width,T.height):n.renderbufferStorage(n.RENDERBUFFER,st,T.width,T.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function ye(N,T,q){let ut=T.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,N),!(T.depthTexture&&T.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ot=i.get(T.depthTexture);ot.__renderTarget=T;let _t=ut?T.depthTexture.image[0]:T.depthTexture.image;(!ot.__webglTexture||_t.width!==T.width||_t.height!==T.height)&&(_t.width=T.width,_t.height=T.height,T.depthTexture.needsUpdate=!0),ut?Mt(T.depthTexture,0):ht(T.depthTexture,0);let yt=ot.__webglTexture,et=re(T),st=ut?n.TEXTURE_CUBE_MAP_POSITIVE_X+q:n.TEXTURE_2D,mt=T.depthTexture.format===xs?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(T.depthTexture.format===us)wt(T)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,mt,st,yt,0,et):n.framebufferTexture2D(n.FRAMEBUFFER,mt,st,yt,0);else if(T.depthTexture.format===xs)wt(T)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,mt,st,yt,0,et):n.framebufferTexture2D(n.FRAMEBUFFER,mt,st,yt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function gn(N){let T=i.get(N),q=N.isWebGLCubeRenderTarget===!0;if(T.__boundDepthTexture!==N.depthTexture){let ut=N.depthTexture;if(T.__depthDisposeCallback&&T.__depthDisposeCallback(),ut){let ot=()=>{delete T.__boundDepthTexture,delete T.__depthDisposeCallback,ut.removeEventListener("dispose",ot)};ut.addEventListener("dispose",ot),T.__depthDisposeCallback=ot}T.__boundDepthTexture=ut}if(N.depthTexture&&!T.__autoAllocateDepthBuffer)if(q)for(let ut=0;ut<6;ut++)ye(T.__webglFramebuffer[ut],N,ut);else N.texture.mipmaps.length>0?ye(T.__webglFramebuffer[0],N,0):ye(T.__webglFramebuffer,N,0);else if(q){T.__webglDepthbuffer=[];for(let ut=0;ut<6;ut++)if(e.bindFramebuffer(n.FRAMEBUFFER,T.__webglFramebuffer[ut]),T.__webglDepthbuffer[ut]===void 0)T.__webglDepthbuffer[ut]=n.createRenderbuffer(),wn(T.__webglDepthbuffer[ut],N,!1);else{let ot=N.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_t=T.__webglDepthbuffer[ut];n.bindRenderbuffer(n.RENDERBUFFER,_t),n.framebufferRenderbuffer(n.FRAMEBUFFER,ot,n.RENDERBUFFER,_t)}}else if(N.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,T.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,T.__webglFramebuffer),T.__webglDepthbuffer===void 0)T.__webglDepthbuffer=n.createRenderbuffer(),wn(T.__webglDepthbuffer,N,!1);else{let ot=N.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_t=T.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,_t),n.framebufferRenderbuffer(n.FRAMEBUFFER,ot,n.RENDERBUFFER,_t)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function Ke(N,T,q){let ut=i.get(N);T!==void 0&&Le(ut.__webglFramebuffer,N,N.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),q!==void 0&&gn(N)}function cn(N){let T=N.texture,q=i.get(N),ut=i.get(T);N.addEventListener("dispose",F),P(N);let ot=N.textures,_t=N.isWebGLCubeRenderTarget===!0,yt=ot.length>1;if(yt||(ut.__webglTexture===void 0&&(ut.__webglTexture=n.createTexture()),ut.__version=T.version,o.memory.textures++),_t){q.__webglFramebuffer=[];for(let et=0;et<6;et++)if(T.mipmaps.length>0){q.__webglFramebuffer[et]=[];for(let st=0;st<T.mipmaps.length;st++)q.__webglFramebuffer[et][st]=n.createFramebuffer()}else q.__webglFramebuffer[et]=n.createFramebuffer()}else{if(T.mipmaps.length>0){q.__webglFramebuffer=[];for(let et=0;et<T.mipmaps.length;et++)q.__webglFramebuffer[et]=n.createFramebuffer()}else q.__webglFramebuffer=n.createFramebuffer();if(yt)for(let et=0,st=ot.length;et<st;et++){let mt=i.get(ot[et]);mt.__webglTexture===void 0&&(mt.__webglTexture=n.createTexture(),o.memory.textures++)}if(N.samples>0&&wt(N)===!1){q.__webglMultisampledFramebuffer=n.createFramebuffer(),q.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let et=0;et<ot.length;et++){let st=ot[et];q.__webglColorRenderbuffer[et]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,q.__webglColorRenderbuffer[et]);let mt=r.convert(st.format,st.colorSpace),B=r.convert(st.type),rt=A(st.internalFormat,mt,B,st.normalized,st.colorSpace,N.isXRRenderTarget===!0),nt=re(N);n.renderbufferStorageMultisample(n.RENDERBUFFER,nt,rt,N.width,N.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+et,n.RENDERBUFFER,q.__webglColorRenderbuffer[et])}n.bindRenderbuffer(n.RENDERBUFFER,null),N.depthBuffer&&(q.__webglDepthRenderbuffer=n.createRenderbuffer(),wn(q.__webglDepthRenderbuffer,N,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(_t){e.bindTexture(n.TEXTURE_CUBE_MAP,ut.__webglTexture),ue(n.TEXTURE_CUBE_MAP,T);for(let et=0;et<6;et++)if(T.mipmaps.length>0)for(let st=0;st<T.mipmaps.length;st++)Le(q.__webglFramebuffer[et][st],N,T,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+et,st);else Le(q.__webglFramebuffer[et],N,T,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+et,0);w(T)?v(n.TEXTURE_CUBE_MAP):T.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),e.unbindTexture()}else if(yt){for(let et=0,st=ot.length;et<st;et++){let mt=ot[et],B=i.get(mt),rt=n.TEXTURE_2D;(N.isWebGL3DRenderTarget||N.isWebGLArrayRenderTarget)&&(rt=N.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(rt,B.__webglTexture),ue(rt,mt),Le(q.__webglFramebuffer,N,mt,n.COLOR_ATTACHMENT0+et,rt,0),w(mt)&&v(rt)}e.unbindTexture()}else{let et=n.TEXTURE_2D;if((N.isWebGL3DRenderTarget||N.isWebGLArrayRenderTarget)&&(et=N.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(et,ut.__webglTexture),ue(et,T),T.mipmaps.length>0)for(let st=0;st<T.mipmaps.length;st++)Le(q.__webglFramebuffer[st],N,T,n.COLOR_ATTACHMENT0,et,st);else Le(q.__webglFramebuffer,N,T,n.COLOR_ATTACHMENT0,et,0);w(T)?v(et):T.mipmaps.length>0&&n.texParameteri(et,n.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),e.unbindTexture()}N.depthBuffer&&gn(N)}function z(N){let T=N.textures;for(let q=0,ut=T.length;q<ut;q++){let ot=T[q];if(w(ot)&&ot.mipmapsAutoUpdate===!0){let _t=E(N),yt=i.get(ot).__webglTexture;e.bindTexture(_t,yt),v(_t),e.unbindTexture()}}}let Rt=[];function qt(N){if(N.samples>0){if(wt(N)===!1){let T=N.textures,q=N.width,ut=N.height,ot=n.COLOR_BUFFER_BIT,_t=N.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,yt=i.get(N),et=T.length>1;if(et)for(let mt=0;mt<T.length;mt++)e.bindFramebuffer(n.FRAMEBUFFER,yt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,yt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,yt.__webglMultisampledFramebuffer),N.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,yt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,yt.__webglFramebuffer);for(let mt=0;mt<T.length;mt++){if(N.resolveDepthBuffer&&(N.depthBuffer&&(ot|=n.DEPTH_BUFFER_BIT),N.stencilBuffer&&N.resolveStencilBuffer&&(ot|=n.STENCIL_BUFFER_BIT)),et){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,yt.__webglColorRenderbuffer[mt]);let B=i.get(T[mt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,B,0)}n.blitFramebuffer(0,0,q,ut,0,0,q,ut,ot,n.NEAREST),l===!0&&(Rt.length=0,Rt.push(n.COLOR_ATTACHMENT0+mt),N.depthBuffer&&N.storeMultisampledDepthBuffer===!1&&Rt.push(_t),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Rt))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),et)for(let mt=0;mt<T.length;mt++){e.bindFramebuffer(n.FRAMEBUFFER,yt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.RENDERBUFFER,yt.__webglColorRenderbuffer[mt]);let B=i.get(T[mt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,yt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.TEXTURE_2D,B,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,yt.__webglMultisampledFramebuffer)}else if(N.depthBuffer&&N.storeMultisampledDepthBuffer===!1&&l){let T=N.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[T])}}}function re(N){return Math.min(s.maxSamples,N.samples)}function wt(N){let T=i.get(N);return N.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&T.__useRenderToTexture!==!1}function De(N){let T=o.render.frame;u.get(N)!==T&&(u.set(N,T),N.update())}function zt(N,T){let q=N.colorSpace,ut=N.format,ot=N.type;return N.isCompressedTexture===!0||N.isVideoTexture===!0||q!==ra&&q!==_s&&(xe.getTransfer(q)===Ae?(ut!==Ii||ot!==Jn)&&Xt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):jt("WebGLTextures: Unsupported texture color space:",q)),T}function $t(N){return typeof HTMLImageElement<"u"&&N instanceof HTMLImageElement?(c.width=N.naturalWidth||N.width,c.height=N.naturalHeight||N.height):typeof VideoFrame<"u"&&N instanceof VideoFrame?(c.width=N.displayWidth,c.height=N.displayHeight):(c.width=N.width,c.height=N.height),c}this.allocateTextureUnit=dt,this.resetTextureUnits=Q,this.getTextureUnits=it,this.setTextureUnits=ft,this.setTexture2D=ht,this.setTexture2DArray=gt,this.setTexture3D=St,this.setTextureCube=Mt,this.rebindTextures=Ke,this.setupRenderTarget=cn,this.updateRenderTargetMipmap=z,this.updateMultisampleRenderTarget=qt,this.setupDepthRenderbuffer=gn,this.setupFrameBufferTexture=Le,this.useMultisampledRTT=wt,this.dispose=V}function Fw(n,t){function e(i,s=_s){let r,o=xe.getTransfer(s);if(i===Jn)return n.UNSIGNED_BYTE;if(i===fc)return n.UNSIGNED_SHORT_4_4_4_4;if(i===pc)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Zh)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Kh)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===qh)return n.BYTE;if(i===Yh)return n.SHORT;if(i===fo)return n.UNSIGNED_SHORT;if(i===dc)return n.INT;if(i===Ri)return n.UNSIGNED_INT;if(i===yi)return n.FLOAT;if(i===Pi)return n.HALF_FLOAT;if(i===Jh)return n.ALPHA;if(i===jh)return n.RGB;if(i===Ii)return n.RGBA;if(i===us)return n.DEPTH_COMPONENT;if(i===xs)return n.DEPTH_STENCIL;if(i===mc)return n.RED;if(i===gc)return n.RED_INTEGER;if(i===Xs)return n.RG;if(i===xc)return n.RG_INTEGER;if(i===_c)return n.RGBA_INTEGER;if(i===Ra||i===Pa||i===Ia||i===La)if(o===Ae)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Ra)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Pa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Ia)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===La)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Ra)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Pa)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Ia)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===La)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===yc||i===vc||i===bc||i===Sc)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===yc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===vc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===bc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Sc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Mc||i===wc||i===Ac||i===Ec||i===Tc||i===Na||i===Cc)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Mc||i===wc)return o===Ae?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Ac)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Ec)return r.COMPRESSED_R11_EAC;if(i===Tc)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Na)return r.COMPRESSED_RG11_EAC;if(i===Cc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Rc||i===Pc||i===Ic||i===Lc||i===Nc||i===Dc||i===Uc||i===Oc||i===Fc||i===kc||i===Bc||i===zc||i===Vc||i===Gc)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Rc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Pc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Ic)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Lc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Nc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Dc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Uc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Oc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Fc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===kc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Bc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===zc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Vc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Gc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Hc||i===Wc||i===$c)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===Hc)return o===Ae?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Wc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===$c)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Xc||i===qc||i===Da||i===Yc)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===Xc)return r.COMPRESSED_RED_RGTC1_EXT;if(i===qc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Da)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Yc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===fr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var kw=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,Bw=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Sd=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new ga(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new Xi({vertexShader:kw,fragmentShader:Bw,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Nn(new _a(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Md=class extends Ci{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,d=null,f=null,p=null,x=typeof XRWebGLBinding<"u",m=new Sd,g={},_=e.getContextAttributes(),w=null,v=null,E=[],A=[],y=new Yt,M=null,P=null,L=new Xn;L.viewport=new Ye;let I=new Xn;I.viewport=new Ye;let F=[L,I],k=new ac,D=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(tt){let ht=E[tt];return ht===void 0&&(ht=new so,E[tt]=ht),ht.getTargetRaySpace()},this.getControllerGrip=function(tt){let ht=E[tt];return ht===void 0&&(ht=new so,E[tt]=ht),ht.getGripSpace()},this.getHand=function(tt){let ht=E[tt];return ht===void 0&&(ht=new so,E[tt]=ht),ht.getHandSpace()};function X(tt){let ht=A.indexOf(tt.inputSource);if(ht===-1)return;let gt=E[ht];gt!==void 0&&(gt.update(tt.inputSource,tt.frame,c||o),gt.dispatchEvent({type:tt.type,data:tt.inputSource}))}function H(){s.removeEventListener("select",X),s.removeEventListener("selectstart",X),s.removeEventListener("selectend",X),s.removeEventListener("squeeze",X),s.removeEventListener("squeezestart",X),s.removeEventListener("squeezeend",X),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",lt);for(let tt=0;tt<E.length;tt++){let ht=A[tt];ht!==null&&(A[tt]=null,E[tt].disconnect(ht))}D=null,V=null,m.reset();for(let tt in g)delete g[tt];if(t.setRenderTarget(w),f=null,d=null,h=null,s=null,v=null,dt.stop(),i.isPresenting=!1,t.setPixelRatio(M),t.setSize(y.width,y.height,!1),P!==null){let tt=P.camera;tt.fov=P.fov,tt.zoom=P.zoom,tt.updateProjectionMatrix(),P=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(tt){r=tt,i.isPresenting===!0&&Xt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(tt){a=tt,i.isPresenting===!0&&Xt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(tt){c=tt},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h===null&&x&&(h=new XRWebGLBinding(s,e)),h},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(tt){if(s=tt,s!==null){if(w=t.getRenderTarget(),s.addEventListener("select",X),s.addEventListener("selectstart",X),s.addEventListener("selectend",X),s.addEventListener("squeeze",X),s.addEventListener("squeezestart",X),s.addEventListener("squeezeend",X),s.addEventListener("end",H),s.addEventListener("inputsourceschange",lt),_.xrCompatible!==!0&&await e.makeXRCompatible(),M=t.getPixelRatio(),t.getSize(y),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let gt=null,St=null,Mt=null;_.depth&&(Mt=_.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,gt=_.stencil?xs:us,St=_.stencil?fr:Ri);let Ht={colorFormat:e.RGBA8,depthFormat:Mt,scaleFactor:r};h=this.getBinding(),d=h.createProjectionLayer(Ht),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),v=new ci(d.textureWidth,d.textureHeight,{format:Ii,type:Jn,depthTexture:new ps(d.textureWidth,d.textureHeight,St,void 0,void 0,void 0,void 0,void 0,void 0,gt),stencilBuffer:_.stencil,colorSpace:t.outputColorSpace,samples:_.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let gt={antialias:_.antialias,alpha:!0,depth:_.depth,stencil:_.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,gt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),v=new ci(f.framebufferWidth,f.framebufferHeight,{format:Ii,type:Jn,colorSpace:t.outputColorSpace,stencilBuffer:_.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}v.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),dt.setContext(s),dt.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function lt(tt){for(let ht=0;ht<tt.removed.length;ht++){let gt=tt.removed[ht],St=A.indexOf(gt);St>=0&&(A[St]=null,E[St].disconnect(gt))}for(let ht=0;ht<tt.added.length;ht++){let gt=tt.added[ht],St=A.indexOf(gt);if(St===-1){for(let Ht=0;Ht<E.length;Ht++)if(Ht>=A.length){A.push(gt),St=Ht;break}else if(A[Ht]===null){A[Ht]=gt,St=Ht;break}if(St===-1)break}let Mt=E[St];Mt&&Mt.connect(gt)}}function Z(tt,ht){ht===null?tt.matrixWorld.copy(tt.matrix):tt.matrixWorld.multiplyMatrices(ht.matrixWorld,tt.matrix),tt.matrixWorldInverse.copy(tt.matrixWorld).invert()}this.updateCamera=function(tt){if(s===null)return;let ht=tt.near,gt=tt.far;m.texture!==null&&(m.depthNear>0&&(ht=m.depthNear),m.depthFar>0&&(gt=m.depthFar)),k.near=I.near=L.near=ht,k.far=I.far=L.far=gt,(D!==k.near||V!==k.far)&&(s.updateRenderState({depthNear:k.near,depthFar:k.far}),D=k.near,V=k.far),k.layers.mask=tt.layers.mask|6,L.layers.mask=k.layers.mask&-5,I.layers.mask=k.layers.mask&-3;let St=tt.parent,Mt=k.cameras;Z(k,St);for(let Ht=0;Ht<Mt.length;Ht++)Z(Mt[Ht],St);k.projectionMatrix.copy(L.projectionMatrix),k.projectionMatrixInverse.copy(L.projectionMatrixInverse),P===null&&tt.isPerspectiveCamera&&(P={camera:tt,fov:tt.fov,zoom:tt.zoom}),Q(tt,k,St)};function Q(tt,ht,gt){gt===null?tt.matrix.copy(ht.matrixWorld):(tt.matrix.copy(gt.matrixWorld),tt.matrix.invert(),tt.matrix.multiply(ht.matrixWorld)),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.updateMatrixWorld(!0),tt.projectionMatrix.copy(ht.projectionMatrix),tt.projectionMatrixInverse.copy(ht.projectionMatrixInverse),tt.isPerspectiveCamera&&(tt.fov=eo*2*Math.atan(1/tt.projectionMatrix.elements[5]),tt.zoom=1)}this.getCamera=function(){return k},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(tt){l=tt,d!==null&&(d.fixedFoveation=tt),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=tt)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(k)},this.getCameraTexture=function(tt){return g[tt]};let it=null;function ft(tt,ht){if(u=ht.getViewerPose(c||o),p=ht,u!==null){let gt=u.views;f!==null&&(t.setRenderTargetFramebuffer(v,f.framebuffer),t.setRenderTarget(v));let St=!1;gt.length!==k.cameras.length&&(k.cameras.length=0,St=!0);for(let Vt=0;Vt<gt.length;Vt++){let ue=gt[Vt],ae=null;if(f!==null)ae=f.getViewport(ue);else{let Xe=h.getViewSubImage(d,ue);ae=Xe.viewport,Vt===0&&(t.setRenderTargetTextures(v,Xe.colorTexture,Xe.depthStencilTexture),t.setRenderTarget(v))}let ne=F[Vt];ne===void 0&&(ne=new Xn,ne.layers.enable(Vt),ne.viewport=new Ye,F[Vt]=ne),ne.matrix.fromArray(ue.transform.matrix),ne.matrix.decompose(ne.position,ne.quaternion,ne.scale),ne.projectionMatrix.fromArray(ue.projectionMatrix),ne.projectionMatrixInverse.copy(ne.projectionMatrix).invert(),ne.viewport.set(ae.x,ae.y,ae.width,ae.height),Vt===0&&(k.matrix.copy(ne.matrix),k.matrix.decompose(k.position,k.quaternion,k.scale)),St===!0&&k.cameras.push(ne)}let Mt=s.enabledFeatures;if(Mt&&Mt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){h=i.getBinding();let Vt=h.getDepthInformation(gt[0]);Vt&&Vt.isValid&&Vt.texture&&m.init(Vt,s.renderState)}if(Mt&&Mt.includes("camera-access")&&x){t.state.unbindTexture(),h=i.getBinding();for(let Vt=0;Vt<gt.length;Vt++){let ue=gt[Vt].camera;if(ue){let ae=g[ue];ae||(ae=new ga,g[ue]=ae);let ne=h.getCameraImage(ue);ae.sourceTexture=ne}}}}for(let gt=0;gt<E.length;gt++){let St=A[gt],Mt=E[gt];St!==null&&Mt!==void 0&&Mt.update(St,ht,c||o)}it&&it(tt,ht),ht.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:ht}),p=null}let dt=new qm;dt.setAnimationLoop(ft),this.setAnimationLoop=function(tt){it=tt},this.dispose=function(){}}},zw=new pe,ig=new ee;ig.set(-1,0,0,0,1,0,0,0,1);function Vw(n,t){function e(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function i(m,g){g.color.getRGB(m.fogColor.value,ud(n)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,_,w,v){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),h(m,g)):g.isMeshPhongMaterial?(r(m,g),u(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),d(m,g),g.isMeshPhysicalMaterial&&f(m,g,v)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),x(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?l(m,g,_,w):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,e(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===Yn&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,e(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===Yn&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,e(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,e(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,e(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let _=t.get(g),w=_.envMap,v=_.envMapRotation;w&&(m.envMap.value=w,m.envMapRotation.value.setFromMatrix4(zw.makeRotationFromEuler(v)).transpose(),w.isCubeTexture&&w.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(ig),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,e(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,e(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,_,w){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*_,m.scale.value=w*.5,g.map&&(m.map.value=g.map,e(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function u(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function h(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function d(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,e(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,e(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function f(m,g,_){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,e(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,e(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,e(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,e(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,e(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,e(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===Yn&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,e(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,e(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=_.texture,m.transmissionSamplerSize.value.set(_.width,_.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,e(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,e(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,e(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,e(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,e(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function x(m,g){let _=t.get(g).light;m.referencePosition.value.setFromMatrixPosition(_.matrixWorld),m.nearDistance.value=_.shadow.camera.near,m.farDistance.value=_.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function Gw(n,t,e,i){let s={},r={};function o(_,w){let v=w.program;i.uniformBlockBinding(_,v,s[_.id])}function a(_,w){let v=s[_.id];v===void 0&&(p(_),v=l(_),s[_.id]=v,_.addEventListener("dispose",m));let E=w.program;i.updateUBOMapping(_,E);let A=t.render.frame;r[_.id]!==A&&(c(_),r[_.id]=A)}function l(_){let w=n.createBuffer(),v=_.__size,E=_.usage;return n.bindBuffer(n.UNIFORM_BUFFER,w),n.bufferData(n.UNIFORM_BUFFER,v,E),n.bindBuffer(n.UNIFORM_BUFFER,null),w}function c(_){let w=s[_.id],v=_.uniforms,E=_.__cache;n.bindBuffer(n.UNIFORM_BUFFER,w);for(let A=0,y=v.length;A<y;A++){let M=v[A];if(Array.isArray(M))for(let P=0,L=M.length;P<L;P++)u(M[P],A,P,E);else u(M,A,0,E)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(_,w,v,E){if(d(_,w,v,E)===!0){let A=_.__offset,y=_.value;if(Array.isArray(y)){let M=0;for(let P=0;P<y.length;P++){let L=y[P],I=x(L,!0);h(L,_.__data,M),M+=I.storage/Float32Array.BYTES_PER_ELEMENT}}else h(y,_.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,A,_.__data)}}function h(_,w,v){typeof _=="number"||typeof _=="boolean"?w[v]=_:_.isMatrix3?(w[v]=_.elements[0],w[v+1]=_.elements[1],w[v+2]=_.elements[2],w[v+3]=0,w[v+4]=_.elements[3],w[v+5]=_.elements[4],w[v+6]=_.elements[5],w[v+7]=0,w[v+8]=_.elements[6],w[v+9]=_.elements[7],w[v+10]=_.elements[8],w[v+11]=0):ArrayBuffer.isView(_)?w.set(_.subarray(0,w.length-v),v):_.toArray(w,v)}function d(_,w,v,E){let A=_.value,y=w+"_"+v;if(Array.isArray(A)){E[y]===void 0&&(E[y]=[]);let M=E[y],P=!1;for(let L=0;L<A.length;L++)f(A[L],M,L)===!0&&(P=!0);return P}return f(A,E,y)}function f(_,w,v){if(w[v]===void 0)return typeof _=="number"||typeof _=="boolean"?w[v]=_:ArrayBuffer.isView(_)?w[v]=_.slice():w[v]=_.clone(),!0;{let E=w[v];if(typeof _=="number"||typeof _=="boolean"){if(E!==_)return w[v]=_,!0}else{if(ArrayBuffer.isView(_))return!0;if(E.equals(_)===!1)return E.copy(_),!0}}return!1}function p(_){let w=_.uniforms,v=0,E=16;for(let y=0,M=w.length;y<M;y++){let P=Array.isArray(w[y])?w[y]:[w[y]];for(let L=0,I=P.length;L<I;L++){let F=P[L],k=Array.isArray(F.value)?F.value:[F.value],D=Array.isArray(w[y])||Array.isArray(F.value),V=v;for(let H=0,lt=k.length;H<lt;H++){let Z=k[H],Q=x(Z,D),it=v%E,ft=it%Q.boundary,dt=it+ft;v+=ft,dt!==0&&E-dt<Q.storage&&(v+=E-dt),H===0&&(V=v),v+=Q.storage}let X=F.type==="int"?Int32Array:F.type==="uint"?Uint32Array:Float32Array;F.__data=new X((v-V)/Float32Array.BYTES_PER_ELEMENT),F.__offset=V}}let A=v%E;return A>0&&(v+=E-A),_.__size=v,_.__cache={},this}function x(_,w){let v={boundary:0,storage:0};return typeof _=="number"||typeof _=="boolean"?(v.boundary=4,v.storage=4):_.isVector2?(v.boundary=8,v.storage=8):_.isVector3||_.isColor?(v.boundary=16,v.storage=12):_.isVector4?(v.boundary=16,v.storage=16):_.isMatrix3?(v.boundary=16,v.storage=48):_.isMatrix4?(v.boundary=16,v.storage=64):_.isTexture?Xt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(_)?(v.boundary=16,v.storage=_.byteLength):Xt("WebGLRenderer: Unsupported uniform value type.",_),w===!0&&(v.boundary=16,v.storage=Math.ceil(v.storage/16)*16),v}function m(_){let w=_.target;w.removeEventListener("dispose",m),n.deleteBuffer(s[w.id]),delete s[w.id],delete r[w.id]}function g(){for(let _ in s)n.deleteBuffer(s[_]);s={},r={}}return{bind:o,update:a,dispose:g}}var Hw=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Yi=null;function Ww(){return Yi===null&&(Yi=new da(Hw,16,16,Xs,Pi),Yi.name="DFG_LUT",Yi.minFilter=qn,Yi.magFilter=qn,Yi.wrapS=Hi,Yi.wrapT=Hi,Yi.generateMipmaps=!1,Yi.needsUpdate=!0),Yi}var Qc=class{constructor(t={}){let{canvas:e=gm(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1,outputBufferType:f=Jn}=t;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let x=f,m=new Set([_c,xc,gc]),g=new Set([Jn,Ri,fo,fr,fc,pc]),_=new Uint32Array(4),w=new Int32Array(4),v={textures:[],min:[],max:[],resolution:[]},E=null,A=null,y=[],M=[],P=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=qi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let L=this,I=!1,F=null,k=null,D=null,V=null;this._outputColorSpace=oi;let X=0,H=0,lt=null,Z=-1,Q=null,it=new Ye,ft=new Ye,dt=null,tt=new Qt(0),ht=0,gt=e.width,St=e.height,Mt=1,Ht=null,se=null,Vt=new Ye(0,0,gt,St),ue=new Ye(0,0,gt,St),ae=!1,ne=new ks,Xe=new Hl,Fe=!1,ln=!1,Le=new pe,wn=new W,ye=new Ye,gn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Ke=!1;function cn(){return lt===null?Mt:1}let z=i;function Rt(R,G){return e.getContext(R,G)}let qt,re,wt,De,zt,$t,N,T,q,ut,ot,_t,yt,et,st,mt,B,rt,nt,At,xt,bt,Gt;try{let R={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Ft,!1),e.addEventListener("webglcontextrestored",Jt,!1),e.addEventListener("webglcontextcreationerror",Ct,!1),z===null){let G="webgl2";if(z=Rt(G,R),z===null)throw Rt(G)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Kt()}catch(R){throw e.removeEventListener("webglcontextlost",Ft,!1),e.removeEventListener("webglcontextrestored",Jt,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),jt("WebGLRenderer: "+R.message),R}function Kt(){qt=new eM(z),qt.init(),xt=new Fw(z,qt),re=new WS(z,qt,t,xt),wt=new Uw(z,qt),re.reversedDepthBuffer&&d&&wt.buffers.depth.setReversed(!0),k=z.createFramebuffer(),D=z.createFramebuffer(),V=z.createFramebuffer(),De=new sM(z),zt=new bw,$t=new Ow(z,qt,wt,zt,re,xt,De),N=new tM(L),T=new ov(z),bt=new GS(z,T),q=new nM(z,T,De,bt),ut=new oM(z,q,T,bt,De),rt=new rM(z,re,$t),st=new $S(zt),ot=new vw(L,N,qt,re,bt,st),_t=new Vw(L,zt),yt=new Mw,et=new Rw(qt),B=new VS(L,N,wt,ut,p,l),mt=new Dw(L,ut,re),Gt=new Gw(z,De,re,wt),nt=new HS(z,qt,De),At=new iM(z,qt,De),De.programs=ot.programs,L.capabilities=re,L.extensions=qt,L.properties=zt,L.renderLists=yt,L.shadowMap=mt,L.state=wt,L.info=De}x!==Jn&&(P=new lM(x,e.width,e.height,a,s,r));let ct=new Md(L,z);this.xr=ct,this.getContext=function(){return z},this.getContextAttributes=function(){return z.getContextAttributes()},this.forceContextLoss=function(){let R=qt.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=qt.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return Mt},this.setPixelRatio=function(R){R!==void 0&&(Mt=R,this.setSize(gt,St,!1))},this.getSize=function(R){return R.set(gt,St)},this.setSize=function(R,G,j=!0){if(ct.isPresenting){Xt("WebGLRenderer: Can't change size while VR device is presenting.");return}gt=R,St=G,e.width=Math.floor(R*Mt),e.height=Math.floor(G*Mt),j===!0&&(e.style.width=R+"px",e.style.height=G+"px"),P!==null&&P.setSize(e.width,e.height),this.setViewport(0,0,R,G)},this.getDrawingBufferSize=function(R){return R.set(gt*Mt,St*Mt).floor()},this.setDrawingBufferSize=function(R,G,j){gt=R,St=G,Mt=j,e.width=Math.floor(R*j),e.height=Math.floor(G*j),this.setViewport(0,0,R,G)},this.setEffects=function(R){if(x===Jn){jt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(R){for(let G=0;G<R.length;G++)if(R[G].isOutputPass===!0){Xt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}P.setEffects(R||[])},this.getCurrentViewport=function(R){return R.copy(it)},this.getViewport=function(R){return R.copy(Vt)},this.setViewport=function(R,G,j,Y){R.isVector4?Vt.set(R.x,R.y,R.z,R.w):Vt.set(R,G,j,Y),wt.viewport(it.copy(Vt).multiplyScalar(cn()).round())},this.getScissor=function(R){return R.copy(ue)},this.setScissor=function(R,G,j,Y){R.isVector4?ue.set(R.x,R.y,R.z,R.w):ue.set(R,G,j,Y),wt.scissor(ft.copy(ue).multiplyScalar(cn()).round())},this.getScissorTest=function(){return ae},this.setScissorTest=function(R){wt.setScissorTest(ae=R)},this.setOpaqueSort=function(R){Ht=R},this.setTransparentSort=function(R){se=R},this.getClearColor=function(R){return R.copy(B.getClearColor())},this.setClearColor=function(){B.setClearColor(...arguments)},this.getClearAlpha=function(){return B.getClearAlpha()},this.setClearAlpha=function(){B.setClearAlpha(...arguments)},this.clear=function(R=!0,G=!0,j=!0){let Y=0;if(R){let K=!1;if(lt!==null){let Et=lt.texture.format;K=m.has(Et)}if(K){let Et=lt.texture.type,Pt=g.has(Et),Tt=B.getClearColor(),It=B.getClearAlpha(),Bt=Tt.r,te=Tt.g,he=Tt.b;Pt?(_[0]=Bt,_[1]=te,_[2]=he,_[3]=It,z.clearBufferuiv(z.COLOR,0,_)):(w[0]=Bt,w[1]=te,w[2]=he,w[3]=It,z.clearBufferiv(z.COLOR,0,w))}else Y|=z.COLOR_BUFFER_BIT}G&&(Y|=z.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(Y|=z.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&z.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(R){R.setRenderer(this),F=R},this.dispose=function(){e.removeEventListener("webglcontextlost",Ft,!1),e.removeEventListener("webglcontextrestored",Jt,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),B.dispose(),yt.dispose(),et.dispose(),$t.dispose(),zt.dispose(),N.dispose(),ut.dispose(),q.dispose(),bt.dispose(),Gt.dispose(),ot.dispose(),ct.dispose(),ct.removeEventListener("sessionstart",tl),ct.removeEventListener("sessionend",Ui),Qi.stop()};function Ft(R){R.preventDefault(),rd("WebGLRenderer: Context Lost."),I=!0}function Jt(){rd("WebGLRenderer: Context Restored."),I=!1;let R=De.autoReset,G=mt.enabled,j=mt.autoUpdate,Y=mt.needsUpdate,K=mt.type;Kt(),De.autoReset=R,mt.enabled=G,mt.autoUpdate=j,mt.needsUpdate=Y,mt.type=K}function Ct(R){jt("WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function oe(R){let G=R.target;G.removeEventListener("dispose",oe),ze(G)}function ze(R){zn(R),zt.remove(R)}function zn(R){let G=zt.get(R).programs;G!==void 0&&(G.forEach(function(j){ot.releaseProgram(j)}),R.isShaderMaterial&&ot.releaseShaderCache(R))}this.renderBufferDirect=function(R,G,j,Y,K,Et){G===null&&(G=gn);let Pt=K.isMesh&&K.matrixWorld.determinantAffine()<0,Tt=Go(R,G,j,Y,K);wt.setMaterial(Y,Pt);let It=j.index,Bt=1;if(Y.wireframe===!0){if(It=q.getWireframeAttribute(j),It===void 0)return;Bt=2}let te=j.drawRange,he=j.attributes.position,kt=te.start*Bt,de=(te.start+te.count)*Bt;Et!==null&&(kt=Math.max(kt,Et.start*Bt),de=Math.min(de,(Et.start+Et.count)*Bt)),It!==null?(kt=Math.max(kt,0),de=Math.min(de,It.count)):he!=null&&(kt=Math.max(kt,0),de=Math.min(de,he.count));let Ze=de-kt;if(Ze<0||Ze===1/0)return;bt.setup(K,Y,Tt,j,It);let Te,Ce=nt;if(It!==null&&(Te=T.get(It),Ce=At,Ce.setIndex(Te)),K.isMesh)Y.wireframe===!0?(wt.setLineWidth(Y.wireframeLinewidth*cn()),Ce.setMode(z.LINES)):Ce.setMode(z.TRIANGLES);else if(K.isLine){let xn=Y.linewidth;xn===void 0&&(xn=1),wt.setLineWidth(xn*cn()),K.isLineSegments?Ce.setMode(z.LINES):K.isLineLoop?Ce.setMode(z.LINE_LOOP):Ce.setMode(z.LINE_STRIP)}else K.isPoints?Ce.setMode(z.POINTS):K.isSprite&&Ce.setMode(z.TRIANGLES);if(K.isBatchedMesh)if(qt.get("WEBGL_multi_draw"))Ce.renderMultiDraw(K._multiDrawStarts,K._multiDrawCounts,K._multiDrawCount);else{let xn=K._multiDrawStarts,Ut=K._multiDrawCounts,un=K._multiDrawCount,ge=It?T.get(It).bytesPerElement:1,es=zt.get(Y).currentProgram.getUniforms();for(let hn=0;hn<un;hn++)es.setValue(z,"_gl_DrawID",hn),Ce.render(xn[hn]/ge,Ut[hn])}else if(K.isInstancedMesh)Ce.renderInstances(kt,Ze,K.count);else if(j.isInstancedBufferGeometry){let xn=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Ut=Math.min(j.instanceCount,xn);Ce.renderInstances(kt,Ze,Ut)}else Ce.render(kt,Ze)};function Bo(R,G,j,Y){F!==null&&R.isNodeMaterial&&F.setObject(Y,R),Fe===!0&&st.setState(R,j,!1),R.transparent===!0&&R.side===kn&&R.forceSinglePass===!1?(R.side=Yn,R.needsUpdate=!0,Oi(R,G,Y),R.side=$s,R.needsUpdate=!0,Oi(R,G,Y),R.side=kn):Oi(R,G,Y)}this.compile=function(R,G,j=null){j===null&&(j=R),F!==null&&F.renderStart(R,G,j),A=et.get(j),A.init(G),M.push(A),j.traverseVisible(function(K){K.isLight&&K.layers.test(G.layers)&&(A.pushLight(K),K.castShadow&&A.pushShadow(K))}),R!==j&&R.traverseVisible(function(K){K.isLight&&K.layers.test(G.layers)&&(A.pushLight(K),K.castShadow&&A.pushShadow(K))}),A.setupLights(),F!==null&&F.updateLights(A.state.lightsArray),ln=this.localClippingEnabled,Fe=st.init(this.clippingPlanes,ln),Fe===!0&&st.setGlobalState(this.clippingPlanes,G),F!==null&&mt.render(A.state.shadowsArray,j,G);let Y=new Set;return R.traverse(function(K){if(!(K.isMesh||K.isPoints||K.isLine||K.isSprite))return;let Et=K.material;if(Et)if(Array.isArray(Et))for(let Pt=0;Pt<Et.length;Pt++){let Tt=Et[Pt];Bo(Tt,j,G,K),Y.add(Tt)}else Bo(Et,j,G,K),Y.add(Et)}),A=M.pop(),F!==null&&F.renderEnd(),Y},this.compileAsync=function(R,G,j=null){let Y=this.compile(R,G,j);return new Promise(K=>{function Et(){if(Y.forEach(function(Pt){let It=zt.get(Pt).currentProgram;(It===void 0||It.isReady())&&Y.delete(Pt)}),Y.size===0){K(R);return}setTimeout(Et,10)}qt.get("KHR_parallel_shader_compile")!==null?Et():setTimeout(Et,10)})};let Ar=null;function Xu(R){Ar&&Ar(R)}function tl(){Qi.stop()}function Ui(){Qi.start()}let Qi=new qm;Qi.setAnimationLoop(Xu),typeof self<"u"&&Qi.setContext(self),this.setAnimationLoop=function(R){Ar=R,ct.setAnimationLoop(R),R===null?Qi.stop():Qi.start()},ct.addEventListener("sessionstart",tl),ct.addEventListener("sessionend",Ui),this.render=function(R,G){if(G!==void 0&&G.isCamera!==!0){jt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;F!==null&&F.renderStart(R,G);let j=ct.enabled===!0&&ct.isPresenting===!0,Y=P!==null&&(lt===null||j)&&P.begin(L,lt);if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),G.parent===null&&G.matrixWorldAutoUpdate===!0&&G.updateMatrixWorld(),ct.enabled===!0&&ct.isPresenting===!0&&(P===null||P.isCompositing()===!1)&&(ct.cameraAutoUpdate===!0&&ct.updateCamera(G),G=ct.getCamera()),R.isScene===!0&&R.onBeforeRender(L,R,G,lt),A=et.get(R,M.length),A.init(G),A.state.textureUnits=$t.getTextureUnits(),M.push(A),Le.multiplyMatrices(G.projectionMatrix,G.matrixWorldInverse),G.isArrayCamera?Xe.setFromArrayCamera(G):ne.setFromProjectionMatrix(Le,_i,G.reversedDepth),ln=this.localClippingEnabled,Fe=st.init(this.clippingPlanes,ln),E=yt.get(R,y.length),E.init(),y.push(E),this.info.render.frame++,ct.enabled===!0&&ct.isPresenting===!0){let Pt=L.xr.getDepthSensingMesh();Pt!==null&&ts(Pt,G,-1/0,L.sortObjects)}ts(R,G,0,L.sortObjects),E.finish(),F!==null&&F.updateLights(A.state.lightsArray),L.sortObjects===!0&&E.sort(Ht,se),Ke=ct.enabled===!1||ct.isPresenting===!1||ct.hasDepthSensing()===!1,Ke&&B.addToRenderList(E,R),this.info.autoReset===!0&&this.info.reset(),Fe===!0&&st.beginShadows();let K=A.state.shadowsArray;if(mt.render(K,R,G),Fe===!0&&st.endShadows(),(Y&&P.hasRenderPass())===!1){let Pt=E.opaque,Tt=E.transmissive;if(A.setupLights(),G.isArrayCamera){let It=G.cameras;if(Tt.length>0)for(let Bt=0,te=It.length;Bt<te;Bt++){let he=It[Bt];Si(Pt,Tt,R,he)}Ke&&B.render(R);for(let Bt=0,te=It.length;Bt<te;Bt++){let he=It[Bt];zo(E,R,he,he.viewport)}}else Tt.length>0&&Si(Pt,Tt,R,G),Ke&&B.render(R),zo(E,R,G)}lt!==null&&H===0&&($t.updateMultisampleRenderTarget(lt),$t.updateRenderTargetMipmap(lt)),Y&&P.end(L),R.isScene===!0&&R.onAfterRender(L,R,G),bt.resetDefaultState(),Z=-1,Q=null,M.pop(),M.length>0?(A=M[M.length-1],$t.setTextureUnits(A.state.textureUnits),Fe===!0&&st.setGlobalState(L.clippingPlanes,A.state.camera)):A=null,y.pop(),y.length>0?E=y[y.length-1]:E=null,F!==null&&F.renderEnd()};function ts(R,G,j,Y){if(R.visible===!1)return;if(R.layers.test(G.layers)){if(R.isGroup)j=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(G);else if(R.isLight)A.pushLight(R),R.castShadow&&A.pushShadow(R);else if(R.isSprite){let Pt=G.isArrayCamera?Xe:ne;if(!R.frustumCulled||R.intersectsFrustum(Pt)){Y&&ye.setFromMatrixPosition(R.matrixWorld).applyMatrix4(Le);let Tt=ut.update(R),It=R.material;It.visible&&E.push(R,Tt,It,j,ye.z,null,G)}}else if(R.isMesh||R.isLine||R.isPoints){let Pt=G.isArrayCamera?Xe:ne;if(!R.frustumCulled||R.intersectsFrustum(Pt)){let Tt=ut.update(R),It=R.material;if(Y&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),ye.copy(R.boundingSphere.center)):(Tt.boundingSphere===null&&Tt.computeBoundingSphere(),ye.copy(Tt.boundingSphere.center)),ye.applyMatrix4(R.matrixWorld).applyMatrix4(Le)),Array.isArray(It)){let Bt=Tt.groups;for(let te=0,he=Bt.length;te<he;te++){let kt=Bt[te],de=It[kt.materialIndex];de&&de.visible&&E.push(R,Tt,de,j,ye.z,kt,G)}}else It.visible&&E.push(R,Tt,It,j,ye.z,null,G)}}}let Et=R.children;for(let Pt=0,Tt=Et.length;Pt<Tt;Pt++)ts(Et[Pt],G,j,Y)}function zo(R,G,j,Y){let{opaque:K,transmissive:Et,transparent:Pt}=R;A.setupLightsView(j),Fe===!0&&st.setGlobalState(L.clippingPlanes,j),Y&&wt.viewport(it.copy(Y)),K.length>0&&Je(K,G,j),Et.length>0&&Je(Et,G,j),Pt.length>0&&Je(Pt,G,j),wt.buffers.depth.setTest(!0),wt.buffers.depth.setMask(!0),wt.buffers.color.setMask(!0),wt.setPolygonOffset(!1)}function Si(R,G,j,Y){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[Y.id]===void 0){let kt=qt.has("EXT_color_buffer_half_float")||qt.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[Y.id]=new ci(1,1,{generateMipmaps:!0,type:kt?Pi:Jn,minFilter:gs,samples:Math.max(4,re.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:xe.workingColorSpace})}let Et=A.state.transmissionRenderTarget[Y.id],Pt=Y.viewport||it;Et.setSize(Pt.z*L.transmissionResolutionScale,Pt.w*L.transmissionResolutionScale);let Tt=L.getRenderTarget(),It=L.getActiveCubeFace(),Bt=L.getActiveMipmapLevel();L.setRenderTarget(Et),L.getClearColor(tt),ht=L.getClearAlpha(),ht<1&&L.setClearColor(16777215,.5),L.clear(),Ke&&B.render(j);let te=L.toneMapping;L.toneMapping=qi;let he=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),A.setupLightsView(Y),Fe===!0&&st.setGlobalState(L.clippingPlanes,Y),Je(R,j,Y),$t.updateMultisampleRenderTarget(Et),$t.updateRenderTargetMipmap(Et),qt.has("WEBGL_multisampled_render_to_texture")===!1){let kt=!1;for(let de=0,Ze=G.length;de<Ze;de++){let Te=G[de],{object:Ce,geometry:xn,material:Ut,group:un}=Te;if(Ut.side===kn&&Ce.layers.test(Y.layers)){let ge=Ut.side;Ut.side=Yn,Ut.needsUpdate=!0,sn(Ce,j,Y,xn,Ut,un),Ut.side=ge,Ut.needsUpdate=!0,kt=!0}}kt===!0&&($t.updateMultisampleRenderTarget(Et),$t.updateRenderTargetMipmap(Et))}L.setRenderTarget(Tt,It,Bt),L.setClearColor(tt,ht),he!==void 0&&(Y.viewport=he),L.toneMapping=te}function Je(R,G,j){let Y=G.isScene===!0?G.overrideMaterial:null;for(let K=0,Et=R.length;K<Et;K++){let Pt=R[K],{object:Tt,geometry:It,group:Bt}=Pt,te=Pt.material;te.allowOverride===!0&&Y!==null&&(te=Y),Tt.layers.test(j.layers)&&sn(Tt,G,j,It,te,Bt)}}function sn(R,G,j,Y,K,Et){F!==null&&K.isNodeMaterial&&F.setObject(R,K),R.onBeforeRender(L,G,j,Y,K,Et),R.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),K.onBeforeRender(L,G,j,Y,R,Et),K.transparent===!0&&K.side===kn&&K.forceSinglePass===!1?(K.side=Yn,K.needsUpdate=!0,L.renderBufferDirect(j,G,Y,K,R,Et),K.side=$s,K.needsUpdate=!0,L.renderBufferDirect(j,G,Y,K,R,Et),K.side=kn):L.renderBufferDirect(j,G,Y,K,R,Et),R.onAfterRender(L,G,j,Y,K,Et)}function rn(R){let G=0;for(let j of R)j.texture!==null&&G++;return G}function Oi(R,G,j){G.isScene!==!0&&(G=gn);let Y=zt.get(R),K=A.state.lights,Et=A.state.shadowsArray,Pt=K.state.version,Tt=ot.getParameters(R,K.state,Et,G,j,A.state.lightProbeGridArray),It=ot.getProgramCacheKey(Tt),Bt=Y.programs;Y.environment=R.isMeshStandardMaterial||R.isMeshLambertMaterial||R.isMeshPhongMaterial?G.environment:null,Y.fog=G.fog;let te=R.isMeshStandardMaterial||R.isMeshLambertMaterial&&!R.envMap||R.isMeshPhongMaterial&&!R.envMap;Y.envMap=N.get(R.envMap||Y.environment,te),Y.envMapRotation=Y.environment!==null&&R.envMap===null?G.environmentRotation:R.envMapRotation,Bt===void 0&&(R.addEventListener("dispose",oe),Bt=new Map,Y.programs=Bt,Y.programVariants=new Map);let he=Bt.get(It);if(he!==void 0){if(Y.currentProgram===he&&Y.lightsStateVersion===Pt)return Vo(R,Tt),he}else Tt.uniforms=ot.getUniforms(R),F!==null&&R.isNodeMaterial&&F.build(R,j,Tt),R.onBeforeCompile(Tt,L),he=ot.acquireProgram(Tt,It),Bt.set(It,he),Y.uniforms=Tt.uniforms;let kt=Y.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(kt.clippingPlanes=st.uniform),Vo(R,Tt),Y.needsLights=Es(R),Y.lightsStateVersion=Pt,Y.needsLights&&(kt.ambientLightColor.value=K.state.ambient,kt.lightProbe.value=K.state.probe,kt.sunLights.value=K.state.sun,kt.sunLightShadows.value=K.state.sunShadow,kt.directionalLights.value=K.state.directional,kt.directionalLightShadows.value=K.state.directionalShadow,kt.spotLights.value=K.state.spot,kt.spotLightShadows.value=K.state.spotShadow,kt.rectAreaLights.value=K.state.rectArea,kt.ltc_1.value=K.state.rectAreaLTC1,kt.ltc_2.value=K.state.rectAreaLTC2,kt.pointLights.value=K.state.point,kt.pointLightShadows.value=K.state.pointShadow,kt.hemisphereLights.value=K.state.hemi,kt.sunShadowMatrix.value=K.state.sunShadowMatrix,kt.sunShadowCascade.value=K.state.sunShadowCascade,kt.directionalShadowMatrix.value=K.state.directionalShadowMatrix,kt.spotLightMatrix.value=K.state.spotLightMatrix,kt.spotLightMap.value=K.state.spotLightMap,kt.pointShadowMatrix.value=K.state.pointShadowMatrix),Y.numLightProbeGrids=rn(A.state.lightProbeGridArray),Y.currentProgram=he,Y.uniformsList=null,he}function ti(R,G,j,Y,K){let Et=zt.get(R),Pt=Et.currentProgram.id+","+Y+","+K,Tt=Et.programVariants.get(Pt);return Tt===void 0?(Tt=Oi(R,G,j),Et.programVariants.set(Pt,Tt)):(Et.currentProgram=Tt,Et.uniformsList=null,Et.outputColorSpace=Y,Et.toneMapping=K),Tt}function As(R){if(R.uniformsList===null){let G=R.currentProgram.getUniforms();R.uniformsList=mo.seqWithValue(G.seq,R.uniforms)}return R.uniformsList}function Vo(R,G){let j=zt.get(R);j.outputColorSpace=G.outputColorSpace,j.batching=G.batching,j.batchingColor=G.batchingColor,j.instancing=G.instancing,j.instancingColor=G.instancingColor,j.instancingMorph=G.instancingMorph,j.skinning=G.skinning,j.morphTargets=G.morphTargets,j.morphNormals=G.morphNormals,j.morphColors=G.morphColors,j.morphTargetsCount=G.morphTargetsCount,j.numClippingPlanes=G.numClippingPlanes,j.numIntersection=G.numClipIntersection,j.vertexAlphas=G.vertexAlphas,j.vertexTangents=G.vertexTangents,j.toneMapping=G.toneMapping}function Go(R,G,j,Y,K){G.isScene!==!0&&(G=gn),$t.resetTextureUnits();let Et=G.fog,Pt=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?G.environment:null,Tt=lt===null?L.outputColorSpace:lt.isXRRenderTarget===!0?lt.texture.colorSpace:xe.workingColorSpace,It=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,Bt=N.get(Y.envMap||Pt,It),te=Y.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,he=!!j.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),kt=!!j.morphAttributes.position,de=!!j.morphAttributes.normal,Ze=!!j.morphAttributes.color,Te=qi;Y.toneMapped&&(lt===null||lt.isXRRenderTarget===!0)&&(Te=L.toneMapping);let Ce=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,xn=Ce!==void 0?Ce.length:0,Ut=zt.get(Y),un=A.state.lights;if(Fe===!0&&(ln===!0||R!==Q)){let Re=R===Q&&Y.id===Z;st.setState(Y,R,Re)}let ge=!1,es=!1;Y.version===Ut.__version?Ut.needsLights&&Ut.lightsStateVersion!==un.state.version||K.isBatchedMesh&&Ut.batching===!1||!K.isBatchedMesh&&Ut.batching===!0||K.isBatchedMesh&&Ut.batchingColor===!0&&K._colorsTexture===null||K.isBatchedMesh&&Ut.batchingColor===!1&&K._colorsTexture!==null||K.isInstancedMesh&&Ut.instancing===!1||!K.isInstancedMesh&&Ut.instancing===!0||K.isSkinnedMesh&&Ut.skinning===!1||!K.isSkinnedMesh&&Ut.skinning===!0||K.isInstancedMesh&&Ut.instancingColor===!0&&K.instanceColor===null||K.isInstancedMesh&&Ut.instancingColor===!1&&K.instanceColor!==null||K.isInstancedMesh&&Ut.instancingMorph===!0&&K.morphTexture===null||K.isInstancedMesh&&Ut.instancingMorph===!1&&K.morphTexture!==null||Ut.envMap!==Bt||Y.fog===!0&&Ut.fog!==Et||Ut.numClippingPlanes!==void 0&&(Ut.numClippingPlanes!==st.numPlanes||Ut.numIntersection!==st.numIntersection)||Ut.vertexAlphas!==te||Ut.vertexTangents!==he||Ut.morphTargets!==kt||Ut.morphNormals!==de||Ut.morphColors!==Ze||Ut.morphTargetsCount!==xn||Ut.numLightProbeGrids!==rn(A.state.lightProbeGridArray)?ge=!0:(Ut.outputColorSpace!==Tt||Ut.toneMapping!==Te)&&(es=!0):(ge=!0,Ut.__version=Y.version);let hn=Ut.currentProgram;(ge===!0||es===!0)&&(hn=es===!0?ti(Y,G,K,Tt,Te):Oi(Y,G,K),F&&Y.isNodeMaterial&&F.onUpdateProgram(Y,hn,Ut));let Cr=!1,Fi=!1,ns=!1,le=hn.getUniforms(),je=Ut.uniforms;if(wt.useProgram(hn.program)&&(Cr=!0,Fi=!0,ns=!0),Y.id!==Z&&(Z=Y.id,Fi=!0),Cr||Q!==R){wt.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),le.setValue(z,"projectionMatrix",R.projectionMatrix),le.setValue(z,"viewMatrix",R.matrixWorldInverse);let dn=le.map.cameraPosition;dn!==void 0&&dn.setValue(z,wn.setFromMatrixPosition(R.matrixWorld)),re.logarithmicDepthBuffer&&le.setValue(z,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&le.setValue(z,"isOrthographic",R.isOrthographicCamera===!0),Q!==R&&(Q=R,Fi=!0,ns=!0)}if(Ut.needsLights&&(un.state.sunShadowMap.length>0&&le.setValue(z,"sunShadowMap",un.state.sunShadowMap,$t),un.state.directionalShadowMap.length>0&&le.setValue(z,"directionalShadowMap",un.state.directionalShadowMap,$t),un.state.spotShadowMap.length>0&&le.setValue(z,"spotShadowMap",un.state.spotShadowMap,$t),un.state.pointShadowMap.length>0&&le.setValue(z,"pointShadowMap",un.state.pointShadowMap,$t)),K.isSkinnedMesh){le.setOptional(z,K,"bindMatrix"),le.setOptional(z,K,"bindMatrixInverse");let Re=K.skeleton;Re&&(Re.boneTexture===null&&Re.computeBoneTexture(),le.setValue(z,"boneTexture",Re.boneTexture,$t))}K.isBatchedMesh&&(le.setOptional(z,K,"batchingTexture"),le.setValue(z,"batchingTexture",K._matricesTexture,$t),le.setOptional(z,K,"batchingIdTexture"),le.setValue(z,"batchingIdTexture",K._indirectTexture,$t),le.setOptional(z,K,"batchingColorTexture"),K._colorsTexture!==null&&le.setValue(z,"batchingColorTexture",K._colorsTexture,$t));let Vn=j.morphAttributes;if((Vn.position!==void 0||Vn.normal!==void 0||Vn.color!==void 0)&&rt.update(K,j,hn),(Fi||Ut.receiveShadow!==K.receiveShadow)&&(Ut.receiveShadow=K.receiveShadow,le.setValue(z,"receiveShadow",K.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&G.environment!==null&&(je.envMapIntensity.value=G.environmentIntensity),je.dfgLUT!==void 0&&(je.dfgLUT.value=Ww()),Fi){if(le.setValue(z,"toneMappingExposure",L.toneMappingExposure),Ut.needsLights&&Er(je,ns),Et&&Y.fog===!0&&_t.refreshFogUniforms(je,Et),_t.refreshMaterialUniforms(je,Y,Mt,St,A.state.transmissionRenderTarget[R.id]),Ut.needsLights&&Ut.numLightProbeGrids>0){let Re=v,dn=0;for(let Dn of A.state.lightProbeGridArray)Dn.texture!==null&&(Re.textures[dn]=Dn.texture,Re.min[dn]=Dn.boundingBox.min,Re.max[dn]=Dn.boundingBox.max,Re.resolution[dn]=Dn.resolution,dn++);for(let Dn in Re)Re[Dn].length=dn;je.probesSH.value=Re.textures,je.probesMin.value=Re.min,je.probesMax.value=Re.max,je.probesResolution.value=Re.resolution}mo.upload(z,As(Ut),je,$t)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(mo.upload(z,As(Ut),je,$t),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&le.setValue(z,"center",K.center),le.setValue(z,"modelViewMatrix",K.modelViewMatrix),le.setValue(z,"normalMatrix",K.normalMatrix),le.setValue(z,"modelMatrix",K.matrixWorld),Y.uniformsGroups!==void 0){let Re=Y.uniformsGroups;for(let dn=0,Dn=Re.length;dn<Dn;dn++){let el=Re[dn];Gt.update(el,hn),Gt.bind(el,hn)}}return hn}function Er(R,G){R.ambientLightColor.needsUpdate=G,R.lightProbe.needsUpdate=G,R.sunLights.needsUpdate=G,R.sunLightShadows.needsUpdate=G,R.directionalLights.needsUpdate=G,R.directionalLightShadows.needsUpdate=G,R.pointLights.needsUpdate=G,R.pointLightShadows.needsUpdate=G,R.spotLights.needsUpdate=G,R.spotLightShadows.needsUpdate=G,R.rectAreaLights.needsUpdate=G,R.hemisphereLights.needsUpdate=G}function Es(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return X},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return lt},this.setRenderTargetTextures=function(R,G,j){let Y=zt.get(R);Y.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),zt.get(R.texture).__webglTexture=G,zt.get(R.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:j,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,G){let j=zt.get(R);j.__webglFramebuffer=G,j.__useDefaultFramebuffer=G===void 0},this.setRenderTarget=function(R,G=0,j=0){lt=R,X=G,H=j;let Y=null,K=!1,Et=!1;if(R){let Tt=zt.get(R);if(Tt.__useDefaultFramebuffer!==void 0){wt.bindFramebuffer(z.FRAMEBUFFER,Tt.__webglFramebuffer),it.copy(R.viewport),ft.copy(R.scissor),dt=R.scissorTest,wt.viewport(it),wt.scissor(ft),wt.setScissorTest(dt),Z=-1;return}else if(Tt.__webglFramebuffer===void 0)$t.setupRenderTarget(R);else if(Tt.__hasExternalTextures)$t.rebindTextures(R,zt.get(R.texture).__webglTexture,zt.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let te=R.depthTexture;if(Tt.__boundDepthTexture!==te){if(te!==null&&zt.has(te)&&(R.width!==te.image.width||R.height!==te.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");$t.setupDepthRenderbuffer(R)}}let It=R.texture;(It.isData3DTexture||It.isDataArrayTexture||It.isCompressedArrayTexture)&&(Et=!0);let Bt=zt.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray(Bt[G])?Y=Bt[G][j]:Y=Bt[G],K=!0):R.samples>0&&$t.useMultisampledRTT(R)===!1?Y=zt.get(R).__webglMultisampledFramebuffer:Array.isArray(Bt)?Y=Bt[j]:Y=Bt,it.copy(R.viewport),ft.copy(R.scissor),dt=R.scissorTest}else it.copy(Vt).multiplyScalar(Mt).floor(),ft.copy(ue).multiplyScalar(Mt).floor(),dt=ae;if(j!==0&&(Y=k),wt.bindFramebuffer(z.FRAMEBUFFER,Y)&&wt.drawBuffers(R,Y),wt.viewport(it),wt.scissor(ft),wt.setScissorTest(dt),K){let Tt=zt.get(R.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_CUBE_MAP_POSITIVE_X+G,Tt.__webglTexture,j)}else if(Et){let Tt=G;for(let It=0;It<R.textures.length;It++){let Bt=zt.get(R.textures[It]);z.framebufferTextureLayer(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0+It,Bt.__webglTexture,j,Tt)}}else if(R!==null&&j!==0){let Tt=zt.get(R.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,Tt.__webglTexture,j)}Z=-1};function Tr(R){let G=zt.get(R);return(G.__readFormat!==R.format||G.__readType!==R.type)&&(G.__readFormat=R.format,G.__readType=R.type,G.__formatReadable=re.textureFormatReadable(R.format),G.__typeReadable=re.textureTypeReadable(R.type)),G}this.readRenderTargetPixels=function(R,G,j,Y,K,Et,Pt,Tt=0){if(!(R&&R.isWebGLRenderTarget)){jt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let It=zt.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Pt!==void 0&&(It=It[Pt],Array.isArray(It)&&(It=It[0])),It){wt.bindFramebuffer(z.FRAMEBUFFER,It);try{let Bt=R.textures[Tt],te=Bt.format,he=Bt.type;R.textures.length>1&&z.readBuffer(z.COLOR_ATTACHMENT0+Tt);let kt=Tr(Bt);if(kt.__formatReadable===!1){jt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(kt.__typeReadable===!1){jt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}G>=0&&G<=R.width-Y&&j>=0&&j<=R.height-K&&z.readPixels(G,j,Y,K,xt.convert(te),xt.convert(he),Et)}finally{let Bt=lt!==null?zt.get(lt).__webglFramebuffer:null;wt.bindFramebuffer(z.FRAMEBUFFER,Bt)}}},this.readRenderTargetPixelsAsync=async function(R,G,j,Y,K,Et,Pt,Tt=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let It=zt.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Pt!==void 0&&(It=It[Pt],Array.isArray(It)&&(It=It[0])),It)if(G>=0&&G<=R.width-Y&&j>=0&&j<=R.height-K){wt.bindFramebuffer(z.FRAMEBUFFER,It);let Bt=R.textures[Tt],te=Bt.format,he=Bt.type;R.textures.length>1&&z.readBuffer(z.COLOR_ATTACHMENT0+Tt);let kt=Tr(Bt);if(kt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(kt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let de=z.createBuffer();z.bindBuffer(z.PIXEL_PACK_BUFFER,de),z.bufferData(z.PIXEL_PACK_BUFFER,Et.byteLength,z.STREAM_READ),z.readPixels(G,j,Y,K,xt.convert(te),xt.convert(he),0),z.bindBuffer(z.PIXEL_PACK_BUFFER,null);let Ze=lt!==null?zt.get(lt).__webglFramebuffer:null;wt.bindFramebuffer(z.FRAMEBUFFER,Ze);let Te=z.fenceSync(z.SYNC_GPU_COMMANDS_COMPLETE,0);return z.flush(),await _m(z,Te,4),z.bindBuffer(z.PIXEL_PACK_BUFFER,de),z.getBufferSubData(z.PIXEL_PACK_BUFFER,0,Et),z.bindBuffer(z.PIXEL_PACK_BUFFER,null),z.deleteBuffer(de),z.deleteSync(Te),Et}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,G=null,j=0){let Y=Math.pow(2,-j),K=Math.floor(R.image.width*Y),Et=Math.floor(R.image.height*Y),Pt=G!==null?G.x:0,Tt=G!==null?G.y:0;$t.setTexture2D(R,0),z.copyTexSubImage2D(z.TEXTURE_2D,j,0,0,Pt,Tt,K,Et),wt.unbindTexture()},this.copyTextureToTexture=function(R,G,j=null,Y=null,K=0,Et=0){let Pt,Tt,It,Bt,te,he,kt,de,Ze,Te=R.isCompressedTexture?R.mipmaps[Et]:R.image;if(j!==null)Pt=j.max.x-j.min.x,Tt=j.max.y-j.min.y,It=j.isBox3?j.max.z-j.min.z:1,Bt=j.min.x,te=j.min.y,he=j.isBox3?j.min.z:0;else{let le=Math.pow(2,-K);Pt=Math.floor(Te.width*le),Tt=Math.floor(Te.height*le),R.isDataArrayTexture?It=Te.depth:R.isData3DTexture?It=Math.floor(Te.depth*le):It=1,Bt=0,te=0,he=0}Y!==null?(kt=Y.x,de=Y.y,Ze=Y.z):(kt=0,de=0,Ze=0);let Ce=xt.convert(G.format),xn=xt.convert(G.type),Ut;G.isData3DTexture?($t.setTexture3D(G,0),Ut=z.TEXTURE_3D):G.isDataArrayTexture||G.isCompressedArrayTexture?($t.setTexture2DArray(G,0),Ut=z.TEXTURE_2D_ARRAY):($t.setTexture2D(G,0),Ut=z.TEXTURE_2D),wt.activeTexture(z.TEXTURE0),wt.pixelStorei(z.UNPACK_FLIP_Y_WEBGL,G.flipY),wt.pixelStorei(z.UNPACK_PREMULTIPLY_ALPHA_WEBGL,G.premultiplyAlpha),wt.pixelStorei(z.UNPACK_ALIGNMENT,G.unpackAlignment);let un=wt.getParameter(z.UNPACK_ROW_LENGTH),ge=wt.getParameter(z.UNPACK_IMAGE_HEIGHT),es=wt.getParameter(z.UNPACK_SKIP_PIXELS),hn=wt.getParameter(z.UNPACK_SKIP_ROWS),Cr=wt.getParameter(z.UNPACK_SKIP_IMAGES);wt.pixelStorei(z.UNPACK_ROW_LENGTH,Te.width),wt.pixelStorei(z.UNPACK_IMAGE_HEIGHT,Te.height),wt.pixelStorei(z.UNPACK_SKIP_PIXELS,Bt),wt.pixelStorei(z.UNPACK_SKIP_ROWS,te),wt.pixelStorei(z.UNPACK_SKIP_IMAGES,he);let Fi=R.isDataArrayTexture||R.isData3DTexture,ns=G.isDataArrayTexture||G.isData3DTexture;if(R.isDepthTexture){let le=zt.get(R),je=zt.get(G),Vn=zt.get(le.__renderTarget),Re=zt.get(je.__renderTarget);wt.bindFramebuffer(z.READ_FRAMEBUFFER,Vn.__webglFramebuffer),wt.bindFramebuffer(z.DRAW_FRAMEBUFFER,Re.__webglFramebuffer);for(let dn=0;dn<It;dn++)Fi&&(z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,zt.get(R).__webglTexture,K,he+dn),z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,zt.get(G).__webglTexture,Et,Ze+dn)),z.blitFramebuffer(Bt,te,Bt+Pt,te+Tt,kt,de,kt+Pt,de+Tt,z.DEPTH_BUFFER_BIT,z.NEAREST);wt.bindFramebuffer(z.READ_FRAMEBUFFER,null),wt.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else if(K!==0||R.isRenderTargetTexture||zt.has(R)){let le=zt.get(R),je=zt.get(G);wt.bindFramebuffer(z.READ_FRAMEBUFFER,D),wt.bindFramebuffer(z.DRAW_FRAMEBUFFER,V);for(let Vn=0;Vn<It;Vn++)Fi?z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,le.__webglTexture,K,he+Vn):z.framebufferTexture2D(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,le.__webglTexture,K),ns?z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,je.__webglTexture,Et,Ze+Vn):z.framebufferTexture2D(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,je.__webglTexture,Et),K!==0?z.blitFramebuffer(Bt,te,Bt+Pt,te+Tt,kt,de,kt+Pt,de+Tt,z.COLOR_BUFFER_BIT,z.NEAREST):ns?z.copyTexSubImage3D(Ut,Et,kt,de,Ze+Vn,Bt,te,Pt,Tt):z.copyTexSubImage2D(Ut,Et,kt,de,Bt,te,Pt,Tt);wt.bindFramebuffer(z.READ_FRAMEBUFFER,null),wt.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else ns?R.isDataTexture||R.isData3DTexture?z.texSubImage3D(Ut,Et,kt,de,Ze,Pt,Tt,It,Ce,xn,Te.data):G.isCompressedArrayTexture?z.compressedTexSubImage3D(Ut,Et,kt,de,Ze,Pt,Tt,It,Ce,Te.data):z.texSubImage3D(Ut,Et,kt,de,Ze,Pt,Tt,It,Ce,xn,Te):R.isDataTexture?z.texSubImage2D(z.TEXTURE_2D,Et,kt,de,Pt,Tt,Ce,xn,Te.data):R.isCompressedTexture?z.compressedTexSubImage2D(z.TEXTURE_2D,Et,kt,de,Te.width,Te.height,Ce,Te.data):z.texSubImage2D(z.TEXTURE_2D,Et,kt,de,Pt,Tt,Ce,xn,Te);wt.pixelStorei(z.UNPACK_ROW_LENGTH,un),wt.pixelStorei(z.UNPACK_IMAGE_HEIGHT,ge),wt.pixelStorei(z.UNPACK_SKIP_PIXELS,es),wt.pixelStorei(z.UNPACK_SKIP_ROWS,hn),wt.pixelStorei(z.UNPACK_SKIP_IMAGES,Cr),Et===0&&G.generateMipmaps===!0&&G.mipmapsAutoUpdate===!0&&z.generateMipmap(Ut),wt.unbindTexture()},this.initRenderTarget=function(R){zt.get(R).__webglFramebuffer===void 0&&$t.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?$t.setTextureCube(R,0):R.isData3DTexture?$t.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?$t.setTexture2DArray(R,0):$t.setTexture2D(R,0),wt.unbindTexture()},this.resetState=function(){X=0,H=0,lt=null,wt.reset(),bt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return _i}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=xe._getDrawingBufferColorSpace(t),e.unpackColorSpace=xe._getUnpackColorSpace()}};function mr(n){let t=new ms;return n===0||(t.onBeforeCompile=e=>{e.vertexShader=e.vertexShader.replace("#include <project_vertex>",`#include <project_vertex>
      vec4 pulled = vec4(mvPosition.xyz - normalize(mvPosition.xyz) * ${n.toExponential()}, 1.0);
      vec4 nearPosition = projectionMatrix * pulled;
      gl_Position.z = nearPosition.z / nearPosition.w * gl_Position.w;`)},t.customProgramCacheKey=()=>`nearer ${n}`),t}function xo(n,t,e,i,s,r){let o=n[e]-n[t],a=n[e+1]-n[t+1],l=n[e+2]-n[t+2],c=Math.hypot(o,a,l)||1e-12;o/=c,a/=c,l/=c;let u=Math.abs(l)<.9,[h,d,f]=u?[a,-o,0]:[0,l,-a],p=Math.hypot(h,d,f);h/=p,d/=p,f/=p,s[r]=i*h,s[r+1]=i*d,s[r+2]=i*f,s[r+4]=c*o,s[r+5]=c*a,s[r+6]=c*l,s[r+8]=i*(d*l-f*a),s[r+9]=i*(f*o-h*l),s[r+10]=i*(h*a-d*o);for(let x=0;x<3;x++)s[r+12+x]=(n[t+x]+n[e+x])/2;s[r+15]=1}var nu="#d55e00",iu="#0072b2",sg=["#e2cf9f","#c5bcd9","#b7cfa2","#d6aeb9","#9cc4dd","#cfcfcf"];function za(n){return sg[n%sg.length]}var $w=["#453781","#39568c","#2d708e","#20908d","#29af7f","#73d055","#b8de29","#fde725"],Xw=["#00224e","#083370","#35456c","#4f576c","#666970","#7d7c78","#948e77","#aea371","#c8b866","#e5cf52","#fee838"],qw=["#ffffcc","#ffeda0","#fed976","#feb24c","#fd8c3c","#fc4d2a","#e2191c","#bb0026","#800026"];function wd(n){let t=n.map(i=>[1,3,5].map(s=>parseInt(i.slice(s,s+2),16)/255));function e(i,s=[0,0,0]){let r=Math.min(1,Math.max(0,i))*(n.length-1),o=Math.min(n.length-2,Math.floor(r));for(let a=0;a<3;a++){let l=t[o][a];s[a]=l+(r-o)*(t[o+1][a]-l)}return s}return{at:e,gradient:`linear-gradient(to right, ${n.join(", ")})`}}var _o=wd($w),og=wd(Xw),su=wd(qw);function Be(n){return getComputedStyle(document.documentElement).getPropertyValue(n).trim()}function qs(n){let t=matchMedia("(prefers-color-scheme: dark)");return t.addEventListener("change",n),()=>t.removeEventListener("change",n)}var rg=[[],[8,4],[8,3,2,3],[2,3]],Yw=7;function ys(n){return{colour:Be(`--line-${n%Yw}`),dash:rg[n%rg.length]}}var Zw=32767,Ys=24,Kw=5/3*Math.PI,Jw=.22,Ad=.11,ag=.7,lg=3,cg=1e-6;function ug(n){let t=n.turns.map(l=>({...l,pivot:nn(l.pivot,Float32Array),axis:Float32Array.from(nn(l.axis,Int16Array),c=>c/Zw),left:l.left&&nn(l.left,Float32Array)})),e=n.pushes.map(l=>({...l,force:l.force&&nn(l.force,Float32Array)})),{drives:i,stages:s}=n;function r(l){let c=s.find(({start:u,end:h})=>l>u&&l<=h);return i.map(({strength:u,rise:h},d)=>c?.drives.includes(d)?u*(h>0?Math.min(1,(l-c.start)/h):1):0)}let o=(l,c)=>l.reduce((u,h,d)=>u+h*c[d],0),a=l=>l.reduce((c,{shares:u})=>{let h=s.map(d=>Math.abs(o(u,i.map(({strength:f},p)=>d.drives.includes(p)?f:0))));return Math.max(c,...h)},0);return{...n,time:nn(n.time,Float64Array),turns:t,pushes:e,strengthsAt:r,summed:o,largestTurn:a(t),largestPush:a(e)}}function hg({drives:n,strengthsAt:t},e,i){let s=t(e);return n.flatMap(({text:r,unit:o,factor:a},l)=>s[l]?[`${r}: ${i(a*s[l])} ${o}`]:[])}function dg(n){let{time:t,turns:e,pushes:i,strengthsAt:s,summed:r,largestTurn:o,largestPush:a}=n.efforts,l=Math.max(0,...e.map(P=>P.radius)),c=.05*n.mesh.span_m,u=mr(Math.max(l,c)),h=new ui(new $i(1,1,1,10),u,e.length*Ys+i.length),d=new ui(new xa(1,1,16),u,e.length+i.length),f=new Fn;for(let P of[h,d])P.frustumCulled=!1,f.add(P);let p=new Float32Array(3*(Ys+2)),[x,m]=[0,0],g=(P,L,I,F,k)=>xo(p,3*L,3*I,F,P.instanceMatrix.array,16*k);function _(P,L){for(let I=0;I<3;I++)p[3*P+I]=L[I]}function w(P,L,I,F){let[k,D]=Ki(t,I),X=(P.left?Ed(P.left,1,k,D)[0]:1)*r(P.shares,F)/o;if(!(Math.abs(X)>cg))return;let[H,lt]=P.ends?jw(L,P.ends):[P.pivot,P.axis].map(ht=>Ed(ht,3,k,D)),Z=t1(lt,P),Q=Qw(lt,Z),it=Kw*Math.min(1.2,Math.abs(X))*Math.sign(X),ft=ht=>H.map((gt,St)=>gt+P.radius*(Math.cos(ht)*Z[St]+Math.sin(ht)*Q[St]));for(let ht=0;ht<=Ys;ht++)_(ht,ft(it*(ht/Ys-.5)));let dt=it/2;_(Ys+1,ft(dt+Math.sign(X)*ag));let tt=Ad*P.radius;for(let ht=0;ht<Ys;ht++)g(h,ht,ht+1,tt,x++);g(d,Ys,Ys+1,lg*tt,m++)}function v(P,L,I,F){let[k,D]=Ki(t,I),V=P.force?Ed(P.force,1,k,D)[0]:r(P.shares,F)/a;if(!(Math.abs(V)>cg))return;let X=Jw*n.mesh.span_m*V,H=L.subarray(3*P.point,3*P.point+3),lt=Z=>P.direction.map((Q,it)=>H[it]+Z*Q);_(0,H),_(1,lt(X)),_(2,lt(X+Math.sign(V)*ag*c)),g(h,0,1,Ad*c,x++),g(d,1,2,lg*Ad*c,m++)}function E(P){[x,m]=[0,0];let L=s(P),I=n.pointsAt(P);for(let F of e)w(F,I,P,L);for(let F of i)v(F,I,P,L);[h.count,d.count]=[x,m];for(let F of[h,d])F.instanceMatrix.needsUpdate=!0}let A=()=>u.color.set(new Qt(Be("--effort")));function y(){for(let P of[h,d])P.dispose(),P.geometry.dispose();u.dispose()}return{group:f,pose:E,paint:A,count:()=>m,dispose:y}}function Ed(n,t,e,i){if(n.length===t)return Array.from(n);let s=Math.min(e+1,n.length/t-1);return Array.from({length:t},(r,o)=>{let a=n[e*t+o];return a+i*(n[s*t+o]-a)})}function jw(n,[t,e]){let[i,s]=[t,e].map(a=>Array.from(n.subarray(3*a,3*a+3))),r=i.map((a,l)=>s[l]-a),o=Math.hypot(...r)||1;return[i.map((a,l)=>(a+s[l])/2),r.map(a=>a/o)]}function Qw(n,t){return[0,1,2].map(e=>n[(e+1)%3]*t[(e+2)%3]-n[(e+2)%3]*t[(e+1)%3])}function t1(n,t){t.side??=n.map(Math.abs).reduce((r,o,a,l)=>o<l[r]-.001?a:r,2);let e=n[t.side],i=n.map((r,o)=>(o===t.side?1:0)-e*r),s=Math.hypot(...i)||1;return i.map(r=>r/s)}var vs="tendon energy";function nn(n,t){let e=atob(n),i=new Uint8Array(e.length);for(let s=0;s<e.length;s++)i[s]=e.charCodeAt(s);return new t(i.buffer)}function jn(n){let t=nn(n.time,Float64Array),e=nn(n.points,Float32Array),i=3*n.pointCount,s={[vs]:{width:n.tendonParts.length,values:nn(n.tendonEnergy_J,Float32Array)}};for(let m of n.readings)s[m.name]={width:m.parts.length,values:nn(m.values,Float32Array)};let r=Int32Array.from(n.between),o=Float64Array.from(n.share),a=new Float32Array(i);function l(m,g=a){return Td(t,e,i,m,g),g}function c(m,g=new Float32Array(3*o.length)){return u(l(m),g)}function u(m,g){for(let _=0;_<o.length;_++){let w=3*r[2*_],v=3*r[2*_+1];for(let E=0;E<3;E++){let A=m[w+E];g[3*_+E]=A+o[_]*(m[v+E]-A)}}return g}function h(m,g,_=new Float32Array(s[m].width)){return Td(t,s[m].values,s[m].width,g,_),_}function d(m,g){let{width:_,values:w}=s[m];return Float32Array.from(t,(v,E)=>w[E*_+g])}let f=nn(n.restLength_m,Float32Array);function p(m,g){f.length===g.length?g.set(f):Td(t,f,g.length,m,g)}let x=n.efforts&&ug(n.efforts);return{name:n.name,reach:Math.max(n.base.radius,x?.pushes.length?.12*n.span_m:0,...(x?.turns??[]).map(m=>.4*m.radius)),mesh:n,marks:n.marks,stages:n.stages,tendons:n.tendonParts.length,readings:n.readings,time:t,start:t[0],end:t[t.length-1],efforts:x,strained:n.built!==null,builtVertices:()=>u(nn(n.built,Float32Array),new Float32Array(3*o.length)),restLengthsAt:p,pointsAt:l,verticesAt:c,verticesOf:u,valuesAt:h,line:d,stageAt:m=>n.stages.findLast(g=>g.start<=m)??n.stages[0],markAt:m=>n.marks.find(g=>Math.abs(g.time-m)<1e-9)}}function Td(n,t,e,i,s){let[r,o]=Ki(n,i),a=r*e,l=Math.min(r+1,n.length-1)*e;for(let c=0;c<e;c++){let u=t[a+c];s[c]=o===0?u:u+o*(t[l+c]-u)}}function Ki(n,t){if(!(t>n[0]))return[0,0];let e=n.length-1;if(t>=n[e])return[e,0];let i=0,s=e;for(;s-i>1;){let r=i+s>>1;n[r]<=t?i=r:s=r}return[i,(t-n[i])/(n[i+1]-n[i])]}function ru(){return document.getElementById("engine-program")!==null}async function yo(n,t){let e=new Blob([nn(document.getElementById("engine-script").textContent,Uint8Array)]).stream(),i=await new Response(e.pipeThrough(new DecompressionStream("deflate"))).text(),s=URL.createObjectURL(new Blob([i],{type:"text/javascript"})),r=new Worker(s),o=new Map,a=0;r.onmessage=({data:u})=>{let h=o.get(u.to);h?(o.delete(u.to),u.said==="refused"?h.refuse(new Error(u.why)):h.take(u)):t(u)},r.onerror=u=>{u.preventDefault();let h=new Error(u.message||"the engine stopped");for(let{refuse:d}of o.values())d(h);o.clear(),t({said:"refused",why:h.message})};function l(u){let h=++a;return new Promise((d,f)=>{o.set(h,{take:d,refuse:f}),r.postMessage({...u,number:h})})}function c(){r.terminate(),URL.revokeObjectURL(s)}try{let u=document.getElementById("engine-program").textContent,{frame:h,version:d}=await l({act:"load",program:u,text:n}),f={first:h,version:d,ask:l,send:x=>r.postMessage(x),take:p,end:c};return f;async function p(x,m){let{frame:g}=await l({act:"load",text:x});return t=m,{...f,first:g}}}catch(u){throw c(),u}}var fg={type:"change"},Rd={type:"start"},mg={type:"end"},ou=new Fs,pg=new ai,e1=Math.cos(70*cd.DEG2RAD),bn=new W,Qn=2*Math.PI,Me={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Cd=1e-6,au=class extends Ea{constructor(t,e=null){super(t,e),this.state=Me.NONE,this.target=new W,this.cursor=new W,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Hs.ROTATE,MIDDLE:Hs.DOLLY,RIGHT:Hs.PAN},this.touches={ONE:Ws.ROTATE,TWO:Ws.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new W,this._lastQuaternion=new li,this._lastTargetPosition=new W,this._quat=new li().setFromUnitVectors(t.up,new W(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new lo,this._sphericalDelta=new lo,this._scale=1,this._panOffset=new W,this._rotateStart=new Yt,this._rotateEnd=new Yt,this._rotateDelta=new Yt,this._panStart=new Yt,this._panEnd=new Yt,this._panDelta=new Yt,this._dollyStart=new Yt,this._dollyEnd=new Yt,this._dollyDelta=new Yt,this._dollyDirection=new W,this._mouse=new Yt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=i1.bind(this),this._onPointerDown=n1.bind(this),this._onPointerUp=s1.bind(this),this._onContextMenu=h1.bind(this),this._onMouseWheel=a1.bind(this),this._onKeyDown=l1.bind(this),this._onTouchStart=c1.bind(this),this._onTouchMove=u1.bind(this),this._onMouseDown=r1.bind(this),this._onMouseMove=o1.bind(this),this._interceptControlDown=d1.bind(this),this._interceptControlUp=f1.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Me.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(fg),this.update(),this.state=Me.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;bn.copy(e).sub(this.target),bn.applyQuaternion(this._quat),this._spherical.setFromVector3(bn),this.autoRotate&&this.state===Me.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=Qn:i>Math.PI&&(i-=Qn),s<-Math.PI?s+=Qn:s>Math.PI&&(s-=Qn),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(bn.setFromSpherical(this._spherical),bn.applyQuaternion(this._quatInverse),e.copy(this.target).add(bn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=bn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new W(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new W(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=bn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(ou.origin.copy(this.object.position),ou.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(ou.direction))<e1?this.object.lookAt(this.target):(pg.setFromNormalAndCoplanarPoint(this.object.up,this.target),ou.intersectPlane(pg,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Cd||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Cd||this._lastTargetPosition.distanceToSquared(this.target)>Cd?(this.dispatchEvent(fg),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?Qn/60*this.autoRotateSpeed*t:Qn/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){bn.setFromMatrixColumn(e,0),bn.multiplyScalar(-t),this._panOffset.add(bn)}_panUp(t,e){this.screenSpacePanning===!0?bn.setFromMatrixColumn(e,1):(bn.setFromMatrixColumn(e,0),bn.crossVectors(this.object.up,bn)),bn.multiplyScalar(t),this._panOffset.add(bn)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;bn.copy(s).sub(this.target);let r=bn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Qn*this._rotateDelta.x/e.clientHeight),this._rotateUp(Qn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Qn*this._rotateDelta.x/e.clientHeight),this._rotateUp(Qn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Yt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function n1(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function i1(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function s1(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(mg),this.state=Me.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function r1(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Hs.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Me.DOLLY;break;case Hs.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Me.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Me.ROTATE}break;case Hs.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Me.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Me.PAN}break;default:this.state=Me.NONE}this.state!==Me.NONE&&this.dispatchEvent(Rd)}function o1(n){switch(this.state){case Me.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Me.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Me.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function a1(n){this.enabled===!1||this.enableZoom===!1||this.state!==Me.NONE||(n.preventDefault(),this.dispatchEvent(Rd),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(mg))}function l1(n){this.enabled!==!1&&this._handleKeyDown(n)}function c1(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case Ws.ROTATE:if(this.enableRotate===!1){this.state=Me.NONE;break}this._handleTouchStartRotate(n),this.state=Me.TOUCH_ROTATE;break;case Ws.PAN:if(this.enablePan===!1){this.state=Me.NONE;break}this._handleTouchStartPan(n),this.state=Me.TOUCH_PAN;break;default:this.state=Me.NONE}break;case 2:switch(this.touches.TWO){case Ws.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Me.TOUCH_DOLLY_PAN;break;case Ws.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Me.TOUCH_DOLLY_ROTATE;break;default:this.state=Me.NONE}break;default:this.state=Me.NONE}this.state!==Me.NONE&&this.dispatchEvent(Rd)}function u1(n){switch(this._trackPointer(n),this.state){case Me.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Me.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Me.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Me.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Me.NONE}}function h1(n){this.enabled!==!1&&n.preventDefault()}function d1(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function f1(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Pd=120,gg=2,xg=6;function Id(n,t,e){let i=new WeakMap,s=t.reduce((l,c)=>n[c].mesh.tubes.reduce((u,h)=>Math.max(u,h.radius),Math.max(l,n[c].reach)),Math.max(...t.map(l=>n[l].mesh.joints.length?n[l].mesh.jointRadius:0))),r=null;function o(){let{span:l}=e;if(!i.has(l)){let c=Array.from({length:Pd+1},(u,h)=>e.timeAt(h/Pd));i.set(l,c.map(u=>t.map(h=>n[h].pointsAt(e.clipTime(h,u)).slice())))}return i.get(l)}function a(l,c){let u=[...l.flatMap(d=>d.toArray()),...c].join();if(r?.key===u&&r.span===e.span)return r;let h=o().map(d=>p1(d,l,c,s));return r={key:u,span:e.span,rows:m1(h),whole:_g(h)},r}return function(c,u,h,d){let f=new W().crossVectors(u,c).normalize(),p=[f,new W().crossVectors(c,f),c],{rows:x,whole:m}=a(p,h),g=d?g1(x,e.wayAt(e.time)*Pd):m,[_,w,v,E,A,y]=g,M=[(_-w)/2,(v-E)/2,(A-y)/2],P=Math.max((_+w)/(2*h[0]),(v+E)/(2*h[1])),L=new W;for(let[I,F]of p.entries())L.addScaledVector(F,M[I]);return{target:L,distance:P-M[2]||1}}}function p1(n,t,e,i){let s=new Float64Array(xg).fill(-1/0),r=e.map(h=>i*Math.hypot(1,h)),o=[r[0],r[0],r[1],r[1],0,0],[a,l,c]=t.map(h=>h.toArray()),u=(h,d,f)=>h[0]*d[f]+h[1]*d[f+1]+h[2]*d[f+2];for(let h of n)for(let d=0;d<h.length;d+=3){let[f,p,x]=[u(a,h,d),u(l,h,d),u(c,h,d)],[m,g]=[e[0]*x,e[1]*x],_=[f+m,m-f,p+g,g-p,x,-x];for(let w=0;w<xg;w++)_[w]>s[w]&&(s[w]=_[w])}return s.map((h,d)=>h+o[d])}function _g(n){return n.reduce((t,e)=>t.map((i,s)=>Math.max(i,e[s])))}function m1(n){let t=(i,s)=>i.slice(Math.max(0,s-gg),s+gg+1),e=n.map((i,s)=>_g(t(n,s)));return n.map((i,s)=>{let r=t(e,s);return r[0].map((o,a)=>r.reduce((l,c)=>l+c[a],0)/r.length)})}function g1(n,t){let e=Math.min(n.length-2,Math.max(0,Math.floor(t))),i=Math.min(1,Math.max(0,t-e));return n[e].map((s,r)=>s+i*(n[e+1][r]-s))}var yg=28,x1=1.05,vg=Math.PI/24,_1=1.15,gr=[{name:"3-D",text:"obliquely from above",towards:[.37,-.695,.616]},{name:"top",text:"from above",towards:[0,-5e-4,1]},{name:"side",text:"from the side, along the flat plane",towards:[0,-1,1e-4]},{name:"along",text:"from the far end, along the centre line",towards:[1,0,1e-4]}];function bg(n,t,e,i,s=xr()){let{size:r,target:o}=y1(t),a=t.map((E,A)=>A),l=Id(t,a,e),c=a.map(E=>Id(t,[E],e)),u=new Xn(yg,1,.02*r,60*r);u.up.set(0,0,1);let h=new au(u,n);h.minDistance=.1*r,h.maxDistance=20*r;let d=null;function f(E=0){let A=s.oneScale?l:c[E],y=Math.tan(yg*Math.PI/360)/x1;d=A(s.towards,u.up,[y*u.aspect,y],s.following),s.oneScale&&(d.distance*=s.scale),h.target.copy(d.target).addScaledVector(s.aside,d.distance),u.position.copy(h.target).addScaledVector(s.towards,s.closer*d.distance),u.lookAt(h.target),u.updateMatrixWorld()}function p(){f(),i()}h.addEventListener("change",()=>{let E=u.position.clone().sub(h.target);s.closer=E.length()/d.distance,s.towards.copy(E).normalize(),s.aside.copy(h.target).sub(d.target).divideScalar(d.distance),p()});let x=E=>{document.activeElement!==n&&!E.ctrlKey&&E.stopImmediatePropagation()};n.parentElement.addEventListener("wheel",x,{capture:!0});function m({towards:E}){s.towards.set(...E).normalize(),s.closer=1,s.aside.set(0,0,0),p()}function g(E,A){let y=s.towards.clone().applyAxisAngle(u.up,E*vg),M=new W().crossVectors(u.up,y).normalize(),P=y.clone().applyAxisAngle(M,-A*vg);s.towards.copy(Math.abs(P.z)<.9999?P:y),p()}function _(E){let A=s.closer*d.distance*_1**-E;s.closer=Math.min(h.maxDistance,Math.max(h.minDistance,A))/d.distance,p()}function w(E){Object.assign(s,E),p()}function v(E,A){u.aspect=E,u.updateProjectionMatrix(),h.rotateSpeed=A,h.panSpeed=A,p()}return{camera:u,controls:h,look:s,size:r,target:o,aim:f,show:m,turn:g,zoom:_,choose:w,resize:v,dispose:()=>h.dispose()}}function xr(){return{towards:new W(...gr[0].towards).normalize(),closer:1,aside:new W,following:!0,oneScale:!0,scale:1}}function y1(n){let t=new W(1/0,1/0,1/0),e=new W(-1/0,-1/0,-1/0),i=new W;for(let r of n){let o=Math.max(1,Math.floor(r.time.length/60));for(let a=0;a<r.time.length;a+=o){let l=r.pointsAt(r.time[a]);for(let c=0;c<l.length;c+=3)i.fromArray(l,c),t.min(i),e.max(i)}}let s=t.clone().add(e).multiplyScalar(.5);return{target:s,size:e.distanceTo(s)||1}}var Va=1/0,Ld=1e-4;function Sg(n,t,e){let i=new Set,s=n.readings.map(({unit:p})=>(p==="deg"?1:t.units.length)*sp(p)),r={start:n.start,end:Math.max(n.end,n.start+1),origins:[0],whole:!0},o=e,a=e,l=0;function c(){l||=requestAnimationFrame(()=>{l=0;for(let p of i)p()})}let u=(p,x)=>p!==Va?n.pointsAt(p,x):x?(x.set(o.points),x):o.points,h={...n,marks:[],efforts:null,reach:n.mesh.base.radius,pointsAt:u,verticesAt:(p,x)=>p===Va?n.verticesOf(o.points,x):n.verticesAt(p,x),valuesAt(p,x,m){if(x!==Va)return n.valuesAt(p,x,m);let g=n.readings.findIndex(w=>w.name===p),_=p===vs?o.energies_J:o.readings[g].map(w=>s[g]*w);return m?(m.set(_),m):Float32Array.from(_)},restLengthsAt(p,x){p===Va?x.set(o.restLengths_m):n.restLengthsAt(p,x)},markAt:()=>{}},d={get time(){return o.time_s},span:r,clipTime:(p,x=Va)=>x,timeAt:p=>r.start+p*(r.end-r.start),wayAt:()=>0,onChange(p){return i.add(p),c(),()=>i.delete(p)}};function f(p){o=p,!(p!==a&&!v1(p,a,Ld*h.reach))&&(a=p,c())}return{clip:h,clock:d,show:f,get frame(){return o}}}function v1(n,t,e){let i=(s,r,o)=>s.some((a,l)=>Math.abs(a-r[l])>o);return i(n.points,t.points,e)||n.readings.some((s,r)=>i(s,t.readings[r],Ld*Math.max(1,...s.map(Math.abs))))||i(n.energies_J,t.energies_J,Ld*Math.max(...t.energies_J))||i(n.restLengths_m,t.restLengths_m,0)}var b1=[["space","play or pause"],["← →","short step back or forward"],["page down, page up","long step back or forward"],["home, end","start, end"]],S1="shift with ← → ↑ ↓",M1=[["+ −","nearer, further"],["0","reset the view"]];function lu(n,t,e){let s=(n.length===1?n[0].marks:[]).map((o,a)=>[String(a+1),o.name]),r=[...b1,...s,...t?[[S1,`turn the ${e}`],...M1]:[]].map(([o,a])=>S("tr",{},S("th",{scope:"row"},o),S("td",{},a)));return S("details",{className:"keys"},S("summary",{},"Keys"),S("table",{},S("tbody",{},...r)),S("p",{},"Space and arrow keys work unless another control has the focus. All other keys work only in the player."))}var Mg={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]};function wg({key:n,shiftKey:t},e,i,s){if(t&&n in Mg)e?.turn(...Mg[n]);else if(s)if(n==="+"||n==="=")e?.zoom(1);else if(n==="-"||n==="−")e?.zoom(-1);else if(n==="0")e?.show(i);else return!1;else return!1;return!0}function Ag(n,t,e){n.addEventListener("keydown",i=>{!i.ctrlKey&&!i.metaKey&&!i.altKey&&wg(i,t,e,!0)&&i.preventDefault()})}function cu(n,t,e,i,s){let r={ArrowLeft:-1,ArrowRight:1,PageUp:10,PageDown:-10};function o(c){e.pause(),c()}function a(c,u){let{key:h}=c;if(wg(c,i,s,u))return!0;if(h in r)o(()=>e.step(r[h]));else if(h===" ")e.playing?e.pause():e.play();else if(h==="Home")o(()=>e.seek(e.span.start));else if(h==="End")o(()=>e.seek(e.span.end));else if(u)if(t.length===1&&t[0].marks[Number(h)-1])o(()=>e.seekClip(0,t[0].marks[Number(h)-1].time));else return!1;else return!1;return!0}function l(c){let u=document.activeElement,h=n.contains(u);!(h||u===document.body||u===null)||c.ctrlKey||c.metaKey||c.altKey||u instanceof HTMLSelectElement||u?.dataset?.keys==="own"||c.key===" "&&/^(BUTTON|SUMMARY|A)$/.test(u?.tagName??"")||u===document.body&&/^(Home|End|PageUp|PageDown)$/.test(c.key)||a(c,h)&&c.preventDefault()}return document.addEventListener("keydown",l),()=>document.removeEventListener("keydown",l)}var Eg=2.4;function Ga(n){let t=10**Math.floor(Math.log10(n/Eg));return t*[5,2,1].find(e=>e*t<=n/Eg)}function Tg(n,t){let e=Ga(n),i=e*Math.ceil(1.25*n/e),s=[],[r,o]=[t.x,t.y].map(c=>e*Math.round(c/e));for(let c=-i;c<=i+e/2;c+=e)s.push(r+c,o-i,0,r+c,o+i,0,r-i,o+c,0,r+i,o+c,0);let a=new _n().setAttribute("position",new en(s,3)),l=new cr(a,new Bs({transparent:!0,opacity:.5,depthWrite:!1}));return l.frustumCulled=!1,l}function Nd(n,t,e,i){let s=i?["marks on the time line: the states of each run, in its colour"]:[];return S("ul",{className:"legend"},...n.map(({sample:r,text:o})=>r==="tendon"?A1(o,t):w1(r,o)),...n.some(({sample:r})=>r==="tendon")?[S("li",{},"slack tendons sag, drawn with their rest length")]:[],S("li",{},`squares of the grid: ${Or(Ga(e),"m")}`),...s.map(r=>S("li",{},r)))}function w1(n,t){let[e,i]=n.split(" "),s={mountain:{color:nu},valley:{color:iu},region:{background:za(i)}};return S("li",{className:e==="region"?"of-region":""},Cg(e==="region"?"panel":e,s[e]??{}),t)}function A1(n,t){let e=S("li",{className:"energy"},`${n}: 0`,Dd(_o));return e.append(`${Pe(t.factor*t.largest_J)} ${t.unit}${t.orMore?" or more":""}`),e}function Dd(n){return Cg("bar",{background:n.gradient})}function Cg(n,t){let e=S("span",{className:`swatch ${n}`,"aria-hidden":"true"});return Object.assign(e.style,t),e}function Rg(n,t){if(!(t>n*(1+1e-6)))return 0;let[e,i]=[0,t/2];for(let s=0;s<40;s++){let r=(e+i)/2;E1(n,r)<t?e=r:i=r}return(e+i)/2}function E1(n,t){return t===0?n:Math.hypot(n,4*t)/2+n*n*Math.asinh(4*t/(n||1e-12))/(8*t)}function Ig(n){let{triangles:t,faces:e}=n.mesh,i=n.builtVertices(),s=Array.from({length:e.length},(c,u)=>Pg(i,t,u)),r=new Float32Array(e.reduce((c,u)=>Math.max(c,u),0)+1),o=new Float32Array(e.length);function a(c){r.fill(-1/0);for(let u=0;u<e.length;u++){let[h,d,f]=s[u],p=h*f-d*d;if(p<=1e-9*(h+f)**2)continue;let[x,m,g]=Pg(c,t,u),_=(f*x-2*d*m+h*g)/(2*p),w=(x*g-m*m)/p,v=(_+Math.sqrt(Math.max(_*_-w,0))-1)/2;r[e[u]]=Math.max(r[e[u]],v)}for(let u=0;u<e.length;u++)o[u]=Math.max(0,r[e[u]]);return o}function l(){let c=new Float32Array(i.length),u=0;for(let h of n.time)u=a(n.verticesAt(h,c)).reduce((d,f)=>Math.max(d,f),u);return u}return{at:a,largest:l}}function Pg(n,t,e){let[i,s,r]=[0,1,2].map(c=>3*t[3*e+c]),[o,a,l]=[0,0,0];for(let c=0;c<3;c++){let u=n[s+c]-n[i+c],h=n[r+c]-n[i+c];o+=u*u,a+=u*h,l+=h*h}return[o,a,l]}var T1=.9,Lg=.4,C1=.02,R1=["crease","rim","edge"],Zs=12;function Ud(n,t){let{mesh:e}=n,i=new Float32Array(3*e.share.length),s=new Float32Array(n.tendons),r=Math.max(0,...e.tubes.map(P=>P.radius)),[o,a]=[!1,!0].map(P=>I1(e,P)),l=Ng(e.tubes.filter(P=>P.kind==="bar"),20,0),c=Ng(e.tubes.filter(P=>R1.includes(P.kind)),8,.4*r),u=L1(n,2.4*r),h=D1(e.base),d=n.efforts?dg(n):null,f=n.strained?Ig(n):null,p=0,x=U1(e),m=new Fn;m.add(h.object,a.object,l.object,x.object,c.object,u.object,o.object),d&&m.add(d.group);let g=P1(o.object,a.object,l.object),_=[0,0,0],w=new Qt;function v(P){n.verticesAt(P,i),o.pose(i),a.pose(i);for(let I of[l,c,x])I.pose(i);n.valuesAt(vs,P,s);let L=s.map(I=>t>0?I/t:0);u.pose(i,P,I=>Lg+(1-Lg)*Math.min(1,Math.max(0,L[I])/C1));for(let I=0;I<n.tendons;I++)_o.at(L[I],_),u.colour(I,w.setRGB(..._,"srgb"));n.tendons&&(u.object.instanceColor.needsUpdate=!0),d?.pose(P),p&&E()}function E(){let P=f.at(i),L=[0,0,0];for(let I of[o,a])I.colour(F=>w.setRGB(...su.at(P[F]/p,L),"srgb"))}function A(P){p=f?P:0;for(let L of[o,a])L.flat(p>0),p||L.colour(I=>w.set(za(e.regions[I])));p&&E()}function y(){for(let P of[l,c,x,h])P.paint();d?.paint(),g.children[0].material.color.set(Be("--shadow"))}function M(){for(let P of[l,c,u,x])P.object.dispose();for(let P of[o,a])P.dispose();d?.dispose(),h.dispose();for(let P of[l,c,u,x])P.object.geometry.dispose(),P.object.material.dispose();g.children[0].material.dispose()}return{group:m,shadow:g,pose:v,paint:y,sort:o.sort,vertices:i,tendons:u.object,efforts:d,strains:f,showStrain:A,dispose:M}}function P1(...n){let t=new lr({side:kn,transparent:!0,opacity:.12,depthWrite:!1,stencilWrite:!0,stencilRef:1,stencilFunc:td,stencilZPass:Qh}),e=new Fn;for(let i of n){let s=i.isInstancedMesh?new ui(i.geometry,t,i.count):new Nn(i.geometry,t);i.isInstancedMesh&&(s.instanceMatrix=i.instanceMatrix),s.frustumCulled=!1,e.add(s)}return e.scale.z=1e-5,e}function I1(n,t){let e=n.regions.flatMap((v,E)=>n.solid[v]===t?[E]:[]),i=e.flatMap(v=>n.triangles.slice(3*v,3*v+3)),s=e.length,r=new on(new Float32Array(3*i.length),3).setUsage(Ua),o=new on(new Float32Array(3*i.length),3).setUsage(Ua),a=new on(new Uint32Array(i.length),1).setUsage(Ua);for(let v=0;v<i.length;v++)a.array[v]=v;let l=new _n;l.setAttribute("position",r),l.setAttribute("color",o),l.setIndex(a);let c=new ms({vertexColors:!0,side:kn,flatShading:!0,transparent:!t,opacity:t?1:T1,depthWrite:t,forceSinglePass:!0});c.onBeforeCompile=v=>{v.fragmentShader=v.fragmentShader.replace("#include <color_fragment>",`#include <color_fragment>
if (!gl_FrontFacing) diffuseColor.rgb *= 0.84;`)};let u=new lr({vertexColors:!0,side:kn}),h=new Nn(l,c);h.frustumCulled=!1,h.renderOrder=t?0:1;let d=new Qt;f(v=>d.set(za(n.regions[v])));function f(v){for(let[E,A]of e.entries()){let y=v(A);for(let M=0;M<3;M++)y.toArray(o.array,9*E+3*M)}o.needsUpdate=!0}let p=v=>{h.material=v?u:c};function x(){l.dispose(),c.dispose(),u.dispose()}function m(v){for(let E=0;E<i.length;E++)for(let A=0;A<3;A++)r.array[3*E+A]=v[3*i[E]+A];r.needsUpdate=!0}let g=new Float32Array(s),_=Array.from({length:s},(v,E)=>E);function w(v){let E=r.array;for(let A=0;A<s;A++){let y=0;for(let M=0;M<3;M++){let P=9*A+M;y+=((E[P]+E[P+3]+E[P+6])/3-v.getComponent(M))**2}g[A]=y}_.sort((A,y)=>g[y]-g[A]);for(let A=0;A<s;A++)for(let y=0;y<3;y++)a.array[3*A+y]=3*_[A]+y;a.needsUpdate=!0}return{object:h,pose:m,sort:w,colour:f,flat:p,dispose:x}}function Ng(n,t,e){let i=new ui(new $i(1,1,1,t),mr(e),n.length);i.frustumCulled=!1,o();let s=n.map(a=>[3*a.ends[0],3*a.ends[1],a.radius]);function r(a,l=()=>1){let c=i.instanceMatrix.array;for(let[u,[h,d,f]]of s.entries())xo(a,h,d,l(u)*f,c,16*u);i.instanceMatrix.needsUpdate=!0}function o(){let a={M:new Qt(nu),V:new Qt(iu),B:new Qt(Be("--bar"))};for(let[l,c]of n.entries())i.setColorAt(l,a[c.crease]);n.length&&(i.instanceColor.needsUpdate=!0)}return{object:i,pose:r,paint:o}}function L1(n,t){let e=n.mesh.tubes.filter(l=>l.kind==="tendon"),i=new ui(new $i(1,1,1,12),mr(t),e.length*Zs);i.frustumCulled=!1;let s=new Float32Array(e.length),r=new Float32Array(3*(Zs+1));function o(l,c,u){n.restLengthsAt(c,s);let h=i.instanceMatrix.array;for(let[d,{ends:f,radius:p}]of e.entries()){N1(l,3*f[0],3*f[1],s[d],r);for(let x=0;x<Zs;x++)xo(r,3*x,3*x+3,u(d)*p,h,16*(d*Zs+x))}i.instanceMatrix.needsUpdate=!0}function a(l,c){for(let u=0;u<Zs;u++)i.setColorAt(l*Zs+u,c)}return{object:i,pose:o,colour:a}}function N1(n,t,e,i,s){let r=[0,1,2].map(d=>n[e+d]-n[t+d]),o=Math.hypot(...r),a=Rg(o,i),l=Math.abs(r[2])>.999*o?[1,0,0]:[0,0,-1],c=l.reduce((d,f,p)=>d+f*r[p],0)/(o*o||1),u=l.map((d,f)=>d-c*r[f]),h=Math.hypot(...u)||1;for(let d=0;d<=Zs;d++){let f=d/Zs,p=4*a*f*(1-f)/h;for(let x=0;x<3;x++)s[3*d+x]=n[t+x]+f*r[x]+p*u[x]}}function D1({rods:n,radius:t}){let e=new Float32Array(n.flat(2)),i=mr(0),s=new ui(new $i(1,1,1,16),i,n.length),r=new ui(new oo(1,16,12),i,2*n.length),o=new Fn;for(let l of[s,r])l.frustumCulled=!1,o.add(l);for(let l=0;l<n.length;l++)xo(e,6*l,6*l+3,t,s.instanceMatrix.array,16*l);for(let l=0;l<2*n.length;l++){let c=r.instanceMatrix.array;for(let u=0;u<3;u++)[c[16*l+5*u],c[16*l+12+u]]=[t,e[3*l+u]];c[16*l+15]=1}function a(){for(let l of[s,r])l.dispose(),l.geometry.dispose();i.dispose()}return{object:o,paint:()=>i.color.set(Be("--base")),dispose:a}}function U1(n){let t=new ui(new oo(1,16,12),mr(0),n.joints.length);t.frustumCulled=!1;let e=()=>t.material.color.set(Be("--joint"));e();function i(s){let r=t.instanceMatrix.array;for(let[o,a]of n.joints.entries()){for(let l=0;l<3;l++)r[16*o+5*l]=n.jointRadius,r[16*o+12+l]=s[3*a+l];r[16*o+15]=1}t.instanceMatrix.needsUpdate=!0}return{object:t,pose:i,paint:e}}var O1=4096,F1=3.2,k1=new W(-.45,.75,1),B1=.42*Math.PI,z1=.64*Math.PI,V1=.5,G1=.14;function Ha(n,t,e,i,s){let r=S("canvas",{tabIndex:0,role:"img","aria-label":`${i} ${H1}`}),o=r.getContext("webgl2",{antialias:!0,alpha:!0,stencil:!0});if(!o)return null;let a=n.map(()=>S("div",{className:"cell"})),l=n.length>1,c=S("div",{className:l?"stage several":"stage"},r,...a);c.style.setProperty("--columns",String(n.length===4?2:Math.min(n.length,n.length>6?4:3)));let u=()=>l?Math.ceil(F1*parseFloat(getComputedStyle(a[0]).fontSize)):0,h=new Qc({canvas:r,context:o,antialias:!0,alpha:!0,stencil:!0});h.setScissorTest(!0);let d=bg(r,n,t,m,s),f=n.map(L=>W1(L,e(L),d)),p=0,x=!1;function m(){p||(p=requestAnimationFrame(_))}function g(){for(let[L,I]of f.entries())I.shape.pose(t.clipTime(L));x=!0}function _(){cancelAnimationFrame(p),p=0,x||g();let L=r.clientHeight,I=u();h.setScissor(0,0,r.clientWidth,L),h.setViewport(0,0,r.clientWidth,L),h.clear();for(let[F,k]of f.entries()){d.aim(F);let D=a[F],V=[D.offsetLeft,L-D.offsetTop-D.offsetHeight,D.offsetWidth,D.offsetHeight-I];h.setViewport(...V),h.setScissor(...V),k.light.position.copy(k1).applyQuaternion(d.camera.quaternion);let X=d.camera.position.z>k.floor.position.z;k.floor.material.opacity=X?V1:G1,k.shape.shadow.visible=X,k.shape.sort(d.camera.position),h.render(k.scene,d.camera)}d.aim()}function w(){for(let L of f)L.floor.material.color.set(Be("--floor")),L.shape.paint();m()}function v(){let[L,I]=[c.clientWidth,c.clientHeight];if(!L||!I)return;h.setPixelRatio(Math.min(devicePixelRatio,2,O1/Math.max(L,I))),h.setSize(L,I,!1);let F=a[0].offsetHeight-u();d.resize(a[0].offsetWidth/F,I/F),_()}let E=new ResizeObserver(v);E.observe(c);let A=t.onChange(()=>{x=!1,_()}),y=qs(w);r.addEventListener("webglcontextrestored",m),w();function M(){cancelAnimationFrame(p),A(),y(),E.disconnect(),d.dispose();for(let{shape:L,floor:I}of f)L.dispose(),I.geometry.dispose(),I.material.dispose();h.dispose(),h.forceContextLoss(),c.remove()}function P(L){let I=L?f.reduce((F,{shape:k})=>Math.max(F,k.strains?.largest()??0),0):0;for(let{shape:F}of f)F.showStrain(I||(L?Number.MIN_VALUE:0));return m(),I}return{element:c,canvas:r,cells:a,eye:d,pose:g,draw:_,views:f,showStrain:P,statistics:()=>h.info.render,dispose:M}}var H1="Drag to turn, pinch to zoom; keys are listed below.";function W1(n,t,e){let i=Tg(e.size,e.target);i.position.z=$1(n)-.06*e.size,t.shadow.position.z=i.position.z+.001*e.size;let s=new wa("#ffffff",B1),r=new ca;return r.add(t.group,t.shadow,i,s,new ba("#ffffff","#dde2e8",z1)),{shape:t,floor:i,light:s,scene:r}}function $1(n){let t=1/0,e=Math.max(1,Math.floor(n.time.length/200));for(let i=0;i<n.time.length;i+=e){let s=n.pointsAt(n.time[i]);for(let r=2;r<s.length;r+=3)t=Math.min(t,s[r])}return t}var X1=.3,q1=4,Y1=4,Ug=[{name:"even motion",value:"even"},{name:"real time",value:1},{name:"1/2",value:1/2},{name:"1/5",value:1/5},{name:"1/10",value:1/10},{name:"1/20",value:1/20},{name:"1/50",value:1/50},{name:"1/100",value:1/100}];function Og(n,t){let e=Z1(n,t),i=new Float64Array(e.length);for(let[l,c]of n.entries())K1(c,t.origins[l],e,i);for(let l=1;l<i.length;l++)i[l]+=i[l-1];let s=i[i.length-1],r=s>0?X1:1;for(let l=0;l<i.length;l++){let c=(e[l]-e[0])/(e[e.length-1]-e[0]||1);i[l]=r*c+(1-r)*(i[l]/(s||1))}let o=l=>l.drive!=="none"&&l.start-t.origins[0]<t.end&&l.end-t.origins[0]>t.start,a=n[0].stages.filter(o).length;return{seconds:q1+Y1*a,wayAt:l=>Dg(e,i,l),timeAt:l=>Dg(i,e,l)}}function Z1(n,t){let e=new Set([t.start,t.end]);for(let[i,s]of n.entries())for(let r of s.time){let o=r-t.origins[i];o>t.start&&o<t.end&&e.add(o)}return Float64Array.from(e).sort()}function K1(n,t,e,i){let s=n.pointsAt(e[0]+t).slice(),r=s.slice();for(let o=1;o<e.length;o++){n.pointsAt(e[o]+t,r);let a=0;for(let l=0;l<r.length;l+=3){let c=Math.hypot(r[l]-s[l],r[l+1]-s[l+1],r[l+2]-s[l+2]);c>a&&(a=c)}i[o]=Math.max(i[o],a),[s,r]=[r,s]}}function Dg(n,t,e){let[i,s]=Ki(n,e);return s===0?t[i]:t[i]+s*(t[i+1]-t[i])}var J1="M7 4.5v15l12-7.5z",j1="M7 5h3.5v14H7zM13.5 5H17v14h-3.5z",Od=1e4;function uu(n,t){let e=S("button",{type:"button",className:"play"}),i=S("input",{type:"range",min:0,max:Od,step:1,"aria-label":"time"}),s=S("div",{className:"bands","aria-hidden":"true"}),r=S("div",{className:"ticks","aria-hidden":"true"}),o=S("p",{className:"time"}),a=S("p",{className:"spoken",role:"status"}),l=n.length===1?n[0].marks.map(f=>Q1(f,t)):[],c=S("div",{className:"transport"},S("div",{className:"line"},e,S("div",{className:"track"},s,i,r)),S("div",{className:"choices"},o,...l.length?[S("div",{className:"states"},...l)]:[],tA(t),...eA(t),a));e.addEventListener("click",()=>t.playing?t.pause():t.play()),i.addEventListener("input",()=>{t.pause(),t.seek(t.momentAt(i.value/Od))});let u=null,h=null,d=0;return t.onChange(()=>{let f=`${t.spans.indexOf(t.span)} ${t.stretched}`;f!==u&&nA(n,t,s,r),u=f,i.value=Math.round(Od*t.shareAt(t.time)),i.setAttribute("aria-valuetext",Fg(n,t));let p=n.length===1?` · ${hu(n[0],t.clipTime(0))}`:t.span.label.replace("time",""),x=t.playing?`, ${iA(t.slowness)}`:"";o.textContent=`${ir(t.time,t.span)}${p}${x}`;for(let[m,g]of(n.length===1?n[0].marks:[]).entries())l[m].setAttribute("aria-pressed",String(Math.abs(g.time-t.clipTime(0))<1e-9));t.playing!==h&&(e.replaceChildren(sl(t.playing?j1:J1)),e.setAttribute("aria-label",t.playing?"pause":"play"),h=t.playing),clearTimeout(d),t.playing||(d=setTimeout(()=>{a.textContent=Fg(n,t)},600))}),c}function Q1(n,t){let e=S("button",{type:"button",className:"state"},S("b",{},n.letter),` ${n.name}`);return e.addEventListener("click",()=>{t.pause(),t.seekClip(0,n.time)}),e}function tA(n){let t=Ug.map(({name:i,value:s})=>S("option",{value:String(s)},i)),e=S("select",{},...t);return e.addEventListener("change",()=>n.setSpeed(e.value==="even"?"even":Number(e.value))),S("label",{},"speed ",e)}function eA(n){if(n.spans.length<2)return[];let t=n.spans.map((i,s)=>S("option",{value:String(s)},i.name)),e=S("select",{},...t);return e.addEventListener("change",()=>n.setSpan(n.spans[Number(e.value)])),n.onChange(()=>{e.value=String(n.spans.indexOf(n.span))}),[S("label",{},"show ",e)]}function nA(n,t,e,i){let{span:s}=t,r=o=>Math.min(1,Math.max(0,t.shareAt(o)));e.replaceChildren(),i.replaceChildren();for(let[o,a]of n.entries()){let l=s.origins[o];for(let c of a.stages.filter(u=>u.driven&&n.length===1)){let[u,h]=[r(c.start-l),r(c.end-l)],d=S("span",{className:"band"});d.style.left=`${100*u}%`,d.style.width=`${100*(h-u)}%`,h>u&&e.append(d)}for(let c of a.marks){let u=c.time-l;if(u<s.start-1e-9||u>s.end+1e-9)continue;let h=S("span",{className:"tick"},n.length===1?c.letter:"");h.style.left=`${100*r(u)}%`,n.length>1&&h.style.setProperty("--tick",`var(--line-${o%7})`),i.append(h)}}}function iA(n){return n<1.05?"real time":`${n<10?$n(n,1):Math.round(n)} times slower`}function hu(n,t){let e=n.markAt(t);return e?`${e.letter} ${e.name}`:n.stageAt(t).name}function Fg(n,t){let e=n.map((i,s)=>{let r=t.clipTime(s);return`${n.length>1?`${i.name}: `:""}${hu(i,r)}${sA(i,r)}`});return`${ir(t.time,t.span)}: ${e.join("; ")}`}function sA(n,t){let[e]=n.readings;if(!e)return"";let i=n.markAt(t)?.readings[e.name]?.mean??n.valuesAt(e.name,t),s=e.unit==="deg"?"degrees":e.unit,r=[Math.min(...i),Math.max(...i)].map(a=>$n(a,1)),o=i.length>1;return`, ${e.label}${o?"s":""} ${o?r.join(" to "):r[0]} ${s}`}function vo(n,t,e,{energy:i,legend:s,text:r,whole:o},a){let l=Ha(t,e,f=>Ud(f,i.largest_J),r,a),c=l?S("div",{className:"picture"},l.element,fu(l.eye,t.length>1||a?o:null)):S("p",{className:"note"},du(o));l&&t.length===1&&rA(l.cells[0],t[0],e);let u=l?[Nd(s,i,l.eye.size,t.length>1?o:null)]:[];l&&t.some(f=>f.strained)&&u.unshift(Bg(l,u[0])),l&&t.length===1&&t[0].efforts?.drives.length&&oA(u.at(-1),t[0],e),l&&t.length>1&&t.some(f=>f.efforts?.drives.some(p=>p.arrow))&&u.at(-1).append(S("li",{className:"effort"},kg(),"torque or force of a drive, while it acts")),n.replaceChildren(c,uu(t,e),...u,lu(t,l!==null,o)),n.classList.add("player"),n.setAttribute("role","region"),n.setAttribute("aria-label",`the moving ${o}`);let h=cu(n,t,e,l?.eye,gr[0]);function d(){e.pause(),h(),l?.dispose(),n.replaceChildren()}return{stage:l,dispose:d}}function bo(n,t,e,{energy:i,legend:s,text:r,whole:o},a){let l=Ha(t,e,h=>Ud(h,i.largest_J),r,a);if(!l)return n.replaceChildren(S("p",{className:"note"},du(o))),{stage:l};let c=S("div",{className:"picture"},l.element,fu(l.eye,null,!a)),u=[Nd(s,{...i,orMore:!0},l.eye.size,null)];return t.some(h=>h.strained)&&u.unshift(Bg(l,u[0])),n.replaceChildren(c,...u),n.classList.add("player"),n.setAttribute("role","region"),n.setAttribute("aria-label",`the ${o} as set by the sliders`),Ag(n,l.eye,gr[0]),{stage:l}}function rA(n,t,e){let i=S("p",{className:"now","aria-hidden":"true"});n.append(i),e.onChange(()=>{i.textContent=hu(t,e.clipTime(0))})}function kg(){return S("span",{className:"swatch arrow","aria-hidden":"true"})}function oA(n,t,e){let i=t.efforts.drives.some(r=>r.arrow),s=S("span");n.append(S("li",{className:"effort"},...i?[kg()]:[],s)),e.onChange(()=>{s.textContent=hg(t.efforts,e.clipTime(0),Pe).join("; ")||"no drive acts now"})}function Bg(n,t){let e=["panels","membrane strain"],i=S("li",{className:"energy",hidden:!0});t.append(i);let s=e.map((r,o)=>{let a=S("button",{type:"button","aria-pressed":String(!o)},r);return a.addEventListener("click",()=>{let l=n.showStrain(!!o);i.replaceChildren("Green strain of the membrane: 0",Dd(su),`${Pe(100*l)} %`),i.hidden=!o;for(let c of t.querySelectorAll(".of-region"))c.hidden=!!o;for(let c of s)c.setAttribute("aria-pressed",String(c===a))}),a});return S("div",{className:"colours",role:"group","aria-label":"colour of the sheet"},"colour:",S("span",{},...s))}function du(n){return`This browser has no WebGL, so the ${n} cannot be drawn in 3-D. The plots and all numbers are below.`}function fu(n,t,e=!0){let i=(c,u,h)=>{let d=S("button",{type:"button",title:u,"aria-label":u},c);return d.addEventListener("click",h),d},s=gr.map(c=>i(c.name,`${c.name}: view ${c.text}`,()=>n.show(c))),r=[["←","turn left",[-1,0]],["→","turn right",[1,0]],["↑","turn up",[0,1]],["↓","turn down",[0,-1]]].map(([c,u,h])=>i(c,u,()=>n.turn(...h))),o=(c,u,h)=>{let d=i(c,u,()=>{n.choose({[h]:!n.look[h]}),d.setAttribute("aria-pressed",String(n.look[h]))});return d.setAttribute("aria-pressed",String(n.look[h])),d},a=[...e?[o("follow","follow: keep the picture filled as the structure moves","following")]:[],...t?[o("one scale",`one scale: draw all ${t}s at the same scale`,"oneScale")]:[]],l=[i("+","nearer",()=>n.zoom(1)),i("−","further",()=>n.zoom(-1))];return S("div",{className:"views",role:"group","aria-label":"view"},...a.length?[S("span",{},...a)]:[],S("span",{},...s),S("span",{className:"turns"},...r),S("span",{},...l))}var aA={deg:.05};function So(n,t,e,i,s=0,r=!1){let{heading:o,names:a}=t.mesh.parts,l=t.readings.map(x=>({name:x.name,title:x.row,parts:x.parts,text:m=>Fd(m,x.unit),ofState:m=>m.readings[x.name]&&lA(m.readings[x.name],x.unit)})),c=x=>Pe(i.factor*x);t.tendons&&l.push({name:vs,title:`tendon energy (${i.unit})`,parts:t.mesh.tendonParts,text:c,ofState:x=>x.tendonEnergy_J.map(c)});let u=l.map(()=>a.map(()=>S("td"))),h=S("caption"),d=S("tr",{},o?S("th",{scope:"col"},o):S("td"),...a.map(x=>S("th",{scope:"col"},x))),f=l.map((x,m)=>S("tr",{},S("th",{scope:"row"},x.title),...u[m])),p=S("table",{className:"numbers"},h,S("thead",{},d),S("tbody",{},...f));return n.replaceChildren(S("div",{className:"table"},p)),n.classList.add("readout"),e.onChange(()=>{let x=e.clipTime(s),m=t.markAt(x),g=m?`, ${m.name} (means)`:"",_=r?`${t.name}: `:"",w=o?`every ${o}`:"all values";h.textContent=`${ke(`${_}${w}`)} at ${ir(e.time,e.span)}${g}`;for(let[v,E]of l.entries()){let A=m&&E.ofState(m)||Array.from(t.valuesAt(E.name,x),E.text);for(let[y,M]of E.parts.entries())u[v][M].textContent=A[y]}})}function Fd(n,t){return t==="deg"?$n(n,1):Pe(n)}function lA({mean:n,swing:t},e){return n.map((i,s)=>{let r=t[s]>(aA[e]??.005*Math.abs(i));return`${Fd(i,e)}${r?` ± ${Fd(t[s],e)}`:""}`})}var cA=0;function Mo(n=document){let t=new ResizeObserver(e=>{for(let{target:i}of e)if(i.scrollWidth>i.clientWidth||i.scrollHeight>i.clientHeight)uA(i);else for(let s of["tabindex","role","aria-label","aria-labelledby"])i.removeAttribute(s)});for(let e of n.querySelectorAll(".table"))t.observe(e)}function uA(n){let{caption:t}=n.querySelector("table");if(n.tabIndex=0,n.setAttribute("role","group"),!t){let e=[...n.querySelectorAll("thead th")].map(i=>i.textContent);return n.setAttribute("aria-label",e.join(", ")||"table")}return t.id||=`caption-${++cA}`,n.setAttribute("aria-labelledby",t.id)}function hA(n,t){let e=n.design.text.split(`
`);for(let{key:i,unit:s,factor:r,line:o}of n.knobs)i in t&&(e[o.number]=`${o.before}${Vg(t[i],s,r)}${o.after}`);return e.join(`
`)}function zg({knobs:n},t,e){let{unit:i,factor:s}=n.find(r=>r.key===t);return Vg(e,i,s)}function Vg(n,t,e){return`${Number((e*n).toPrecision(12))} ${t}`}function Gg(n){let t=S("a",{className:"button",download:"design.toml"},"This setting as a design file"),e=S("code"),i=S("p",{className:"note"},"This page does not check the energy balance; a run of the file does."),s=S("div",{className:"setting"},t,S("pre",{},e),i);function r(o){let a=new TextEncoder().encode(hA(n,o));t.href=`data:application/toml;base64,${btoa(String.fromCharCode(...a))}`,e.textContent="forficula run design.toml"}return r({}),{element:s,refresh:r}}var dA=500,Hg=[["a little",.1],["half",.5],["as strong as its drives",1]],Wg=[["←","left","ArrowLeft",[-1,0]],["↑","up","ArrowUp",[0,1]],["↓","down","ArrowDown",[0,-1]],["→","right","ArrowRight",[1,0]]];function $g(n,t,e,i,s){let r=e.map((_,w)=>[_,w]).filter(([,_])=>t.movable[_]),o=S("select",{},...r.map(([_,w])=>S("option",{value:w},_))),a=S("select",{},...Hg.map(([_,w])=>S("option",{value:w,selected:w===Hg[0][1]},_))),l=S("span",{className:"note",role:"status"}),c=Wg.map(([_,w,v])=>S("button",{type:"button",title:`push ${w}`,"aria-label":`push ${w}`,"data-way":v},_)),u=S("span",{className:"pad",role:"group","aria-label":"push in the plane of the picture"},...c),h=S("p",{className:"note"},"On these buttons, arrow keys push while they are held. Pressing a button pushes for half a second."),d=S("details",{className:"push-keys"},S("summary",{},"Push without a pointer"),S("div",{className:"choices"},S("label",{},"point ",o),S("label",{},"force ",a),u,l),h),f=fA(n,t,()=>Number(o.value),d),p=new Set,x=0;function m(){clearTimeout(x);let[_,w]=[0,1].map(A=>Wg.reduce((y,[,,M,P])=>y+(p.has(M)?P[A]:0),0));if(!_&&!w){l.textContent="",s(0,null);return}let{camera:v}=n.eye,E=new W().setFromMatrixColumn(v.matrixWorld,0).multiplyScalar(_);E.addScaledVector(new W().setFromMatrixColumn(v.matrixWorld,1),w).setLength(Number(a.value)*i),l.textContent=`${o.selectedOptions[0].text} pushed with ${Pe(E.length())} N`,s(Number(o.value),E.toArray())}function g(){p.size&&(p.clear(),m())}u.addEventListener("keydown",_=>{!_.key.startsWith("Arrow")||_.shiftKey||_.ctrlKey||_.metaKey||_.altKey||(_.preventDefault(),_.stopPropagation(),!p.has(_.key)&&(p.add(_.key),m()))}),u.addEventListener("keyup",({key:_})=>{p.delete(_)&&m()}),u.addEventListener("focusout",g);for(let _ of c)_.addEventListener("click",()=>{p.clear(),p.add(_.dataset.way),m(),x=setTimeout(g,dA)});return o.addEventListener("change",()=>{g(),f()}),d.addEventListener("toggle",f),d}function fA(n,t,e,i){let s="http://www.w3.org/2000/svg",r=document.createElementNS(s,"svg"),o=document.createElementNS(s,"circle");o.setAttribute("r","9"),r.classList.add("push"),r.setAttribute("aria-hidden","true"),r.append(o),n.element.append(r);let a=new W;function l(){if(r.style.display=i.open?"":"none",!i.open)return;let{x:c,y:u}=a.fromArray(t.frame.points,3*e()).project(n.eye.camera);o.setAttribute("cx",(c+1)/2*n.canvas.clientWidth),o.setAttribute("cy",(1-u)/2*n.canvas.clientHeight)}return t.clock.onChange(l),n.eye.controls.addEventListener("change",l),l(),l}var pA=22,mA=.25;function Xg(n,t,e,i,s){let{canvas:r,eye:o}=n,a=document.createElementNS("http://www.w3.org/2000/svg","line"),l=document.createElementNS("http://www.w3.org/2000/svg","svg");l.classList.add("push"),l.setAttribute("aria-hidden","true"),l.append(a);let c=S("p",{className:"pushed","aria-hidden":"true"});n.element.append(l,c),l.style.display="none";let u=new W,h=null;function d(_){let w=u.fromArray(t.frame.points,3*_).project(o.camera);return[(w.x+1)/2*r.clientWidth,(1-w.y)/2*r.clientHeight]}function f(_){let w=r.getBoundingClientRect();return[_.clientX-w.left,_.clientY-w.top]}function p([_,w]){let v={point:-1,away:pA};for(let E=0;E<t.movable.length;E++){if(!t.movable[E])continue;let[A,y]=d(E),M=Math.hypot(A-_,y-w);M<v.away&&(v={point:E,away:M})}return v.point}function x(_){let[w,v]=f(_),E=new W().fromArray(t.frame.points,3*h),A=E.clone().project(o.camera).z;return new W(2*w/r.clientWidth-1,1-2*v/r.clientHeight,A).unproject(o.camera).sub(E).multiplyScalar(i/(mA*e)).clampLength(0,i).toArray()}function m(_,w){let[v,E]=[d(h),f(_)];for(let[A,y]of[["x1",v[0]],["y1",v[1]],["x2",E[0]],["y2",E[1]]])a.setAttribute(A,y);l.style.display="",c.textContent=`pushed with ${Pe(w)} N`}r.addEventListener("pointerdown",_=>{let w=_.button===0?p(f(_)):-1;w<0||(h=w,o.controls.enabled=!1,r.setPointerCapture(_.pointerId),_.stopImmediatePropagation())},{capture:!0}),r.addEventListener("pointermove",_=>{if(h===null){r.classList.toggle("grip",p(f(_))>=0);return}let w=x(_);s(h,w),m(_,Math.hypot(...w))});let g=()=>{h!==null&&(h=null,o.controls.enabled=!0,l.style.display="none",c.textContent="",s(0,null))};r.addEventListener("pointerup",g),r.addEventListener("pointercancel",g)}var Wa=200,gA=20,xA=3;function qg(n,t,e){let i=n.map(o=>_A(o,t,e)),s=S("button",{type:"button",disabled:!0},`Reset all to ${t}`);s.addEventListener("click",()=>i.forEach(o=>o.reset()));let r=S("div",{className:"sliders",role:"group","aria-label":"values to change"});return r.append(...i.map(o=>o.element),s),{element:r,set(o){for(let a of i)a.put(o[a.knob.key]??a.knob.value)},get changes(){let o=i.filter(a=>a.value!==a.knob.value);return Object.fromEntries(o.map(a=>[a.knob.key,a.value]))},refresh(){s.disabled=i.every(o=>o.value===o.knob.value)}}}function _A(n,t,e){let{key:i,title:s,unit:r,factor:o,lowest:a,highest:l}=n,c=a>0&&l/a>=gA,u=E=>c?a*(l/a)**E:a+E*(l-a),h=E=>c?Math.log(E/a)/Math.log(l/a):(E-a)/(l-a),d=Math.round(Wa*h(n.value)),f=ke(i.replace("protocol.","").replace("youngs","Young's").replaceAll(/[._]/g," ")),p=S("input",{type:"range",min:0,max:Wa,step:1,"aria-label":f,"aria-description":s}),x=S("output"),m=S("span",{className:"home",title:`in ${t}`,"aria-hidden":"true"});m.style.left=`${100*d/Wa}%`,p.dataset.keys="own";let g=n.value;function _(){let E=`${Pe(o*g)} ${r.replaceAll("^2","²").replaceAll("^3","³")}`;x.textContent=E,p.setAttribute("aria-valuetext",g===n.value?`${E}, as in ${t}`:E),v.classList.toggle("changed",g!==n.value)}function w(E){g=E,p.value=Math.round(Wa*h(g)),_(),e(i,g)}p.addEventListener("input",()=>{let E=Number(p.value);g=E===d?n.value:Number((o*u(E/Wa)).toPrecision(xA))/o,_(),e(i,g)});let v=S("label",{className:"slider",title:`${i}: ${s}`},S("span",{className:"name"},f),x,S("span",{className:"rail"},p,m));return p.value=d,_(),{element:v,knob:n,get value(){return g},put:w,reset:()=>w(n.value)}}var yA=[["real time",1],["1/2",.5],["1/5",.2],["1/20",.05],["1/100",.01]],vA=.2,bA=1.4,SA="Values were changed, or it was pushed, during the motion, which no run of a design file repeats. “Whole protocol” runs these settings from the start.",MA=1e-15;async function wo(n,t,e,i,{look:s,pace:r=vA,set:o}={}){let a=JSON.parse(e),l={frame:null,engine:null,pace:r},c=await i(e,M=>A(M)),u=Sg(n,a,c.first),h=S("p",{className:"verdict",role:"status"}),d=S("p",{className:"note"}),f=S("p",{className:"time"}),p=S("p",{className:"account"}),x=S("div"),m=S("div"),g=Gg(a),_=qg(a.knobs,t.kind==="bench"?"the design":"this run",(M,P)=>{c.send({act:"set",values:{[M]:P}}),_.refresh(),g.refresh(_.changes),o?.(M,zg(a,M,P))}),w=AA(a,c,l,()=>{h.textContent="",d.textContent=""}),v=a.motors.every(M=>M.kind==="torque")?"torques":"drives",E=null;function A(M){if(M.said==="refused"){h.textContent=`The simulator stopped: ${M.why}.`;return}M.said==="frame"&&y(M.frame)}function y(M){l.frame=M,u.show(M),f.textContent=`${ir(M.time_s,{start:0,end:Math.max(1,M.time_s)})}${EA(M,a.protocol)}`;let P=M.energies_J.reduce((D,V)=>D+V,0),L=M.works_J.reduce((D,V)=>D+V,0),I=[...n.tendons?[`tendon energy ${kd(P)}`]:[],`work of the ${v} ${kd(L)}`];p.textContent=I.join(" · ");let F=M.stageNumber===null?M.ended:null,k=F&&JSON.stringify([F.verdict,...F.stages.map(D=>D.end_s)]);k!==E&&(h.textContent=F?TA(F,t.whole,a.texts.outcome):"",d.textContent=[F?.advice,F&&M.meddled&&SA].filter(Boolean).join(" ")),E=k}return l.element=S("div",{className:"trial"},S("div",{className:"seen"},S("div",{className:"choices"},...w),S("div",{className:"live-facts"},f,p),h,d,x,m),S("div",{className:"hands"},_.element,...o?[]:[g.element])),l.begin=()=>{let M=s??{...xr(),following:!1,closer:t.kind==="bench"?bA:1},{stage:P}=bo(x,[u.clip],u.clock,{...t,text:`${t.shape}, live.`},M);if(l.stage=P,So(m,u.clip,u.clock,t.energy),Mo(l.element),P){u.movable=a.anchors.bodies.map(F=>F>0);let L=wA(a,n.mesh.span_m),I=(F,k)=>c.send({act:"push",point:F,force:k});Xg(P,u,n.mesh.span_m,L,I),x.querySelector(".picture").after($g(P,u,a.anchors.names,L,I))}y(c.first),c.send({act:"pace",value:l.pace}),c.send({act:"restart",through:!1}),t.kind!=="bench"&&w[0].focus()},l.leave=()=>l.stage?.dispose(),Object.assign(l,{engine:c,live:u,sliders:_,design:g,own:a})}function wA({protocol:n,motors:t},e){let i=n.drives.map(({strength:s,torques:r})=>{let o=t[r.findIndex(a=>a!==0)];return o?.kind==="torque"?Math.abs(s)/e:o?.kind==="force"?Math.abs(s):0});return Math.max(...i)||1}function AA({protocol:n},t,e,i){let s=(a,l,c)=>{let u=S("button",{type:"button",title:c});return u.append(a),u.addEventListener("click",()=>{i(),t.send(l)}),u},r=n.stages.flatMap(({name:a,drives:l},c)=>{if(!l.length)return[];let u=n.stages.findIndex((d,f)=>f>c&&d.drives.length>0),h=(u<0?n.stages.length:u)-1;return[s(ke(a),{act:"stages",from:c,to:h},`the stage "${a}" of the protocol, and what follows without a drive`)]}),o=S("select",{},...yA.map(([a,l])=>S("option",{value:l,selected:l===e.pace},a)));return o.addEventListener("change",()=>{e.pace=Number(o.value),t.send({act:"pace",value:e.pace})}),[s("Start again",{act:"restart",through:!1},"from the start of the run"),...r,s("Release",{act:"release"},"without any drive"),s("Whole protocol",{act:"restart",through:!0},"all stages, as in the run"),S("label",{},"speed ",o)]}function EA({stage:n,stageNumber:t,running:e,ended:i},{stages:s}){let r=n&&!s[t].drives.length&&i?.stages.at(-1),a=r&&r.goal_s!==null&&s.find(({name:l})=>l===r.name).drives.length?`, ${r.name} reached its goal in ${Or(r.goal_s-r.start_s,"s")}`:"";return n?` · ${n}${a}`:e?" · no drive acts":" · at rest"}function TA({status:n,verdict:t,transitions:e},i,s){let r=e.filter(({took:o})=>o?.succeeded&&o.time_s!==null).map(({words:o,took:a})=>nh(s.transition,{did:o.did||o.done,time:Or(a.time_s,"s"),work:kd(a.work_J)}));return r.length?nh(s[t==="reached"?"reached":"missed"],{whole:i,transitions:r.join(s.then),status:n}):`${ke(n)}.`}var kd=n=>Or(Math.abs(n)<MA?0:n,"J");function pu(n,t,e,i){if(!n)return null;let s={panel:null,failed:"",start:null},r=document.getElementById("live").textContent,o=S("button",{type:"button",className:"try"},"Try it"),a=S("p",{className:"note"});a.textContent=`Move this ${e.whole} yourself: change values, switch drives, release it, push it. The simulator runs in this page.`,n.append(S("div",{className:"offer"},o,a));function l(u){s.failed=u,o.disabled=!0,a.textContent=`This ${e.whole} cannot be simulated in a page: ${u}. Use the command line: forficula run.`}let c=JSON.parse(r.startsWith('{"refused"')?r:"null");return c!==null?l(c.refused):ru()||l("this page was written without the engine"),s.start=async()=>{if(!o.disabled){o.disabled=!0,a.setAttribute("role","status"),a.textContent="Starting the simulator …",i();try{s.panel=await wo(t,e,r,yo),n.replaceChildren(S("h2",{},"Try it"),s.panel.element),s.panel.begin()}catch(u){l(u.message)}}},o.addEventListener("click",s.start),s}function Yg(n){let t=jn(n.clips[0]),e=pu(document.getElementById("try"),t,n,()=>{});return e.start(),{clips:[t],trial:e}}var CA=200;function bs(n,t){let e=new Set,i=t[0].start,s=t[0],r="even",o=!1,a=0,l=0,c=new Map;function u(){return c.has(s)||c.set(s,Og(n,s)),c.get(s)}let h=()=>r==="even"&&s.whole;function d(_){return h()?u().wayAt(_):(_-s.start)/(s.end-s.start||1)}function f(_){return h()?u().timeAt(_):s.start+_*(s.end-s.start)}function p(){l||(l=requestAnimationFrame(x))}function x(_){if(l=0,o){let w=Math.min((_-a)/1e3,.1);a=_,m(w),l=requestAnimationFrame(x)}for(let w of e)w()}function m(_){r==="even"?i=u().timeAt(Math.min(1,u().wayAt(i)+_/u().seconds)):i=Math.min(s.end,i+r*_),i>=s.end&&(o=!1)}function g(_){i=Math.min(s.end,Math.max(s.start,_)),p()}return{get time(){return i},get span(){return s},get speed(){return r},get playing(){return o},spans:t,clipTime:(_,w=i)=>Math.min(n[_].end,Math.max(n[_].start,w+s.origins[_])),get stretched(){return h()},shareAt:d,momentAt:f,wayAt:_=>u().wayAt(_),timeAt:_=>u().timeAt(_),get slowness(){if(r!=="even")return 1/r;let _=u().wayAt(i),[w,v]=[Math.max(0,_-5e-4),Math.min(1,_+5e-4)];return(v-w)*u().seconds/(u().timeAt(v)-u().timeAt(w)||1e-12)},onChange(_){return e.add(_),p(),()=>e.delete(_)},seek:g,seekClip(_,w){(w<s.start+s.origins[_]||w>s.end+s.origins[_])&&(s=t.find(v=>w>=v.start+v.origins[_]&&w<=v.end+v.origins[_])??t[0]),g(w-s.origins[_])},step:_=>g(f(d(i)+_/CA)),play(){i>=s.end&&(i=s.start),o=!0,a=performance.now(),p()},pause(){o=!1,p()},setSpeed(_){r=_,p()},setSpan(_){s=_,g(i<s.start||i>s.end?s.start:i)},redraw:p}}var RA="uplot",PA="u-hz",IA="u-vt",LA="u-title",NA="u-wrap",DA="u-under",UA="u-over",OA="u-axis",vr="u-off",FA="u-select",kA="u-cursor-x",BA="u-cursor-y",zA="u-cursor-pt",VA="u-legend",GA="u-live",HA="u-inline",WA="u-series",$A="u-marker",Zg="u-label",XA="u-value",Xa="width",qa="height";var Kg="bottom",Ao="left",Bd="right",nf="#000",Jg=nf+"0",zd="mousemove",jg="mousedown",Vd="mouseup",Qg="mouseenter",t0="mouseleave",e0="dblclick",qA="resize",YA="scroll",n0="change",yu="dppxchange",sf="--",Lo=typeof window<"u",Xd=Lo?document:null,To=Lo?window:null,ZA=Lo?navigator:null,we,mu;function qd(){let n=devicePixelRatio;we!=n&&(we=n,mu&&Zd(n0,mu,qd),mu=matchMedia(`(min-resolution: ${we-.001}dppx) and (max-resolution: ${we+.001}dppx)`),br(n0,mu,qd),To.dispatchEvent(new CustomEvent(yu)))}function di(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function Yd(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function $e(n,t,e){n.style[t]=e+"px"}function Li(n,t,e,i){let s=Xd.createElement(n);return t!=null&&di(s,t),e?.insertBefore(s,i),s}function vi(n,t){return Li("div",n,t)}var i0=new WeakMap;function Ji(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=i0.get(n);r!=o&&(n.style.transform=r,i0.set(n,r),t<0||e<0||t>i||e>s?di(n,vr):Yd(n,vr))}var s0=new WeakMap;function r0(n,t,e){let i=t+e,s=s0.get(n);i!=s&&(s0.set(n,i),n.style.background=t,n.style.borderColor=e)}var o0=new WeakMap;function a0(n,t,e,i){let s=t+""+e,r=o0.get(n);s!=r&&(o0.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var rf={passive:!0},KA={...rf,capture:!0};function br(n,t,e,i){t.addEventListener(n,e,i?KA:rf)}function Zd(n,t,e,i){t.removeEventListener(n,e,rf)}Lo&&qd();function Ni(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:fi((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function U0(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var O0=n=>n!=null,F0=n=>n!=null&&n>0,Su=U0(O0),JA=U0(F0);function jA(n,t,e,i=0,s=!1){let r=s?JA:Su,o=s?F0:O0;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Ue,l??-Ue]}function Mu(n,t,e,i){let s=u0(n),r=u0(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?Ss:k0,a=s==1?fi:bi,l=r==1?bi:fi,c=a(o(Mn(n))),u=l(o(Mn(t))),h=Co(e,c),d=Co(e,u);return e==10&&(c<0&&(h=Oe(h,-c)),u<0&&(d=Oe(d,-u))),i||e==2?(n=h*s,t=d*r):(n=G0(n,h),t=wu(t,d)),[n,t]}function of(n,t,e,i){let s=Mu(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var af=.1,l0={mode:3,pad:af},Za={pad:0,soft:null,mode:0},QA={min:Za,max:Za};function vu(n,t,e,i){return Au(e)?c0(n,t,e):(Za.pad=e,Za.soft=i?0:null,Za.mode=i?3:0,c0(n,t,QA))}function be(n,t){return n??t}function tE(n,t,e){for(t=be(t,0),e=be(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function c0(n,t,e){let i=e.min,s=e.max,r=be(i.pad,0),o=be(s.pad,0),a=be(i.hard,-Ue),l=be(s.hard,Ue),c=be(i.soft,Ue),u=be(s.soft,-Ue),h=be(i.mode,0),d=be(s.mode,0),f=t-n,p=Ss(f),x=Zn(Mn(n),Mn(t)),m=Ss(x),g=Mn(m-p);(f<1e-24||g>10)&&(f=0,(n==0||t==0)&&(f=1e-24,h==2&&c!=Ue&&(r=0),d==2&&u!=-Ue&&(o=0)));let _=f||x||1e3,w=Ss(_),v=Co(10,fi(w)),E=_*(f==0?n==0?.1:1:r),A=Oe(G0(n-E,v/10),24),y=n>=c&&(h==1||h==3&&A<=c||h==2&&A>=c)?c:Ue,M=Zn(a,A<y&&n>=y?y:Di(y,A)),P=_*(f==0?t==0?.1:1:o),L=Oe(wu(t+P,v/10),24),I=t<=u&&(d==1||d==3&&L>=u||d==2&&L<=u)?u:-Ue,F=Di(l,L>I&&t<=I?I:Zn(I,L));return M==F&&M==0&&(F=100),[M,F]}var eE=new Intl.NumberFormat(Lo?ZA.language:"en-US"),lf=n=>eE.format(n),pi=Math,_u=pi.PI,Mn=pi.abs,fi=pi.floor,Sn=pi.round,bi=pi.ceil,Di=pi.min,Zn=pi.max,Co=pi.pow,u0=pi.sign,Ss=pi.log10,k0=pi.log2,nE=(n,t=1)=>pi.sinh(n)*t,Gd=(n,t=1)=>pi.asinh(n/t),Ue=1/0;function h0(n){return(Ss((n^n>>31)-(n>>31))|0)+1}function Kd(n,t,e){return Di(Zn(n,t),e)}function B0(n){return typeof n=="function"}function _e(n){return B0(n)?n:()=>n}var iE=()=>{},z0=n=>n,V0=(n,t)=>t,sE=n=>null,d0=n=>!0,f0=(n,t)=>n==t,rE=/\.\d*?(?=9{6,}|0{6,})/gm,Sr=n=>{if(W0(n)||Js.has(n))return n;let t=`${n}`,e=t.match(rE);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Sr(s)}e${r}`}return Oe(n,i)};function _r(n,t){return Sr(Oe(Sr(n/t))*t)}function wu(n,t){return Sr(bi(Sr(n/t))*t)}function G0(n,t){return Sr(fi(Sr(n/t))*t)}function Oe(n,t=0){if(W0(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return Sn(i)/e}var Js=new Map;function H0(n){return((""+n).split(".")[1]||"").length}function Ja(n,t,e,i){let s=[],r=i.map(H0);for(let o=t;o<e;o++){let a=Mn(o),l=Oe(Co(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=n==10?u:Oe(u,h);s.push(d),Js.set(d,h)}}return s}var Ka={},cf=[],Ro=[null,null],Ks=Array.isArray,W0=Number.isInteger,oE=n=>n===void 0;function p0(n){return typeof n=="string"}function Au(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function aE(n){return n!=null&&typeof n=="object"}var lE=Object.getPrototypeOf(Uint8Array),$0="__proto__";function Po(n,t=Au){let e;if(Ks(n)){let i=n.find(s=>s!=null);if(Ks(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=Po(n[s],t)}else e=n.slice()}else if(n instanceof lE)e=n.slice();else if(t(n)){e={};for(let i in n)i!=$0&&(e[i]=Po(n[i],t))}else e=n;return e}function mn(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=$0&&(Au(n[s])?mn(n[s],Po(i[s])):n[s]=Po(i[s]))}return n}var cE=0,uE=1,hE=2;function dE(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function fE(n,t){if(gE(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return xE(o[0])||(o=mE(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),d=t?t[o][c]:uE,f=[];for(let p=0;p<u.length;p++){let x=u[p],m=r.get(l[p]);x===null?d!=cE&&(h[m]=x,d==hE&&f.push(m)):h[m]=x}dE(h,f,s),i.push(h)}}return i}var pE=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function mE(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function gE(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function xE(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Zn(1,fi((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var X0=["January","February","March","April","May","June","July","August","September","October","November","December"],q0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Y0(n){return n.slice(0,3)}var _E=q0.map(Y0),yE=X0.map(Y0),vE={MMMM:X0,MMM:yE,WWWW:q0,WWW:_E};function $a(n){return(n<10?"0":"")+n}function bE(n){return(n<10?"00":n<100?"0":"")+n}var SE={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>$a(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>$a(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>$a(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>$a(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>$a(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>bE(n.getMilliseconds())};function uf(n,t){t=t||vE;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?SE[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var ME=new Intl.DateTimeFormat().resolvedOptions().timeZone;function wE(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==ME?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var Z0=n=>n%1==0,bu=[1,2,2.5,5],AE=Ja(10,-32,0,bu),K0=Ja(10,0,32,bu),EE=K0.filter(Z0),yr=AE.concat(K0),hf=`
`,J0="{YYYY}",m0=hf+J0,j0="{M}/{D}",Ya=hf+j0,gu=Ya+"/{YY}",Q0="{aa}",TE="{h}:{mm}",Eo=TE+Q0,g0=hf+Eo,x0=":{ss}",Ee=null;function tx(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?Ja(10,0,3,bu).filter(Z0):Ja(10,-3,0,bu)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,J0,Ee,Ee,Ee,Ee,Ee,Ee,1],[s*28,"{MMM}",m0,Ee,Ee,Ee,Ee,Ee,1],[s,j0,m0,Ee,Ee,Ee,Ee,Ee,1],[i,"{h}"+Q0,gu,Ee,Ya,Ee,Ee,Ee,1],[e,Eo,gu,Ee,Ya,Ee,Ee,Ee,1],[t,x0,gu+" "+Eo,Ee,Ya+" "+Eo,Ee,g0,Ee,1],[n,x0+".{fff}",gu+" "+Eo,Ee,Ya+" "+Eo,Ee,g0,Ee,1]];function u(h){return(d,f,p,x,m,g)=>{let _=[],w=m>=o,v=m>=r&&m<o,E=h(p),A=Oe(E*n,3),y=Hd(E.getFullYear(),w?0:E.getMonth(),v||w?1:E.getDate()),M=Oe(y*n,3);if(v||w){let P=v?m/r:0,L=w?m/o:0,I=A==M?A:Oe(Hd(y.getFullYear()+L,y.getMonth()+P,1)*n,3),F=new Date(Sn(I/n)),k=F.getFullYear(),D=F.getMonth();for(let V=0;I<=x;V++){let X=Hd(k+L*V,D+P*V,1),H=X-h(Oe(X*n,3));I=Oe((+X+H)*n,3),I<=x&&_.push(I)}}else{let P=m>=s?s:m,L=fi(p)-fi(A),I=M+L+wu(A-M,P);_.push(I);let F=h(I),k=F.getHours()+F.getMinutes()/e+F.getSeconds()/i,D=m/i,V=d.axes[f]._space,X=g/V;for(;I=Oe(I+m,n==1?0:3),!(I>x);)if(D>1){let H=fi(Oe(k+D,6))%24,Q=h(I).getHours()-H;Q>1&&(Q=-1),I-=Q*i,k=(k+D)%24;let it=_[_.length-1];Oe((I-it)/m,3)*X>=.7&&_.push(I)}else _.push(I)}return _}}return[l,c,u]}var[CE,RE,PE]=tx(1),[IE,LE,NE]=tx(.001);Ja(2,-53,53,[1]);function _0(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function y0(n,t){return(e,i,s,r,o)=>{let a=t.find(p=>o>=p[0])||t[t.length-1],l,c,u,h,d,f;return i.map(p=>{let x=n(p),m=x.getFullYear(),g=x.getMonth(),_=x.getDate(),w=x.getHours(),v=x.getMinutes(),E=x.getSeconds(),A=m!=l&&a[2]||g!=c&&a[3]||_!=u&&a[4]||w!=h&&a[5]||v!=d&&a[6]||E!=f&&a[7]||a[1];return l=m,c=g,u=_,h=w,d=v,f=E,A(x)})}}function DE(n,t){let e=uf(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function Hd(n,t,e){return new Date(n,t,e)}function v0(n,t){return t(n)}var UE="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function b0(n,t){return(e,i,s,r)=>r==null?sf:t(n(i))}function OE(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function FE(n,t){return n.series[t].fill(n,t)}var kE={show:!0,live:!0,isolate:!1,mount:iE,markers:{show:!0,width:2,stroke:OE,fill:FE,dash:"solid"},idx:null,idxs:null,values:[]};function BE(n,t){let e=n.cursor.points,i=vi(),s=e.size(n,t);$e(i,Xa,s),$e(i,qa,s);let r=s/-2;$e(i,"marginLeft",r),$e(i,"marginTop",r);let o=e.width(n,t,s);return o&&$e(i,"borderWidth",o),i}function zE(n,t){let e=n.series[t].points;return e._fill||e._stroke}function VE(n,t){let e=n.series[t].points;return e._stroke||e._fill}function GE(n,t){return n.series[t].points.size}var Wd=[0,0];function HE(n,t,e){return Wd[0]=t,Wd[1]=e,Wd}function xu(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function $d(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var WE={show:!0,x:!0,y:!0,lock:!1,move:HE,points:{one:!1,show:BE,size:GE,width:0,stroke:VE,fill:zE},bind:{mousedown:xu,mouseup:xu,click:xu,dblclick:xu,mousemove:$d,mouseleave:$d,mouseenter:$d},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},ex={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},df=mn({},ex,{filter:V0}),nx=mn({},df,{size:10}),ix=mn({},ex,{show:!1}),ff='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',sx="bold "+ff,rx=1.5,S0={show:!0,scale:"x",stroke:nf,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:sx,side:2,grid:df,ticks:nx,border:ix,font:ff,lineGap:rx,rotate:0},$E="Value",XE="Time",M0={show:!0,scale:"x",auto:!1,sorted:1,min:Ue,max:-Ue,idxs:[]};function qE(n,t,e,i,s){return t.map(r=>r==null?"":lf(r))}function YE(n,t,e,i,s,r,o){let a=[],l=Js.get(s)||0;e=o?e:Oe(wu(e,s),l);for(let c=e;c<=i;c=Oe(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Jd(n,t,e,i,s,r,o){let a=[],l=n.scales[n.axes[t].scale].log,c=l==10?Ss:k0,u=fi(c(e));s=Co(l,u),l==10&&(s=yr[Ni(s,yr)]);let h=e,d=s*l;l==10&&(d=yr[Ni(d,yr)]);do a.push(h),h=h+s,l==10&&!Js.has(h)&&(h=Oe(h,Js.get(s))),h>=d&&(s=h,d=s*l,l==10&&(d=yr[Ni(d,yr)]));while(h<=i);return a}function ZE(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?Jd(n,t,Zn(l,e),i,s):[l],u=i>=0&&e<=0?[0]:[];return(e<-l?Jd(n,t,Zn(l,-i),-e,s):[l]).reverse().map(d=>-d).concat(u,c)}var ox=/./,KE=/[12357]/,JE=/[125]/,w0=/1/,jd=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function jE(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?ox:l(7,o)-u>=c?KE:l(5,o)-u>=c?JE:w0;if(h==w0){let d=Mn(l(1,o)-u);if(d<c)return jd(t.slice().reverse(),a.distr,h,bi(c/d)).reverse()}return jd(t,a.distr,h,1)}function QE(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=Mn(l(1,o)-l(2,o));return c<a?jd(t.slice().reverse(),3,ox,bi(a/c)).reverse():t}function tT(n,t,e,i){return i==null?sf:t==null?"":lf(t)}var A0={show:!0,scale:"y",stroke:nf,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:sx,side:3,grid:df,ticks:nx,border:ix,font:ff,lineGap:rx,rotate:0};function eT(n,t){let e=3+(n||1)*2;return Oe(e*t,3)}function nT(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=Mn(o-r),l=n.series[t],c=a/(l.points.space*we);return i[1]-i[0]<=c}var E0={scale:null,auto:!0,sorted:0,min:Ue,max:-Ue},ax=(n,t,e,i,s)=>s,T0={show:!0,auto:!0,sorted:0,gaps:ax,alpha:1,facets:[mn({},E0,{scale:"x"}),mn({},E0,{scale:"y"})]},C0={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:ax,alpha:1,points:{show:nT,filter:null},values:null,min:Ue,max:-Ue,idxs:[],path:null,clip:null};function iT(n,t,e,i,s){return e/10}var lx={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},sT=mn({},lx,{time:!1,ori:1}),R0={};function cx(n,t){let e=R0[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(R0[n]=e)),e}var Io=1,Qd=2;function Mr(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[t],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,p=a.width,x=a.height,m=n.valToPosH,g=n.valToPosV;return u.ori==0?e(s,l,c,u,h,m,g,d,f,p,x,Tu,No,Ru,hx,fx):e(s,l,c,u,h,g,m,f,d,x,p,Cu,Do,gf,dx,px)}function pf(n,t){let e=0,i=0,s=be(n.bands,cf);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function rT(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ms(n,t,e,i,s,r){return Mr(n,t,(o,a,l,c,u,h,d,f,p,x,m)=>{let g=o.pxRound,_=c.dir*(c.ori==0?1:-1),w=c.ori==0?No:Do,v,E;_==1?(v=e,E=i):(v=i,E=e);let A=g(h(a[v],c,x,f)),y=g(d(l[v],u,m,p)),M=g(h(a[E],c,x,f)),P=g(d(r==1?u.max:u.min,u,m,p)),L=new Path2D(s);return w(L,M,P),w(L,A,P),w(L,A,y),L})}function Eu(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?Ru:gf,l=e;for(let h=0;h<n.length;h++){let d=n[h];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,i,f,i+r),l=d[1]}}let c=e+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function oT(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function mf(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let h=c,d=c;if(s==1)for(;++c<=i&&t[c]===null;)d=c;else for(;--c>=e&&t[c]===null;)d=c;let f=r(n[h]),p=d==h?f:r(n[d]),x=h-s;f=o<=0&&x>=0&&x<l?r(n[x]):f;let g=d+s;p=o>=0&&g>=0&&g<l?r(n[g]):p,p>=f&&a.push([f,p])}return a}function P0(n){return n==0?z0:n==1?Sn:t=>_r(t,n)}function ux(n){let t=n==0?Tu:Cu,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Di(c,a/2,l/2),u=Di(u,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,u),e(s,r,o+l,r,o,u),e(s,r,o,r+a,o,c),s.closePath())}}var Tu=(n,t,e)=>{n.moveTo(t,e)},Cu=(n,t,e)=>{n.moveTo(e,t)},No=(n,t,e)=>{n.lineTo(t,e)},Do=(n,t,e)=>{n.lineTo(e,t)},Ru=ux(0),gf=ux(1),hx=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},dx=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},fx=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},px=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function mx(n){return(t,e,i,s,r)=>Mr(t,e,(o,a,l,c,u,h,d,f,p,x,m)=>{let{pxRound:g,points:_}=o,w,v;c.ori==0?(w=Tu,v=hx):(w=Cu,v=dx);let E=Oe(_.width*we,3),A=(_.size-_.width)/2*we,y=Oe(A*2,3),M=new Path2D,P=new Path2D,{left:L,top:I,width:F,height:k}=t.bbox;Ru(P,L-y,I-y,F+y*2,k+y*2);let D=V=>{if(l[V]!=null){let X=g(h(a[V],c,x,f)),H=g(d(l[V],u,m,p));w(M,X+A,H),v(M,X,H,A,0,_u*2)}};if(r)r.forEach(D);else for(let V=i;V<=s;V++)D(V);return{stroke:E>0?M:null,fill:M,clip:P,flags:Io|Qd}})}function gx(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var aT=gx(No),lT=gx(Do);function xx(n){let t=be(n?.alignGaps,0);return(e,i,s,r)=>Mr(e,i,(o,a,l,c,u,h,d,f,p,x,m)=>{[s,r]=Su(l,s,r);let g=o.pxRound,_=k=>g(h(k,c,x,f)),w=k=>g(d(k,u,m,p)),v,E;c.ori==0?(v=No,E=aT):(v=Do,E=lT);let A=c.dir*(c.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Io},M=y.stroke,P=!1;if(r-s>=x*4){let k=dt=>e.posToVal(dt,c.key,!0),D=null,V=null,X,H,lt,Z=_(a[A==1?s:r]),Q=_(a[s]),it=_(a[r]),ft=k(A==1?Q+1:it-1);for(let dt=A==1?s:r;dt>=s&&dt<=r;dt+=A){let tt=a[dt],gt=(A==1?tt<ft:tt>ft)?Z:_(tt),St=l[dt];gt==Z?St!=null?(H=St,D==null?(v(M,gt,w(H)),X=D=V=H):H<D?D=H:H>V&&(V=H)):St===null&&(P=!0):(D!=null&&E(M,Z,w(D),w(V),w(X),w(H)),St!=null?(H=St,v(M,gt,w(H)),D=V=X=H):(D=V=null,St===null&&(P=!0)),Z=gt,ft=k(Z+A))}D!=null&&D!=V&&lt!=Z&&E(M,Z,w(D),w(V),w(X),w(H))}else for(let k=A==1?s:r;k>=s&&k<=r;k+=A){let D=l[k];D===null?P=!0:D!=null&&v(M,_(a[k]),w(D))}let[I,F]=pf(e,i);if(o.fill!=null||I!=0){let k=y.fill=new Path2D(M),D=o.fillTo(e,i,o.min,o.max,I),V=w(D),X=_(a[s]),H=_(a[r]);A==-1&&([H,X]=[X,H]),v(k,H,V),v(k,X,V)}if(!o.spanGaps){let k=[];P&&k.push(...mf(a,l,s,r,A,_,t)),y.gaps=k=o.gaps(e,i,s,r,k),y.clip=Eu(k,c.ori,f,p,x,m)}return F!=0&&(y.band=F==2?[Ms(e,i,s,r,M,-1),Ms(e,i,s,r,M,1)]:Ms(e,i,s,r,M,F)),y})}function cT(n){let t=be(n.align,1),e=be(n.ascDesc,!1),i=be(n.alignGaps,0),s=be(n.extend,!1);return(r,o,a,l)=>Mr(r,o,(c,u,h,d,f,p,x,m,g,_,w)=>{[a,l]=Su(h,a,l);let v=c.pxRound,{left:E,width:A}=r.bbox,y=Q=>v(p(Q,d,_,m)),M=Q=>v(x(Q,f,w,g)),P=d.ori==0?No:Do,L={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Io},I=L.stroke,F=d.dir*(d.ori==0?1:-1),k=M(h[F==1?a:l]),D=y(u[F==1?a:l]),V=D,X=D;s&&t==-1&&(X=E,P(I,X,k)),P(I,D,k);for(let Q=F==1?a:l;Q>=a&&Q<=l;Q+=F){let it=h[Q];if(it==null)continue;let ft=y(u[Q]),dt=M(it);t==1?P(I,ft,k):P(I,V,dt),P(I,ft,dt),k=dt,V=ft}let H=V;s&&t==1&&(H=E+A,P(I,H,k));let[lt,Z]=pf(r,o);if(c.fill!=null||lt!=0){let Q=L.fill=new Path2D(I),it=c.fillTo(r,o,c.min,c.max,lt),ft=M(it);P(Q,H,ft),P(Q,X,ft)}if(!c.spanGaps){let Q=[];Q.push(...mf(u,h,a,l,F,y,i));let it=c.width*we/2,ft=e||t==1?it:-it,dt=e||t==-1?-it:it;Q.forEach(tt=>{tt[0]+=ft,tt[1]+=dt}),L.gaps=Q=c.gaps(r,o,a,l,Q),L.clip=Eu(Q,d.ori,m,g,_,w)}return Z!=0&&(L.band=Z==2?[Ms(r,o,a,l,I,-1),Ms(r,o,a,l,I,1)]:Ms(r,o,a,l,I,Z)),L})}function I0(n,t,e,i,s,r,o=Ue){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let u=Mn(n[l]-n[a]);u<c&&(c=u,o=Mn(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function uT(n){n=n||Ka;let t=be(n.size,[.6,Ue,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=_e(s),o=1-t[0],a=be(t[1],Ue),l=be(t[2],1),c=be(n.disp,Ka),u=be(n.each,f=>{}),{fill:h,stroke:d}=c;return(f,p,x,m)=>Mr(f,p,(g,_,w,v,E,A,y,M,P,L,I)=>{let F=g.pxRound,k=e,D=i*we,V=a*we,X=l*we,H,lt;v.ori==0?[H,lt]=r(f,p):[lt,H]=r(f,p);let Z=v.dir*(v.ori==0?1:-1),Q=v.ori==0?Ru:gf,it=v.ori==0?u:(Rt,qt,re,wt,De,zt,$t)=>{u(Rt,qt,re,De,wt,$t,zt)},ft=be(f.bands,cf).find(Rt=>Rt.series[0]==p),dt=ft!=null?ft.dir:0,tt=g.fillTo(f,p,g.min,g.max,dt),ht=F(y(tt,E,I,P)),gt,St,Mt,Ht=L,se=F(g.width*we),Vt=!1,ue=null,ae=null,ne=null,Xe=null;h!=null&&(se==0||d!=null)&&(Vt=!0,ue=h.values(f,p,x,m),ae=new Map,new Set(ue).forEach(Rt=>{Rt!=null&&ae.set(Rt,new Path2D)}),se>0&&(ne=d.values(f,p,x,m),Xe=new Map,new Set(ne).forEach(Rt=>{Rt!=null&&Xe.set(Rt,new Path2D)})));let{x0:Fe,size:ln}=c;if(Fe!=null&&ln!=null){k=1,_=Fe.values(f,p,x,m),Fe.unit==2&&(_=_.map(re=>f.posToVal(M+re*L,v.key,!0)));let Rt=ln.values(f,p,x,m);ln.unit==2?St=Rt[0]*L:St=A(Rt[0],v,L,M)-A(0,v,L,M),Ht=I0(_,w,A,v,L,M,Ht),Mt=Ht-St+D}else Ht=I0(_,w,A,v,L,M,Ht),Mt=Ht*o+D,St=Ht-Mt;Mt<1&&(Mt=0),se>=St/2&&(se=0),Mt<5&&(F=z0);let Le=Mt>0,wn=Ht-Mt-(Le?se:0);St=F(Kd(wn,X,V)),gt=(k==0?St/2:k==Z?0:St)-k*Z*((k==0?D/2:0)+(Le?se/2:0));let ye={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},gn=Vt?null:new Path2D,Ke=null;if(ft!=null)Ke=f.data[ft.series[1]];else{let{y0:Rt,y1:qt}=c;Rt!=null&&qt!=null&&(w=qt.values(f,p,x,m),Ke=Rt.values(f,p,x,m))}let cn=H*St,z=lt*St;for(let Rt=Z==1?x:m;Rt>=x&&Rt<=m;Rt+=Z){let qt=w[Rt];if(qt==null)continue;if(Ke!=null){let q=Ke[Rt]??0;if(qt-q==0)continue;ht=y(q,E,I,P)}let re=v.distr!=2||c!=null?_[Rt]:Rt,wt=A(re,v,L,M),De=y(be(qt,tt),E,I,P),zt=F(wt-gt),$t=F(Zn(De,ht)),N=F(Di(De,ht)),T=$t-N;if(qt!=null){let q=qt<0?z:cn,ut=qt<0?cn:z;Vt?(se>0&&ne[Rt]!=null&&Q(Xe.get(ne[Rt]),zt,N+fi(se/2),St,Zn(0,T-se),q,ut),ue[Rt]!=null&&Q(ae.get(ue[Rt]),zt,N+fi(se/2),St,Zn(0,T-se),q,ut)):Q(gn,zt,N+fi(se/2),St,Zn(0,T-se),q,ut),it(f,p,Rt,zt-se/2,N,St+se,T)}}return se>0?ye.stroke=Vt?Xe:gn:Vt||(ye._fill=g.width==0?g._fill:g._stroke??g._fill,ye.width=0),ye.fill=Vt?ae:gn,ye})}function hT(n,t){let e=be(t?.alignGaps,0);return(i,s,r,o)=>Mr(i,s,(a,l,c,u,h,d,f,p,x,m,g)=>{[r,o]=Su(c,r,o);let _=a.pxRound,w=H=>_(d(H,u,m,p)),v=H=>_(f(H,h,g,x)),E,A,y;u.ori==0?(E=Tu,y=No,A=fx):(E=Cu,y=Do,A=px);let M=u.dir*(u.ori==0?1:-1),P=w(l[M==1?r:o]),L=P,I=[],F=[];for(let H=M==1?r:o;H>=r&&H<=o;H+=M)if(c[H]!=null){let Z=l[H],Q=w(Z);I.push(L=Q),F.push(v(c[H]))}let k={stroke:n(I,F,E,y,A,_),fill:null,clip:null,band:null,gaps:null,flags:Io},D=k.stroke,[V,X]=pf(i,s);if(a.fill!=null||V!=0){let H=k.fill=new Path2D(D),lt=a.fillTo(i,s,a.min,a.max,V),Z=v(lt);y(H,L,Z),y(H,P,Z)}if(!a.spanGaps){let H=[];H.push(...mf(l,c,r,o,M,w,e)),k.gaps=H=a.gaps(i,s,r,o,H),k.clip=Eu(H,u.ori,p,x,m,g)}return X!=0&&(k.band=X==2?[Ms(i,s,r,o,D,-1),Ms(i,s,r,o,D,1)]:Ms(i,s,r,o,D,X)),k})}function dT(n){return hT(fT,n)}function fT(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let d=0;d<o-1;d++)u[d]=t[d+1]-t[d],h[d]=n[d+1]-n[d],c[d]=u[d]/h[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(h[d-1]+h[d])/((2*h[d]+h[d-1])/c[d-1]+(h[d]+2*h[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,n[d]+h[d]/3,t[d]+l[d]*h[d]/3,n[d+1]-h[d]/3,t[d+1]-l[d+1]*h[d]/3,n[d+1],t[d+1])}return a}var tf=new Set;function L0(){for(let n of tf)n.syncRect(!0)}Lo&&(br(qA,To,L0),br(YA,To,L0,!0),br(yu,To,()=>{an.pxRatio=we}));var pT=xx(),mT=mx();function N0(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>ef(r,o,t,e))}function gT(n,t){return n.map((e,i)=>i==0?{}:mn({},t,e))}function ef(n,t,e,i){return mn({},t==0?e:i,n)}function _x(n,t,e){return t==null?Ro:[t,e]}var xT=_x;function _T(n,t,e){return t==null?Ro:vu(t,e,af,!0)}function yx(n,t,e,i){return t==null?Ro:Mu(t,e,n.scales[i].log,!1)}var yT=yx;function vx(n,t,e,i){return t==null?Ro:of(t,e,n.scales[i].log,!1)}var vT=vx;function bT(n,t,e,i,s){let r=Zn(h0(n),h0(t)),o=t-n,a=Ni(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?Js.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function D0(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=Sn((e=+s)*we))+"px"),[n,t,e]}function ST(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=Oe(t[2]*we,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function an(n,t,e){let i={mode:be(n.mode,1)},s=i.mode;function r(b,C,U,O){let $=C.valToPct(b);return O+U*(C.dir==-1?1-$:$)}function o(b,C,U,O){let $=C.valToPct(b);return O+U*(C.dir==-1?$:1-$)}function a(b,C,U,O){return C.ori==0?r(b,C,U,O):o(b,C,U,O)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=vi(RA);if(n.id!=null&&(c.id=n.id),di(c,n.class),n.title){let b=vi(LA,c);b.textContent=n.title}let u=Li("canvas"),h=i.ctx=u.getContext("2d"),d=vi(NA,c);br("click",d,b=>{b.target===p&&(Ve!=Ir||qe!=Lr)&&In.click(i,b)},!0);let f=i.under=vi(DA,d);d.appendChild(u);let p=i.over=vi(UA,d);n=Po(n);let x=+be(n.pxAlign,1),m=P0(x);(n.plugins||[]).forEach(b=>{b.opts&&(n=b.opts(i,n)||n)});let g=n.ms||.001,_=i.series=s==1?N0(n.series||[],M0,C0,!1):gT(n.series||[null],T0),w=i.axes=N0(n.axes||[],S0,A0,!0),v=i.scales={},E=i.bands=n.bands||[];E.forEach(b=>{b.fill=_e(b.fill||null),b.dir=be(b.dir,-1)});let A=s==2?_[1].facets[0].scale:_[0].scale,y={axes:ns,series:de},M=(n.drawOrder||["axes","series"]).map(b=>y[b]);function P(b){let C=b.distr==3?U=>Ss(U>0?U:b.clamp(i,U,b.min,b.max,b.key)):b.distr==4?U=>Gd(U,b.asinh):b.distr==100?U=>b.fwd(U):U=>U;return U=>{let O=C(U),{_min:$,_max:J}=b,at=J-$;return(O-$)/at}}function L(b){let C=v[b];if(C==null){let U=(n.scales||Ka)[b]||Ka;if(U.from!=null){L(U.from);let O=mn({},v[U.from],U,{key:b});O.valToPct=P(O),v[b]=O}else{C=v[b]=mn({},b==A?lx:sT,U),C.key=b;let O=C.time,$=C.range,J=Ks($);if((b!=A||s==2&&!O)&&(J&&($[0]==null||$[1]==null)&&($={min:$[0]==null?l0:{mode:1,hard:$[0],soft:$[0]},max:$[1]==null?l0:{mode:1,hard:$[1],soft:$[1]}},J=!1),!J&&Au($))){let at=$;$=(pt,vt,Nt)=>vt==null?Ro:vu(vt,Nt,at)}C.range=_e($||(O?xT:b==A?C.distr==3?yT:C.distr==4?vT:_x:C.distr==3?yx:C.distr==4?vx:_T)),C.auto=_e(J?!1:C.auto),C.clamp=_e(C.clamp||iT),C._min=C._max=null,C.valToPct=P(C)}}}L("x"),L("y"),s==1&&_.forEach(b=>{L(b.scale)}),w.forEach(b=>{L(b.scale)});for(let b in n.scales)L(b);let I=v[A],F=I.distr,k,D;I.ori==0?(di(c,PA),k=r,D=o):(di(c,IA),k=o,D=r);let V={};for(let b in v){let C=v[b];(C.min!=null||C.max!=null)&&(V[b]={min:C.min,max:C.max},C.min=C.max=null)}let X=n.tzDate||(b=>new Date(Sn(b/g))),H=n.fmtDate||uf,lt=g==1?PE(X):NE(X),Z=y0(X,_0(g==1?RE:LE,H)),Q=b0(X,v0(UE,H)),it=[],ft=i.legend=mn({},kE,n.legend),dt=i.cursor=mn({},WE,{drag:{y:s==2}},n.cursor),tt=ft.show,ht=dt.show,gt=ft.markers;ft.idxs=it,gt.width=_e(gt.width),gt.dash=_e(gt.dash),gt.stroke=_e(gt.stroke),gt.fill=_e(gt.fill);let St,Mt,Ht,se=[],Vt=[],ue,ae=!1,ne={};if(ft.live){let b=_[1]?_[1].values:null;ae=b!=null,ue=ae?b(i,1,0):{_:0};for(let C in ue)ne[C]=sf}if(tt)if(St=Li("table",VA,c),Ht=Li("tbody",null,St),ft.mount(i,St),ae){Mt=Li("thead",null,St,Ht);let b=Li("tr",null,Mt);Li("th",null,b);for(var Xe in ue)Li("th",Zg,b).textContent=Xe}else di(St,HA),ft.live&&di(St,GA);let Fe={show:!0},ln={show:!1};function Le(b,C){if(C==0&&(ae||!ft.live||s==2))return Ro;let U=[],O=Li("tr",WA,Ht,Ht.childNodes[C]);di(O,b.class),b.show||di(O,vr);let $=Li("th",null,O);if(gt.show){let pt=vi($A,$);if(C>0){let vt=gt.width(i,C);vt&&(pt.style.border=vt+"px "+gt.dash(i,C)+" "+gt.stroke(i,C)),pt.style.background=gt.fill(i,C)}}let J=vi(Zg,$);b.label instanceof HTMLElement?J.appendChild(b.label):J.textContent=b.label,C>0&&(gt.show||(J.style.color=b.width>0?gt.stroke(i,C):gt.fill(i,C)),ye("click",$,pt=>{if(dt._lock)return;Kt(pt);let vt=_.indexOf(b);if((pt.ctrlKey||pt.metaKey)!=ft.isolate){let Nt=_.some((Dt,Ot)=>Ot>0&&Ot!=vt&&Dt.show);_.forEach((Dt,Ot)=>{Ot>0&&ki(Ot,Nt?Ot==vt?Fe:ln:Fe,!0,fn.setSeries)})}else ki(vt,{show:!b.show},!0,fn.setSeries)},!1),Jt&&ye(Qg,$,pt=>{dt._lock||(Kt(pt),ki(_.indexOf(b),Dr,!0,fn.setSeries))},!1));for(var at in ue){let pt=Li("td",XA,O);pt.textContent="--",U.push(pt)}return[O,U]}let wn=new Map;function ye(b,C,U,O=!0){let $=wn.get(C)||{},J=dt.bind[b](i,C,U,O);J&&(br(b,C,$[b]=J),wn.set(C,$))}function gn(b,C,U){let O=wn.get(C)||{};for(let $ in O)(b==null||$==b)&&(Zd($,C,O[$]),delete O[$]);b==null&&wn.delete(C)}let Ke=0,cn=0,z=0,Rt=0,qt=0,re=0,wt=qt,De=re,zt=z,$t=Rt,N=0,T=0,q=0,ut=0;i.bbox={};let ot=!1,_t=!1,yt=!1,et=!1,st=!1,mt=!1;function B(b,C,U){(U||b!=i.width||C!=i.height)&&rt(b,C),le(!1),yt=!0,_t=!0,Dn()}function rt(b,C){i.width=Ke=z=b,i.height=cn=Rt=C,qt=re=0,bt(),Gt();let U=i.bbox;N=U.left=_r(qt*we,.5),T=U.top=_r(re*we,.5),q=U.width=_r(z*we,.5),ut=U.height=_r(Rt*we,.5)}let nt=3;function At(){let b=!1,C=0;for(;!b;){C++;let U=Cr(C),O=Fi(C);b=C==nt||U&&O,b||(rt(i.width,i.height),_t=!0)}}function xt({width:b,height:C}){B(b,C)}i.setSize=xt;function bt(){let b=!1,C=!1,U=!1,O=!1;w.forEach(($,J)=>{if($.show&&$._show){let{side:at,_size:pt}=$,vt=at%2,Nt=$.label!=null?$.labelSize:0,Dt=pt+Nt;Dt>0&&(vt?(z-=Dt,at==3?(qt+=Dt,O=!0):U=!0):(Rt-=Dt,at==0?(re+=Dt,b=!0):C=!0))}}),Ui[0]=b,Ui[1]=U,Ui[2]=C,Ui[3]=O,z-=Si[1]+Si[3],qt+=Si[3],Rt-=Si[2]+Si[0],re+=Si[0]}function Gt(){let b=qt+z,C=re+Rt,U=qt,O=re;function $(J,at){switch(J){case 1:return b+=at,b-at;case 2:return C+=at,C-at;case 3:return U-=at,U+at;case 0:return O-=at,O+at}}w.forEach((J,at)=>{if(J.show&&J._show){let pt=J.side;J._pos=$(pt,J._size),J.label!=null&&(J._lpos=$(pt,J.labelSize))}})}if(dt.dataIdx==null){let b=dt.hover,C=b.skip=new Set(b.skip??[]);C.add(void 0);let U=b.prox=_e(b.prox),O=b.bias??=0;dt.dataIdx=($,J,at,pt)=>{if(J==0)return at;let vt=at,Nt=U($,J,at,pt)??Ue,Dt=Nt>=0&&Nt<Ue,Ot=I.ori==0?z:Rt,ie=dt.left,Se=t[0],ve=t[J];if(C.has(ve[at])){vt=null;let me=null,Zt=null,Wt;if(O==0||O==-1)for(Wt=at;me==null&&Wt-- >0;)C.has(ve[Wt])||(me=Wt);if(O==0||O==1)for(Wt=at;Zt==null&&Wt++<ve.length;)C.has(ve[Wt])||(Zt=Wt);if(me!=null||Zt!=null)if(Dt){let He=me==null?-1/0:k(Se[me],I,Ot,0),Qe=Zt==null?1/0:k(Se[Zt],I,Ot,0),Cn=ie-He,Ne=Qe-ie;Cn<=Ne?Cn<=Nt&&(vt=me):Ne<=Nt&&(vt=Zt)}else vt=Zt==null?me:me==null?Zt:at-me<=Zt-at?me:Zt}else Dt&&Mn(ie-k(Se[at],I,Ot,0))>Nt&&(vt=null);return vt}}let Kt=b=>{dt.event=b};dt.idxs=it,dt._lock=!1;let ct=dt.points;ct.show=_e(ct.show),ct.size=_e(ct.size),ct.stroke=_e(ct.stroke),ct.width=_e(ct.width),ct.fill=_e(ct.fill);let Ft=i.focus=mn({},n.focus||{alpha:.3},dt.focus),Jt=Ft.prox>=0,Ct=Jt&&ct.one,oe=[],ze=[],zn=[];function Bo(b,C){let U=ct.show(i,C);if(U instanceof HTMLElement)return di(U,zA),di(U,b.class),Ji(U,-10,-10,z,Rt),p.insertBefore(U,oe[C]),U}function Ar(b,C){if(s==1||C>0){let U=s==1&&v[b.scale].time,O=b.value;b.value=U?p0(O)?b0(X,v0(O,H)):O||Q:O||tT,b.label=b.label||(U?XE:$E)}if(Ct||C>0){b.width=b.width==null?1:b.width,b.paths=b.paths||pT||sE,b.fillTo=_e(b.fillTo||rT),b.pxAlign=+be(b.pxAlign,x),b.pxRound=P0(b.pxAlign),b.stroke=_e(b.stroke||null),b.fill=_e(b.fill||null),b._stroke=b._fill=b._paths=b._focus=null;let U=eT(Zn(1,b.width),1),O=b.points=mn({},{size:U,width:Zn(1,U*.2),stroke:b.stroke,space:U*2,paths:mT,_stroke:null,_fill:null},b.points);O.show=_e(O.show),O.filter=_e(O.filter),O.fill=_e(O.fill),O.stroke=_e(O.stroke),O.paths=_e(O.paths),O.pxAlign=b.pxAlign}if(tt){let U=Le(b,C);se.splice(C,0,U[0]),Vt.splice(C,0,U[1]),ft.values.push(null)}if(ht){it.splice(C,0,null);let U=null;Ct?C==0&&(U=Bo(b,C)):C>0&&(U=Bo(b,C)),oe.splice(C,0,U),ze.splice(C,0,0),zn.splice(C,0,0)}Tn("addSeries",C)}function Xu(b,C){C=C??_.length,b=s==1?ef(b,C,M0,C0):ef(b,C,{},T0),_.splice(C,0,b),Ar(_[C],C)}i.addSeries=Xu;function tl(b){if(_.splice(b,1),tt){ft.values.splice(b,1),Vt.splice(b,1);let C=se.splice(b,1)[0];gn(null,C.firstChild),C.remove()}ht&&(it.splice(b,1),oe.splice(b,1)[0].remove(),ze.splice(b,1),zn.splice(b,1)),Tn("delSeries",b)}i.delSeries=tl;let Ui=[!1,!1,!1,!1];function Qi(b,C){if(b._show=b.show,b.show){let U=b.side%2,O=v[b.scale];O==null&&(b.scale=U?_[1].scale:A,O=v[b.scale]);let $=O.time;b.size=_e(b.size),b.space=_e(b.space),b.rotate=_e(b.rotate),Ks(b.incrs)&&b.incrs.forEach(at=>{!Js.has(at)&&Js.set(at,H0(at))}),b.incrs=_e(b.incrs||(O.distr==2?EE:$?g==1?CE:IE:yr)),b.splits=_e(b.splits||($&&O.distr==1?lt:O.distr==3?Jd:O.distr==4?ZE:YE)),b.stroke=_e(b.stroke),b.grid.stroke=_e(b.grid.stroke),b.ticks.stroke=_e(b.ticks.stroke),b.border.stroke=_e(b.border.stroke);let J=b.values;b.values=Ks(J)&&!Ks(J[0])?_e(J):$?Ks(J)?y0(X,_0(J,H)):p0(J)?DE(X,J):J||Z:J||qE,b.filter=_e(b.filter||(O.distr>=3&&O.log==10?jE:O.distr==3&&O.log==2?QE:V0)),b.font=D0(b.font),b.labelFont=D0(b.labelFont),b._size=b.size(i,null,C,0),b._space=b._rotate=b._incrs=b._found=b._splits=b._values=null,b._size>0&&(Ui[C]=!0,b._el=vi(OA,d))}}function ts(b,C,U,O){let[$,J,at,pt]=U,vt=C%2,Nt=0;return vt==0&&(pt||J)&&(Nt=C==0&&!$||C==2&&!at?Sn(S0.size/3):0),vt==1&&($||at)&&(Nt=C==1&&!J||C==3&&!pt?Sn(A0.size/2):0),Nt}let zo=i.padding=(n.padding||[ts,ts,ts,ts]).map(b=>_e(be(b,ts))),Si=i._padding=zo.map((b,C)=>b(i,C,Ui,0)),Je,sn=null,rn=null,Oi=s==1?_[0].idxs:null,ti=null,As=!1;function Vo(b,C){if(t=b??[],i.data=i._data=t,s==2){Je=0;for(let U=1;U<_.length;U++)Je+=t[U][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),ti=t[0],Je=ti.length;let U=t;if(F==2){U=t.slice();let O=U[0]=Array(Je);for(let $=0;$<Je;$++)O[$]=$}i._data=t=U}if(le(!0),Tn("setData"),F==2&&(yt=!0),C!==!1){let U=I;U.auto(i,As)?Go():Cs(A,U.min,U.max),et=et||dt.left>=0,mt=!0,Dn()}}i.setData=Vo;function Go(){As=!0;let b,C;s==1&&(Je>0?(sn=Oi[0]=0,rn=Oi[1]=Je-1,b=t[0][sn],C=t[0][rn],F==2?(b=sn,C=rn):b==C&&(F==3?[b,C]=Mu(b,b,I.log,!1):F==4?[b,C]=of(b,b,I.log,!1):I.time?C=b+Sn(86400/g):[b,C]=vu(b,C,af,!0))):(sn=Oi[0]=b=null,rn=Oi[1]=C=null)),Cs(A,b,C)}let Er,Es,Tr,R,G,j,Y,K,Et,Pt;function Tt(b,C,U,O,$,J){b??=Jg,U??=cf,O??="butt",$??=Jg,J??="round",b!=Er&&(h.strokeStyle=Er=b),$!=Es&&(h.fillStyle=Es=$),C!=Tr&&(h.lineWidth=Tr=C),J!=G&&(h.lineJoin=G=J),O!=j&&(h.lineCap=j=O),U!=R&&h.setLineDash(R=U)}function It(b,C,U,O){C!=Es&&(h.fillStyle=Es=C),b!=Y&&(h.font=Y=b),U!=K&&(h.textAlign=K=U),O!=Et&&(h.textBaseline=Et=O)}function Bt(b,C,U,O,$=0){if(O.length>0&&b.auto(i,As)&&(C==null||C.min==null)){let J=be(sn,0),at=be(rn,O.length-1),pt=U.min==null?jA(O,J,at,$,b.distr==3):[U.min,U.max];b.min=Di(b.min,U.min=pt[0]),b.max=Zn(b.max,U.max=pt[1])}}let te={min:null,max:null};function he(){for(let O in v){let $=v[O];V[O]==null&&($.min==null||V[A]!=null&&$.auto(i,As))&&(V[O]=te)}for(let O in v){let $=v[O];V[O]==null&&$.from!=null&&V[$.from]!=null&&(V[O]=te)}V[A]!=null&&le(!0);let b={};for(let O in V){let $=V[O];if($!=null){let J=b[O]=Po(v[O],aE);if($.min!=null)mn(J,$);else if(O!=A||s==2)if(Je==0&&J.from==null){let at=J.range(i,null,null,O);J.min=at[0],J.max=at[1]}else J.min=Ue,J.max=-Ue}}if(Je>0){_.forEach((O,$)=>{if(s==1){let J=O.scale,at=V[J];if(at==null)return;let pt=b[J];if($==0){let vt=pt.range(i,pt.min,pt.max,J);pt.min=vt[0],pt.max=vt[1],sn=Ni(pt.min,t[0]),rn=Ni(pt.max,t[0]),rn-sn>1&&(t[0][sn]<pt.min&&sn++,t[0][rn]>pt.max&&rn--),O.min=ti[sn],O.max=ti[rn]}else O.show&&O.auto&&Bt(pt,at,O,t[$],O.sorted);O.idxs[0]=sn,O.idxs[1]=rn}else if($>0&&O.show&&O.auto){let[J,at]=O.facets,pt=J.scale,vt=at.scale,[Nt,Dt]=t[$],Ot=b[pt],ie=b[vt];Ot!=null&&Bt(Ot,V[pt],J,Nt,J.sorted),ie!=null&&Bt(ie,V[vt],at,Dt,at.sorted),O.min=at.min,O.max=at.max}});for(let O in b){let $=b[O],J=V[O];if($.from==null&&(J==null||J.min==null)){let at=$.range(i,$.min==Ue?null:$.min,$.max==-Ue?null:$.max,O);$.min=at[0],$.max=at[1]}}}for(let O in b){let $=b[O];if($.from!=null){let J=b[$.from];if(J.min==null)$.min=$.max=null;else{let at=$.range(i,J.min,J.max,O);$.min=at[0],$.max=at[1]}}}let C={},U=!1;for(let O in b){let $=b[O],J=v[O];if(J.min!=$.min||J.max!=$.max){J.min=$.min,J.max=$.max;let at=J.distr;J._min=at==3?Ss(J.min):at==4?Gd(J.min,J.asinh):at==100?J.fwd(J.min):J.min,J._max=at==3?Ss(J.max):at==4?Gd(J.max,J.asinh):at==100?J.fwd(J.max):J.max,C[O]=U=!0}}if(U){_.forEach((O,$)=>{s==2?$>0&&C.y&&(O._paths=null):C[O.scale]&&(O._paths=null)});for(let O in C)yt=!0,Tn("setScale",O);ht&&dt.left>=0&&(et=mt=!0)}for(let O in V)V[O]=null}function kt(b){let C=Kd(sn-1,0,Je-1),U=Kd(rn+1,0,Je-1);for(;b[C]==null&&C>0;)C--;for(;b[U]==null&&U<Je-1;)U++;return[C,U]}function de(){if(Je>0){let b=_.some(C=>C._focus)&&Pt!=Ft.alpha;b&&(h.globalAlpha=Pt=Ft.alpha),_.forEach((C,U)=>{if(U>0&&C.show&&(Ze(U,!1),Ze(U,!0),C._paths==null)){let O=Pt;Pt!=C.alpha&&(h.globalAlpha=Pt=C.alpha);let $=s==2?[0,t[U][0].length-1]:kt(t[U]);C._paths=C.paths(i,U,$[0],$[1]),Pt!=O&&(h.globalAlpha=Pt=O)}}),_.forEach((C,U)=>{if(U>0&&C.show){let O=Pt;Pt!=C.alpha&&(h.globalAlpha=Pt=C.alpha),C._paths!=null&&Te(U,!1);{let $=C._paths!=null?C._paths.gaps:null,J=C.points.show(i,U,sn,rn,$),at=C.points.filter(i,U,J,$);(J||at)&&(C.points._paths=C.points.paths(i,U,sn,rn,at),Te(U,!0))}Pt!=O&&(h.globalAlpha=Pt=O),Tn("drawSeries",U)}}),b&&(h.globalAlpha=Pt=1)}}function Ze(b,C){let U=C?_[b].points:_[b];U._stroke=U.stroke(i,b),U._fill=U.fill(i,b)}function Te(b,C){let U=C?_[b].points:_[b],{stroke:O,fill:$,clip:J,flags:at,_stroke:pt=U._stroke,_fill:vt=U._fill,_width:Nt=U.width}=U._paths;Nt=Oe(Nt*we,3);let Dt=null,Ot=Nt%2/2;C&&vt==null&&(vt=Nt>0?"#fff":pt);let ie=U.pxAlign==1&&Ot>0;if(ie&&h.translate(Ot,Ot),!C){let Se=N-Nt/2,ve=T-Nt/2,me=q+Nt,Zt=ut+Nt;Dt=new Path2D,Dt.rect(Se,ve,me,Zt)}C?Ut(pt,Nt,U.dash,U.cap,vt,O,$,at,J):Ce(b,pt,Nt,U.dash,U.cap,vt,O,$,at,Dt,J),ie&&h.translate(-Ot,-Ot)}function Ce(b,C,U,O,$,J,at,pt,vt,Nt,Dt){let Ot=!1;vt!=0&&E.forEach((ie,Se)=>{if(ie.series[0]==b){let ve=_[ie.series[1]],me=t[ie.series[1]],Zt=(ve._paths||Ka).band;Ks(Zt)&&(Zt=ie.dir==1?Zt[0]:Zt[1]);let Wt,He=null;ve.show&&Zt&&tE(me,sn,rn)?(He=ie.fill(i,Se)||J,Wt=ve._paths.clip):Zt=null,Ut(C,U,O,$,He,at,pt,vt,Nt,Dt,Wt,Zt),Ot=!0}}),Ot||Ut(C,U,O,$,J,at,pt,vt,Nt,Dt)}let xn=Io|Qd;function Ut(b,C,U,O,$,J,at,pt,vt,Nt,Dt,Ot){Tt(b,C,U,O,$),(vt||Nt||Ot)&&(h.save(),vt&&h.clip(vt),Nt&&h.clip(Nt)),Ot?(pt&xn)==xn?(h.clip(Ot),Dt&&h.clip(Dt),ge($,at),un(b,J,C)):pt&Qd?(ge($,at),h.clip(Ot),un(b,J,C)):pt&Io&&(h.save(),h.clip(Ot),Dt&&h.clip(Dt),ge($,at),h.restore(),un(b,J,C)):(ge($,at),un(b,J,C)),(vt||Nt||Ot)&&h.restore()}function un(b,C,U){U>0&&(C instanceof Map?C.forEach((O,$)=>{h.strokeStyle=Er=$,h.stroke(O)}):C!=null&&b&&h.stroke(C))}function ge(b,C){C instanceof Map?C.forEach((U,O)=>{h.fillStyle=Es=O,h.fill(U)}):C!=null&&b&&h.fill(C)}function es(b,C,U,O){let $=w[b],J;if(O<=0)J=[0,0];else{let at=$._space=$.space(i,b,C,U,O),pt=$._incrs=$.incrs(i,b,C,U,O,at);J=bT(C,U,pt,O,at)}return $._found=J}function hn(b,C,U,O,$,J,at,pt,vt,Nt){let Dt=at%2/2;x==1&&h.translate(Dt,Dt),Tt(pt,at,vt,Nt,pt),h.beginPath();let Ot,ie,Se,ve,me=$+(O==0||O==3?-J:J);U==0?(ie=$,ve=me):(Ot=$,Se=me);for(let Zt=0;Zt<b.length;Zt++)C[Zt]!=null&&(U==0?Ot=Se=b[Zt]:ie=ve=b[Zt],h.moveTo(Ot,ie),h.lineTo(Se,ve));h.stroke(),x==1&&h.translate(-Dt,-Dt)}function Cr(b){let C=!0;return w.forEach((U,O)=>{if(!U.show)return;let $=v[U.scale];if($.min==null){U._show&&(C=!1,U._show=!1,le(!1));return}else U._show||(C=!1,U._show=!0,le(!1));let J=U.side,at=J%2,{min:pt,max:vt}=$,[Nt,Dt]=es(O,pt,vt,at==0?z:Rt);if(Dt==0)return;let Ot=$.distr==2,ie=U._splits=U.splits(i,O,pt,vt,Nt,Dt,Ot),Se=$.distr==2?ie.map(Wt=>ti[Wt]):ie,ve=$.distr==2?ti[ie[1]]-ti[ie[0]]:Nt,me=U._values=U.values(i,U.filter(i,Se,O,Dt,ve),O,Dt,ve);U._rotate=J==2?U.rotate(i,me,O,Dt):0;let Zt=U._size;U._size=bi(U.size(i,me,O,b)),Zt!=null&&U._size!=Zt&&(C=!1)}),C}function Fi(b){let C=!0;return zo.forEach((U,O)=>{let $=U(i,O,Ui,b);$!=Si[O]&&(C=!1),Si[O]=$}),C}function ns(){for(let b=0;b<w.length;b++){let C=w[b];if(!C.show||!C._show)continue;let U=C.side,O=U%2,$,J,at=C.stroke(i,b),pt=U==0||U==3?-1:1,[vt,Nt]=C._found;if(C.label!=null){let Hn=C.labelGap*pt,ii=Sn((C._lpos+Hn)*we);It(C.labelFont[0],at,"center",U==2?"top":Kg),h.save(),O==1?($=J=0,h.translate(ii,Sn(T+ut/2)),h.rotate((U==3?-_u:_u)/2)):($=Sn(N+q/2),J=ii);let er=B0(C.label)?C.label(i,b,vt,Nt):C.label;h.fillText(er,$,J),h.restore()}if(Nt==0)continue;let Dt=v[C.scale],Ot=O==0?q:ut,ie=O==0?N:T,Se=C._splits,ve=Dt.distr==2?Se.map(Hn=>ti[Hn]):Se,me=Dt.distr==2?ti[Se[1]]-ti[Se[0]]:vt,Zt=C.ticks,Wt=C.border,He=Zt.show?Zt.size:0,Qe=Sn(He*we),Cn=Sn((C.alignTo==2?C._size-He-C.gap:C.gap)*we),Ne=C._rotate*-_u/180,tn=m(C._pos*we),ei=(Qe+Cn)*pt,Gn=tn+ei;J=O==0?Gn:0,$=O==1?Gn:0;let mi=C.font[0],Mi=C.align==1?Ao:C.align==2?Bd:Ne>0?Ao:Ne<0?Bd:O==0?"center":U==3?Bd:Ao,zi=Ne||O==1?"middle":U==2?"top":Kg;It(mi,at,Mi,zi);let ni=C.font[1]*C.lineGap,gi=Se.map(Hn=>m(a(Hn,Dt,Ot,ie))),wi=C._values;for(let Hn=0;Hn<wi.length;Hn++){let ii=wi[Hn];if(ii!=null){O==0?$=gi[Hn]:J=gi[Hn],ii=""+ii;let er=ii.indexOf(`
`)==-1?[ii]:ii.split(/\n/gm);for(let Wn=0;Wn<er.length;Wn++){let ep=er[Wn];Ne?(h.save(),h.translate($,J+Wn*ni),h.rotate(Ne),h.fillText(ep,0,0),h.restore()):h.fillText(ep,$,J+Wn*ni)}}}Zt.show&&hn(gi,Zt.filter(i,ve,b,Nt,me),O,U,tn,Qe,Oe(Zt.width*we,3),Zt.stroke(i,b),Zt.dash,Zt.cap);let Vi=C.grid;Vi.show&&hn(gi,Vi.filter(i,ve,b,Nt,me),O,O==0?2:1,O==0?T:N,O==0?ut:q,Oe(Vi.width*we,3),Vi.stroke(i,b),Vi.dash,Vi.cap),Wt.show&&hn([tn],[1],O==0?1:0,O==0?1:2,O==1?T:N,O==1?ut:q,Oe(Wt.width*we,3),Wt.stroke(i,b),Wt.dash,Wt.cap)}Tn("drawAxes")}function le(b){_.forEach((C,U)=>{U>0&&(C._paths=null,b&&(s==1?(C.min=null,C.max=null):C.facets.forEach(O=>{O.min=null,O.max=null})))})}let je=!1,Vn=!1,Re=[];function dn(){Vn=!1;for(let b=0;b<Re.length;b++)Tn(...Re[b]);Re.length=0}function Dn(){je||(pE(Ff),je=!0)}function el(b,C=!1){je=!0,Vn=C,b(i),Ff(),C&&Re.length>0&&queueMicrotask(dn)}i.batch=el;function Ff(){if(ot&&(he(),ot=!1),yt&&(At(),yt=!1),_t){if($e(f,Ao,qt),$e(f,"top",re),$e(f,Xa,z),$e(f,qa,Rt),$e(p,Ao,qt),$e(p,"top",re),$e(p,Xa,z),$e(p,qa,Rt),$e(d,Xa,Ke),$e(d,qa,cn),u.width=Sn(Ke*we),u.height=Sn(cn*we),w.forEach(({_el:b,_show:C,_size:U,_pos:O,side:$})=>{if(b!=null)if(C){let J=$===3||$===0?U:0,at=$%2==1;$e(b,at?"left":"top",O-J),$e(b,at?"width":"height",U),$e(b,at?"top":"left",at?re:qt),$e(b,at?"height":"width",at?Rt:z),Yd(b,vr)}else di(b,vr)}),Er=Es=Tr=G=j=Y=K=Et=R=null,Pt=1,$o(!0),qt!=wt||re!=De||z!=zt||Rt!=$t){le(!1);let b=z/zt,C=Rt/$t;if(ht&&!et&&dt.left>=0){dt.left*=b,dt.top*=C,Rr&&Ji(Rr,Sn(dt.left),0,z,Rt),Pr&&Ji(Pr,0,Sn(dt.top),z,Rt);for(let U=0;U<oe.length;U++){let O=oe[U];O!=null&&(ze[U]*=b,zn[U]*=C,Ji(O,bi(ze[U]),bi(zn[U]),z,Rt))}}if(Ge.show&&!st&&Ge.left>=0&&Ge.width>0){Ge.left*=b,Ge.width*=b,Ge.top*=C,Ge.height*=C;for(let U in ju)$e(Nr,U,Ge[U])}wt=qt,De=re,zt=z,$t=Rt}Tn("setSize"),_t=!1}Ke>0&&cn>0&&(h.clearRect(0,0,u.width,u.height),Tn("drawClear"),M.forEach(b=>b()),Tn("draw")),Ge.show&&st&&(nl(Ge),st=!1),ht&&et&&(tr(null,!0,!1),et=!1),ft.show&&ft.live&&mt&&(Ku(),mt=!1),l||(l=!0,i.status=1,Tn("ready")),As=!1,je=!1}i.redraw=(b,C)=>{yt=C||!1,b!==!1?Cs(A,I.min,I.max):Dn()};function qu(b,C){let U=v[b];if(U.from==null){if(Je==0){let O=U.range(i,C.min,C.max,b);C.min=O[0],C.max=O[1]}if(C.min>C.max){let O=C.min;C.min=C.max,C.max=O}if(Je>1&&C.min!=null&&C.max!=null&&C.max-C.min<1e-16)return;b==A&&U.distr==2&&Je>0&&(C.min=Ni(C.min,t[0]),C.max=Ni(C.max,t[0]),C.min==C.max&&C.max++),V[b]=C,ot=!0,Dn()}}i.setScale=qu;let Yu,Zu,Rr,Pr,kf,Bf,Ir,Lr,zf,Vf,Ve,qe,Ts=!1,In=dt.drag,An=In.x,En=In.y;ht&&(dt.x&&(Yu=vi(kA,p)),dt.y&&(Zu=vi(BA,p)),I.ori==0?(Rr=Yu,Pr=Zu):(Rr=Zu,Pr=Yu),Ve=dt.left,qe=dt.top);let Ge=i.select=mn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Nr=Ge.show?vi(FA,Ge.over?p:f):null;function nl(b,C){if(Ge.show){for(let U in b)Ge[U]=b[U],U in ju&&$e(Nr,U,b[U]);C!==!1&&Tn("setSelect")}}i.setSelect=nl;function J_(b){if(_[b].show)tt&&Yd(se[b],vr);else if(tt&&di(se[b],vr),ht){let U=Ct?oe[0]:oe[b];U!=null&&Ji(U,-10,-10,z,Rt)}}function Cs(b,C,U){qu(b,{min:C,max:U})}function ki(b,C,U,O){C.focus!=null&&ny(b),C.show!=null&&_.forEach(($,J)=>{J>0&&(b==J||b==null)&&($.show=C.show,J_(J),s==2?(Cs($.facets[0].scale,null,null),Cs($.facets[1].scale,null,null)):Cs($.scale,null,null),Dn())}),U!==!1&&Tn("setSeries",b,C),O&&Xo("setSeries",i,b,C)}i.setSeries=ki;function j_(b,C){mn(E[b],C)}function Q_(b,C){b.fill=_e(b.fill||null),b.dir=be(b.dir,-1),C=C??E.length,E.splice(C,0,b)}function ty(b){b==null?E.length=0:E.splice(b,1)}i.addBand=Q_,i.setBand=j_,i.delBand=ty;function ey(b,C){_[b].alpha=C,ht&&oe[b]!=null&&(oe[b].style.opacity=C),tt&&se[b]&&(se[b].style.opacity=C)}let is,Rs,Qs,Dr={focus:!0};function ny(b){if(b!=Qs){let C=b==null,U=Ft.alpha!=1;_.forEach((O,$)=>{if(s==1||$>0){let J=C||$==0||$==b;O._focus=C?null:J,U&&ey($,J?1:Ft.alpha)}}),Qs=b,U&&Dn()}}tt&&Jt&&ye(t0,St,b=>{dt._lock||(Kt(b),Qs!=null&&ki(null,Dr,!0,fn.setSeries))});function Bi(b,C,U){let O=v[C];U&&(b=b/we-(O.ori==1?re:qt));let $=z;O.ori==1&&($=Rt,b=$-b),O.dir==-1&&(b=$-b);let J=O._min,at=O._max,pt=b/$,vt=J+(at-J)*pt,Nt=O.distr;return Nt==3?Co(10,vt):Nt==4?nE(vt,O.asinh):Nt==100?O.bwd(vt):vt}function iy(b,C){let U=Bi(b,A,C);return Ni(U,t[0],sn,rn)}i.valToIdx=b=>Ni(b,t[0]),i.posToIdx=iy,i.posToVal=Bi,i.valToPos=(b,C,U)=>v[C].ori==0?r(b,v[C],U?q:z,U?N:0):o(b,v[C],U?ut:Rt,U?T:0),i.setCursor=(b,C,U)=>{Ve=b.left,qe=b.top,tr(null,C,U)};function Gf(b,C){$e(Nr,Ao,Ge.left=b),$e(Nr,Xa,Ge.width=C)}function Hf(b,C){$e(Nr,"top",Ge.top=b),$e(Nr,qa,Ge.height=C)}let Ho=I.ori==0?Gf:Hf,Wo=I.ori==1?Gf:Hf;function sy(){if(tt&&ft.live)for(let b=s==2?1:0;b<_.length;b++){if(b==0&&ae)continue;let C=ft.values[b],U=0;for(let O in C)Vt[b][U++].firstChild.nodeValue=C[O]}}function Ku(b,C){if(b!=null&&(b.idxs?b.idxs.forEach((U,O)=>{it[O]=U}):oE(b.idx)||it.fill(b.idx),ft.idx=it[0]),tt&&ft.live){for(let U=0;U<_.length;U++)(U>0||s==1&&!ae)&&ry(U,it[U]);sy()}mt=!1,C!==!1&&Tn("setLegend")}i.setLegend=Ku;function ry(b,C){let U=_[b],O=b==0&&F==2?ti:t[b],$;ae?$=U.values(i,b,C)??ne:($=U.value(i,C==null?null:O[C],b,C),$=$==null?ne:{_:$}),ft.values[b]=$}function tr(b,C,U){zf=Ve,Vf=qe,[Ve,qe]=dt.move(i,Ve,qe),dt.left=Ve,dt.top=qe,ht&&(Rr&&Ji(Rr,Sn(Ve),0,z,Rt),Pr&&Ji(Pr,0,Sn(qe),z,Rt));let O,$=sn>rn;is=Ue,Rs=null;let J=I.ori==0?z:Rt,at=I.ori==1?z:Rt;if(Ve<0||Je==0||$){O=dt.idx=null;for(let pt=0;pt<_.length;pt++){let vt=oe[pt];vt!=null&&Ji(vt,-10,-10,z,Rt)}Jt&&ki(null,Dr,!0,b==null&&fn.setSeries),ft.live&&(it.fill(O),mt=!0)}else{let pt,vt,Nt;s==1&&(pt=I.ori==0?Ve:qe,vt=Bi(pt,A),O=dt.idx=Ni(vt,t[0],sn,rn),Nt=k(t[0][O],I,J,0));let Dt=-10,Ot=-10,ie=0,Se=0,ve=!0,me="",Zt="";for(let Wt=s==2?1:0;Wt<_.length;Wt++){let He=_[Wt],Qe=it[Wt],Cn=Qe==null?null:s==1?t[Wt][Qe]:t[Wt][1][Qe],Ne=dt.dataIdx(i,Wt,O,vt),tn=Ne==null?null:s==1?t[Wt][Ne]:t[Wt][1][Ne];if(mt=mt||tn!=Cn||Ne!=Qe,it[Wt]=Ne,Wt>0&&He.show){let ei=Ne==null?-10:Ne==O?Nt:k(s==1?t[0][Ne]:t[Wt][0][Ne],I,J,0),Gn=tn==null?-10:D(tn,s==1?v[He.scale]:v[He.facets[1].scale],at,0);if(Jt&&tn!=null){let mi=I.ori==1?Ve:qe,Mi=Mn(Ft.dist(i,Wt,Ne,Gn,mi));if(Mi<is){let zi=Ft.bias;if(zi!=0){let ni=Bi(mi,He.scale),gi=tn>=0?1:-1,wi=ni>=0?1:-1;wi==gi&&(wi==1?zi==1?tn>=ni:tn<=ni:zi==1?tn<=ni:tn>=ni)&&(is=Mi,Rs=Wt)}else is=Mi,Rs=Wt}}if(mt||Ct){let mi,Mi;I.ori==0?(mi=ei,Mi=Gn):(mi=Gn,Mi=ei);let zi,ni,gi,wi,Vi,Hn,ii=!0,er=ct.bbox;if(er!=null){ii=!1;let Wn=er(i,Wt);gi=Wn.left,wi=Wn.top,zi=Wn.width,ni=Wn.height}else gi=mi,wi=Mi,zi=ni=ct.size(i,Wt);if(Hn=ct.fill(i,Wt),Vi=ct.stroke(i,Wt),Ct)Wt==Rs&&is<=Ft.prox&&(Dt=gi,Ot=wi,ie=zi,Se=ni,ve=ii,me=Hn,Zt=Vi);else{let Wn=oe[Wt];Wn!=null&&(ze[Wt]=gi,zn[Wt]=wi,a0(Wn,zi,ni,ii),r0(Wn,Hn,Vi),Ji(Wn,bi(gi),bi(wi),z,Rt))}}}}if(Ct){let Wt=Ft.prox,He=Qs==null?is<=Wt:is>Wt||Rs!=Qs;if(mt||He){let Qe=oe[0];Qe!=null&&(ze[0]=Dt,zn[0]=Ot,a0(Qe,ie,Se,ve),r0(Qe,me,Zt),Ji(Qe,bi(Dt),bi(Ot),z,Rt))}}}if(Ge.show&&Ts)if(b!=null){let[pt,vt]=fn.scales,[Nt,Dt]=fn.match,[Ot,ie]=b.cursor.sync.scales,Se=b.cursor.drag;if(An=Se._x,En=Se._y,An||En){let{left:ve,top:me,width:Zt,height:Wt}=b.select,He=b.scales[Ot].ori,Qe=b.posToVal,Cn,Ne,tn,ei,Gn,mi=pt!=null&&Nt(pt,Ot),Mi=vt!=null&&Dt(vt,ie);mi&&An?(He==0?(Cn=ve,Ne=Zt):(Cn=me,Ne=Wt),tn=v[pt],ei=k(Qe(Cn,Ot),tn,J,0),Gn=k(Qe(Cn+Ne,Ot),tn,J,0),Ho(Di(ei,Gn),Mn(Gn-ei))):Ho(0,J),Mi&&En?(He==1?(Cn=ve,Ne=Zt):(Cn=me,Ne=Wt),tn=v[vt],ei=D(Qe(Cn,ie),tn,at,0),Gn=D(Qe(Cn+Ne,ie),tn,at,0),Wo(Di(ei,Gn),Mn(Gn-ei))):Wo(0,at)}else Qu()}else{let pt=Mn(zf-kf),vt=Mn(Vf-Bf);if(I.ori==1){let ie=pt;pt=vt,vt=ie}An=In.x&&pt>=In.dist,En=In.y&&vt>=In.dist;let Nt=In.uni;Nt!=null?An&&En&&(An=pt>=Nt,En=vt>=Nt,!An&&!En&&(vt>pt?En=!0:An=!0)):In.x&&In.y&&(An||En)&&(An=En=!0);let Dt,Ot;An&&(I.ori==0?(Dt=Ir,Ot=Ve):(Dt=Lr,Ot=qe),Ho(Di(Dt,Ot),Mn(Ot-Dt)),En||Wo(0,at)),En&&(I.ori==1?(Dt=Ir,Ot=Ve):(Dt=Lr,Ot=qe),Wo(Di(Dt,Ot),Mn(Ot-Dt)),An||Ho(0,J)),!An&&!En&&(Ho(0,0),Wo(0,0))}if(In._x=An,In._y=En,b==null){if(U){if(tp!=null){let[pt,vt]=fn.scales;fn.values[0]=pt!=null?Bi(I.ori==0?Ve:qe,pt):null,fn.values[1]=vt!=null?Bi(I.ori==1?Ve:qe,vt):null}Xo(zd,i,Ve,qe,z,Rt,O)}if(Jt){let pt=U&&fn.setSeries,vt=Ft.prox;Qs==null?is<=vt&&ki(Rs,Dr,!0,pt):is>vt?ki(null,Dr,!0,pt):Rs!=Qs&&ki(Rs,Dr,!0,pt)}}mt&&(ft.idx=O,Ku()),C!==!1&&Tn("setCursor")}let Ps=null;Object.defineProperty(i,"rect",{get(){return Ps==null&&$o(!1),Ps}});function $o(b=!1){b?Ps=null:(Ps=p.getBoundingClientRect(),Tn("syncRect",Ps))}function Wf(b,C,U,O,$,J,at){dt._lock||Ts&&b!=null&&b.movementX==0&&b.movementY==0||(Ju(b,C,U,O,$,J,at,!1,b!=null),b!=null?tr(null,!0,!0):tr(C,!0,!1))}function Ju(b,C,U,O,$,J,at,pt,vt){if(Ps==null&&$o(!1),Kt(b),b!=null)U=b.clientX-Ps.left,O=b.clientY-Ps.top;else{if(U<0||O<0){Ve=-10,qe=-10;return}let[Nt,Dt]=fn.scales,Ot=C.cursor.sync,[ie,Se]=Ot.values,[ve,me]=Ot.scales,[Zt,Wt]=fn.match,He=C.axes[0].side%2==1,Qe=I.ori==0?z:Rt,Cn=I.ori==1?z:Rt,Ne=He?J:$,tn=He?$:J,ei=He?O:U,Gn=He?U:O;if(ve!=null?U=Zt(Nt,ve)?a(ie,v[Nt],Qe,0):-10:U=Qe*(ei/Ne),me!=null?O=Wt(Dt,me)?a(Se,v[Dt],Cn,0):-10:O=Cn*(Gn/tn),I.ori==1){let mi=U;U=O,O=mi}}vt&&(C==null||C.cursor.event.type==zd)&&((U<=1||U>=z-1)&&(U=_r(U,z)),(O<=1||O>=Rt-1)&&(O=_r(O,Rt))),pt?(kf=U,Bf=O,[Ir,Lr]=dt.move(i,U,O)):(Ve=U,qe=O)}let ju={width:0,height:0,left:0,top:0};function Qu(){nl(ju,!1)}let $f,Xf,qf,Yf;function Zf(b,C,U,O,$,J,at){Ts=!0,An=En=In._x=In._y=!1,Ju(b,C,U,O,$,J,at,!0,!1),b!=null&&(ye(Vd,Xd,Kf,!1),Xo(jg,i,Ir,Lr,z,Rt,null));let{left:pt,top:vt,width:Nt,height:Dt}=Ge;$f=pt,Xf=vt,qf=Nt,Yf=Dt}function Kf(b,C,U,O,$,J,at){Ts=In._x=In._y=!1,Ju(b,C,U,O,$,J,at,!1,!0);let{left:pt,top:vt,width:Nt,height:Dt}=Ge,Ot=Nt>0||Dt>0,ie=$f!=pt||Xf!=vt||qf!=Nt||Yf!=Dt;if(Ot&&ie&&nl(Ge),In.setScale&&Ot&&ie){let Se=pt,ve=Nt,me=vt,Zt=Dt;if(I.ori==1&&(Se=vt,ve=Dt,me=pt,Zt=Nt),An&&Cs(A,Bi(Se,A),Bi(Se+ve,A)),En)for(let Wt in v){let He=v[Wt];Wt!=A&&He.from==null&&He.min!=Ue&&Cs(Wt,Bi(me+Zt,Wt),Bi(me,Wt))}Qu()}else dt.lock&&(dt._lock=!dt._lock,tr(C,!0,b!=null));b!=null&&(gn(Vd,Xd),Xo(Vd,i,Ve,qe,z,Rt,null))}function oy(b,C,U,O,$,J,at){if(dt._lock)return;Kt(b);let pt=Ts;if(Ts){let vt=!0,Nt=!0,Dt=10,Ot,ie;I.ori==0?(Ot=An,ie=En):(Ot=En,ie=An),Ot&&ie&&(vt=Ve<=Dt||Ve>=z-Dt,Nt=qe<=Dt||qe>=Rt-Dt),Ot&&vt&&(Ve=Ve<Ir?0:z),ie&&Nt&&(qe=qe<Lr?0:Rt),tr(null,!0,!0),Ts=!1}Ve=-10,qe=-10,it.fill(null),tr(null,!0,!0),pt&&(Ts=pt)}function Jf(b,C,U,O,$,J,at){dt._lock||(Kt(b),Go(),Qu(),b!=null&&Xo(e0,i,Ve,qe,z,Rt,null))}function jf(){w.forEach(ST),B(i.width,i.height,!0)}br(yu,To,jf);let Ur={};Ur.mousedown=Zf,Ur.mousemove=Wf,Ur.mouseup=Kf,Ur.dblclick=Jf,Ur.setSeries=(b,C,U,O)=>{let $=fn.match[2];U=$(i,C,U),U!=-1&&ki(U,O,!0,!1)},ht&&(ye(jg,p,Zf),ye(zd,p,Wf),ye(Qg,p,b=>{Kt(b),$o(!1)}),ye(t0,p,oy),ye(e0,p,Jf),tf.add(i),i.syncRect=$o);let il=i.hooks=n.hooks||{};function Tn(b,C,U){Vn?Re.push([b,C,U]):b in il&&il[b].forEach(O=>{O.call(null,i,C,U)})}(n.plugins||[]).forEach(b=>{for(let C in b.hooks)il[C]=(il[C]||[]).concat(b.hooks[C])});let Qf=(b,C,U)=>U,fn=mn({key:null,setSeries:!1,filters:{pub:d0,sub:d0},scales:[A,_[1]?_[1].scale:null],match:[f0,f0,Qf],values:[null,null]},dt.sync);fn.match.length==2&&fn.match.push(Qf),dt.sync=fn;let tp=fn.key,th=cx(tp);function Xo(b,C,U,O,$,J,at){fn.filters.pub(b,C,U,O,$,J,at)&&th.pub(b,C,U,O,$,J,at)}th.sub(i);function ay(b,C,U,O,$,J,at){fn.filters.sub(b,C,U,O,$,J,at)&&Ur[b](null,C,U,O,$,J,at)}i.pub=ay;function ly(){th.unsub(i),tf.delete(i),wn.clear(),Zd(yu,To,jf),c.remove(),St?.remove(),Tn("destroy")}i.destroy=ly;function eh(){Tn("init",n,t),Vo(t||n.data,!1),V[A]?qu(A,V[A]):Go(),st=Ge.show&&(Ge.width>0||Ge.height>0),et=mt=!0,B(n.width,n.height)}return _.forEach(Ar),w.forEach(Qi),e?e instanceof HTMLElement?(e.appendChild(c),eh()):e(i,eh):eh(),i}an.assign=mn;an.fmtNum=lf;an.rangeNum=vu;an.rangeLog=Mu;an.rangeAsinh=of;an.orient=Mr;an.pxRatio=we;an.join=fE;an.fmtDate=uf,an.tzDate=wE;an.sync=cx;{an.addGap=oT,an.clipGaps=Eu;let n=an.paths={points:mx};n.linear=xx,n.stepped=cT,n.bars=uT,n.spline=dT}var Pu=210,MT=64,wT=[.01,.02,.05,.1,.2,.5,1,2,5,10,15,30,45,90,180,360,...UT(3,20)];function Uo(n,t,e,i){let s=t.map(o=>AT(o,e)),r=t.map((o,a)=>{let l=o.sharing?s.filter((c,u)=>t[u].sharing===o.sharing).flat():null;return TT(o,s[a].map(c=>c.values),l,e,i)});n.replaceChildren(...r.map(o=>o.element)),n.classList.add("plots");for(let o of r)o.start();return{charts:r.map(o=>o.chart),dispose:()=>r.forEach(o=>o.dispose())}}function AT(n,t){return n.lines.map(e=>({clip:e.clip,values:e.readings?t[e.clip].line(e.readings,e.part):nn(e.values,Float32Array)}))}function ET(n,t,e){let i=[0,0];for(let{clip:s,values:r}of n){let o=t[s].time;for(let a=0;a<o.length;a++){let l=o[a]-e.origins[s];l<e.start||l>e.end||(r[a]<i[0]&&(i[0]=r[a]),r[a]>i[1]&&(i[1]=r[a]))}}return i}function xf(n){let[t,...e]=n.lines.map(i=>i.clip);return e.every(i=>i===t)?t??null:null}function TT(n,t,e,i,s){let{element:r,key:o,place:a}=_f(n,n.owner),l=S("div",{className:"cursor"}),c=null,u=null,h=!1,d=[],f=new ResizeObserver(()=>c?.setSize({width:a.clientWidth,height:Pu}));function p(){let{word:_}=n,w=n.lines.map((v,E)=>S("li",{},nr(ys(v.look??E)),_?v.name.slice(_.length+1):v.name));o.replaceChildren(..._?[S("li",{},_)]:[],...w)}function x(){(s.span!==u||s.stretched!==h)&&(u=s.span,h=s.stretched,c.setData(bx(n,t,i,u),!1),c.setScale("x",{min:u.start,max:u.end})),l.style.transform=`translateX(${c.valToPos(s.time,"x").toFixed(2)}px)`}function m(){u=s.span,h=s.stretched,c=new an(CT(n,e,i,s,a.clientWidth),bx(n,t,i,u),a),c.setScale("x",{min:u.start,max:u.end}),c.over.append(l),DT(c,s),f.observe(a),c.hooks.setSize=[x];let _=()=>{p(),c.redraw(!1)};d=[s.onChange(x),qs(_)],p()}function g(){for(let _ of d)_();f.disconnect(),c.destroy()}return{element:r,start:m,dispose:g,get chart(){return c}}}function _f(n,t=null){let e=t?`${ke(t)}. ${n.text}`:n.text,i=S("div",{className:"chart",role:"img","aria-label":e}),s=S("ul",{className:"key"}),r=S("h2",{},`${ke(n.title)} (${n.unit})`);return t&&r.append(S("small",{},t)),{element:S("figure",{},r,s,i,S("figcaption",{},n.text)),key:s,place:i}}function bx(n,t,e,i){let s=n.lines.map((r,o)=>[Float64Array.from(e[r.clip].time,a=>a-i.origins[r.clip]),t[o]]);return xf(n)!==null?[s[0]?.[0]??[],...s.map(r=>r[1])]:an.join(s)}function CT(n,t,e,i,s){let r=Iu(),o=(a,l,c)=>IT(n,...t?ET(t,e,i.span):[l,c]);return{width:s,height:Pu,legend:{show:!1},cursor:{show:!1},padding:[8,10,0,0],scales:{x:{time:!1,auto:!1,distr:100,fwd:i.shareAt,bwd:i.momentAt},y:{range:o}},series:[{},...yf(n.lines)],axes:[{...r,...vf,labelFont:r.font,label:()=>`${i.span.label} (${qo(i.span).unit})${i.stretched?", stretched":""}`,filter:(a,l)=>l,splits:(a,l,c,u,h)=>i.stretched?RT(a,i):PT(c,u,h),values:(a,l)=>l.map(c=>c===null?"":Sx(c*qo(i.span).factor)),space:56},bf(n)],hooks:{drawClear:[a=>LT(a,e,xf(n),i.span)],draw:[a=>NT(a,e,xf(n),i.span)]}}}function RT(n,t){let e=Math.max(2,Math.floor(n.bbox.width/devicePixelRatio/MT)),{factor:i}=qo(t.span),s=new Set;for(let r=0;r<=e;r++){let o=t.momentAt(r/e),a=[1,2,3,4,5,6].map(c=>Number((i*o).toPrecision(c))/i),l=c=>Math.abs(t.shareAt(c)-r/e)<.2/e;s.add(a.find(l)??a[a.length-1])}return[...s].filter(r=>r>=t.span.start&&r<=t.span.end)}function PT(n,t,e){let i=Math.ceil(n/e-1e-9);return Array.from({length:Math.floor(t/e+1e-9)-i+1},(s,r)=>(i+r)*e)}function yf(n){return n.map(({look:t},e)=>({stroke:()=>ys(t??e).colour,dash:ys(t??e).dash,width:1.6,points:{show:!1},spanGaps:!0}))}var vf={size:24,gap:3,labelSize:18,labelGap:0};function Iu(){return{stroke:()=>Be("--muted"),grid:{stroke:()=>Be("--grid"),width:1},ticks:{stroke:()=>Be("--grid"),width:1,size:4},font:"12px system-ui, sans-serif"}}function bf(n){return{...Iu(),size:(t,e)=>Math.max(48,16+7*Math.max(0,...(e??[]).map(i=>i.length))),gap:3,values:(t,e)=>e.map(i=>i===null?"":Sx(i)),...n.unit==="deg"?{incrs:wT,space:26}:{space:30}}}function IT(n,t,e){let[i,s]=[Math.min(0,t??0),Math.max(0,e??0)],r=.06*(s-i||1);return[n.unit==="deg"||i<0?i-r:i,s+2*r]}function Sx(n){let t=Math.abs(n)<1e-12?"0":String(Number(n.toPrecision(6)));return t.length>7?Pe(n):t.replace("-","−")}function LT(n,t,e,i){if(e===null)return;let{ctx:s,bbox:r}=n;s.save(),s.fillStyle=Be("--band");for(let o of t[e].stages.filter(a=>a.driven)){let[a,l]=[o.start,o.end].map(u=>n.valToPos(u-i.origins[e],"x",!0)),c=Math.max(a,r.left);s.fillRect(c,r.top,Math.max(0,Math.min(l,r.left+r.width)-c),r.height)}s.restore()}function NT(n,t,e,i){if(e===null)return;let{ctx:s,bbox:r}=n,o=devicePixelRatio;s.save(),s.strokeStyle=Be("--muted"),s.font=`bold ${12*o}px system-ui, sans-serif`,s.setLineDash([2*o,3*o]);for(let a of t[e].marks){let l=n.valToPos(a.time-i.origins[e],"x",!0);if(l<r.left-1||l>r.left+r.width+1)continue;s.beginPath(),s.moveTo(l,r.top),s.lineTo(l,r.top+r.height),s.stroke();let c=l>r.left+r.width-16*o?-1:1;s.fillStyle=Be("--page"),s.fillRect(l+(c>0?2:-14)*o,r.top+1*o,12*o,15*o),s.fillStyle=Be("--ink"),s.textAlign="center",s.fillText(a.letter,l+c*8*o,r.top+13*o)}s.restore()}function DT(n,t){Sf(n,e=>{t.pause(),t.seek(n.posToVal(e.clientX-n.over.getBoundingClientRect().left,"x"))})}function Sf(n,t){n.over.addEventListener("pointerdown",e=>{e.button===0&&(n.over.setPointerCapture(e.pointerId),t(e))}),n.over.addEventListener("pointermove",e=>{n.over.hasPointerCapture(e.pointerId)&&t(e)})}function UT(n,t){return Array.from({length:t-n},(e,i)=>[1,2,5].map(s=>s*10**(n+i))).flat()}function Lu(n,t){if(matchMedia("(prefers-reduced-motion: reduce)").matches)return;let e=new IntersectionObserver(i=>{i.some(s=>s.isIntersecting)&&(e.disconnect(),t.play())},{threshold:.3});e.observe(n.querySelector(".picture")??n),n.addEventListener("pointerdown",()=>e.disconnect(),{once:!0})}function Mx(n){let t=n.clips.map(jn),e=bs(t,n.spans),i=vo(document.getElementById("player"),t,e,n);i.stage&&Mf(i.stage.cells,t,e,n.energy);let s=Uo(document.getElementById("plots"),n.plots,t,e);return Lu(document.getElementById("player"),e),{clips:t,clock:e,player:i,plots:s}}function Mf(n,t,e,i){let s=t.map((r,o)=>{let a=S("span",{className:"state-now"}),l=S("b",{},nr(ys(o)),r.name);return qs(()=>l.replaceChild(nr(ys(o)),l.firstChild)),n[o].append(l,a),a});e.onChange(()=>{for(let[r,o]of t.entries()){let a=e.clipTime(r),c=[e.time+e.span.origins[r]>o.end?"ended":o.stageAt(a).name],[u]=o.readings;u&&c.push(OT(o.valuesAt(u.name,a),u.unit));let h=o.valuesAt(vs,a).reduce((d,f)=>d+f,0);o.tendons&&c.push(`${Pe(i.factor*h)} ${i.unit}`),s[r].textContent=c.join(" · ")}})}function OT(n,t){let e=s=>t==="deg"?`${$n(s,0)}°`:`${Pe(s)} ${t}`,i=[Math.min(...n),Math.max(...n)].map(e);return i[0]===i[1]?i[0]:i.join(" to ")}var FT=[.1,.2,.5,1,2,5,10,15,30,45,60,90,180],kT=1.35;function ja(n,t,e=[],i=null,s=null){let r=t.map(o=>BT(o,e[0],i,s));n.replaceChildren(...r.map(o=>o.element)),n.classList.add("plots");for(let o of r)o.start();return r}function BT(n,t,e,i){let[s,r,o]=[n.lines,n.balls,n.marks].map(A=>A.map(zT)),{element:a,key:l,place:c}=_f(n),u=(r.length?r:[s[0]]).map(A=>S("span",{className:"ball"},r.length&&A.name.length<3?A.name:"")),h=r.map(A=>[A.places[0],A.values[0]]),d=Math.round(kT*Pu),f=VT(s),p=f,x=null;function m(){let A=s.map((M,P)=>S("li",{},nr(ys(P)),M.name)),y=r.length?"the run now":"moved by the slider";l.replaceChildren(...A,S("li",{},S("span",{className:"ball still"}),y))}function g(){for(let[A,[y,M]]of h.entries()){let[P,L]=[x.valToPos(y,"x"),x.valToPos(M,"y")];u[A].style.transform=`translate(${P.toFixed(2)}px, ${L.toFixed(2)}px)`}}function _(){let[A,y]=Ki(t.time,e.clipTime(0));for(let[M,{places:P,values:L}]of r.entries())h[M]=[wf(P,A,y),wf(L,A,y)];g()}function w(A){p=A,x.setScale("x",{min:A[0],max:A[1]})}function v(A,y,M){if(p!==f){let{places:I,values:F}=s[0],k=F.filter((X,H)=>I[H]>=p[0]&&I[H]<=p[1]),[D,V]=[Math.min(...k),Math.max(...k)];return[D-.25*(V-D),V+.25*(V-D)]}let P=r.reduce((I,F)=>Math.max(I,F.most),M),L=Math.min(0,y);return[L-.06*(P-L||1),P+.1*(P-L||1)]}function E(){let A=an.join(s.map(y=>[y.sorted.places,y.sorted.values]));x=new an(GT({data:n,lines:s,balls:r,marks:o,energyRange:v},c.clientWidth,d),A,c),x.over.append(...u),new ResizeObserver(()=>x.setSize({width:c.clientWidth,height:d})).observe(c),x.hooks.setSize=[g],x.hooks.setScale=[g],m(),qs(()=>{m(),x.redraw(!1)}),n.top&&c.after($T(f,n.top,w)),r.length?(e.onChange(_),XT(x,r,t,e)):qT(n,s[0],c,(y,M)=>{h[0]=[y,M],g()},i),w(f)}return{element:a,start:E,now:h,get chart(){return x}}}function zT({name:n,places:t,values:e}){let i={name:n,places:nn(t,Float32Array),values:nn(e,Float32Array)},s=Array.from(i.places.keys()).sort((r,o)=>i.places[r]-i.places[o]);return i.most=i.values.reduce((r,o)=>Math.max(r,o),0),i.sorted={places:s.map(r=>i.places[r]),values:s.map(r=>i.values[r])},i}function wf(n,t,e){let i=n[Math.min(t+1,n.length-1)];return n[t]+e*(i-n[t])}function VT(n){let t=n.flatMap(s=>[s.sorted.places[0],s.sorted.places.at(-1)]),[e,i]=[Math.min(...t),Math.max(...t)];return[e-.03*(i-e),i+.03*(i-e)]}function GT({data:n,lines:t,balls:e,marks:i,energyRange:s},r,o){let a=Iu(),l=bf(n);return{width:r,height:o,legend:{show:!1},cursor:{show:!1},pxAlign:0,padding:[10,12,0,0],scales:{x:{time:!1,auto:!1,dir:n.backwards?-1:1},y:{range:s}},series:[{},...yf(t)],axes:[{...a,...vf,labelFont:a.font,label:`${n.axis} (deg)`,values:l.values,incrs:FT,space:44},l],hooks:{draw:[c=>HT(c,e),c=>WT(c,i)]}}}function HT(n,t){let{ctx:e,bbox:i}=n,s=1.6*devicePixelRatio;e.save(),e.globalAlpha=.55,e.fillStyle=Be("--accent");for(let{places:r,values:o}of t)for(let a=0;a<r.length;a++){let[l,c]=[n.valToPos(r[a],"x",!0),n.valToPos(o[a],"y",!0)];l>i.left&&l<i.left+i.width&&c>i.top&&c<i.top+i.height&&e.fillRect(l-s/2,c-s/2,s,s)}e.restore()}function WT(n,t){let{ctx:e,bbox:i}=n,s=devicePixelRatio;e.save(),e.beginPath(),e.rect(i.left-6*s,i.top,i.width+12*s,i.height+6*s),e.clip(),e.setLineDash([]),e.font=`${12*s}px system-ui, sans-serif`;for(let{name:r,places:o,values:a}of t){let l=Array.from(o,f=>n.valToPos(f,"x",!0)),c=Array.from(a,f=>n.valToPos(f,"y",!0)),[u,h]=[l[l.length>>1],c[c.length>>1]];if(e.beginPath(),l.length===1)e.arc(u,h,4.5*s,0,2*Math.PI),e.fillStyle=Be("--page"),e.fill(),e.strokeStyle=Be("--ink"),e.lineWidth=1.4*s,e.stroke();else{e.globalAlpha=.35;for(let f of l.keys())e.lineTo(l[f],c[f]);e.strokeStyle=Be("--line-2"),e.lineWidth=7*s,e.stroke(),e.globalAlpha=1}let d=l.length>1?0:u>i.left+i.width/2?-1:1;e.fillStyle=Be("--ink"),e.textAlign=["right","center","left"][d+1],e.fillText(r,u+12*d*s,h-9*s)}e.restore()}function $T(n,t,e){let i=[["whole curve",n],["barrier enlarged",t]].map(([s,r],o)=>{let a=S("button",{type:"button","aria-pressed":String(o===0)},s);return a.addEventListener("click",()=>{for(let l of i)l.setAttribute("aria-pressed",String(l===a));e(r)}),a});return S("div",{className:"ranges",role:"group","aria-label":"part of the curve"},...i)}function XT(n,t,e,i){Sf(n,r=>{let o=n.over.getBoundingClientRect(),[a,l]=[r.clientX-o.left,r.clientY-o.top],[c,u]=[0,1/0];for(let{places:h,values:d}of t)for(let f=0;f<h.length;f++){let p=Math.hypot(n.valToPos(h[f],"x")-a,n.valToPos(d[f],"y")-l);p<u&&([c,u]=[f,p])}i.pause(),i.seekClip(0,e.time[c])})}function qT(n,t,e,i,s){let r=t.places.length-1,o=S("input",{type:"range",min:"0",max:String(r),value:"0"});o.setAttribute("aria-label",`${n.axis} along the curve`);let a=S("output",{"aria-live":"off"}),l=()=>{let d=Number(o.value);i(t.places[d],t.values[d]);let[f,p]=[Pe(t.places[d]),`${Pe(t.values[d])} ${n.unit}`];a.textContent=`${f}°, ${p}`,o.setAttribute("aria-valuetext",`${n.axis} ${f} degrees, energy ${p}`)},c=n.poses&&s?nn(n.poses,Float32Array):null,u=!1;o.addEventListener("input",()=>{l(),u=!0,c&&s.seek(YT(c,t.places[Number(o.value)]))}),c&&s.onChange(()=>{u||(o.value=String(ZT(t.places,wf(c,Math.floor(s.time),s.time%1))),l()),u=!1});let h=n.drawn?[S("p",{className:"note"},n.drawn)]:[];e.after(S("div",{className:"slide"},o,a),...h),l()}function YT(n,t){let e=n[n.length-1]>=n[0]?1:-1,i=n.findIndex(r=>e*r>=e*t);if(i<=0)return i===0?0:n.length-1;let s=n[i]-n[i-1];return i-1+(s?(t-n[i-1])/s:0)}function ZT(n,t){return n.reduce((e,i,s)=>Math.abs(i-t)<Math.abs(n[e]-t)?s:e,0)}function Nu(n){let t=new Set,e={start:n.start,end:n.end,origins:[0]},i=n.start,s=0;function r(){s||=requestAnimationFrame(()=>{s=0;for(let o of t)o()})}return{get time(){return i},span:e,clipTime:(o,a=i)=>Math.min(n.end,Math.max(n.start,a)),timeAt:o=>e.start+o*(e.end-e.start),wayAt:o=>(o-e.start)/(e.end-e.start||1),onChange(o){return t.add(o),r(),()=>t.delete(o)},seek(o){i=Math.min(e.end,Math.max(e.start,o)),r()}}}function wx(n){let t=document.getElementById("curves");if(!n.clips)return{curves:ja(t,n.curves)};let e=n.clips.map(jn),i=Nu(e[0]),s=bo(document.getElementById("player"),e,i,n);return{clips:e,clock:i,player:s,curves:ja(t,n.curves,[],null,i)}}function Af(n){return n.energy?_o:og}function Ax(n,t){let e=n.at(t).map(s=>Math.round(255*s)),i=.299*e[0]+.587*e[1]+.114*e[2]>118;return{face:`rgb(${e.join(" ")})`,ink:i?"#000":"#fff"}}function Oo({sign:n,pattern:t}){return S("span",{className:`what ${t}`,"aria-hidden":"true"},S("span",{},n))}function Du(n,t){let e=n.scaleOf(t);if(!e)return[];let i=S("span",{className:"bar","aria-hidden":"true"});return i.style.background=Af(t).gradient,[S("p",{className:"scale"},`${t.title} (${t.unit})`,S("span",{},e.text(e.low)),i,S("span",{},e.text(e.high)))]}function Uu(n,t){let{factors:e,quantities:i,words:s}=n,r=e.map(h=>h.values.length),o=new Map;for(let h of t)o.set(h.point,[...o.get(h.point)??[],h]);function a(h){if(n.sampled)return e.map(()=>h);let d=[];for(let f=r.length-1;f>=0;f--)d[f]=h%r[f],h=Math.floor(h/r[f]);return d}let l=h=>h.reduce((d,f,p)=>d*r[p]+f,0);function c(h){let f=(h.shares?i.filter(_=>_.group===h.group):[h]).flatMap(_=>_.values??[]).filter(_=>_!==null);if(!f.length)return null;let[p,x]=[f.reduce((_,w)=>Math.min(_,w)),f.reduce((_,w)=>Math.max(_,w))],m=_=>x>p?(_-p)/(x-p):.5,g=KT((h.values??[]).filter(_=>_!==null));return{low:p,high:x,colour:_=>Ax(Af(h),m(_)),text:_=>ji(Number(_.toFixed(g)))}}let u=(h,d)=>`${h.name} ${h.texts[d]}${h.unit?` ${h.unit}`:""}`;return{study:n,sizes:r,numbers:i.filter(h=>h.values&&!h.tried),columns:e,shown:()=>!0,nameOf:()=>"",placesOf:a,pointAt:l,scaleOf:c,factorText:u,largestSpan:t.reduce((h,d)=>Math.max(h,d.play.clips[0].span_m),0),runsOf:h=>o.get(h)??[],word:h=>s[h],pointText:h=>a(h).map((d,f)=>u(e[f],d)).join(", "),valueText(h,d){let f=h.values?.[d]??null;return f===null?s[h.reasons[d]].word:`${ji(f)} ${h.unit}`}}}function KT(n){let t=n.reduce((e,i)=>Math.max(e,Math.abs(i)),0);return Math.min(20,Math.max(0,2-Math.floor(Math.log10(t||1))))}function ji(n){let t=Number(n.toPrecision(3));return(t!==0&&Math.abs(t)<.001?t.toExponential():String(t)).replaceAll("-","−")}var JT="http://www.w3.org/2000/svg";function Ie(n,t,...e){let i=document.createElementNS(JT,n);for(let[s,r]of Object.entries(t))i.setAttribute(s,r);return i.append(...e),i}function Fo({values:n,log:t},e=[]){let i=[...new Set(n.filter(d=>typeof d=="string"))];if(i.length)return{words:i,share:f=>(i.indexOf(f)+.5)/i.length,ticks:i,value:f=>i[Math.min(i.length-1,Math.max(0,Math.floor(f*i.length)))]};let s=[...n,...e].filter(d=>typeof d=="number"),r=t&&s.every(d=>d>0),[o,a]=r?[Math.log,Math.exp]:[d=>d,d=>d],l=s.reduce((d,f)=>Math.min(d,o(f)),1/0),c=s.reduce((d,f)=>Math.max(d,o(f)),-1/0),u=d=>c>l?(o(d)-l)/(c-l):.5,h=s.length?(r?jT:Ex)(a(l),a(c)):[];return{words:i,share:u,ticks:h,value:d=>a(l+d*(c-l))}}function Ef(n,t,e,i,s=[]){let r=t.unit?`${t.name} (${t.unit})`:t.name,o=Fo({values:n,log:t.log},s),a=.04*(i-e),l=u=>e+a+o.share(u)*(i-e-2*a),c=o.ticks.map(u=>[l(u),typeof u=="number"?ji(u):u]);return{label:r,from:e,to:i,ticks:c,at:l,place:u=>n[u]===null?e:l(n[u])}}function Ex(n,t){if(!(t>n))return[n];let e=(t-n)/5,i=10**Math.floor(Math.log10(e)),s=i*([1,2,5].find(o=>o*i>=e)??10),r=[];for(let o=Math.ceil(n/s)*s;o<=t+1e-9*s;o+=s)r.push(Number(o.toPrecision(12)));return r}function jT(n,t){if(!(t>n))return[n];let e=t/n>200?[1]:[1,2,5],i=[];for(let s=Math.floor(Math.log10(n));s<=Math.ceil(Math.log10(t));s++)for(let r of e){let o=Number((r*10**s).toPrecision(12));o>=n*(1-1e-9)&&o<=t*(1+1e-9)&&i.push(o)}return i.length>1?i:Ex(n,t)}function Tx(n,t,e){let i=[Ie("path",{class:"axis",d:`M${n.from} ${t.to}V${t.from}H${n.to}`})],s=(r,o)=>i.push(Ie("text",{class:"label",...o},r));for(let[r,o]of n.ticks)s(o,{x:r,y:t.from+18,"text-anchor":"middle"});for(let[r,o]of t.ticks)s(o,{x:n.from-8,y:r,dy:"0.35em","text-anchor":"end"});return s(n.label,{x:(n.from+n.to)/2,y:e-8,"text-anchor":"middle"}),s(t.label,{transform:`translate(14 ${(t.from+t.to)/2}) rotate(-90)`,"text-anchor":"middle"}),i}var Ou=300,Cx=30,QT=92,Ix=16,tC=5;function Lx(n,t,{best:e,best_word:i,front:s},r){let a={axes:[...new Set(t.map(n.indexOf).filter(w=>w>=0))],opened:null,hovered:null,best:e,bestWord:i,front:s},l=S("div",{className:"titles"}),c=S("div",{className:"drawn"}),u=S("div",{className:"board"},l,c),h=S("div",{className:"scroll"},u),d=S("p",{className:"note",role:"status"}),f=S("p",{className:"note under"}," "),p=S("button",{type:"button"},`show all ${n.study.noun}s`);p.addEventListener("click",()=>{n.forget(),c.querySelector("[role=slider]")?.focus()});let x=()=>{iC(n,a,{board:u,titles:l,place:c,width:h.clientWidth}),Fu(n,a,c)},g=S("section",{className:"lines"},S("h2",{},`All ${n.study.noun}s as lines`),S("p",{className:"note"},"Press a line to open its run. Move the two handles of an axis to select a range of values."),eC(n,a,x),h,nC(n,a),S("div",{className:"choices"},p,d),f);lC(n,a,c,f,r),n.whenAsked(()=>{Fu(n,a,c),Nx(n,a,c),Rx(n,d,p)}),Rx(n,d,p);let _=0;return new ResizeObserver(()=>{h.clientWidth!==_&&(_=h.clientWidth,x())}).observe(h),{element:g,show(w){a.opened=w,Fu(n,a,c)}}}function Rx(n,t,e){let{points:i,noun:s}=n.study,r=Array.from({length:i},(l,c)=>c).filter(n.shown),o=r.filter(n.good).length,a=n.study.words.find(l=>l.good)?.word;t.textContent=`${r.length} of ${i} ${s}s lie within the selected ranges${a?`; ${a}: ${o}`:""}.`,e.hidden=n.asked.size===0}function eC(n,t,e){let i=n.columns.map((s,r)=>{let o=S("input",{type:"checkbox",checked:t.axes.includes(r)});return o.addEventListener("change",()=>{t.axes=n.columns.map((a,l)=>l).filter(a=>a===r?o.checked:t.axes.includes(a)),o.checked||n.ask(r,0,1),e()}),S("label",{},o,s.name)});return S("details",{},S("summary",{},"Axes"),S("fieldset",{className:"filter"},S("legend",{},"Show an axis of"),...i))}function nC(n,t){let e=(r,o)=>S("li",{},S("span",{className:`line ${r}`,"aria-hidden":"true"}),o),i=n.study.words.find(r=>r.good),s=[];return i&&s.push(e("good",i.word)),n.study.words.some(r=>!r.good)&&s.push(e("behind",i?`other ${n.study.noun}s`:`all ${n.study.noun}s`)),t.front.length&&s.push(e("front","Pareto front")),t.best!==null&&s.push(e("best",t.bestWord)),s.push(e("opened","open")),n.columns.some(r=>r.limits.length)&&s.push(S("li",{},S("span",{className:"bound","aria-hidden":"true"}),"range allowed by a limit")),S("ul",{className:"keys-of-lines"},...s)}function iC(n,t,{board:e,titles:i,place:s,width:r}){let o=t.axes.length,a=Math.max(r,o*QT);e.style.width=`${a}px`,i.replaceChildren(...t.axes.map(c=>sC(n.columns[c]))),i.style.gridTemplateColumns=`repeat(${o}, 1fr)`,t.x=c=>(c+.5)*a/o,t.y=c=>Ou-Cx-c*(Ou-2*Cx);let l=Ie("svg",{width:a,height:Ou,viewBox:`0 0 ${a} ${Ou}`,role:"img","aria-label":`${n.study.points} ${n.study.noun}s as lines over ${o} axes; the table below has them all`});l.append(Ie("g",{class:"layers"}));for(let[c,u]of t.axes.entries())l.append(...rC(n.columns[u],t.x(c),t.y));s.replaceChildren(l),Nx(n,t,s)}function sC(n){let t=n.unit?` (${n.unit})`:"",e=n.aim?S("small",{},`${n.aim} is best`):"";return S("div",{},`${n.name}${t}`,e)}function rC({scale:n,limits:t},e,i){let s=[Ie("path",{class:"axis",d:`M${e} ${i(0)}V${i(1)}`})];for(let{kind:r,bound:o}of t){let a=Math.min(1,Math.max(0,n.share(o)));s.push(Ie("path",{class:"bound",d:`M${e} ${i(a)}V${i(r===">="?1:0)}`}))}for(let r of n.ticks){let o=i(n.share(r));s.push(Ie("path",{class:"axis",d:`M${e} ${o}h5`}),Ie("text",{class:"label",x:e+8,y:o,dy:"0.35em"},typeof r=="number"?ji(r):r))}return s}function Nx(n,t,e){let i=e.contains(document.activeElement)?document.activeElement.dataset.handle:null;for(let s of e.querySelectorAll("[role=slider]"))s.remove();for(let[s,r]of t.axes.entries())for(let o of["least","most"]){let a=oC(n,t,e,r,o);a.style.left=`${t.x(s)}px`,e.append(a),a.dataset.handle===i&&a.focus()}}function oC(n,t,e,i,s){let r=n.columns[i],[o,a]=n.asked.get(i)??[0,1],l=s==="least"?o:a,c=r.scale.value(l),u=typeof c=="number"?`${ji(c)} ${r.unit}`.trim():String(c??""),h=S("div",{role:"slider",className:`handle ${s}`,tabIndex:0,"aria-orientation":"vertical","aria-label":`${s} ${r.name}`,"aria-valuemin":"0","aria-valuemax":"100","aria-valuenow":String(Math.round(100*l)),"aria-valuetext":u,title:`${s} ${r.name}: ${u}`});h.dataset.handle=`${i} ${s}`,h.dataset.keys="own",h.style.top=`${t.y(l)}px`;let d=x=>{let[m,g]=n.asked.get(i)??[0,1];s==="least"?n.ask(i,Math.min(Math.max(x,0),g),g):n.ask(i,m,Math.max(Math.min(x,1),m))},f=r.scale.words.length?1/r.scale.words.length:.02,p={ArrowUp:f,ArrowRight:f,ArrowDown:-f,ArrowLeft:-f,PageUp:5*f,PageDown:-5*f};return h.addEventListener("keydown",x=>{if(!(x.ctrlKey||x.metaKey||x.altKey)){if(x.key in p)d(l+p[x.key]);else if(x.key==="Home")d(0);else if(x.key==="End")d(1);else return;x.preventDefault()}}),h.addEventListener("pointerdown",x=>{x.preventDefault(),h.focus(),Dx(x,m=>d(Tf(t,e,m)))}),h}function Dx(n,t,e=()=>{}){let i=o=>a=>a.pointerId===n.pointerId&&o(a),s=i(t),r=i(o=>{removeEventListener("pointermove",s),removeEventListener("pointerup",r),removeEventListener("pointercancel",r),e(o)});addEventListener("pointermove",s),addEventListener("pointerup",r),addEventListener("pointercancel",r)}function Tf(n,t,e){let i=e.clientY-t.getBoundingClientRect().top;return Math.min(1,Math.max(0,(n.y(0)-i)/(n.y(0)-n.y(1))))}function aC(n,t,e){let i="",s=!1;for(let[r,o]of t.axes.entries()){let a=n.columns[o].values[e];a!==null&&(i+=`${s?"L":"M"}${t.x(r).toFixed(1)} ${t.y(n.columns[o].scale.share(a)).toFixed(1)}`),s=a!==null}return i}function Fu(n,t,e){let i=e.querySelector(".layers");if(!i)return;let s=Array.from({length:n.study.points},(u,h)=>h),[r,o]=[s.filter(n.shown),s.filter(u=>!n.shown(u))],a=u=>u===null?[]:[u],l={out:o,behind:r.filter(u=>!n.good(u)),good:r.filter(n.good),front:t.front.filter(n.shown),best:a(t.best),opened:a(t.opened),hovered:a(t.hovered)},c=Object.entries(l).filter(([,u])=>u.length);i.replaceChildren(...c.map(([u,h])=>Ie("path",{class:`line ${u}`,d:h.map(d=>aC(n,t,d)).join("")})))}function lC(n,t,e,i,s){let r=o=>{o!==t.hovered&&(t.hovered=o,e.classList.toggle("pressable",o!==null),i.textContent=o===null?" ":`${n.nameOf(o)}${n.pointText(o)}: ${n.study.statuses[o]}`,Fu(n,t,e))};e.addEventListener("pointermove",o=>{o.pointerType==="mouse"&&o.buttons===0&&r(Px(n,t,e,o))}),e.addEventListener("pointerleave",()=>r(null)),e.addEventListener("pointerdown",o=>{if(o.button!==0||o.target.closest("[role=slider]"))return;let a=o.pointerType==="touch"?null:cC(t,e,o),l=Tf(t,e,o),c=!1;Dx(o,h=>{c||=Math.hypot(h.clientX-o.clientX,h.clientY-o.clientY)>tC;let d=Tf(t,e,h);c&&a!==null&&n.ask(a,Math.min(l,d),Math.max(l,d))},h=>{let d=c||h.type==="pointercancel"?null:Px(n,t,e,h);d!==null&&s(d)})})}function cC(n,t,e){let i=e.clientX-t.getBoundingClientRect().left,s=n.axes.findIndex((r,o)=>Math.abs(n.x(o)-i)<Ix);return s<0?null:n.axes[s]}function Px(n,t,e,i){let s=e.getBoundingClientRect(),[r,o]=[i.clientX-s.left,i.clientY-s.top],a=t.axes.findLastIndex((p,x)=>t.x(x)<=r),[l,c]=[Math.max(0,a),Math.min(t.axes.length-1,a+1)],u=c>l?(r-t.x(l))/(t.x(c)-t.x(l)):0,h=(p,x)=>{let m=n.columns[t.axes[p]],g=m.values[x];return g===null?NaN:t.y(m.scale.share(g))},[d,f]=[null,Ix];for(let p=0;p<n.study.points;p++){if(!n.shown(p))continue;let[x,m]=[h(l,p),h(c,p)],g=x+u*(m-x),_=c>l?(m-x)/(t.x(c)-t.x(l)):0,w=Math.abs(o-g)/Math.hypot(1,_)-(n.good(p)?1:0);w<f&&([d,f]=[p,w])}return d}function Ux(n,t){let e=Uu(n,t),i=n.factors.map(c=>({...c,limits:[],aim:""})),s=e.numbers.map(c=>({...c,key:c.name,name:c.title,log:!1,own:null})),r=[...i,...s].map(c=>({...c,scale:Fo(c,uC(c))})),o=new Map,a=[],l=([c,[u,h]],d)=>{let f=r[c].values[d];if(f===null)return!1;let p=r[c].scale.share(f);return p>=u-1e-9&&p<=h+1e-9};return{...e,columns:r,asked:o,indexOf:c=>r.findIndex(u=>u.key===c),shown:c=>[...o].every(u=>l(u,c)),good:c=>e.word(n.verdicts[c]).good,nameOf:c=>`${n.noun} ${c+1}: `,whenAsked:c=>a.push(c),ask(c,u,h){u<=0&&h>=1?o.delete(c):o.set(c,[u,h]);for(let d of a)d()},forget(){o.clear();for(let c of a)c()}}}function uC({limits:n,values:t}){let e=t.filter(r=>typeof r=="number"),[i,s]=[Math.min(...e),Math.max(...e)];return n.map(r=>r.bound).filter(r=>r>=i-(s-i)&&r<=s+(s-i))}var hC=12,[Cf,ws]=[200,76],Qa=130;function Fx(n,{marginals:t,pairs:e},i){let s=S("div",{className:"marginals"}),r=S("div",{className:"pairs"}),[o,a]=[t,e].map(h=>h.map(n.indexOf).filter(d=>d>=0)),l=()=>{s.replaceChildren(...o.map(h=>pC(n,h))),r.replaceChildren(...mC(n,a,i))};r.style.setProperty("--columns",Math.max(1,a.length-1)),n.whenAsked(l),l();let u=[S("h2",{},"Single unknowns"),S("p",{className:"note"},"Blue: samples that agree. Grey: all drawn samples. Each colour is scaled by its number of samples. Unknowns that the facts narrow most come first."),s];return a.length>1&&u.push(S("h2",{},"Pairs of unknowns"),S("p",{className:"note"},"Press a pair to enlarge it."),r),{element:S("section",{className:"agreeing"},...u)}}var dC=n=>Array.from({length:n.study.points},(t,e)=>e),kx=n=>dC(n).filter(t=>!["placed","unbuilt"].includes(n.word(n.study.verdicts[t]).pattern));function fC(n,t,e){let i=t.words.length||hC,s=new Array(i).fill(0);for(let r of e)s[Math.min(i-1,Math.floor(t.share(n.values[r])*i))]+=1/e.length;return s}function pC(n,t){let e=n.columns[t],i=Fo(e),s=kx(n),r=s.filter(m=>n.good(m)&&n.shown(m)),[o,a]=[s,r].map(m=>fC(e,i,m)),l=Math.max(...o,...r.length?a:[0]),c=Cf/o.length,u=(m,g)=>Ie("path",{class:g,d:m.map((_,w)=>`M${w*c+1} ${ws}v${-_/l*(ws-4)}h${c-2}V${ws}z`).join("")}),h=m=>Ie("path",{class:"agree",d:`M0 ${ws}${m.map((g,_)=>`V${ws-g/l*(ws-4)}H${(_+1)*c}`).join("")}V${ws}`}),d=`${e.name}: ${Ox(e,i,r)}`,f=Ie("svg",{viewBox:`0 0 ${Cf} ${ws}`,role:"img","aria-label":d,preserveAspectRatio:"none"},u(o,"all"),...r.length?[h(a)]:[],Ie("path",{class:"axis",d:`M0 ${ws}H${Cf}`})),p=i.words.length?i.words:[0,1].map(m=>ji(i.value(m))),x=e.unit?` (${e.unit})`:"";return S("figure",{},S("figcaption",{},`${e.name}${x}`),f,S("div",{className:"ends"},...p.map(m=>S("span",{},m))),S("small",{},Ox(e,i,r)))}function Ox(n,t,e){if(!e.length)return"no sample agrees";if(t.words.length)return t.words.map(r=>`${Math.round(100*e.filter(o=>n.values[o]===r).length/e.length)} % ${r}`).join(", ");let i=e.map(r=>n.values[r]).sort((r,o)=>r-o),s=r=>ji(i[Math.round(r*(i.length-1))]);return`middle half: ${s(.25)} to ${s(.75)}`}function mC(n,t,e){return t.slice(1).flatMap((i,s)=>t.slice(0,-1).map((r,o)=>o>s?S("span",{}):gC(n,r,i,e)))}function gC(n,t,e,i){let[s,r]=[t,e].map(f=>n.columns[f]),[o,a]=[s,r].map(f=>Fo(f)),l=(f,p)=>Ie("path",{class:p,d:f.map(x=>`M${(4+o.share(s.values[x])*(Qa-8)).toFixed(1)} ${(Qa-4-a.share(r.values[x])*(Qa-8)).toFixed(1)}h0`).join("")}),c=kx(n),u=c.filter(f=>n.good(f)&&n.shown(f)),h=Ie("svg",{viewBox:`0 0 ${Qa} ${Qa}`,"aria-hidden":"true"},l(c.filter(f=>!u.includes(f)),"all"),l(u,"agree")),d=S("button",{type:"button","aria-label":`${r.name} over ${s.name}, large`},h,S("small",{},`${r.name} ↑, ${s.name} →`));return d.addEventListener("click",()=>i(t,e)),d}var[Bx,Rf]=[600,420],ku={left:64,right:14,top:12,bottom:52},zx=60,Vx={ArrowLeft:-1,ArrowUp:-1,ArrowRight:1,ArrowDown:1};function Bu(n,t,e){let{columns:i,study:s}=n,{quantity:r}=t,o=Array.from({length:s.points},(g,_)=>_),a=n.scaleOf(r),l=Ef(i[t.x].values,i[t.x],ku.left,Bx-ku.right,t.cells?.across),c=t.y===null?r.values??o.map(()=>0):i[t.y].values,u=t.y===null?{name:r.title,unit:r.unit}:i[t.y],h=Ef(c,u,Rf-ku.bottom,ku.top,t.cells?.upwards),d=`${r.title} of ${s.points} ${s.noun}s; arrows move between them, enter opens one`,f=Ie("svg",{viewBox:`0 0 ${Bx} ${Rf}`,class:["scatter",o.length>zx&&"many",t.ordered&&"judged"].filter(Boolean).join(" "),role:"listbox","aria-label":d});t.cells&&f.append(...yC(t.cells,l,h)),f.append(...Tx(l,h,Rf),...Hx(i[t.x],l,h,!0),...t.y===null?[]:Hx(i[t.y],h,l,!1));let p=o.map(g=>[l.place(g),h.place(g)]);t.joined&&f.append(vC(t.front,p,i[t.x].aim));let x=o.length>zx?6:8,m=o.map(g=>_C(n,t,a,g,p[g],x));return f.append(...(t.ordered?xC(n,t,o):o).map(g=>m[g])),(m[t.current??0]??m[0])?.setAttribute("tabindex","0"),bC(f,m,t.ordered?[...o].sort((g,_)=>p[g][0]-p[_][0]):o,e),{element:S("div",{className:"scroll"},f),points:o}}function xC(n,t,e){let i=s=>(n.shown(s)?0:1e6)+(t.best===s?-1:n.study.verdicts[s]);return[...e].sort((s,r)=>i(r)-i(s))}function _C(n,t,e,i,[s,r],o){let{quantity:a}=t,l=a.values?.[i]??null,c=`${n.nameOf(i)}${n.pointText(i)}: ${n.valueText(a,i)}`,u=Ie("g",{role:"option",tabindex:"-1","aria-label":c,"aria-selected":String(t.opened===i),"data-point":i,transform:`translate(${s.toFixed(1)} ${r.toFixed(1)})`},Ie("title",{},c)),{sign:h,pattern:d}=l===null?n.word(a.reasons[i]):{};return h&&u.setAttribute("class",`what ${d}`),n.shown(i)||u.classList.add("out"),t.front?.includes(i)&&u.append(Ie("circle",{r:o+3,class:"front"})),u.append(Ie("circle",{r:o,class:l===null?"missing":"found",fill:l===null?"transparent":e.colour(l).face})),h&&u.append(Ie("text",{"text-anchor":"middle",dy:"0.36em"},h)),t.best===i&&u.append(Ie("text",{class:"best","text-anchor":"middle",dy:-o-6},t.bestWord)),u}function yC(n,t,e){let[i,s]=[Gx(n.across.map(t.at)),Gx(n.upwards.map(e.at))];return n.works.flatMap((r,o)=>r.map((a,l)=>Ie("rect",{class:a?"map-works":"map-fails",x:i[o],width:i[o+1]-i[o],y:s[l+1],height:s[l]-s[l+1]})))}function Gx(n){let t=n.slice(1).map((s,r)=>(s+n[r])/2),[e,i]=[n[0],n.at(-1)];return[e,...t,i]}function Hx(n,t,e,i){let s=(a,l)=>Ie("path",{class:l,d:i?`M${a} ${e.from}V${e.to}`:`M${e.from} ${a}H${e.to}`}),r=a=>a>=Math.min(t.from,t.to)&&a<=Math.max(t.from,t.to),o=[];typeof n.own=="number"&&r(t.at(n.own))&&o.push(s(t.at(n.own),"own"));for(let{kind:a,bound:l}of n.limits??[]){let c=t.at(l);if(!r(c))continue;let u=a===">="?t.from:t.to,[h,d]=[Math.min(c,u),Math.abs(c-u)],f=i?{x:h,width:d,y:e.to,height:e.from-e.to}:{y:h,height:d,x:e.from,width:e.to-e.from};o.push(Ie("rect",{class:"beyond",...f}),s(c,"limit"))}return o}function vC(n,t,e){let i=n.map(r=>t[r]).sort((r,o)=>r[0]-o[0]),s=([r,o])=>e==="least"?`H${r.toFixed(1)}V${o.toFixed(1)}`:`V${o.toFixed(1)}H${r.toFixed(1)}`;return Ie("path",{class:"front",d:i.map((r,o)=>o?s(r):`M${r.join(" ")}`).join("")})}function bC(n,t,e,i){let s=r=>r.target.closest("[data-point]");n.addEventListener("click",r=>{s(r)&&i(Number(s(r).dataset.point))}),n.addEventListener("focusin",r=>{for(let o of t)o.setAttribute("tabindex",o===r.target?"0":"-1")}),n.addEventListener("keydown",r=>{let o=s(r);if(!o||r.ctrlKey||r.metaKey||r.altKey)return;let a=Number(o.dataset.point);if(r.key==="Enter"||r.key===" ")i(a);else if(r.key in Vx)t[e[e.indexOf(a)+Vx[r.key]]]?.focus();else return;r.preventDefault()})}function Wx(n,{plane:t,front:e,best:i,best_word:s,joined:r},o){let{quantities:a}=n.study,[l,c]=[t.x,t.y].map(n.indexOf),[u,h]=[l,c],d={quantity:a[0],x:l,y:c,current:i??0,opened:null,front:e,best:i,bestWord:s,ordered:!0},f=S("div",{className:"map-place"}),p=S("div",{className:"map-legend"}),x=()=>{let M=d.x===u&&d.y===h;d.cells=M?t.cells:void 0,d.joined=r&&new Set([d.x,d.y,u,h]).size===2;let P=Bu(n,d,m);f.replaceChildren(P.element),p.replaceChildren(...SC(n,d))},m=M=>{g(M),o(M)};function g(M){d.current=d.opened=M;let P=f.contains(document.activeElement);x(),P&&f.querySelector(`[data-point="${M}"]`)?.focus()}let _=n.columns.map((M,P)=>[P,M.name]),w={across:v("across",_,()=>d.x,M=>A("x","y",M)),upwards:v("upwards",_,()=>d.y,M=>A("y","x",M)),show:v("show",a.map((M,P)=>[P,M.title]),()=>a.indexOf(d.quantity),M=>{d.quantity=a[M]})};function v(M,P,L,I){let F=S("select",{},...P.map(([D,V])=>S("option",{value:String(D)},V)));F.value=String(L()),F.addEventListener("change",()=>{I(Number(F.value)),E(),x()});let k=S("label",{},`${M} `,F);return k.dataset.name=M,{element:k,fill:()=>{F.value=String(L())}}}let E=()=>Object.values(w).forEach(M=>M.fill());function A(M,P,L){d[P]===L&&(d[P]=d[M]),d[M]=L}let y=S("section",{className:"map"},S("h2",{},t.title),S("div",{className:"choices"},...Object.values(w).map(M=>M.element)),f,p);return n.whenAsked(x),x(),{element:y,show:g,over(M,P){[d.x,d.y]=[M,P],E(),x()}}}function SC(n,{quantity:t,front:e,cells:i,x:s,y:r}){let o=Du(n,t),a=t.values?t.reasons:n.study.verdicts,l=n.study.words.flatMap((u,h)=>{let d=a.filter((f,p)=>f===h&&n.shown(p)).length;return d?[S("li",{},Oo(u),`${u.word} (${d})`)]:[]});e.length&&l.push(S("li",{},S("span",{className:"ring","aria-hidden":"true"}),"Pareto front"));let c=[s,r].map(u=>n.columns[u]);if(c.some(u=>typeof u.own=="number")&&l.push(S("li",{},S("span",{className:"dashes","aria-hidden":"true"}),"as designed")),c.some(u=>u.limits.length)&&l.push(S("li",{},S("span",{className:"shade","aria-hidden":"true"}),"beyond a limit")),i)for(let u of["works","fails"])l.push(S("li",{},S("span",{className:`map-${u}`,"aria-hidden":"true"}),`${u} if only these two deviate`));return l.length&&o.push(S("ul",{},...l)),o}var MC=2e4,wC=16,AC=16,$x={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]};function Yx(n,t){let{quantities:e,sampled:i}=n.study,s=n.study.axes.filter(x=>n.sizes[x]>1),[r,o]=s.length>1?s:[null,s[0]??0],a={quantity:e[0],x:o,y:r,fixed:[...n.study.cuts],current:null,opened:null},l=S("div",{className:"map-place"}),c=S("div",{className:"map-legend"}),u=S("p",{className:"note"}),h=()=>{let x=i?Bu(n,a,d):CC(n,a,d);l.replaceChildren(x.element),c.replaceChildren(...IC(n,a.quantity,x.points)),u.textContent=LC(n,a.quantity,x.points)},d=x=>{a.current=a.opened=x,EC(l,x),t(x,a.quantity)},f=TC(n,a,s,h),p=S("section",{className:"map"},S("h2",{},"Map"),f.element,l,c,u);return h(),{element:p,show(x){a.current=a.opened=x,i||(a.fixed=n.placesOf(x)),f.fill(),h()}}}function EC(n,t){for(let e of n.querySelectorAll("[data-point]")){let i=Number(e.dataset.point)===t;e.setAttribute("aria-selected",String(i)),e.tabIndex=i?0:-1}}function TC(n,t,e,i){let{factors:s,quantities:r,sampled:o}=n.study,a=S("div",{className:"choices"}),l=(h,d,f,p)=>{let x=S("select",{},...d.map(([m,g])=>S("option",{value:String(m)},g)));return x.value=String(f),x.addEventListener("change",()=>{p(Number(x.value)),u(),i(),[...a.querySelectorAll("label")].find(m=>m.dataset.name===h)?.querySelector("select").focus()}),S("label",{},`${h} `,x)},c=(h,d)=>f=>{t[d]===f&&(t[d]=t[h]),t[h]=f};function u(){let h=[l("show",r.map((d,f)=>[f,d.title]),r.indexOf(t.quantity),d=>{t.quantity=r[d]})];if(e.length>2){let d=e.map(f=>[f,s[f].name]);h.push(l("across",d,t.x,c("x","y")),l("upwards",d,t.y,c("y","x")))}for(let d of e.filter(f=>!o&&f!==t.x&&f!==t.y)){let f=s[d].texts.map((p,x)=>[x,s[d].unit?`${p} ${s[d].unit}`:p]);h.push(l(s[d].name,f,t.fixed[d],p=>{t.fixed[d]=p}))}for(let d of h)d.dataset.name=d.firstChild.textContent.trim();a.replaceChildren(...h)}return u(),{element:a,fill:u}}function CC(n,t,e){let{factors:i}=n.study,[s,r]=[n.sizes[t.x],t.y===null?1:n.sizes[t.y]];if(s*r>MC)return{element:S("p",{className:"note"},"This map has too many cells for a page; see the figures of the study."),points:[]};let o=n.scaleOf(t.quantity),a=s<=wC,l=(g,_)=>n.pointAt(t.fixed.map((w,v)=>v===t.x?g:v===t.y?_:w)),c=new Map,u=[],h=[];for(let g=r-1;g>=0;g--){let _=S("tr",{},S("th",{scope:"row"},t.y===null?"":qx(i[t.y],g)));for(let w=0;w<s;w++){let v=l(w,g),E=S("td",{tabIndex:-1,role:"gridcell"});RC(E,n,t,o,v,a),c.set(`${w} ${g}`,E),h.push(v),_.append(E)}u.push(_)}let d=i[t.x].texts.map((g,_)=>S("th",{scope:"col"},qx(i[t.x],_)));u.push(S("tr",{className:"feet"},S("td"),...d));let f=S("table",{role:"grid",className:a?"grid":"grid small","aria-label":DC(n,t)},S("tbody",{},...u));f.style.setProperty("--columns",s);let p=[...c.values()].find(g=>Number(g.dataset.point)===t.current)??c.get("0 0");p.tabIndex=0,PC(f,c,e);let x=S("div",{className:"upwards"},t.y===null?"":Xx(i[t.y])),m=S("div",{className:"across"},Xx(i[t.x]));return{element:S("div",{className:r<6?"axes low":"axes"},x,S("div",{},S("div",{className:"scroll"},f),m)),points:h}}function RC(n,t,e,i,s,r){let{quantity:o}=e,a=o.values?.[s]??null;n.dataset.point=s,n.setAttribute("aria-selected",String(e.opened===s));let l=`${t.pointText(s)}: ${o.values?`${o.title} `:""}${t.valueText(o,s)}`;if(n.setAttribute("aria-label",l),n.title=l,a===null){let{sign:h,pattern:d}=t.word(o.reasons[s]);n.className=`what ${d}`,n.append(S("span",{},r?h:""));return}let{face:c,ink:u}=i.colour(a);n.style.background=c,n.style.color=u,n.textContent=r?i.text(a):""}function PC(n,t,e){let i=new Map([...t].map(([s,r])=>[r,s.split(" ").map(Number)]));n.addEventListener("click",s=>{let r=s.target.closest("[data-point]");r&&e(Number(r.dataset.point))}),n.addEventListener("keydown",s=>{let r=s.target.closest("[data-point]");if(!r||s.ctrlKey||s.metaKey||s.altKey)return;let[o,a]=i.get(r),[l,c]=$x[s.key]??[0,0],u=Math.max(...[...i.values()].map(([d])=>d)),h={Home:`0 ${a}`,End:`${u} ${a}`}[s.key]??`${o+l} ${a+c}`;if(s.key==="Enter"||s.key===" ")e(Number(r.dataset.point));else{if(!(s.key in $x)&&s.key!=="Home"&&s.key!=="End")return;t.has(h)&&(r.tabIndex=-1,t.get(h).tabIndex=0,t.get(h).focus())}s.preventDefault()})}function IC(n,t,e){let i=Du(n,t),s=[...Zx(t,e)].map(([r,o])=>{let a=n.word(r);return S("li",{},Oo(a),`${a.word} (${o})`)});return s.length&&i.push(S("ul",{},...s)),i}function Zx(n,t){let e=new Map;for(let i of t){let s=n.reasons[i];s!==null&&e.set(s,(e.get(s)??0)+1)}return new Map([...e].sort(([i],[s])=>i-s))}function LC(n,t,e){let i=e.filter(c=>(t.values?.[c]??null)!==null),s=[...Zx(t,e)].map(([c,u])=>`${u} ${n.word(c).word}`),r=`${t.title[0].toUpperCase()}${t.title.slice(1)}`;if(!i.length)return`${r} of ${e.length} points: ${s.join(", ")||"none"}.`;let o=s.length?` Other points: ${s.join(", ")}.`:"",[a,l]=[Math.min,Math.max].map(c=>NC(n,t,i,c));return`${r}, known for ${i.length} of ${e.length} points: from ${a} to ${l}.${o}`}function NC(n,t,e,i){let s=e.map(a=>t.values[a]).reduce((a,l)=>i(a,l)),r=e.filter(a=>t.values[a]===s),o=r.length>1?`${r.length} points`:n.pointText(r[0]);return`${n.valueText(t,r[0])} (${o})`}function DC(n,t){let{factors:e}=n.study,i=t.y===null?e[t.x].name:`${e[t.x].name} across and ${e[t.y].name} upwards`;return`${t.quantity.title} over ${i}; arrows move between cells, enter opens one`}function Xx(n){return n.unit?`${n.name} (${n.unit})`:n.name}function qx(n,t){let e=Math.ceil(n.texts.length/AC);return t%e?"":n.texts[t]}var Kx=2,UC=20;function Qx(n){let t=document.getElementById("live")?.textContent??null,e=t&&JSON.parse(t),i=S("div",{className:"answer"}),s=S("p",{className:"outcome",role:"status"}),r=S("div"),o=S("div"),a=null,l=!1,c=0,u=Promise.resolve(),h=0;function d(_,w){if(h+=1,c=_,!e)return[];if(!ru())return w?[]:[S("p",{className:"note"},`It cannot be simulated here either: ${e.refused}.`)];if(a)x(_);else if(!l){let v=S("button",{type:"button",className:"try"},w?"Try it and refine here":"Simulate it here"),E=S("p",{className:"note"});v.addEventListener("click",()=>f(v,E)),o.replaceChildren(S("div",{className:"offer"},v,E))}return[o]}async function f(_,w){l=_.disabled=!0,w.textContent="Starting the simulator …";try{a=await wo(jn(e.bench.clips[0]),e.bench,t,yo),o.replaceChildren(i),i.replaceChildren(a.element),a.begin(),x(c)}catch(v){w.textContent=`It cannot be simulated here: ${v.message}.`}}async function p(_,w){if(await u.catch(()=>null),w!==h)return null;u=a.engine.ask({act:"answer",values:_,search:e.search});let{answer:v}=await u;return w===h?v:null}async function x(_){let w=++h,v=S("button",{type:"button"},"Refine here");v.addEventListener("click",()=>g(_)),r.replaceChildren(),i.replaceChildren(s,...t_(n,e).length?[v]:[],r,a.element),s.textContent="Simulating …",a.sliders.set(e.points[_]);let E=await p(e.points[_],w);E&&(s.textContent=`${ke(n.pointText(_))}: ${jx(e,E)}.`,m(_))}function m(_){a.sliders.set(e.points[_]),a.engine.send({act:"restart",through:!1})}async function g(_){let w=++h,v=FC(n,e,_),E=new Map,A=S("p",{className:"note",role:"status"}),y=v[1].values.map(F=>v[0].values.map(k=>OC(v,k,F))).reverse(),M=y.map((F,k)=>S("tr",{},S("th",{scope:"row"},Jx(v[1],v[1].values.length-1-k)),...F.map(({cell:D})=>D))),P=S("tr",{className:"feet"},S("td"),...v[0].values.map((F,k)=>S("th",{scope:"col"},Jx(v[0],k)))),L=S("table",{className:"grid"},S("caption",{},BC(v,n.study.sampled)),S("tbody",{},...M,P));r.replaceChildren(S("div",{className:"table",tabIndex:0,role:"group","aria-label":"finer map"},L),A);let I=y.flat();for(let[F,{cell:k,values:D,where:V}]of I.entries()){A.textContent=`${F} of ${I.length} points simulated`;let X=await p({...e.points[_],...D},w);if(!X)return;let{sign:H,pattern:lt}=n.study.words.find(({word:Z})=>Z===X.word)??n.study.other;k.className=`what ${lt}`,k.replaceChildren(S("span",{},H)),k.title=`${V}: ${jx(e,X)}`,k.setAttribute("aria-label",k.title),E.set(X.word,H)}A.textContent=[...E].map(([F,k])=>`${k} ${F}`).join(" · "),m(_)}return{offer:d,get panel(){return a}}}function OC(n,t,e){let i={[n[0].key]:t};n[1].key&&(i[n[1].key]=e);let s=n.filter(({key:r})=>r).map(r=>`${r.name} ${Pe(r.factor*i[r.key])} ${r.unit}`).join(", ");return{cell:S("td",{"aria-label":`${s}: not simulated yet`}),values:i,where:s}}function t_(n,t){let e=i=>t.knobs.some(({key:s})=>s===n.study.factors[i].key);return n.study.axes.filter(i=>n.sizes[i]>1&&e(i))}function FC(n,t,e){let i=t_(n,t),[s,r]=i.length>1?i:[null,i[0]??0],o=a=>{if(a===null)return{key:"",name:"",unit:"",factor:1,values:[0]};let{key:l,name:c}=n.study.factors[a],u=t.knobs.find(m=>m.key===l);if(n.study.sampled)return{key:l,name:c,unit:u.unit,factor:u.factor,values:kC(t.points.map(m=>m[l]),e)};let h=n.placesOf(e),d=m=>t.points[n.pointAt(h.map((g,_)=>_===a?m:g))][l],[f,p]=[Math.max(0,h[a]-1),Math.min(n.sizes[a]-1,h[a]+1)],x=[];for(let m=f;m<p;m++)for(let g=0;g<Kx;g++)x.push(d(m)+g/Kx*(d(m+1)-d(m)));return{key:l,name:c,unit:u.unit,factor:u.factor,values:[...x,d(p)]}};return[o(r),o(s)]}function kC(n,t){let[e,i]=[Math.min(...n),Math.max(...n)],s=[-2,-1,0,1,2].map(r=>n[t]+r*(i-e)/UC);return[...new Set(s.map(r=>Math.min(i,Math.max(e,r))))].sort((r,o)=>r-o)}var Jx=({key:n,factor:t,unit:e,values:i},s)=>n?`${Pe(t*i[s])} ${e}`:"";function BC([n,t],e){return`${t.key?`${ke(n.name)} across, ${t.name} upwards`:ke(n.name)}, ${e?"around it":"at half the steps"}`}function jx(n,{status:t,least:e}){let s=(n.search?[n.search.first,n.search.second].filter(Boolean):[]).filter(({name:r})=>e[r]!==null&&e[r]!==void 0).map(({key:r,name:o,title:a})=>{let{factor:l,unit:c}=n.knobs.find(u=>u.key===r);return`${a} ${Pe(l*e[o])} ${c}`});return[t,...s].join("; ")}function zu(n){let t=S("h2"),e=S("p",{className:"outcome",role:"status"}),i=S("table",{className:"numbers"}),s=S("section",{className:"facts",id:"point"},t,e,S("div",{className:"table"},i)),r=S("div",{className:"parts",role:"group","aria-label":`runs of this ${n.study.noun}`}),o=S("div"),a=S("div",{className:"more"}),l=S("section",{className:"run",id:"run","aria-label":"the run that is open"},r,o,a),c=Qx(n),u={facts:s,element:l,point:null,playing:null,answers:c,open:f,show:m},h=null,d=xr();function f(_,{play:w=!1,transition:v=null}={}){u.point=_;let E=n.runsOf(_);t.textContent=ke(`${n.study.noun} ${_+1}`),e.textContent=`${ke(n.pointText(_))}: ${n.study.statuses[_]}.`,i.replaceChildren(S("caption",{},"Values in the table"),S("tbody",{},...WC(n,_))),r.replaceChildren(...E.length>1?E.map(p):E.map(M=>S("b",{},ke(M.title))));let A=v===null?null:E.find(M=>M.transition===v),y=w?E.find(M=>M.failed):null;E.length?m(A??y??E[0],{play:w}):(x(),o.replaceChildren(S("p",{className:"note"},$C(n,_)))),a.replaceChildren(...n.study.built[_]?c.offer(_,E.length>0):[])}function p(_){let w=S("button",{type:"button"},_.title);return w.dataset.part=_.part,w.addEventListener("click",()=>m(_,{play:!0})),w}function x(){u.playing?.dispose(),u.playing=null}function m(_,{play:w=!1}={}){x();for(let L of r.querySelectorAll("button"))L.setAttribute("aria-pressed",String(L.dataset.part===_.part));let v=h&&h!==_?h:null,E=v?[v,_]:[_],A={player:S("div"),plots:S("div"),readouts:E.map(()=>S("div"))},[y,M]=[XC,qC].map(L=>E.map((I,F)=>L(I,e_(E,n)[F]))),P=_.advice?[S("p",{className:"note"},_.advice)]:[];o.replaceChildren(S("p",{},_.text),g(_),...P,A.player,A.plots,...A.readouts,...y,...M),d.scale=n.largestSpan/_.play.clips[0].span_m,u.playing={run:_,beside:v,...zC(A,_,v,n,d)},Mo(o),w&&!matchMedia("(prefers-reduced-motion: reduce)").matches&&u.playing.clock.play()}function g(_){let v=S("button",{type:"button",className:"pin"},h?`unpin ${n.study.noun} ${h.point+1}`:"pin to compare with another");return v.addEventListener("click",()=>{h=h?null:_,m(_),o.querySelector(".pin").focus()}),v}return u}function zC(n,t,e,i,s){let r=e?[e,t]:[t],o=r.map((f,p)=>GC(f,e_(r,i)[p],i)),a=r.map((f,p)=>({...jn(f.play.clips[0]),...e?{name:o[p]}:{}})),l=bs(a,e?[HC(a)]:t.play.spans),c=r.map(f=>f.play.energy).reduce((f,p)=>p.largest_J>f.largest_J?p:f),u=e?`${ke(a[0].name)} and ${a[1].name}, side by side with a common clock.`:t.play.text,h=vo(n.player,a,l,{...t.play,energy:c,text:u},s);e&&h.stage&&Mf(h.stage.cells,a,l,c);let d=Uo(n.plots,e?VC(r,a):t.play.plots,a,l);n.plots.classList.toggle("paired",e!==null);for(let[f,p]of a.entries())So(n.readouts[f],p,l,c,f,e!==null);return{clips:a,clock:l,player:h,plots:d,dispose(){h.dispose(),d.dispose()}}}function VC(n,t){let e=n.map(({play:s},r)=>s.plots.map(o=>({...o,owner:t[r].name,sharing:`${o.title} ${o.unit}`,lines:o.lines.map(a=>({...a,clip:r}))})));return[...new Set(e.flat().map(s=>s.title))].flatMap(s=>e.flat().filter(r=>r.title===s))}function e_(n,{study:t}){if(n.length===1)return[""];let e=new Set(n.map(i=>i.point)).size<n.length;return n.map(i=>`${t.noun} ${i.point+1}${e?`, ${i.title}`:""}`)}function GC(n,t,e){let{factors:i}=e.study,s=e.placesOf(n.point).map((r,o)=>`${i[o].texts[r]} ${i[o].unit}`.trim());return`${t}: ${s.join(", ")}`}function HC(n){let t=n.map(s=>s.stages.find(r=>r.driven)?.start??s.start),[e,i]=[Math.min(...n.map((s,r)=>s.start-t[r])),Math.max(...n.map((s,r)=>s.end-t[r]))];return{name:"whole runs",label:"time since the first drive acts",start:e,end:i,origins:t,whole:!0}}function WC(n,t){return n.numbers.map(e=>S("tr",{},S("th",{scope:"row"},e.title),S("td",{},n.valueText(e,t))))}function $C(n,t){return n.study.built[t]?`This run was not kept, so it cannot be played here. ${n.study.keeps}`:n.study.unbuilt}function XC(n,t){let e=S("div");return e.innerHTML=n.numbers,S("details",{},S("summary",{},`States of ${t||"this run"}`),e)}function qC(n,t){let e=[`forficula run ${n.folder}/design.toml`,`forficula film ${n.folder} --out film.mp4`];return S("details",{},S("summary",{},t?`Commands for ${t}`:"Commands"),S("p",{className:"note"},"In the folder of this page, these commands repeat the run and make a film of it:"),S("pre",{},S("code",{},e.join(`
`))))}function Vu(n,t,e,i){let s=n?.querySelector("table");if(!s)return()=>{};let r=[...s.tBodies[0].rows],o=S("p",{className:"note",role:"status"}),a=YC(t,()=>{let u=a.shown(),h=0;for(let[d,f]of r.entries())f.hidden=!u.has(t.study.verdicts[d])||!t.shown(d),h+=f.hidden?0:1;o.textContent=`${h} of ${r.length} ${t.study.noun}s shown.`});for(let[u,h]of r.entries()){let d=S("button",{type:"button","aria-label":`open ${t.study.noun} ${u+1}`},h.cells[0].textContent);d.addEventListener("click",()=>i(u)),h.cells[0].replaceChildren(d)}let l=t.study.factors.length+1;for(let u of[s.tHead.rows[0],...r])u.cells[l].classList.add("words");KC(s,r,ZC(t));let c=S("div",{className:"choices"},a.element,...e?[jC(e,t.study.file)]:[]);return s.closest(".table").before(c,o),a.changed(),a.changed}function YC(n,t){let e=new Map,i=n.study.words.flatMap((r,o)=>{if(!r.count)return[];let a=S("input",{type:"checkbox",checked:!0});return a.addEventListener("change",t),e.set(o,a),[S("label",{},a,Oo(r),`${r.word} (${r.count})`)]});return{element:S("fieldset",{className:"filter"},S("legend",{},`Show ${n.study.noun}s that`),...i),changed:t,shown:()=>new Set([...e].filter(([,r])=>r.checked).map(([r])=>r))}}function ZC(n){let{study:t}=n,e=t.statuses.map((r,o)=>o),i=t.factors.map((r,o)=>e.map(a=>r.values[n.placesOf(a)[o]])),s=n.numbers.map(r=>r.values);return[e,...i,t.statuses,...s]}function KC(n,t,e){let i=[...n.tHead.rows[0].cells];for(let[s,r]of i.entries()){let o=S("button",{type:"button"},...r.childNodes);r.replaceChildren(o),o.addEventListener("click",()=>{let a=r.getAttribute("aria-sort")==="ascending";for(let c of i)c.removeAttribute("aria-sort");r.setAttribute("aria-sort",a?"descending":"ascending");let l=t.map((c,u)=>u).sort((c,u)=>JC(e[s][c],e[s][u],a?-1:1)||c-u);n.tBodies[0].append(...l.map(c=>t[c]))})}i[0].setAttribute("aria-sort","ascending")}function JC(n,t,e){if(n===null||t===null)return(n===null)-(t===null);let i=typeof n=="number"?n-t:String(n).localeCompare(String(t),"en");return e*i}function jC(n,t){let e=S("button",{type:"button",className:"button"},`Download ${t}`);return e.addEventListener("click",()=>{let i=URL.createObjectURL(new Blob([n],{type:"text/csv;charset=utf-8"}));S("a",{href:i,download:t}).click(),setTimeout(()=>URL.revokeObjectURL(i),1e4)}),e}function n_(n){let t=Uu(n.study,n.runs),e=zu(t),i=(a,l=null)=>{e.open(a,{play:!0,transition:l}),Pf(e)},s=Yx(t,(a,l)=>i(a,l.transition)),r=S("div",{},s.element,e.facts);document.getElementById("explorer").replaceChildren(S("div",{className:"explorer"},r,e.element)),Vu(document.getElementById("points"),t,n.csv,a=>{s.show(a),i(a)});let o=QC(t,n.runs);return e.open(o),s.show(o),{model:t,map:s,panel:e,open:i}}function QC(n,t){let e=n.study.quantities.filter(o=>o.group==="torque"),i=o=>[n.study.verdicts[o],...e.map(a=>a.values[o]??1/0),o],s=(o,a)=>{let l=o.findIndex((c,u)=>c!==a[u]);return l>=0&&o[l]<a[l]};return t.map(o=>o.point).reduce((o,a)=>o===null||s(i(a),i(o))?a:o,null)??0}function Pf({facts:n,element:t}){let{top:e}=t.getBoundingClientRect();if(e>=0&&e<.5*innerHeight)return;let i=n.getBoundingClientRect().left===t.getBoundingClientRect().left,s=matchMedia("(prefers-reduced-motion: reduce)").matches;(i?n:t).scrollIntoView({behavior:s?"auto":"smooth",block:"start"})}function i_(n){let{views:t}=n,e=Ux(n.study,n.runs),i=zu(e),s=[],r=(m,g)=>{i.open(m,{play:g});for(let _ of s)_.show?.(m)},o=m=>{r(m,!0),Pf(i)},a=Lx(e,t.lines,t,o),l=e.columns.filter(m=>m.aim).length===2,c=Wx(e,{...t,joined:l},o),u=t.pairs?.length?Fx(e,t,h):null;s.push(a,c);function h(m,g){c.over(m,g),c.element.scrollIntoView({block:"start"})}let d=n.runs.length?[[c.element,i.facts],[i.element]]:[[c.element],[i.facts]],f=S("div",{className:"explorer"},...d.map(m=>S("div",{},...m))),p={lines:a.element,pairs:u?.element,plane:f};document.getElementById("explorer").replaceChildren(...t.order.map(m=>p[m]));let x=Vu(document.getElementById("points"),e,n.csv,o);return e.whenAsked(x),n.study.points&&r(tR(e,n),!1),{model:e,panel:i,lines:a,plane:c,open:o}}function tR(n,{runs:t,views:e,study:i}){let{best:s}=e,r=t.map(o=>o.point);return s!==null&&r.includes(s)?s:r.find(o=>n.good(o))??r[0]??s??i.verdicts.findIndex((o,a)=>n.good(a)||a===i.points-1)}async function s_(n){let t=new Blob([nn(n,Uint8Array)]).stream(),e=await new Response(t.pipeThrough(new DecompressionStream("deflate"))).arrayBuffer();function i({kind:s,start:r,shape:o,low:a,step:l}){let c=o.reduce((d,f)=>d*f,1);if(s==="f4")return new Float32Array(e,r,c);if(s==="f8")return new Float64Array(e,r,c);let u=new(s==="u2"?Uint16Array:Uint32Array)(e,r,c),h=eR(u,...o);return a?Float32Array.from(h,(d,f)=>a[f%o[1]]+l[f%o[1]]*d):h}return i}function eR(n,t,e){let i=n.constructor,s=new i(1),r=new i(n.length);for(let o=0;o<e;o++){s[0]=0;for(let a=0;a<t;a++)s[0]+=n[o*t+a],r[a*e+o]=s[0]}return r}var nR="M7 4.5v15l12-7.5z",iR="M7 5h3.5v14H7zM13.5 5H17v14h-3.5z",js=180/Math.PI,Gu=1,r_=10,o_=720;function c_(n,t,e,i){let[s,r]=[n.lowest,n.highest].map(p=>p*js),o=aR(n),a=oR(n,s,r,o),l=S("button",{type:"button",className:"play"}),c=S("input",{type:"range",min:s,max:r,step:"any","aria-label":"hinge angle"});c.dataset.keys="own";let u=S("p",{className:"time"}),h=p=>{t.pause(),t.seek(i(Math.min(r,Math.max(s,p))/js))},d=()=>t.playing?t.pause():t.play(),f=a.map(({angle:p,name:x})=>{let m=S("button",{type:"button"},S("b",{},a_(p)),` ${x}`);return m.addEventListener("click",()=>h(p)),m});return c.addEventListener("input",()=>h(Number(c.value))),rR(c,()=>e(t.time)*js,h,d),l.addEventListener("click",d),t.onChange(()=>{let p=e(t.time)*js;c.value=p,u.textContent=`${a_(p,1)}${l_(n,p)}`,c.setAttribute("aria-valuetext",`${$n(p,1)} degrees${l_(n,p)}`);for(let[m,g]of a.entries())f[m].setAttribute("aria-pressed",String(Math.abs(g.angle-p)<.005));let x=t.playing?"pause":"play: fold from stop to stop";l.getAttribute("aria-label")!==x&&l.replaceChildren(sl(t.playing?iR:nR)),l.setAttribute("aria-label",x)}),S("div",{className:"transport"},S("div",{className:"line"},l,sR(c,s,r,o,a)),S("div",{className:"choices"},u,S("div",{className:"states"},...f)))}function sR(n,t,e,i,s){let r=S("div",{className:"bands","aria-hidden":"true"}),o=S("div",{className:"ticks","aria-hidden":"true"}),a=l=>`${100*l/(e-t)}%`;for(let[l,c]of i){let u=S("span",{className:"band"});Object.assign(u.style,{left:a(l-t),width:a(c-l)}),r.append(u)}for(let{angle:l,stop:c}of s){let u=S("span",{className:c?"tick stop":"tick"});u.style.left=a(l-t),o.append(u)}return S("div",{className:"track"},r,n,o)}function rR(n,t,e,i){let s={ArrowLeft:-Gu,ArrowDown:-Gu,ArrowRight:Gu,ArrowUp:Gu},r={PageDown:-r_,PageUp:r_,Home:-1/0,End:1/0};n.addEventListener("keydown",o=>{if(!(o.shiftKey||o.ctrlKey||o.metaKey||o.altKey)){if(o.key===" ")i();else if(o.key in s)e(Math.round(t()+s[o.key]));else if(o.key in r)e(t()+r[o.key]);else return;o.preventDefault()}})}var a_=(n,t=null)=>`${t===null?$n(n,Number.isInteger(Number(n.toFixed(3)))?0:1):$n(n,t)}°`;function oR(n,t,e,i){let s=a=>[...new Set(n.joints.map(l=>Number((l[a]*js).toFixed(6))))],r=[...s("lower").map(a=>({angle:a,name:"folding stop",stop:!0})),...i.flatMap(([a,l])=>[a,l].map(c=>({angle:c,name:"all straps slack"}))),...t<0&&e>0?[{angle:0,name:"flat"}]:[],...s("upper").map(a=>({angle:a,name:e>0?"overbend stop":"stop, flat",stop:!0}))],o=a=>Math.abs(a-t)<1e-6||Math.abs(a-e)<1e-6;return r.filter(a=>a.stop||a.name==="flat"||!o(a.angle)).sort((a,l)=>a.angle-l.angle)}function aR(n){let t=a=>u_(n,a).every(({longer:l})=>l<0),[e,i]=[n.lowest*js,n.highest*js],s=(a,l)=>{let c=t(a);for(let u=0;u<40;u++){let h=(a+l)/2;t(h)===c?a=h:l=h}return l},r=[];if(!n.straps.length)return r;let o=t(e)?null:e;for(let a=1;a<=o_;a++){let[l,c]=[a-1,a].map(u=>e+(i-e)*u/o_);t(l)!==t(c)&&(o===null?o=s(l,c):(r.push([o,s(l,c)]),o=null))}return o!==null&&r.push([o,i]),r}function u_(n,t){let e=n.turn(n.anglesTogether(t/js));return n.straps.flatMap(i=>n.strapStretches(i,e).map(s=>({longer:s,rest:i.rest})))}function l_(n,t){let e=u_(n,t);if(!e.length)return"";let i=e.filter(({longer:a})=>a<0).length,s=Math.max(...e.map(({longer:a})=>a));if(i===e.length)return`, straps slack by ${$n(-1e3*s,1)} mm or more`;let r=Math.max(...e.map(({longer:a,rest:l})=>a/l)),o=`stretched by up to ${$n(1e3*s,1)} mm (${$n(100*r,1)} %)`;return i?`, ${i} of ${e.length} straps slack, others ${o}`:`, straps ${o}`}function h_(n){let t=S("input",{type:"range",min:0,max:100,step:1,value:0});return t.dataset.keys="own",t.addEventListener("input",()=>n(Number(t.value)/100)),t.setAttribute("aria-valuetext","together"),t.addEventListener("input",()=>{t.setAttribute("aria-valuetext",t.value==="0"?"together":`${t.value} % apart`)}),S("label",{className:"slide"},"take apart ",t)}function d_(n,t,e){let i=n.map((s,r)=>{let o=S("input",{type:"checkbox",checked:!0});o.dataset.keys="own",o.addEventListener("change",()=>e(r,o.checked));let a=S("span",{className:"swatch panel","aria-hidden":"true"});return a.style.background=s.colour,S("label",{},o,a,`${s.name}${t[r]>1?`, ${t[r]}`:""}`)});return S("fieldset",{className:"kinds"},S("legend",{},"show"),...i)}function If(n,t,e){let i=S("select",{},...t.map((s,r)=>S("option",{value:String(r)},s)));return i.addEventListener("change",()=>e(Number(i.value))),S("label",{},`${n} `,i)}var Hu=28,f_=24;function p_(n,t){return n.ends.map(e=>{let[i,s]=e.map((r,o)=>new W(...r).applyMatrix4(ko(t,n.bodies[o])));return i.distanceTo(s)-n.rest})}var lR=new pe,ko=(n,t)=>t<0?lR:n[t];function Lf(n,t,e,i,s){let r=new W(...n.axis).transformDirection(ko(t,n.bodies[0])),o=new W(...n.up).transformDirection(ko(t,n.bodies[0]));return n.ends.map(a=>{let l=a.map((_,w)=>new W(..._).applyMatrix4(ko(t,n.bodies[w])).add(i)),c=l[1].clone().sub(l[0]),u=c.dot(r);c.addScaledVector(r,-u);let h=c.length(),d=h>1e-9?c.divideScalar(h):new W().crossVectors(r,o),f=new W().crossVectors(r,d).multiplyScalar(e),x=n.rest>Math.hypot(h,u)?Math.sqrt(n.rest**2-u**2):h,m=cR(s,x>1e-9?h/x:1);return{points:m.map(([_,w],v)=>l[0].clone().addScaledVector(d,_*x).addScaledVector(f,w*x).addScaledVector(r,u*v/(m.length-1))),wide:r,ends:l}})}function cR({values:n,shape:t},e){let[i,s]=t,r=Math.sqrt(Math.max(0,1-e))*(i-1),o=Math.min(i-2,Math.floor(r)),a=Math.min(1,r-o),l=(d,f,p)=>n[(d*s+f)*2+p],c=(d,f)=>l(o,d,f)+a*(l(o+1,d,f)-l(o,d,f)),u=c(s-1,0),h=u>1e-6?e/u:1;return Array.from({length:s},(d,f)=>[h*c(f,0),c(f,1)])}function m_(n,t,e){let i={triangles:[],edges:[]};for(let{points:s,wide:r,ends:o}of t){let a=r.clone().multiplyScalar(n.width/2),l=s.map((c,u)=>{let d=s[Math.min(u+1,s.length-1)].clone().sub(s[Math.max(u-1,0)]).cross(r).setLength(n.thickness/2);return[[-1,-1],[1,-1],[1,1],[-1,1]].map(([f,p])=>c.clone().addScaledVector(a,f).addScaledVector(d,p))});x_(i,l,[0,1,2,3]);for(let[c,u]of o.entries()){let h=new W(...n.across[c]).transformDirection(ko(e,n.bodies[c]));hR(i,u,h,n.width,n.eye/2,n.peg/2)}}return i}function Nf(n,t,e){let i=n.places.map(x=>new W(...x).add(e)),[s,r,o,a]=i,l=ko(t,n.body),[c,u]=[o,a].map(x=>x.clone().sub(e).applyMatrix4(l).add(e)),h=r.clone().sub(s).normalize(),d=u.clone().sub(c).normalize(),f=r.distanceTo(o),p=[s];for(let x=0;x<=f_;x++)p.push(uR(r,h,c,d,f,x/f_));return[...p,u]}function uR(n,t,e,i,s,r){let[o,a]=[1-r,r];return n.clone().multiplyScalar(o*o*(1+2*a)).addScaledVector(e,a*a*(1+2*o)).addScaledVector(t,s*o*o*a).addScaledVector(i,-s*a*a*o)}function g_(n,t){let e={triangles:[],edges:[]},i=n[1].clone().sub(n[0]).normalize(),s=new W(Math.abs(i.z)<.9?0:1,0,Math.abs(i.z)<.9?1:0),r=n.map((o,a)=>{let l=n[Math.min(a+1,n.length-1)].clone().sub(n[Math.max(a-1,0)]).normalize();s=s.clone().addScaledVector(l,-s.dot(l)).normalize();let c=new W().crossVectors(l,s);return Array.from({length:Hu},(u,h)=>{let d=2*Math.PI*h/Hu;return o.clone().addScaledVector(s,Math.cos(d)*t/2).addScaledVector(c,Math.sin(d)*t/2)})});return x_(e,r,[]),e}function x_({triangles:n,edges:t},e,i){let s=e[0].length;for(let r=1;r<e.length;r++){let[o,a]=[e[r-1],e[r]];for(let l=0;l<s;l++){let c=(l+1)%s;n.push(o[l],o[c],a[c],o[l],a[c],a[l]),i.includes(l)&&t.push(o[l],a[l])}}for(let r of[e[0],e.at(-1)])for(let o=1;o<s-1;o++)n.push(r[0],r[o],r[o+1])}function hR({triangles:n,edges:t},e,i,s,r,o){let a=new W(Math.abs(i.z)<.9?0:1,0,Math.abs(i.z)<.9?1:0);a.addScaledVector(i,-a.dot(i)).normalize();let l=new W().crossVectors(i,a),c=(u,h,d)=>e.clone().addScaledVector(i,d*s/2).addScaledVector(a,h*Math.cos(u)).addScaledVector(l,h*Math.sin(u));for(let u=0;u<Hu;u++){let[h,d]=[u,u+1].map(p=>2*Math.PI*p/Hu),f=(p,x,m,g)=>n.push(p,x,m,p,m,g);f(c(h,r,-1),c(d,r,-1),c(d,r,1),c(h,r,1));for(let p of[-1,1])f(c(h,o,p),c(d,o,p),c(d,r,p),c(h,r,p)),t.push(c(h,r,p),c(d,r,p))}}function __(n,t){let e=t.map(({origin:a,axis:l})=>[new W(...a),new W(...l)]),i=n.map((a,l)=>t.flatMap((c,u)=>c.body===l?[u]:[])),s=n.map(()=>new pe),r=new pe,o=new W;return function(l){for(let[c,u]of n.entries()){let h=s[c];u<0?h.identity():h.copy(s[u]);for(let d of i[c]){let[f,p]=e[d];r.makeRotationAxis(p,l[d]-t[d].built),o.copy(f).applyMatrix4(r),r.setPosition(f.x-o.x,f.y-o.y,f.z-o.z),h.multiply(r)}}return s}}var dR=[-1,0,1].flatMap(n=>[-1,0,1].flatMap(t=>[-1,0,1].map(e=>[n,t,e]))),fR=new pe;function y_(n,t){let e=n.parts.map(f=>({...f,...f.mesh?pR(f.mesh,t):{}})),i={values:t(n.bows),shape:n.bows.shape},s=__(n.bodies,n.turns),r=Math.min(...n.joints.map(f=>f.lower)),o=Math.max(...n.joints.map(f=>f.upper)),a=new Float64Array(n.turns.length);function l(f){for(let[p,x]of n.turns.entries())a[p]=x.built;for(let p of n.joints)a[p.turn]=Math.min(p.upper,Math.max(p.lower,f));return a}let c=(f,p)=>new W(...f.apart).multiplyScalar(p);function u(f,p,x,m=new pe){let g=c(f,x);return m.copy(f.body===null||f.body<0?fR:p[f.body]).multiply(new pe().makeTranslation(g.x,g.y,g.z))}function h(f,p,{apart:x,side:m}){let g=c(f,x);return f.root?g_(Nf(f.root,p,g),f.root.diameter):m_(f.strap,Lf(f.strap,p,m,g,i),p)}function d(f,p,{apart:x,side:m}){let g=[];for(let _ of f){if(_.outer){let E=u(_,p,x);for(let A of _.outer)g.push(...A.clone().applyMatrix4(E).toArray());continue}let w=c(_,x),v=_.root?[Nf(_.root,p,w)]:Lf(_.strap,p,m,w,i).map(E=>E.points);for(let E of v)for(let A=0;A<E.length;A+=4)g.push(...E[A].toArray())}return Float64Array.from(g)}return{parts:e,looks:n.looks,joints:n.joints,turns:n.turns,lowest:r,highest:o,turn:s,anglesTogether:l,matrixOf:u,bentMesh:h,outline:d,straps:e.filter(f=>f.strap).map(f=>f.strap),strapStretches:p_}}function pR({points:n,triangles:t,stops:e,edges:i},s){let r=s(n),o=s(t),a=n.shape[0];for(let l=0;l<o.length;l+=3)o[l+1]=(o[l]+o[l+1])%a,o[l+2]=(o[l]+o[l+2])%a;return{places:r,corners:o,stops:e,edges:s(i),outer:mR(r)}}function mR(n){let t=new Set;for(let[e,i,s]of dR){let[r,o]=[0,-1/0];for(let a=0;a<n.length;a+=3){let l=e*n[a]+i*n[a+1]+s*n[a+2];l>o&&([r,o]=[a,l])}t.add(r)}return Array.from(t,e=>new W().fromArray(n,e))}function v_(n,t){let e=t(n.time),i=t(n.angles),[,s]=n.angles.shape,r=new Float64Array(s);function o(a){let[l,c]=Ki(e,a),u=Math.min(l+1,e.length-1);for(let h=0;h<s;h++){let d=i[l*s+h];r[h]=d+c*(i[u*s+h]-d)}return r}return{time:e,anglesAt:o,marks:n.marks,stages:n.stages,spans:n.spans}}var gR="#14171a",xR=.55,_R=Math.cos(Math.PI/9),yR=.42;function b_(n,t,e,i){let s=n.parts.map(f=>vR(f,n.looks[f.look].colour,i)),r=new Fn;for(let f of s)r.add(f.mesh,f.lines);let o=new Fn,a=n.turn(n.anglesTogether(0));function l(f){a=n.turn(e(f));for(let[p,x]of n.parts.entries()){let{mesh:m,lines:g}=s[p],_=!t.hidden.has(x.look);for(let w of[m,g])w.visible=_;_&&(x.places?n.matrixOf(x,a,t.apart,m.matrix):MR(s[p],n.bentMesh(x,a,t)))}}function c(){let f=new Qt(Be("--accent"));for(let[p,{mesh:x}]of s.entries())for(let m of[x.material].flat())m.emissive.copy(f),m.emissiveIntensity=t.chosen===p?yR:0}function u(f,p){let x=new Aa;x.setFromCamera(f,p),r.updateMatrixWorld(!0);for(let{mesh:g}of s)g.geometry.boundingSphere===null&&g.geometry.computeBoundingSphere();let[m]=x.intersectObjects(s.map(g=>g.mesh).filter(g=>g.visible),!1);return m?s.findIndex(g=>g.mesh===m.object):null}function h(f){let p=n.parts.findIndex(_=>_.name===f),{mesh:x}=s[p],m=x.geometry.getAttribute("position"),g=new on(m.array.slice(),3);return Array.from(g.applyMatrix4(x.matrix).array)}function d(){for(let{mesh:f,lines:p}of s){f.geometry.dispose(),p.geometry.dispose();for(let x of[f.material,p.material].flat())x.dispose()}}return{group:r,shadow:o,pose:l,paint:c,sort:()=>{},at:u,verticesOf:h,dispose:d,current:()=>a}}function vR(n,t,e){let i=(u,h)=>new ms({color:u,side:kn,flatShading:h,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}),s=n.places?bR(n):new _n,r=n.places?[i(e,!1),i(t,!1)]:i(t,!0),o=new Nn(s,r),a=new _n;n.places&&a.setAttribute("position",new on(S_(n.places,n.edges),3));let l=new Bs({color:gR,transparent:!0,opacity:xR}),c=new cr(a,l);for(let u of[o,c])Object.assign(u,{frustumCulled:!1,matrixAutoUpdate:!1});return c.matrix=o.matrix,{mesh:o,lines:c}}function bR({places:n,corners:t,stops:e}){let i=new _n;return i.setAttribute("position",new on(S_(n,t),3)),i.setAttribute("normal",new on(SR(n,t),3)),i.addGroup(0,3*e,0),i.addGroup(3*e,t.length-3*e,1),i}function S_(n,t){let e=new Float32Array(3*t.length);for(let[i,s]of t.entries())for(let r=0;r<3;r++)e[3*i+r]=n[3*s+r];return e}function SR(n,t){let e=t.length/3,i=new Float64Array(t.length),s=Array.from({length:n.length/3},()=>[]);for(let l=0;l<e;l++){let[c,u,h]=[0,1,2].map(f=>3*t[3*l+f]),d=(f,p,x)=>n[p+x%3]-n[f+x%3];for(let f=0;f<3;f++)i[3*l+f]=d(c,u,f+1)*d(c,h,f+2)-d(c,u,f+2)*d(c,h,f+1);for(let f=0;f<3;f++)s[t[3*l+f]].push(l)}let r=Float64Array.from({length:e},(l,c)=>Math.hypot(...i.subarray(3*c,3*c+3))),o=new Float32Array(3*t.length),a=(l,c)=>i[3*l]*i[3*c]+i[3*l+1]*i[3*c+1]+i[3*l+2]*i[3*c+2];for(let l=0;l<t.length;l++){let c=Math.floor(l/3),u=[0,0,0];for(let d of s[t[l]])if(d===c||a(c,d)>=_R*r[c]*r[d])for(let f=0;f<3;f++)u[f]+=i[3*d+f];let h=Math.hypot(...u)||1;for(let d=0;d<3;d++)o[3*l+d]=u[d]/h}return o}function MR({mesh:n,lines:t},{triangles:e,edges:i}){for(let[s,r]of[[n,e],[t,i]]){let{geometry:o}=s,a=o.getAttribute("position");a?.count!==r.length&&(a=new on(new Float32Array(3*r.length),3),o.setAttribute("position",a));for(let[l,c]of r.entries())c.toArray(a.array,3*l);a.needsUpdate=!0,o.boundingSphere=null}}var wR=.25,M_=60,AR=4;async function A_(n){let t=await s_(n.arrays),e=y_(n,t),i={apart:0,side:1,hidden:new Set,chosen:null},s=[ER(e,i),...n.motion?[TR(e,i,v_(n.motion,t))]:[]],r=CR(s),o=document.getElementById("player"),a=RR(o,n,e,i,r),l=UR(e,n,i,a);return a.onPress(l.choose),{model:e,state:i,clock:s[0].clock,run:s[1]?.clock??null,...a,choose:l.choose}}function ER(n,t){let e=c=>n.highest+c*(n.lowest-n.highest),i=c=>(c-n.highest)/(n.lowest-n.highest||1),s=Float64Array.from({length:M_+1},(c,u)=>u/M_),r=c=>n.anglesTogether(e(c)),o=E_(n,t,{time:s,anglesAt:r,marks:[],stages:[]}),a=bs([T_(n,o,r)],[{name:"",label:"",start:0,end:1,origins:[0],whole:!1}]);a.setSpeed(wR);let l=c_(n,a,e,i);return{name:"all joints together",clip:o,clock:a,anglesAt:r,control:l}}function TR(n,t,e){let i=E_(n,t,e),s=bs([T_(n,i,e.anglesAt)],e.spans);return{name:"as in the simulated run",clip:i,clock:s,anglesAt:e.anglesAt,control:uu([i],s)}}function E_(n,t,{time:e,anglesAt:i,marks:s,stages:r}){let o=()=>{let a=n.parts.filter(l=>!t.hidden.has(l.look));return a.length?a:n.parts};return{name:"",time:e,start:e[0],end:e[e.length-1],marks:s,stages:r,readings:[],reach:0,mesh:{tubes:[],joints:[],jointRadius:0},pointsAt:a=>n.outline(o(),n.turn(i(a)),t),stageAt:a=>r.findLast(l=>l.start<=a)??r[0],markAt:a=>s.find(l=>Math.abs(l.time-a)<1e-9)}}function T_(n,t,e){let i=n.parts.filter(s=>s.outer).map(s=>({...s,outer:[s.outer[0],s.outer.at(-1)]}));return{...t,pointsAt:s=>n.outline(i,n.turn(e(s)),{apart:0,side:1})}}function CR(n){let t=n[0],e={of:null},i=new Set;for(let a of n)a.clock.onChange(()=>{if(a===t)for(let l of i)l()});let s=()=>t.clock.redraw(),r={get time(){return t.clock.time},get playing(){return t.clock.playing},get span(){return e.of!==t.clock.span&&(e={...t.clock.span,of:t.clock.span}),e},clipTime:(a,l)=>t.clock.clipTime(a,l),timeAt:a=>t.clock.timeAt(a),wayAt:a=>t.clock.wayAt(a),onChange(a){return i.add(a),s(),()=>i.delete(a)},seek:a=>t.clock.seek(a),seekClip:(a,l)=>t.clock.seekClip(a,l),step:a=>t.clock.step(a),play:()=>t.clock.play(),pause:()=>t.clock.pause()};return{clip:{...n[0].clip,pointsAt:a=>t.clip.pointsAt(a)},clock:r,sources:n,get now(){return t},anglesAt:a=>t.anglesAt(a),take(a){t.clock.pause(),t=n[a],e={of:null},s()},changed(){e={of:null},s()}}}var C_="Press a part, or its name in the table, for details.",w_="parts";function RR(n,t,e,i,s){let{clip:r,clock:o,sources:a}=s,l=null,u=Ha([r],o,()=>l=b_(e,i,s.anglesAt,t.stopColour),t.text),h=u?S("div",{className:"picture"},u.element,fu(u.eye,null)):S("p",{className:"note"},du(w_)),d=S("p",{className:"chosen",role:"status"},C_),f=S("div",{},a[0].control);return n.replaceChildren(h,d,f,PR(e,i,s,f),IR(e,i,s),LR(t,e,u),lu([r],u!==null,w_)),n.classList.add("player"),n.setAttribute("role","region"),n.setAttribute("aria-label","the moving parts"),cu(n,[r],o,u?.eye,gr[0]),{stage:u,shape:l,info:d,repaint:()=>{l?.paint(),o.seek(o.time)},onPress:p=>u&&DR(u.canvas,x=>p(l.at(x,u.eye.camera)))}}function PR(n,t,e,i){let s=l=>{Object.assign(t,l),e.changed()},r=e.sources.map(l=>l.name),o=If("motion",r,l=>{e.take(l),i.replaceChildren(e.now.control)}),a=If("slack straps bow",["away from the hinge","towards the hinge"],l=>s({side:l?-1:1}));return S("div",{className:"choices"},...r.length>1?[o]:[],h_(l=>s({apart:l})),...n.straps.length?[a]:[])}function IR(n,t,e){let i=n.looks.map((s,r)=>n.parts.reduce((o,a)=>o+(a.look===r?a.count:0),0));return d_(n.looks,i,(s,r)=>{r?t.hidden.delete(s):t.hidden.add(s),e.changed()})}function LR(n,t,e){let i=S("span",{className:"swatch taut","aria-hidden":"true"});return S("ul",{className:"legend"},...t.parts.some(s=>s.stops)?[NR(n.stopColour,"face of a stop")]:[],...t.straps.length?[S("li",{},i,"on the slider: range of taut straps")]:[],...e?[S("li",{},`squares of the grid: ${Pe(1e3*Ga(e.eye.size))} mm`)]:[])}function NR(n,t){let e=S("span",{className:"swatch panel","aria-hidden":"true"});return e.style.background=n,S("li",{},e,t)}function DR(n,t){let e=null;n.addEventListener("pointerdown",i=>{e=i.isPrimary?[i.clientX,i.clientY]:null}),n.addEventListener("pointerup",i=>{if(e===null||Math.hypot(i.clientX-e[0],i.clientY-e[1])>AR)return;let s=n.getBoundingClientRect(),[r,o]=[(i.clientX-s.left)/s.width,(i.clientY-s.top)/s.height];t(new Yt(2*r-1,1-2*o))})}function UR(n,t,e,i){let r=Array.from(document.querySelectorAll("#bill tbody tr")).map((l,c)=>{let[u]=l.querySelector("th").childNodes,h=S("button",{type:"button",className:"name","aria-pressed":"false"},u.textContent);return u.replaceWith(h),h.addEventListener("click",()=>o(e.chosen===c?null:c)),h});function o(l){e.chosen=l;for(let[c,u]of r.entries())u.setAttribute("aria-pressed",String(c===l));i.info.textContent=l===null?C_:a(l),i.repaint()}function a(l){let c=n.parts[l],[u,h,d]=c.facts,f=c.count>1?`${c.count} identical ones, each `:"";return`${c.name}: ${n.looks[c.look].name} of ${u}, ${f}${h}, ${d}`}return{choose:o}}function R_(n){let t=n.clips.map(jn),e=bs(t,n.spans),i=vo(document.getElementById("player"),t,e,n),s=n.curves?ja(document.getElementById("curves"),n.curves,t,e):[],r=Uo(document.getElementById("plots"),n.plots,t,e);So(document.getElementById("readout"),t[0],e,n.energy),Lu(document.getElementById("player"),e);let o=pu(document.getElementById("try"),t[0],n,()=>e.pause());return{clips:t,clock:e,player:i,curves:s,plots:r,trial:o}}var I_={"Content-Type":"application/json"},P_=19e6;async function wr(n,t,e){let i=JSON.stringify(t);if(i.length>P_)return{refused:`need files of at most ${P_/1e6} MB in all`};try{return await(await fetch(n,{method:"POST",headers:I_,body:i,signal:e})).json()}catch(s){if(s.name==="AbortError")throw s;return{refused:Wu}}}async function L_(n,t,e,i){let s="",r={refused:Wu};try{let a=(await fetch(n,{method:"POST",headers:I_,body:JSON.stringify(t),signal:e})).body.pipeThrough(new TextDecoderStream).getReader();for(let l=await a.read();!l.done;l=await a.read()){let c=`${s}${l.value}`.split(`
`);s=c.pop();for(let u of c)r=JSON.parse(u),r.doing&&i(r.doing)}s&&(r=JSON.parse(s))}catch(o){if(o.name==="AbortError")throw o;return{refused:Wu}}return r.doing?{refused:Wu}:r}var Wu="the workbench does not answer; is forficula open still running?";var Df=`forficula ${location.pathname}`;function D_(n){let t={asked:null,base:null,reply:null,rejected:new Map};t.open=async(r,o)=>{let a=r.files[0]?.name||r.design||"the design";n.says.wait(`Opening ${a}`);let l=await wr("design",{...r,settings:{}}),c=l.refused??await e({...r,settings:o},l);return c?n.says.refuse(`${a} is not opened: ${c}`):t.rejected.clear(),t.reply&&s(t.reply),c};async function e(r,o){let a=performance.now(),l=new AbortController;n.says.wait("Building",()=>l.abort());try{let c=await wr("design",r,l.signal);if(c.refused)return c.refused;let u=await wr("model",r,l.signal);if(u.refused)return u.refused;Object.assign(t,{asked:r,base:o}),s(c),await n.model(u),n.says.done(`Built in ${((performance.now()-a)/1e3).toFixed(1)} s.`)}catch(c){if(c.name!=="AbortError")throw c;return"building was stopped"}return""}t.change=async(r,o)=>{let{asked:a,rejected:l}=t,c=[...l].filter(([f])=>f!==r).map(([f,p])=>[f,p.text]),u=i(a.settings,[[r,o]]),h=c.length?[i(a.settings,[...c,[r,o]]),u]:[u],d="";for(let f of h)if(d=N_(f,a.settings)?"":await e({...a,settings:f},t.base),!d){f===h[0]?l.clear():l.delete(r);break}d?(l.set(r,{text:o,why:d}),n.says.refuse(`${d} – the last working model is kept`)):N_(u,a.settings)&&n.says.done(""),s(t.reply)},t.slide=async r=>{let o=i(t.asked.settings,Object.entries(r)),a=await wr("design",{...t.asked,settings:o});return a.refused?n.says.refuse(a.refused):(t.asked={...t.asked,settings:o},s(a))};function i(r,o){let a={...r};for(let[l,c]of o)c===""||c===t.base.keys.find(u=>u.key===l)?.value?delete a[l]:a[l]=c;return a}function s(r){t.reply=r,OR(t.asked),n.reply(t)}return t}var N_=(n,t)=>JSON.stringify(Object.entries(n).sort())===JSON.stringify(Object.entries(t).sort());function U_(){return JSON.parse(sessionStorage.getItem(Df)??"null")}function OR(n){try{sessionStorage.setItem(Df,JSON.stringify(n))}catch{sessionStorage.removeItem(Df)}}function O_(n){let t=S("textarea",{id:"file-text",className:"file",rows:24,spellcheck:!1,"aria-describedby":"file-note"}),e=S("button",{type:"button"},"Build this text"),s=S("div",{},S("label",{htmlFor:"file-text"},"The design file"),S("p",{className:"note",id:"file-note"},"Add or remove stages, tendons and whole sections here. The result counts as a new design file."),t,S("p",{className:"choices"},e));e.addEventListener("click",()=>n(t.value));let r="";return{element:s,show(o){o.text!==r&&(t.value=r=o.text)}}}function $u(n,t){let e="";for(let i of new TextEncoder().encode(n))e+=String.fromCharCode(i);return`data:${t};base64,${btoa(e)}`}var Uf=40,FR=0;function F_(n,t){let e=`key-${++FR}`,i=n.key.split(".").at(-1).replaceAll("_"," "),s=kR(n,e),r=S("button",{type:"button",className:"home",hidden:!0},"undo"),o=S("p",{className:"wrong",id:`${e}-wrong`}),a="",l=S("p",{className:"note",id:`${e}-notes`}),c=S("div",{className:"field"},S("label",{htmlFor:e,title:n.key},i),S("span",{className:"entry"},s,...BR(n,e),r),o,l);s.setAttribute("aria-describedby",`${e}-wrong ${e}-notes`),s.addEventListener("change",()=>{a=s.value.trim(),t(a)}),r.addEventListener("click",()=>{t(""),s.focus()}),r.setAttribute("aria-label",`undo the change of ${i}`);function u(d,f,p){(document.activeElement!==s||s.value.trim()===a)&&(s.value=f??d.value),a=s.value.trim(),h("");let x=f===void 0?null:p?.value||"left out";c.classList.toggle("changed",x!==null),r.hidden=x===null;let m=d.default&&d.default!=="needed"?`if left out ${d.default}`:"",_=[d.allowed,x===null?m:`was ${x}`,d.chosen&&`chosen: ${d.chosen}`].filter(Boolean).join(" · ").replaceAll(">=","≥").replaceAll("<=","≤");l.replaceChildren(ke(d.meaning),S("span",{className:"may"},_))}function h(d,f){f!==void 0&&(s.value=a=f),o.textContent=d,c.classList.toggle("rejected",d!==""),d?(s.setAttribute("aria-invalid","true"),r.hidden=!1):s.removeAttribute("aria-invalid")}return{element:c,input:s,fact:n,show:u,reject:h}}function kR({key:n,value:t,words:e,onlyWords:i,default:s},r){if(i){let l=t?[]:[S("option",{value:""},s&&s!=="needed"?`left out: ${s}`:"left out")];return S("select",{id:r,"data-key":n},...l,...e.map(c=>S("option",{value:c},c)))}let o={id:r,spellcheck:!1,autocomplete:"off",autocapitalize:"off","data-key":n};if(t.length>Uf)return S("textarea",{...o,rows:Math.min(6,Math.ceil(t.length/Uf))});let a=S("input",{...o,type:"text"});return e.length&&a.setAttribute("list",`${r}-words`),a}function BR({words:n,onlyWords:t,value:e},i){return t||!n.length||e.length>Uf?[]:[S("datalist",{id:`${i}-words`},...n.map(s=>S("option",{value:s})))]}var zR=["pattern","tendon"];function k_(n){let t=S("input",{type:"search",id:"find-key",spellcheck:!1,placeholder:"stiffness, length, torque …"}),e=S("p",{className:"note",role:"status"}),i=S("div",{className:"sections"}),s=S("section",{className:"keys-of-design","aria-label":"keys of the design"},S("h2",{},"Keys"),S("label",{className:"find",htmlFor:"find-key"},"Find a key",t),e,i),r=new Map,o=[];t.addEventListener("input",a);function a(){let h=t.value.toLowerCase().split(/\s+/).filter(Boolean),d=0;for(let{fact:f,element:p}of r.values()){let x=`${f.key.replaceAll("_"," ")} ${f.key} ${f.meaning}`.toLowerCase();p.hidden=!h.every(m=>x.includes(m)),d+=p.hidden?0:1}for(let f of o){f.element.hidden=f.fields.every(p=>p.element.hidden);for(let{heading:p,fields:x}of f.parts)p.hidden=x.every(m=>m.element.hidden);h.length&&!f.element.hidden&&(f.element.open=!0)}e.textContent=h.length?`${d} of ${r.size} keys`:`${r.size} keys; enter values with units, as in a design file`}function l(h,d,f){let p=new Map(f.keys.map(x=>[x.key,x]));VR(h.keys,r)||c(h);for(let x of h.keys)r.get(x.key).show(x,d[x.key],p.get(x.key));for(let x of o)x.count(d);a()}function c(h){let d=new Set(o.length?o.filter(({element:x})=>x.open).map(({name:x})=>x):zR),f=document.activeElement?.dataset?.key;r=new Map(h.keys.map(x=>[x.key,F_(x,m=>n(x.key,m))])),o=[...new Set(h.keys.map(({key:x})=>x.includes(".")?x.split(".")[0]:""))].sort((x,m)=>(m===""?-1:0)-(x===""?-1:0)).map(x=>GR(x,h,r));for(let x of o)x.element.open=d.has(x.name);i.replaceChildren(...o.map(x=>x.element)),f&&r.get(f)?.input.focus()}function u(h,d,f){let p=r.get(h);if(p){p.reject(f,d);for(let x of o)x.fields.includes(p)&&(x.element.open=!0)}}return{element:s,show:l,reject:u,field:h=>r.get(h)}}function VR(n,t){let e=[...t.keys()],i=(s,r)=>s.key===r&&s.onlyWords===t.get(r).fact.onlyWords;return n.length===e.length&&n.every((s,r)=>i(s,e[r]))}function GR(n,t,e){let i=t.keys.filter(({key:d})=>(d.includes(".")?d.split(".")[0]:"")===n),s=i.map(({key:d})=>e.get(d)),r=S("summary"),o=t.sections[n],a=[],l=[];for(let{key:d}of i){let f=d.split(".").slice(1,-1).join(".");if(f!==(a.at(-1)?.within??"")){let p=t.keys.find(m=>m.key===`${n}.${f}.name`)?.value,x=S("h3",{},`${n}.${f}${p?` · ${p}`:""}`);a.push({within:f,heading:x,fields:[]}),l.push(x)}a.at(-1)?.fields.push(e.get(d)),l.push(e.get(d).element)}let c=o?[S("p",{className:"note"},`${ke(o).replace(/\.$/,"")}.`)]:[],u=S("details",{},r,...c,...l);function h(d){let f=i.filter(({key:p})=>p in d).length;r.replaceChildren(n?ke(n):"Name",...f?[S("small",{},` ${f} changed`)]:[])}return{name:n,element:u,fields:s,parts:a.filter(({heading:d})=>d),count:h}}function B_(n,t,e){let i=S("option",{value:""},t),s=n.filter(({name:f})=>f!==t).map(({name:f,shows:p})=>S("option",{value:f,title:p},f)),r=S("select",{id:"which-design"},i,...s),o=S("input",{type:"file",id:"which-files",multiple:!0,accept:".toml,.fold,.svg,.dxf",className:"spoken"}),a=S("input",{type:"text",id:"which-unit",placeholder:"1 cm",size:6,spellcheck:!1}),l="A design (.toml, with the files that it names), a FOLD file or a drawing (.svg, .dxf) can be dropped anywhere on the page.",c=S("label",{className:"button",htmlFor:"which-files"},"Open files …"),u=S("div",{className:"opening choices"},S("label",{htmlFor:"which-design"},"design ",r),S("span",{className:"choosing"},o,c),S("label",{htmlFor:"which-unit",title:"for a FOLD file or a drawing without a unit"},"unit of a drawing ",a),S("p",{className:"note"},l));r.addEventListener("change",()=>e({design:r.value,files:[],unit:""})),o.addEventListener("change",async()=>{o.files.length&&await d([...o.files]),o.value=""}),a.addEventListener("change",()=>{h&&e({design:"",files:h,unit:a.value.trim()})});let h=null;async function d(f){let p=await Promise.all(f.map(async x=>({name:x.name,text:await x.text()})));h=HR(p),await e({design:"",files:h,unit:a.value.trim()})}return WR(d),{element:u,show({design:f,files:p}){r.querySelector(".sent")?.remove(),p.length&&r.append(S("option",{value:p[0].name,className:"sent"},p[0].name)),r.value=p.length?p[0].name:f,h=p.length?p:null}}}function HR(n){let t=n.filter(({name:i})=>/\.toml$/i.test(i)),e=t.find(({name:i})=>!t.some(s=>s.name!==i&&s.text.includes(i)))??n[0];return[e,...n.filter(i=>i!==e)]}function WR(n){let{body:t}=document,e=i=>{i.dataTransfer?.types.includes("Files")&&(i.preventDefault(),t.classList.add("dropping"))};t.addEventListener("dragenter",e),t.addEventListener("dragover",e),t.addEventListener("dragleave",i=>{i.relatedTarget||t.classList.remove("dropping")}),t.addEventListener("drop",i=>{t.classList.remove("dropping"),i.dataTransfer?.files.length&&(i.preventDefault(),n([...i.dataTransfer.files]))})}function z_(n,{button:t,text:e,title:i},s){let r=S("button",{type:"button",className:"try"},t),o=S("button",{type:"button",hidden:!0},"Stop"),a=S("p",{className:"note",role:"status"},e),l=S("div"),c=S("div",{className:"results"},S("div",{className:"offer"},r,o,a),l),u=null,h=null;async function d(){if(h)return;let x=s(),m=performance.now();h=new AbortController,r.disabled=!0,o.hidden=!1,a.textContent="Starting …";let g=!1;try{let _=await L_(n,x,h.signal,w=>a.textContent=`${w} …`);_.refused?a.textContent=`No result: ${_.refused}.`:f(_.done,x,(performance.now()-m)/1e3),g=!_.refused}catch{a.textContent="Stopped."}h=null,r.disabled=!1,o.hidden=!0,g&&p()}function f(x,m,g){u=JSON.stringify(m),a.textContent=`Done in ${g.toFixed(g<10?1:0)} s.`;let _=S("a",{href:x,target:"_blank",rel:"noopener"},"Open in a new window"),w=S("iframe",{src:x,title:i,sandbox:"allow-scripts allow-downloads"});l.replaceChildren(S("p",{},_),w)}function p(){u!==null&&!h&&u!==JSON.stringify(s())&&(a.textContent="This result belongs to the design before its last change.")}return r.addEventListener("click",d),o.addEventListener("click",()=>h?.abort()),{element:c,find:d,seen:p}}var $R=1500;function V_(){let n=S("p",{role:"status"}),t=S("p",{className:"wrong",role:"alert"}),e=S("button",{type:"button",hidden:!0},"Stop building"),i=0,s=null;e.addEventListener("click",()=>s?.());function r(o,a=""){clearTimeout(i),e.hidden=!0,n.textContent=o,t.textContent=a}return{element:S("div",{className:"says"},n,e,t),wait(o,a){r(`${o} …`),s=a,a&&(i=setTimeout(()=>e.hidden=!1,$R))},done:o=>r(o),refuse:o=>r("",o.endsWith(".")?o:`${o}.`)}}function G_(){let n=S("a",{className:"button"},"Download the design"),t=S("code"),e=S("pre",{tabIndex:0,role:"group","aria-label":"the command that runs it"},t);return{element:S("div",{className:"taking"},n,e),show(i){n.href=$u(i.text,"application/toml"),n.download=`${i.name}.toml`,t.textContent=i.command}}}function H_(n){let t=S("div"),e=null;async function i(){let s=n();if(!s)return;let r=JSON.stringify(s);if(r===e)return;e=r,t.querySelector("img")||t.replaceChildren(S("p",{className:"note",role:"status"},"Drawing …"));let o=await wr("pattern",s);if(e!==r)return;if(o.refused){t.replaceChildren(S("p",{className:"note",role:"status"},`No pattern is drawn: ${o.refused}.`));return}let a=S("img",{src:`data:image/svg+xml;base64,${o.drawing}`,alt:o.said}),l=(u,h,d)=>S("a",{className:"button",download:h,href:d},u),c=$u(o.fold,"application/json");t.replaceChildren(S("figure",{className:"drawn"},a),S("p",{className:"choices"},l("Drawing as SVG","pattern.svg",a.src),l("Pattern as FOLD","pattern.fold",c)))}return{element:t,seen:i}}function W_(n){let t={},e=0;function i(){if(clearTimeout(e),!Object.keys(t).length)return;let s=t;return t={},n(s)}return{put(s,r){t[s]=r,clearTimeout(e),e=setTimeout(i,250)},hand:i}}function $_(n,t){let e=n.map(({name:o,title:a,element:l},c)=>{l.id=`view-${o}`,l.setAttribute("role","tabpanel"),l.setAttribute("aria-labelledby",`tab-${o}`);let u=S("button",{type:"button",id:`tab-${o}`,role:"tab","aria-controls":l.id},a);return u.addEventListener("click",()=>r(c)),u}),i=S("div",{className:"tabs",role:"tablist","aria-label":t},...e),s=0;function r(o){s=o;for(let[a,l]of e.entries())l.setAttribute("aria-selected",String(a===o)),l.tabIndex=a===o?0:-1,n[a].element.hidden=a!==o;n[o].seen?.()}return i.addEventListener("keydown",({key:o})=>{let a={ArrowRight:s+1,ArrowLeft:s-1,Home:0,End:e.length-1};o in a&&(r((a[o]+e.length)%e.length),e[s].focus())}),{element:S("div",{className:"views-of-bench"},i,...n.map(({element:o})=>o)),choose:o=>r(n.findIndex(a=>a.name===o)),name:(o,a)=>e[n.findIndex(l=>l.name===o)].textContent=a,seen:()=>n[s].seen?.()}}function q_(n,t){let e=S("div"),i={element:e,panel:null,refused:"",engine:null},s=null,r,o;function a(){i.panel?.leave(),s?.dispose(),i.panel=s=null}i.show=async({bench:u,live:h,warnings:d})=>{let f=jn(u.clips[0]);if(i.refused=h.refused??"",o=i.panel?.pace??o,!i.refused)try{let p=await wo(f,u,JSON.stringify(h),l,{look:r,pace:o,set:n});a(),e.replaceChildren(p.element,...X_(d)),p.begin(),i.panel=p,r=p.stage?.eye.look;return}catch(p){i.engine?.end(),i.engine=null,i.refused=p.message}a(),c(f,u,d)};async function l(u,h){return i.engine?i.engine.take(u,h):(i.engine=await yo(u,h),i.engine)}function c(u,h,d){let f=S("p",{className:"note"},`The picture shows the start. A page cannot simulate this ${h.whole}: ${i.refused}. The package can:`),p=S("button",{type:"button"},"Run it");p.addEventListener("click",t);let x=S("div");e.replaceChildren(S("div",{className:"offer"},f,p),x,...X_(d));let m=r??{...xr(),following:!1},{stage:g}=bo(x,[u],Nu(u),{...h,text:`${h.shape}, at its start.`},m);x.setAttribute("aria-label",`the ${h.whole} at its start`),s=g,r=g?.eye.look??r}return i}function X_(n){if(!n.length)return[];let t=e=>`${e.replace(/^[a-z](?=\S* )/,i=>i.toUpperCase()).replace(/\.$/,"")}.`;return[S("h2",{},"What to know"),S("ul",{className:"warnings"},...n.map(e=>S("li",{},t(e))))]}var XR={landscape:{button:"Compute it",text:"Statics computes the equilibria, the barriers between them, and the motion under the drives.",title:"landscape"},run:{button:"Run it",text:"The package simulates the protocol, checks the energy balance and reports the outcome.",title:"run"}};async function Y_(n){let t=V_(),e=Promise.resolve(),i=p=>e=e.then(p).catch(x=>t.refuse(x.message)),s=D_({says:t,reply:h,model:d}),r=W_(p=>i(()=>s.slide(p))),o=p=>i(()=>s.open(p,{})),a=B_(n.designs,n.opened,o),l=k_((p,x)=>{r.hand(),i(()=>s.change(p,x))}),c=YR(s,r,o),u=G_();function h({asked:p,base:x,reply:m,rejected:g}){document.title=`${m.title}: workbench`,document.querySelector("h1").textContent=m.title,a.show(p),l.show(m,p.settings,x);for(let[_,{text:w,why:v}]of g)l.reject(_,w,v);c.file.show(m),u.show(m),c.tabs.seen()}async function d(p){await c.wing.show(p),c.tabs.name("wing",ke(p.bench.whole))}let f=S("div",{className:"masthead"},a.element,u.element,t.element);return document.getElementById("workbench").append(f,l.element,c.tabs.element),c.tabs.choose("wing"),await i(()=>qR(s,n)),Object.assign(s,{wing:c.wing,idle:()=>e})}async function qR(n,t){let e=U_();e&&!await n.open({design:e.design,files:e.files,unit:e.unit},e.settings)||await n.open({design:"",files:[],unit:""},t.settings)}function YR(n,t,e){let i=()=>n.asked,s=Object.fromEntries(Object.entries(XR).map(([c,u])=>[c,z_(c,u,i)])),r=q_(t.put,()=>{l.choose("run"),s.run.find()}),o=H_(i),a=O_(c=>e({design:"",files:[{name:`${n.reply?.name??"design"}.toml`,text:c}],unit:""})),l=$_([{name:"wing",title:"Structure",element:r.element},{name:"sheet",title:"Pattern",...o},{name:"landscape",title:"Landscape",...s.landscape},{name:"run",title:"Run",...s.run},{name:"file",title:"File",element:a.element}],"views of the design");return{tabs:l,wing:r,file:a}}var ZR={run:R_,compare:Mx,curves:wx,study:n_,goals:i_,parts:A_,bench:Yg,workbench:Y_},Of=JSON.parse(document.getElementById("data").textContent);np(Of.reading_units);function Z_(n){let t=`Moving pictures cannot be shown in this browser (${n.message}); all numbers are below.`;throw document.querySelector("main").prepend(S("p",{className:"note",role:"alert"},t)),n}function K_(n){window.forficula=n}try{let n=ZR[Of.kind](Of);n instanceof Promise?n.then(K_,Z_):K_(n)}catch(n){Z_(n)}Mo();})();
