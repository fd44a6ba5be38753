/* forficula, MIT; with three.js and uPlot, MIT: see LICENSES.txt; sources 994df09a8c51d24d3e60a0003ce59f61c3d769fd6347e8628653fff0dbd362f7 */
(()=>{function R(n,t={},...e){let i=document.createElement(n);for(let[s,r]of Object.entries(t))s.includes("-")||s==="role"?i.setAttribute(s,r):i[s]=r;return i.append(...e),i}function tl(n){let t="http://www.w3.org/2000/svg",e=document.createElementNS(t,"svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidden","true");let i=document.createElementNS(t,"path");return i.setAttribute("d",n),e.append(i),e}function ir({colour:n,dash:t}){let e="http://www.w3.org/2000/svg",i=document.createElementNS(e,"svg");i.setAttribute("viewBox","0 0 24 8"),i.setAttribute("aria-hidden","true"),i.classList.add("sample");let s=document.createElementNS(e,"path");return s.setAttribute("d","M0 4H24"),s.setAttribute("stroke",n),s.setAttribute("stroke-dasharray",t.join(" ")),i.append(s),i}var Ws={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Xs={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},bp=0,Eh=1,Sp=2;var ba=1,Mp=2,ao=3,$s=0,Yn=1,Bn=2,ur=0,lo=1,Th=2,Ch=3,Rh=4,wp=5;var hr=100,Ap=101,Ep=102,Tp=103,Cp=104,Rp=200,Pp=201,Ip=202,Lp=203,Ph=204,Ih=205,Np=206,Dp=207,Up=208,Op=209,Fp=210,kp=211,Bp=212,zp=213,Vp=214,El=0,Tl=1,Cl=2,Jr=3,Rl=4,Pl=5,Il=6,Ll=7,sc=0,Gp=1,Hp=2,Yi=0,Lh=1,Nh=2,Dh=3,Uh=4,Oh=5,Fh=6,kh=7;var Bh=300,dr=301,co=302,rc=303,oc=304,Nl=1e3,Wi=1001,Dl=1002,Pn=1003,Wp=1004;var Sa=1005;var qn=1006,ac=1007;var xs=1008;var Kn=1009,zh=1010,Vh=1011,uo=1012,lc=1013,Ri=1014,_i=1015,Pi=1016,cc=1017,uc=1018,fr=1020,Gh=35902,Hh=35899,Wh=1021,Xh=1022,Ii=1023,hs=1026,_s=1027,hc=1028,dc=1029,qs=1030,fc=1031;var pc=1033,Ma=33776,wa=33777,Aa=33778,Ea=33779,mc=35840,gc=35841,xc=35842,_c=35843,yc=36196,vc=37492,bc=37496,Sc=37488,Mc=37489,Ta=37490,wc=37491,Ac=37808,Ec=37809,Tc=37810,Cc=37811,Rc=37812,Pc=37813,Ic=37814,Lc=37815,Nc=37816,Dc=37817,Uc=37818,Oc=37819,Fc=37820,kc=37821,Bc=36492,zc=36494,Vc=36495,Gc=36283,Hc=36284,Ca=36285,Wc=36286;var jo=2300,Ul=2301,wl=2302,_h=2303,yh=2400,vh=2401,bh=2402;var Xp=3200;var Xc=0,$p=1,ys="",ri="srgb",Qo="srgb-linear",ta="linear",Ae="srgb";var Al=7680,$h=7681;var qh=517;var qp=519,Yp=512,Zp=513,Jp=514,Yh=515,Kp=516,jp=517,Zh=518,Jh=519,Qp=35044,Ra=35048;var Kh="300 es",xi=2e3,Kr=2001;function T_(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function C_(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function ea(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function tm(){let n=ea("canvas");return n.style.display="block",n}var Hf={},jr=null;function jh(...n){let t="THREE."+n.shift();jr?jr("log",t,...n):console.log(t,...n)}function em(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function $t(...n){n=em(n);let t="THREE."+n.shift();if(jr)jr("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function jt(...n){n=em(n);let t="THREE."+n.shift();if(jr)jr("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function Zo(...n){let t=n.join(" ");t in Hf||(Hf[t]=!0,$t(...n))}function nm(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var im={[El]:El,[Cl]:Il,[Rl]:Rl,[Jr]:Pl,[Tl]:Tl,[Il]:Cl,[Ll]:Ll,[Pl]:Jr},Ci=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},On=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Wf=1234567,Jo=Math.PI/180,Qr=180/Math.PI;function ho(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(On[n&255]+On[n>>8&255]+On[n>>16&255]+On[n>>24&255]+"-"+On[t&255]+On[t>>8&255]+"-"+On[t>>16&15|64]+On[t>>24&255]+"-"+On[e&63|128]+On[e>>8&255]+"-"+On[e>>16&255]+On[e>>24&255]+On[i&255]+On[i>>8&255]+On[i>>16&255]+On[i>>24&255]).toLowerCase()}function fe(n,t,e){return Math.max(t,Math.min(e,n))}function Qh(n,t){return(n%t+t)%t}function R_(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function P_(n,t,e){return n!==t?(e-n)/(t-n):0}function Ko(n,t,e){return(1-e)*n+e*t}function I_(n,t,e,i){return Ko(n,t,1-Math.exp(-e*i))}function L_(n,t=1){return t-Math.abs(Qh(n,t*2)-t)}function N_(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function D_(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function U_(n,t){return n+Math.floor(Math.random()*(t-n+1))}function O_(n,t){return n+Math.random()*(t-n)}function F_(n){return n*(.5-Math.random())}function k_(n){n!==void 0&&(Wf=n);let t=Wf+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function B_(n){return n*Jo}function z_(n){return n*Qr}function V_(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function G_(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function td(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function H_(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),u=o((t+i)/2),h=r((t-i)/2),d=o((t-i)/2),f=r((i-t)/2),p=o((i-t)/2);switch(s){case"XYX":n.set(a*u,l*h,l*d,a*c);break;case"YZY":n.set(l*d,a*u,l*h,a*c);break;case"ZXZ":n.set(l*h,l*d,a*u,a*c);break;case"XZX":n.set(a*u,l*p,l*f,a*c);break;case"YXY":n.set(l*f,a*u,l*p,a*c);break;case"ZYZ":n.set(l*p,l*f,a*u,a*c);break;default:$t("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function ed(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function sm(n,t){if(t.constructor===Float32Array)return n;let e=ed(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function rm(n,t){if(t.constructor===Float32Array)return n;let e=ed(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var nd={DEG2RAD:Jo,RAD2DEG:Qr,generateUUID:ho,clamp:fe,euclideanModulo:Qh,mapLinear:R_,inverseLerp:P_,lerp:Ko,damp:I_,pingpong:L_,smoothstep:N_,smootherstep:D_,randInt:U_,randFloat:O_,randFloatSpread:F_,seededRandom:k_,degToRad:B_,radToDeg:z_,isPowerOfTwo:V_,ceilPowerOfTwo:G_,floorPowerOfTwo:td,setQuaternionFromProperEuler:H_,normalize:rm,denormalize:sm},Yt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=fe(this.x,t.x,e.x),this.y=fe(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=fe(this.x,t,e),this.y=fe(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(fe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(fe(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},ai=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],d=r[o+0],f=r[o+1],p=r[o+2],_=r[o+3];if(h!==_||l!==d||c!==f||u!==p){let g=l*d+c*f+u*p+h*_;g<0&&(d=-d,f=-f,p=-p,_=-_,g=-g);let m=1-a;if(g<.9995){let x=Math.acos(g),w=Math.sin(x);m=Math.sin(m*x)/w,a=Math.sin(a*x)/w,l=l*m+d*a,c=c*m+f*a,u=u*m+p*a,h=h*m+_*a}else{l=l*m+d*a,c=c*m+f*a,u=u*m+p*a,h=h*m+_*a;let x=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=x,c*=x,u*=x,h*=x}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return t[e]=a*p+u*h+l*f-c*d,t[e+1]=l*p+u*d+c*h-a*f,t[e+2]=c*p+u*f+a*d-l*h,t[e+3]=u*p-a*h-l*d-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),d=l(i/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=d*u*h+c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h-d*f*p;break;case"YXZ":this._x=d*u*h+c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h+d*f*p;break;case"ZXY":this._x=d*u*h-c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h-d*f*p;break;case"ZYX":this._x=d*u*h-c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h+d*f*p;break;case"YZX":this._x=d*u*h+c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h-d*f*p;break;case"XZY":this._x=d*u*h-c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h+d*f*p;break;default:$t("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],h=e[10],d=i+a+h;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>h){let f=2*Math.sqrt(1+i-a-h);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>h){let f=2*Math.sqrt(1+a-i-h);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+h-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(fe(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,e=Math.sin(e*c)/u,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},W=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Xf.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Xf.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),u=2*(a*e-r*s),h=2*(r*i-o*e);return this.x=e+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=fe(this.x,t.x,e.x),this.y=fe(this.y,t.y,e.y),this.z=fe(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=fe(this.x,t,e),this.y=fe(this.y,t,e),this.z=fe(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(fe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return Ku.copy(this).projectOnVector(t),this.sub(Ku)}reflect(t){return this.sub(Ku.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(fe(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Ku=new W,Xf=new ai,ee=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],d=i[2],f=i[5],p=i[8],_=s[0],g=s[3],m=s[6],x=s[1],w=s[4],b=s[7],S=s[2],M=s[5],y=s[8];return r[0]=o*_+a*x+l*S,r[3]=o*g+a*w+l*M,r[6]=o*m+a*b+l*y,r[1]=c*_+u*x+h*S,r[4]=c*g+u*w+h*M,r[7]=c*m+u*b+h*y,r[2]=d*_+f*x+p*S,r[5]=d*g+f*w+p*M,r[8]=d*m+f*b+p*y,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=u*o-a*c,d=a*l-u*r,f=c*r-o*l,p=e*h+i*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/p;return t[0]=h*_,t[1]=(s*c-u*i)*_,t[2]=(a*i-s*o)*_,t[3]=d*_,t[4]=(u*e-s*l)*_,t[5]=(s*r-a*e)*_,t[6]=f*_,t[7]=(i*l-c*e)*_,t[8]=(o*e-i*r)*_,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return Zo("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(ju.makeScale(t,e)),this}rotate(t){return Zo("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(ju.makeRotation(-t)),this}translate(t,e){return Zo("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(ju.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},ju=new ee,$f=new ee().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),qf=new ee().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function W_(){let n={enabled:!0,workingColorSpace:Qo,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ae&&(s.r=us(s.r),s.g=us(s.g),s.b=us(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ae&&(s.r=Zr(s.r),s.g=Zr(s.g),s.b=Zr(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===ys?ta:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Qo]:{primaries:t,whitePoint:i,transfer:ta,toXYZ:$f,fromXYZ:qf,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:ri},outputColorSpaceConfig:{drawingBufferColorSpace:ri}},[ri]:{primaries:t,whitePoint:i,transfer:Ae,toXYZ:$f,fromXYZ:qf,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:ri}}}),n}var xe=W_();function us(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Zr(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Ur,Ol=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{Ur===void 0&&(Ur=ea("canvas")),Ur.width=t.width,Ur.height=t.height;let s=Ur.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=Ur}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=ea("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=us(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(us(e[i]/255)*255):e[i]=us(e[i]);return{data:e,width:t.width,height:t.height}}else return $t("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},X_=0,to=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:X_++}),this.uuid=ho(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Qu(s[o].image)):r.push(Qu(s[o]))}else r=Qu(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function Qu(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Ol.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:($t("Texture: Unable to serialize Texture."),{})}var $_=0,th=new W,Jn=class n extends Ci{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=Wi,s=Wi,r=qn,o=xs,a=Ii,l=Kn,c=n.DEFAULT_ANISOTROPY,u=ys){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:$_++}),this.uuid=ho(),this.name="",this.source=new to(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Yt(0,0),this.repeat=new Yt(1,1),this.center=new Yt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ee,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(th).x}get height(){return this.source.getSize(th).y}get depth(){return this.source.getSize(th).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){$t(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){$t(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Bh)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Nl:t.x=t.x-Math.floor(t.x);break;case Wi:t.x=t.x<0?0:1;break;case Dl:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Nl:t.y=t.y-Math.floor(t.y);break;case Wi:t.y=t.y<0?0:1;break;case Dl:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Jn.DEFAULT_IMAGE=null;Jn.DEFAULT_MAPPING=Bh;Jn.DEFAULT_ANISOTROPY=1;var qe=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],u=l[4],h=l[8],d=l[1],f=l[5],p=l[9],_=l[2],g=l[6],m=l[10];if(Math.abs(u-d)<.01&&Math.abs(h-_)<.01&&Math.abs(p-g)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+_)<.1&&Math.abs(p+g)<.1&&Math.abs(c+f+m-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let w=(c+1)/2,b=(f+1)/2,S=(m+1)/2,M=(u+d)/4,y=(h+_)/4,A=(p+g)/4;return w>b&&w>S?w<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(w),s=M/i,r=y/i):b>S?b<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),i=M/s,r=A/s):S<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(S),i=y/r,s=A/r),this.set(i,s,r,e),this}let x=Math.sqrt((g-p)*(g-p)+(h-_)*(h-_)+(d-u)*(d-u));return Math.abs(x)<.001&&(x=1),this.x=(g-p)/x,this.y=(h-_)/x,this.z=(d-u)/x,this.w=Math.acos((c+f+m-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=fe(this.x,t.x,e.x),this.y=fe(this.y,t.y,e.y),this.z=fe(this.z,t.z,e.z),this.w=fe(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=fe(this.x,t,e),this.y=fe(this.y,t,e),this.z=fe(this.z,t,e),this.w=fe(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(fe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Fl=class extends Ci{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:qn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new qe(0,0,t,e),this.scissorTest=!1,this.viewport=new qe(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Jn({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:qn,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new to(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},li=class extends Fl{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},na=class extends Jn{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Pn,this.minFilter=Pn,this.wrapR=Wi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var kl=class extends Jn{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Pn,this.minFilter=Pn,this.wrapR=Wi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var pe=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,l,c,u,h,d,f,p,_,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,u,h,d,f,p,_,g)}set(t,e,i,s,r,o,a,l,c,u,h,d,f,p,_,g){let m=this.elements;return m[0]=t,m[4]=e,m[8]=i,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=u,m[10]=h,m[14]=d,m[3]=f,m[7]=p,m[11]=_,m[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/Or.setFromMatrixColumn(t,0).length(),r=1/Or.setFromMatrixColumn(t,1).length(),o=1/Or.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(t.order==="XYZ"){let d=o*u,f=o*h,p=a*u,_=a*h;e[0]=l*u,e[4]=-l*h,e[8]=c,e[1]=f+p*c,e[5]=d-_*c,e[9]=-a*l,e[2]=_-d*c,e[6]=p+f*c,e[10]=o*l}else if(t.order==="YXZ"){let d=l*u,f=l*h,p=c*u,_=c*h;e[0]=d+_*a,e[4]=p*a-f,e[8]=o*c,e[1]=o*h,e[5]=o*u,e[9]=-a,e[2]=f*a-p,e[6]=_+d*a,e[10]=o*l}else if(t.order==="ZXY"){let d=l*u,f=l*h,p=c*u,_=c*h;e[0]=d-_*a,e[4]=-o*h,e[8]=p+f*a,e[1]=f+p*a,e[5]=o*u,e[9]=_-d*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let d=o*u,f=o*h,p=a*u,_=a*h;e[0]=l*u,e[4]=p*c-f,e[8]=d*c+_,e[1]=l*h,e[5]=_*c+d,e[9]=f*c-p,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let d=o*l,f=o*c,p=a*l,_=a*c;e[0]=l*u,e[4]=_-d*h,e[8]=p*h+f,e[1]=h,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=f*h+p,e[10]=d-_*h}else if(t.order==="XZY"){let d=o*l,f=o*c,p=a*l,_=a*c;e[0]=l*u,e[4]=-h,e[8]=c*u,e[1]=d*h+_,e[5]=o*u,e[9]=f*h-p,e[2]=p*h-f,e[6]=a*u,e[10]=_*h+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(q_,t,Y_)}lookAt(t,e,i){let s=this.elements;return ii.subVectors(t,e),ii.lengthSq()===0&&(ii.z=1),ii.normalize(),Ls.crossVectors(i,ii),Ls.lengthSq()===0&&(Math.abs(i.z)===1?ii.x+=1e-4:ii.z+=1e-4,ii.normalize(),Ls.crossVectors(i,ii)),Ls.normalize(),el.crossVectors(ii,Ls),s[0]=Ls.x,s[4]=el.x,s[8]=ii.x,s[1]=Ls.y,s[5]=el.y,s[9]=ii.y,s[2]=Ls.z,s[6]=el.z,s[10]=ii.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],d=i[9],f=i[13],p=i[2],_=i[6],g=i[10],m=i[14],x=i[3],w=i[7],b=i[11],S=i[15],M=s[0],y=s[4],A=s[8],I=s[12],L=s[1],P=s[5],F=s[9],z=s[13],U=s[2],G=s[6],$=s[10],H=s[14],lt=s[3],J=s[7],Q=s[11],it=s[15];return r[0]=o*M+a*L+l*U+c*lt,r[4]=o*y+a*P+l*G+c*J,r[8]=o*A+a*F+l*$+c*Q,r[12]=o*I+a*z+l*H+c*it,r[1]=u*M+h*L+d*U+f*lt,r[5]=u*y+h*P+d*G+f*J,r[9]=u*A+h*F+d*$+f*Q,r[13]=u*I+h*z+d*H+f*it,r[2]=p*M+_*L+g*U+m*lt,r[6]=p*y+_*P+g*G+m*J,r[10]=p*A+_*F+g*$+m*Q,r[14]=p*I+_*z+g*H+m*it,r[3]=x*M+w*L+b*U+S*lt,r[7]=x*y+w*P+b*G+S*J,r[11]=x*A+w*F+b*$+S*Q,r[15]=x*I+w*z+b*H+S*it,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],h=t[6],d=t[10],f=t[14],p=t[3],_=t[7],g=t[11],m=t[15],x=l*f-c*d,w=a*f-c*h,b=a*d-l*h,S=o*f-c*u,M=o*d-l*u,y=o*h-a*u;return e*(_*x-g*w+m*b)-i*(p*x-g*S+m*M)+s*(p*w-_*S+m*y)-r*(p*b-_*M+g*y)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],u=t[10];return e*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=t[9],d=t[10],f=t[11],p=t[12],_=t[13],g=t[14],m=t[15],x=e*a-i*o,w=e*l-s*o,b=e*c-r*o,S=i*l-s*a,M=i*c-r*a,y=s*c-r*l,A=u*_-h*p,I=u*g-d*p,L=u*m-f*p,P=h*g-d*_,F=h*m-f*_,z=d*m-f*g,U=x*z-w*F+b*P+S*L-M*I+y*A;if(U===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let G=1/U;return t[0]=(a*z-l*F+c*P)*G,t[1]=(s*F-i*z-r*P)*G,t[2]=(_*y-g*M+m*S)*G,t[3]=(d*M-h*y-f*S)*G,t[4]=(l*L-o*z-c*I)*G,t[5]=(e*z-s*L+r*I)*G,t[6]=(g*b-p*y-m*w)*G,t[7]=(u*y-d*b+f*w)*G,t[8]=(o*F-a*L+c*A)*G,t[9]=(i*L-e*F-r*A)*G,t[10]=(p*M-_*b+m*x)*G,t[11]=(h*b-u*M-f*x)*G,t[12]=(a*I-o*P-l*A)*G,t[13]=(e*P-i*I+s*A)*G,t[14]=(_*w-p*S-g*x)*G,t[15]=(u*S-h*w+d*x)*G,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,u=o+o,h=a+a,d=r*c,f=r*u,p=r*h,_=o*u,g=o*h,m=a*h,x=l*c,w=l*u,b=l*h,S=i.x,M=i.y,y=i.z;return s[0]=(1-(_+m))*S,s[1]=(f+b)*S,s[2]=(p-w)*S,s[3]=0,s[4]=(f-b)*M,s[5]=(1-(d+m))*M,s[6]=(g+x)*M,s[7]=0,s[8]=(p+w)*y,s[9]=(g-x)*y,s[10]=(1-(d+_))*y,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=Or.set(s[0],s[1],s[2]).length(),a=Or.set(s[4],s[5],s[6]).length(),l=Or.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Ai.copy(this);let c=1/o,u=1/a,h=1/l;return Ai.elements[0]*=c,Ai.elements[1]*=c,Ai.elements[2]*=c,Ai.elements[4]*=u,Ai.elements[5]*=u,Ai.elements[6]*=u,Ai.elements[8]*=h,Ai.elements[9]*=h,Ai.elements[10]*=h,e.setFromRotationMatrix(Ai),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=xi,l=!1){let c=this.elements,u=2*r/(e-t),h=2*r/(i-s),d=(e+t)/(e-t),f=(i+s)/(i-s),p,_;if(l)p=r/(o-r),_=o*r/(o-r);else if(a===xi)p=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===Kr)p=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=h,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=_,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=xi,l=!1){let c=this.elements,u=2/(e-t),h=2/(i-s),d=-(e+t)/(e-t),f=-(i+s)/(i-s),p,_;if(l)p=1/(o-r),_=o/(o-r);else if(a===xi)p=-2/(o-r),_=-(o+r)/(o-r);else if(a===Kr)p=-1/(o-r),_=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=h,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=_,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},Or=new W,Ai=new pe,q_=new W(0,0,0),Y_=new W(1,1,1),Ls=new W,el=new W,ii=new W,Yf=new pe,Zf=new ai,ds=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(fe(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-fe(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(fe(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-fe(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(fe(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-fe(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:$t("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return Yf.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Yf,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Zf.setFromEuler(this),this.setFromQuaternion(Zf,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};ds.DEFAULT_ORDER="XYZ";var eo=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},Z_=0,Jf=new W,Fr=new ai,rs=new pe,nl=new W,Go=new W,J_=new W,K_=new ai,Kf=new W(1,0,0),jf=new W(0,1,0),Qf=new W(0,0,1),tp={type:"added"},j_={type:"removed"},kr={type:"childadded",child:null},eh={type:"childremoved",child:null},Ln=class n extends Ci{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Z_++}),this.uuid=ho(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new W,e=new ds,i=new ai,s=new W(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new pe},normalMatrix:{value:new ee}}),this.matrix=new pe,this.matrixWorld=new pe,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new eo,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Fr.setFromAxisAngle(t,e),this.quaternion.multiply(Fr),this}rotateOnWorldAxis(t,e){return Fr.setFromAxisAngle(t,e),this.quaternion.premultiply(Fr),this}rotateX(t){return this.rotateOnAxis(Kf,t)}rotateY(t){return this.rotateOnAxis(jf,t)}rotateZ(t){return this.rotateOnAxis(Qf,t)}translateOnAxis(t,e){return Jf.copy(t).applyQuaternion(this.quaternion),this.position.add(Jf.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Kf,t)}translateY(t){return this.translateOnAxis(jf,t)}translateZ(t){return this.translateOnAxis(Qf,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(rs.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?nl.copy(t):nl.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Go.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?rs.lookAt(Go,nl,this.up):rs.lookAt(nl,Go,this.up),this.quaternion.setFromRotationMatrix(rs),s&&(rs.extractRotation(s.matrixWorld),Fr.setFromRotationMatrix(rs),this.quaternion.premultiply(Fr.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(jt("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(tp),kr.child=t,this.dispatchEvent(kr),kr.child=null):jt("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(j_),eh.child=t,this.dispatchEvent(eh),eh.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),rs.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),rs.multiply(t.parent.matrixWorld)),t.applyMatrix4(rs),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(tp),kr.child=t,this.dispatchEvent(kr),kr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Go,t,J_),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Go,K_,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(t.shapes,h)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),h=o(t.shapes),d=o(t.skeletons),f=o(t.animations),p=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Ln.DEFAULT_UP=new W(0,1,0);Ln.DEFAULT_MATRIX_AUTO_UPDATE=!0;Ln.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var kn=class extends Ln{constructor(){super(),this.isGroup=!0,this.type="Group"}},Q_={type:"move"},no=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new kn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new kn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new W,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new W),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new kn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new W,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new W,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let _ of t.hand.values()){let g=e.getJointPose(_,i),m=this._getHandJoint(c,_);g!==null&&(m.matrix.fromArray(g.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=g.radius),m.visible=g!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,p=.005;c.inputState.pinching&&d>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&d<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Q_)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new kn;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},om={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ns={h:0,s:0,l:0},il={h:0,s:0,l:0};function nh(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var Qt=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=ri){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,xe.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=xe.workingColorSpace){return this.r=t,this.g=e,this.b=i,xe.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=xe.workingColorSpace){if(t=Qh(t,1),e=fe(e,0,1),i=fe(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=nh(o,r,t+1/3),this.g=nh(o,r,t),this.b=nh(o,r,t-1/3)}return xe.colorSpaceToWorking(this,s),this}setStyle(t,e=ri){function i(r){r!==void 0&&parseFloat(r)<1&&$t("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:$t("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);$t("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=ri){let i=om[t.toLowerCase()];return i!==void 0?this.setHex(i,e):$t("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=us(t.r),this.g=us(t.g),this.b=us(t.b),this}copyLinearToSRGB(t){return this.r=Zr(t.r),this.g=Zr(t.g),this.b=Zr(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=ri){return xe.workingToColorSpace(Fn.copy(this),t),Math.round(fe(Fn.r*255,0,255))*65536+Math.round(fe(Fn.g*255,0,255))*256+Math.round(fe(Fn.b*255,0,255))}getHexString(t=ri){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=xe.workingColorSpace){xe.workingToColorSpace(Fn.copy(this),e);let i=Fn.r,s=Fn.g,r=Fn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=xe.workingColorSpace){return xe.workingToColorSpace(Fn.copy(this),e),t.r=Fn.r,t.g=Fn.g,t.b=Fn.b,t}getStyle(t=ri){xe.workingToColorSpace(Fn.copy(this),t);let e=Fn.r,i=Fn.g,s=Fn.b;return t!==ri?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(Ns),this.setHSL(Ns.h+t,Ns.s+e,Ns.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(Ns),t.getHSL(il);let i=Ko(Ns.h,il.h,e),s=Ko(Ns.s,il.s,e),r=Ko(Ns.l,il.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Fn=new Qt;Qt.NAMES=om;var ia=class extends Ln{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ds,this.environmentIntensity=1,this.environmentRotation=new ds,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Ei=new W,os=new W,ih=new W,as=new W,Br=new W,zr=new W,ep=new W,sh=new W,rh=new W,oh=new W,ah=new qe,lh=new qe,ch=new qe,Fs=class n{constructor(t=new W,e=new W,i=new W){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),Ei.subVectors(t,e),s.cross(Ei);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){Ei.subVectors(s,e),os.subVectors(i,e),ih.subVectors(t,e);let o=Ei.dot(Ei),a=Ei.dot(os),l=Ei.dot(ih),c=os.dot(os),u=os.dot(ih),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let d=1/h,f=(c*l-a*u)*d,p=(o*u-a*l)*d;return r.set(1-f-p,p,f)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,as)===null?!1:as.x>=0&&as.y>=0&&as.x+as.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,as)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,as.x),l.addScaledVector(o,as.y),l.addScaledVector(a,as.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return ah.setScalar(0),lh.setScalar(0),ch.setScalar(0),ah.fromBufferAttribute(t,e),lh.fromBufferAttribute(t,i),ch.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(ah,r.x),o.addScaledVector(lh,r.y),o.addScaledVector(ch,r.z),o}static isFrontFacing(t,e,i,s){return Ei.subVectors(i,e),os.subVectors(t,e),Ei.cross(os).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Ei.subVectors(this.c,this.b),os.subVectors(this.a,this.b),Ei.cross(os).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;Br.subVectors(s,i),zr.subVectors(r,i),sh.subVectors(t,i);let l=Br.dot(sh),c=zr.dot(sh);if(l<=0&&c<=0)return e.copy(i);rh.subVectors(t,s);let u=Br.dot(rh),h=zr.dot(rh);if(u>=0&&h<=u)return e.copy(s);let d=l*h-u*c;if(d<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),e.copy(i).addScaledVector(Br,o);oh.subVectors(t,r);let f=Br.dot(oh),p=zr.dot(oh);if(p>=0&&f<=p)return e.copy(r);let _=f*c-l*p;if(_<=0&&c>=0&&p<=0)return a=c/(c-p),e.copy(i).addScaledVector(zr,a);let g=u*p-f*h;if(g<=0&&h-u>=0&&f-p>=0)return ep.subVectors(r,s),a=(h-u)/(h-u+(f-p)),e.copy(s).addScaledVector(ep,a);let m=1/(g+_+d);return o=_*m,a=d*m,e.copy(i).addScaledVector(Br,o).addScaledVector(zr,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Xi=class{constructor(t=new W(1/0,1/0,1/0),e=new W(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Ti.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Ti.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Ti.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Ti):Ti.fromBufferAttribute(r,o),Ti.applyMatrix4(t.matrixWorld),this.expandByPoint(Ti);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),sl.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),sl.copy(i.boundingBox)),sl.applyMatrix4(t.matrixWorld),this.union(sl)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Ti),Ti.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Ho),rl.subVectors(this.max,Ho),Vr.subVectors(t.a,Ho),Gr.subVectors(t.b,Ho),Hr.subVectors(t.c,Ho),Ds.subVectors(Gr,Vr),Us.subVectors(Hr,Gr),sr.subVectors(Vr,Hr);let e=[0,-Ds.z,Ds.y,0,-Us.z,Us.y,0,-sr.z,sr.y,Ds.z,0,-Ds.x,Us.z,0,-Us.x,sr.z,0,-sr.x,-Ds.y,Ds.x,0,-Us.y,Us.x,0,-sr.y,sr.x,0];return!uh(e,Vr,Gr,Hr,rl)||(e=[1,0,0,0,1,0,0,0,1],!uh(e,Vr,Gr,Hr,rl))?!1:(ol.crossVectors(Ds,Us),e=[ol.x,ol.y,ol.z],uh(e,Vr,Gr,Hr,rl))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Ti).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Ti).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(ls[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),ls[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),ls[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),ls[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),ls[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),ls[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),ls[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),ls[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(ls),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},ls=[new W,new W,new W,new W,new W,new W,new W,new W],Ti=new W,sl=new Xi,Vr=new W,Gr=new W,Hr=new W,Ds=new W,Us=new W,sr=new W,Ho=new W,rl=new W,ol=new W,rr=new W;function uh(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){rr.fromArray(n,r);let a=s.x*Math.abs(rr.x)+s.y*Math.abs(rr.y)+s.z*Math.abs(rr.z),l=t.dot(rr),c=e.dot(rr),u=i.dot(rr);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var fn=new W,al=new Yt,ty=0,rn=class extends Ci{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:ty++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=Qp,this.updateRanges=[],this.gpuType=_i,this.version=0,this._normalizationScale=t!==void 0?ed(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)al.fromBufferAttribute(this,e),al.applyMatrix3(t),this.setXY(e,al.x,al.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)fn.fromBufferAttribute(this,e),fn.applyMatrix3(t),this.setXYZ(e,fn.x,fn.y,fn.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)fn.fromBufferAttribute(this,e),fn.applyMatrix4(t),this.setXYZ(e,fn.x,fn.y,fn.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)fn.fromBufferAttribute(this,e),fn.applyNormalMatrix(t),this.setXYZ(e,fn.x,fn.y,fn.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)fn.fromBufferAttribute(this,e),fn.transformDirection(t),this.setXYZ(e,fn.x,fn.y,fn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):sm(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):rm(t,this.array)}};var sa=class extends rn{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var ra=class extends rn{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var tn=class extends rn{constructor(t,e,i){super(new Float32Array(t),e,i)}},ey=new Xi,Wo=new W,hh=new W,fs=class{constructor(t=new W,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):ey.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Wo.subVectors(t,this.center);let e=Wo.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(Wo,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(hh.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Wo.copy(t.center).add(hh)),this.expandByPoint(Wo.copy(t.center).sub(hh))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},ny=0,gi=new pe,dh=new Ln,Wr=new W,si=new Xi,Xo=new Xi,Rn=new W,xn=class n extends Ci{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:ny++}),this.uuid=ho(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(T_(t)?ra:sa)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new ee().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return gi.makeRotationFromQuaternion(t),this.applyMatrix4(gi),this}rotateX(t){return gi.makeRotationX(t),this.applyMatrix4(gi),this}rotateY(t){return gi.makeRotationY(t),this.applyMatrix4(gi),this}rotateZ(t){return gi.makeRotationZ(t),this.applyMatrix4(gi),this}translate(t,e,i){return gi.makeTranslation(t,e,i),this.applyMatrix4(gi),this}scale(t,e,i){return gi.makeScale(t,e,i),this.applyMatrix4(gi),this}lookAt(t){return dh.lookAt(t),dh.updateMatrix(),this.applyMatrix4(dh.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Wr).negate(),this.translate(Wr.x,Wr.y,Wr.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new tn(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&$t("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Xi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){jt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new W(-1/0,-1/0,-1/0),new W(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];si.setFromBufferAttribute(r),this.morphTargetsRelative?(Rn.addVectors(this.boundingBox.min,si.min),this.boundingBox.expandByPoint(Rn),Rn.addVectors(this.boundingBox.max,si.max),this.boundingBox.expandByPoint(Rn)):(this.boundingBox.expandByPoint(si.min),this.boundingBox.expandByPoint(si.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&jt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new fs);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){jt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new W,1/0);return}if(t){let i=this.boundingSphere.center;if(si.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Xo.setFromBufferAttribute(a),this.morphTargetsRelative?(Rn.addVectors(si.min,Xo.min),si.expandByPoint(Rn),Rn.addVectors(si.max,Xo.max),si.expandByPoint(Rn)):(si.expandByPoint(Xo.min),si.expandByPoint(Xo.max))}si.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Rn.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Rn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Rn.fromBufferAttribute(a,c),l&&(Wr.fromBufferAttribute(t,c),Rn.add(Wr)),s=Math.max(s,i.distanceToSquared(Rn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&jt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){jt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new rn(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let I=0;I<i.count;I++)a[I]=new W,l[I]=new W;let u=new W,h=new W,d=new W,f=new Yt,p=new Yt,_=new Yt,g=new W,m=new W;function x(I,L,P){c[I]=c[L]=c[P]=1,u.fromBufferAttribute(i,I),h.fromBufferAttribute(i,L),d.fromBufferAttribute(i,P),f.fromBufferAttribute(r,I),p.fromBufferAttribute(r,L),_.fromBufferAttribute(r,P),h.sub(u),d.sub(u),p.sub(f),_.sub(f);let F=1/(p.x*_.y-_.x*p.y);isFinite(F)&&(g.copy(h).multiplyScalar(_.y).addScaledVector(d,-p.y).multiplyScalar(F),m.copy(d).multiplyScalar(p.x).addScaledVector(h,-_.x).multiplyScalar(F),a[I].add(g),a[L].add(g),a[P].add(g),l[I].add(m),l[L].add(m),l[P].add(m))}let w=this.groups;w.length===0&&(w=[{start:0,count:t.count}]);for(let I=0,L=w.length;I<L;++I){let P=w[I],F=P.start,z=P.count;for(let U=F,G=F+z;U<G;U+=3)x(t.getX(U+0),t.getX(U+1),t.getX(U+2))}let b=new W,S=new W,M=new W,y=new W;function A(I){M.fromBufferAttribute(s,I),y.copy(M);let L=a[I];b.copy(L),b.sub(M.multiplyScalar(M.dot(L))).normalize(),S.crossVectors(y,L);let F=S.dot(l[I])<0?-1:1;o.setXYZW(I,b.x,b.y,b.z,F)}for(let I=0,L=i.count;I<L;++I)c[I]&&A(I);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new rn(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let s=new W,r=new W,o=new W,a=new W,l=new W,c=new W,u=new W,h=new W;if(t)for(let d=0,f=t.count;d<f;d+=3){let p=t.getX(d+0),_=t.getX(d+1),g=t.getX(d+2);s.fromBufferAttribute(e,p),r.fromBufferAttribute(e,_),o.fromBufferAttribute(e,g),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,p),l.fromBufferAttribute(i,_),c.fromBufferAttribute(i,g),a.add(u),l.add(u),c.add(u),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(_,l.x,l.y,l.z),i.setXYZ(g,c.x,c.y,c.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(d+0,u.x,u.y,u.z),i.setXYZ(d+1,u.x,u.y,u.z),i.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)Rn.fromBufferAttribute(t,e),Rn.normalize(),t.setXYZ(e,Rn.x,Rn.y,Rn.z)}toNonIndexed(){function t(a,l){let c=a.array,u=a.itemSize,h=a.normalized,d=new c.constructor(l.length*u),f=0,p=0;for(let _=0,g=l.length;_<g;_++){a.isInterleavedBufferAttribute?f=l[_]*a.data.stride+a.offset:f=l[_]*u;for(let m=0;m<u;m++)d[p++]=c[f++]}return new rn(d,u,h)}if(this.index===null)return $t("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let d=c[u],f=t(d,i);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,d=c.length;h<d;h++){let f=c[h];u.push(f.toJSON(t.data))}u.length>0&&(s[l]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(e))}let r=t.morphAttributes;for(let c in r){let u=[],h=r[c];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var fh=new W,iy=new W,sy=new ee,oi=class{constructor(t=new W(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=fh.subVectors(i,e).cross(iy.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(fh),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||sy.getNormalMatrix(t),s=this.coplanarPoint(fh).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},ry=0,ps=class extends Ci{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:ry++}),this.uuid=ho(),this.name="",this.type="Material",this.blending=lo,this.side=$s,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Ph,this.blendDst=Ih,this.blendEquation=hr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Qt(0,0,0),this.blendAlpha=0,this.depthFunc=Jr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=qp,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Al,this.stencilZFail=Al,this.stencilZPass=Al,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){$t(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){$t(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new Qt().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new oi().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Yt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Yt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var cs=new W,ph=new W,ll=new W,cl=new W,ks=class{constructor(t=new W,e=new W(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,cs)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=cs.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(cs.copy(this.origin).addScaledVector(this.direction,e),cs.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){ph.copy(t).add(e).multiplyScalar(.5),ll.copy(e).sub(t).normalize(),cl.copy(this.origin).sub(ph);let r=t.distanceTo(e)*.5,o=-this.direction.dot(ll),a=cl.dot(this.direction),l=-cl.dot(ll),c=cl.lengthSq(),u=Math.abs(1-o*o),h,d,f,p;if(u>0)if(h=o*l-a,d=o*a-l,p=r*u,h>=0)if(d>=-p)if(d<=p){let _=1/u;h*=_,d*=_,f=h*(h+o*d+2*a)+d*(o*h+d+2*l)+c}else d=r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d=-r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d<=-p?(h=Math.max(0,-(-o*r+a)),d=h>0?-r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c):d<=p?(h=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(h=Math.max(0,-(o*r+a)),d=h>0?r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c);else d=o>0?-r:r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(ph).addScaledVector(ll,d),f}intersectSphere(t,e){if(t.radius<0)return null;cs.subVectors(t.center,this.origin);let i=cs.dot(this.direction),s=cs.dot(cs)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return c>=0?(i=(t.min.x-d.x)*c,s=(t.max.x-d.x)*c):(i=(t.max.x-d.x)*c,s=(t.min.x-d.x)*c),u>=0?(r=(t.min.y-d.y)*u,o=(t.max.y-d.y)*u):(r=(t.max.y-d.y)*u,o=(t.min.y-d.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(t.min.z-d.z)*h,l=(t.max.z-d.z)*h):(a=(t.max.z-d.z)*h,l=(t.min.z-d.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,cs)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=t.x-o.x,d=t.y-o.y,f=t.z-o.z,p=e.x-o.x,_=e.y-o.y,g=e.z-o.z,m=i.x-o.x,x=i.y-o.y,w=i.z-o.z,b=Math.abs(l),S=Math.abs(c),M=Math.abs(u),y,A,I,L,P,F,z,U,G,$,H,lt;if(b>=S&&b>=M?(I=l,F=h,G=p,lt=m,l>=0?(y=c,A=u,L=d,P=f,z=_,U=g,$=x,H=w):(y=u,A=c,L=f,P=d,z=g,U=_,$=w,H=x)):S>=M?(I=c,F=d,G=_,lt=x,c>=0?(y=u,A=l,L=f,P=h,z=g,U=p,$=w,H=m):(y=l,A=u,L=h,P=f,z=p,U=g,$=m,H=w)):(I=u,F=f,G=g,lt=w,u>=0?(y=l,A=c,L=h,P=d,z=p,U=_,$=m,H=x):(y=c,A=l,L=d,P=h,z=_,U=p,$=x,H=m)),I===0)return null;let J=y/I,Q=A/I,it=1/I,ft=L-J*F,dt=P-Q*F,tt=z-J*G,ht=U-Q*G,gt=$-J*lt,St=H-Q*lt,Mt=gt*ht-St*tt,Ht=ft*St-dt*gt,se=tt*dt-ht*ft;if(s){if(Mt<0||Ht<0||se<0)return null}else if((Mt<0||Ht<0||se<0)&&(Mt>0||Ht>0||se>0))return null;let Vt=Mt+Ht+se;if(Vt===0)return null;let ue=it*(Mt*F+Ht*G+se*lt);return(Vt>0?ue<0:ue>0)?null:this.at(ue/Vt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},lr=class extends ps{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Qt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ds,this.combine=sc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},np=new pe,or=new ks,ul=new fs,ip=new W,hl=new W,dl=new W,fl=new W,mh=new W,pl=new W,sp=new W,ml=new W,Nn=class extends Ln{constructor(t=new xn,e=new lr){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){pl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(mh.fromBufferAttribute(h,t),o?pl.addScaledVector(mh,u):pl.addScaledVector(mh.sub(e),u))}e.add(pl)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),ul.copy(i.boundingSphere),ul.applyMatrix4(r),or.copy(t.ray).recast(t.near),!(ul.containsPoint(or.origin)===!1&&(or.intersectSphere(ul,ip)===null||or.origin.distanceToSquared(ip)>(t.far-t.near)**2))&&(np.copy(r).invert(),or.copy(t.ray).applyMatrix4(np),!(i.boundingBox!==null&&or.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,or)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,_=d.length;p<_;p++){let g=d[p],m=o[g.materialIndex],x=Math.max(g.start,f.start),w=Math.min(a.count,Math.min(g.start+g.count,f.start+f.count));for(let b=x,S=w;b<S;b+=3){let M=a.getX(b),y=a.getX(b+1),A=a.getX(b+2);s=gl(this,m,t,i,c,u,h,M,y,A),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),_=Math.min(a.count,f.start+f.count);for(let g=p,m=_;g<m;g+=3){let x=a.getX(g),w=a.getX(g+1),b=a.getX(g+2);s=gl(this,o,t,i,c,u,h,x,w,b),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,_=d.length;p<_;p++){let g=d[p],m=o[g.materialIndex],x=Math.max(g.start,f.start),w=Math.min(l.count,Math.min(g.start+g.count,f.start+f.count));for(let b=x,S=w;b<S;b+=3){let M=b,y=b+1,A=b+2;s=gl(this,m,t,i,c,u,h,M,y,A),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),_=Math.min(l.count,f.start+f.count);for(let g=p,m=_;g<m;g+=3){let x=g,w=g+1,b=g+2;s=gl(this,o,t,i,c,u,h,x,w,b),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}}};function oy(n,t,e,i,s,r,o,a){let l;if(t.side===Yn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===$s,a),l===null)return null;ml.copy(a),ml.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(ml);return c<e.near||c>e.far?null:{distance:c,point:ml.clone(),object:n}}function gl(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,hl),n.getVertexPosition(l,dl),n.getVertexPosition(c,fl);let u=oy(n,t,e,i,hl,dl,fl,sp);if(u){let h=new W;Fs.getBarycoord(sp,hl,dl,fl,h),s&&(u.uv=Fs.getInterpolatedAttribute(s,a,l,c,h,new Yt)),r&&(u.uv1=Fs.getInterpolatedAttribute(r,a,l,c,h,new Yt)),o&&(u.normal=Fs.getInterpolatedAttribute(o,a,l,c,h,new W),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new W,materialIndex:0};Fs.getNormal(hl,dl,fl,d.normal),u.face=d,u.barycoord=h}return u}var oa=class extends Jn{constructor(t=null,e=1,i=1,s,r,o,a,l,c=Pn,u=Pn,h,d){super(null,o,a,l,c,u,s,r,h,d),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var aa=class extends rn{constructor(t,e,i,s=1){super(t,e,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},Xr=new pe,rp=new pe,xl=[],op=new Xi,ay=new pe,$o=new Nn,qo=new fs,ci=class extends Nn{constructor(t,e,i){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new aa(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,ay)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new Xi),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Xr),op.copy(t.boundingBox).applyMatrix4(Xr),this.boundingBox.union(op)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new fs),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Xr),qo.copy(t.boundingSphere).applyMatrix4(Xr),this.boundingSphere.union(qo)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let i=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=t*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(t,e){let i=this.matrixWorld,s=this.count;if($o.geometry=this.geometry,$o.material=this.material,$o.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),qo.copy(this.boundingSphere),qo.applyMatrix4(i),t.ray.intersectsSphere(qo)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Xr),rp.multiplyMatrices(i,Xr),$o.matrixWorld=rp,$o.raycast(t,xl);for(let o=0,a=xl.length;o<a;o++){let l=xl[o];l.instanceId=r,l.object=this,e.push(l)}xl.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new aa(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let i=e.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new oa(new Float32Array(s*this.count),s,this.count,hc,_i));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*t;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},ar=new fs,ly=new Yt(.5,.5),_l=new W,Bs=class{constructor(t=new oi,e=new oi,i=new oi,s=new oi,r=new oi,o=new oi){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=xi,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],d=r[6],f=r[7],p=r[8],_=r[9],g=r[10],m=r[11],x=r[12],w=r[13],b=r[14],S=r[15];if(s[0].setComponents(c-o,f-u,m-p,S-x).normalize(),s[1].setComponents(c+o,f+u,m+p,S+x).normalize(),s[2].setComponents(c+a,f+h,m+_,S+w).normalize(),s[3].setComponents(c-a,f-h,m-_,S-w).normalize(),i)s[4].setComponents(l,d,g,b).normalize(),s[5].setComponents(c-l,f-d,m-g,S-b).normalize();else if(s[4].setComponents(c-l,f-d,m-g,S-b).normalize(),e===xi)s[5].setComponents(c+l,f+d,m+g,S+b).normalize();else if(e===Kr)s[5].setComponents(l,d,g,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),ar.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),ar.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(ar)}intersectsSprite(t){ar.center.set(0,0,0);let e=ly.distanceTo(t.center);return ar.radius=.7071067811865476+e,ar.applyMatrix4(t.matrixWorld),this.intersectsSphere(ar)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(_l.x=s.normal.x>0?t.max.x:t.min.x,_l.y=s.normal.y>0?t.max.y:t.min.y,_l.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(_l)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},ap=new pe,Bl=class n{constructor(){this.coordinateSystem=xi,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];ap.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Bs),i[s].setFromProjectionMatrix(ap,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Bs),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var zs=class extends ps{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Qt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},zl=new W,Vl=new W,lp=new pe,Yo=new ks,yl=new fs,gh=new W,cp=new W,Gl=class extends Ln{constructor(t=new xn,e=new zs){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)zl.fromBufferAttribute(e,s-1),Vl.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=zl.distanceTo(Vl);t.setAttribute("lineDistance",new tn(i,1))}else $t("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),yl.copy(i.boundingSphere),yl.applyMatrix4(s),yl.radius+=r,t.ray.intersectsSphere(yl)===!1)return;lp.copy(s).invert(),Yo.copy(t.ray).applyMatrix4(lp);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,d=i.attributes.position;if(u!==null){let f=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let _=f,g=p-1;_<g;_+=c){let m=u.getX(_),x=u.getX(_+1),w=vl(this,t,Yo,l,m,x,_);w&&e.push(w)}if(this.isLineLoop){let _=u.getX(p-1),g=u.getX(f),m=vl(this,t,Yo,l,_,g,p-1);m&&e.push(m)}}else{let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let _=f,g=p-1;_<g;_+=c){let m=vl(this,t,Yo,l,_,_+1,_);m&&e.push(m)}if(this.isLineLoop){let _=vl(this,t,Yo,l,p-1,f,p-1);_&&e.push(_)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function vl(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(zl.fromBufferAttribute(a,s),Vl.fromBufferAttribute(a,r),e.distanceSqToSegment(zl,Vl,gh,cp)>i)return;gh.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(gh);if(!(c<t.near||c>t.far))return{distance:c,point:cp.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var up=new W,hp=new W,cr=class extends Gl{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)up.fromBufferAttribute(e,s),hp.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+up.distanceTo(hp);t.setAttribute("lineDistance",new tn(i,1))}else $t("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var la=class extends Jn{constructor(t=[],e=dr,i,s,r,o,a,l,c,u){super(t,e,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var ms=class extends Jn{constructor(t,e,i=Ri,s,r,o,a=Pn,l=Pn,c,u=hs,h=1){if(u!==hs&&u!==_s)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:h};super(d,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new to(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},ca=class extends ms{constructor(t,e=Ri,i=dr,s,r,o=Pn,a=Pn,l,c=hs){let u={width:t,height:t,depth:1},h=[u,u,u,u,u,u];super(t,t,e,i,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},ua=class extends Jn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},io=class n extends xn{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],d=0,f=0;p("z","y","x",-1,-1,i,e,t,o,r,0),p("z","y","x",1,-1,i,e,-t,o,r,1),p("x","z","y",1,1,t,i,e,s,o,2),p("x","z","y",1,-1,t,i,-e,s,o,3),p("x","y","z",1,-1,t,e,i,s,r,4),p("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new tn(c,3)),this.setAttribute("normal",new tn(u,3)),this.setAttribute("uv",new tn(h,2));function p(_,g,m,x,w,b,S,M,y,A,I){let L=b/y,P=S/A,F=b/2,z=S/2,U=M/2,G=y+1,$=A+1,H=0,lt=0,J=new W;for(let Q=0;Q<$;Q++){let it=Q*P-z;for(let ft=0;ft<G;ft++){let dt=ft*L-F;J[_]=dt*x,J[g]=it*w,J[m]=U,c.push(J.x,J.y,J.z),J[_]=0,J[g]=0,J[m]=M>0?1:-1,u.push(J.x,J.y,J.z),h.push(ft/y),h.push(1-Q/A),H+=1}}for(let Q=0;Q<A;Q++)for(let it=0;it<y;it++){let ft=d+it+G*Q,dt=d+it+G*(Q+1),tt=d+(it+1)+G*(Q+1),ht=d+(it+1)+G*Q;l.push(ft,dt,ht),l.push(dt,tt,ht),lt+=6}a.addGroup(f,lt,I),f+=lt,d+=H}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var $i=class n extends xn{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],d=[],f=[],p=0,_=[],g=i/2,m=0;x(),o===!1&&(t>0&&w(!0),e>0&&w(!1)),this.setIndex(u),this.setAttribute("position",new tn(h,3)),this.setAttribute("normal",new tn(d,3)),this.setAttribute("uv",new tn(f,2));function x(){let b=new W,S=new W,M=0,y=(e-t)/i;for(let A=0;A<=r;A++){let I=[],L=A/r,P=L*(e-t)+t;for(let F=0;F<=s;F++){let z=F/s,U=z*l+a,G=Math.sin(U),$=Math.cos(U);S.x=P*G,S.y=-L*i+g,S.z=P*$,h.push(S.x,S.y,S.z),b.set(G,y,$).normalize(),d.push(b.x,b.y,b.z),f.push(z,1-L),I.push(p++)}_.push(I)}for(let A=0;A<s;A++)for(let I=0;I<r;I++){let L=_[I][A],P=_[I+1][A],F=_[I+1][A+1],z=_[I][A+1];(t>0||I!==0)&&(u.push(L,P,z),M+=3),(e>0||I!==r-1)&&(u.push(P,F,z),M+=3)}c.addGroup(m,M,0),m+=M}function w(b){let S=p,M=new Yt,y=new W,A=0,I=b===!0?t:e,L=b===!0?1:-1;for(let F=1;F<=s;F++)h.push(0,g*L,0),d.push(0,L,0),f.push(.5,.5),p++;let P=p;for(let F=0;F<=s;F++){let U=F/s*l+a,G=Math.cos(U),$=Math.sin(U);y.x=I*$,y.y=g*L,y.z=I*G,h.push(y.x,y.y,y.z),d.push(0,L,0),M.x=G*.5+.5,M.y=$*.5*L+.5,f.push(M.x,M.y),p++}for(let F=0;F<s;F++){let z=S+F,U=P+F;b===!0?u.push(U,U+1,z):u.push(U+1,U,z),A+=3}c.addGroup(m,A,b===!0?1:2),m+=A}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},ha=class n extends $i{constructor(t=1,e=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new n(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var da=class n extends xn{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=t/a,d=e/l,f=[],p=[],_=[],g=[];for(let m=0;m<u;m++){let x=m*d-o;for(let w=0;w<c;w++){let b=w*h-r;p.push(b,-x,0),_.push(0,0,1),g.push(w/a),g.push(1-m/l)}}for(let m=0;m<l;m++)for(let x=0;x<a;x++){let w=x+c*m,b=x+c*(m+1),S=x+1+c*(m+1),M=x+1+c*m;f.push(w,b,M),f.push(b,S,M)}this.setIndex(f),this.setAttribute("position",new tn(p,3)),this.setAttribute("normal",new tn(_,3)),this.setAttribute("uv",new tn(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var so=class n extends xn{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new W,d=new W,f=[],p=[],_=[],g=[];for(let m=0;m<=i;m++){let x=[],w=m/i,b=o+w*a,S=t*Math.cos(b),M=Math.sqrt(t*t-S*S),y=0;m===0&&o===0?y=.5/e:m===i&&l===Math.PI&&(y=-.5/e);for(let A=0;A<=e;A++){let I=A/e,L=s+I*r;h.x=-M*Math.cos(L),h.y=S,h.z=M*Math.sin(L),p.push(h.x,h.y,h.z),d.copy(h).normalize(),_.push(d.x,d.y,d.z),g.push(I+y,1-w),x.push(c++)}u.push(x)}for(let m=0;m<i;m++)for(let x=0;x<e;x++){let w=u[m][x+1],b=u[m][x],S=u[m+1][x],M=u[m+1][x+1];(m!==0||o>0)&&f.push(w,b,M),(m!==i-1||l<Math.PI)&&f.push(b,S,M)}this.setIndex(f),this.setAttribute("position",new tn(p,3)),this.setAttribute("normal",new tn(_,3)),this.setAttribute("uv",new tn(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};function pr(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(dp(s))s.isRenderTargetTexture?($t("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(dp(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function zn(n){let t={};for(let e=0;e<n.length;e++){let i=pr(n[e]);for(let s in i)t[s]=i[s]}return t}function dp(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function cy(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function id(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:xe.workingColorSpace}var am={clone:pr,merge:zn},uy=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,hy=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,qi=class extends ps{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=uy,this.fragmentShader=hy,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=pr(t.uniforms),this.uniformsGroups=cy(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new Qt().setHex(s.value);break;case"v2":this.uniforms[i].value=new Yt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new W().fromArray(s.value);break;case"v4":this.uniforms[i].value=new qe().fromArray(s.value);break;case"m3":this.uniforms[i].value=new ee().fromArray(s.value);break;case"m4":this.uniforms[i].value=new pe().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Hl=class extends qi{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var gs=class extends ps{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Qt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Qt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Xc,this.normalScale=new Yt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ds,this.combine=sc,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},Wl=class extends ps{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Xp,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Xl=class extends ps{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function $r(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function bl(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Vs=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},$l=class extends Vs{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:yh,endingEnd:yh}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case vh:r=t,a=2*e-i;break;case bh:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case vh:o=t,l=2*i-e;break;case bh:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,u=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(i-e)/(s-e),_=p*p,g=_*p,m=-d*g+2*d*_-d*p,x=(1+d)*g+(-1.5-2*d)*_+(-.5+d)*p+1,w=(-1-f)*g+(1.5+f)*_+.5*p,b=f*g-f*_;for(let S=0;S!==a;++S)r[S]=m*o[u+S]+x*o[c+S]+w*o[l+S]+b*o[h+S];return r}},ql=class extends Vs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=(i-e)/(s-e),h=1-u;for(let d=0;d!==a;++d)r[d]=o[c+d]*h+o[l+d]*u;return r}},Yl=class extends Vs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Zl=class extends Vs{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let p=(i-e)/(s-e),_=1-p;for(let g=0;g!==a;++g)r[g]=o[c+g]*_+o[l+g]*p;return r}let d=a*2,f=t-1;for(let p=0;p!==a;++p){let _=o[c+p],g=o[l+p],m=f*d+p*2,x=h[m],w=h[m+1],b=t*d+p*2,S=u[b],M=u[b+1],y=fy(i,e,x,S,s);r[p]=lm(y,_,w,M,g)}return r}};function lm(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function dy(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function fy(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=lm(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=dy(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var ui=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=$r(e,this.TimeBufferType),this.values=$r(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:$r(t.times,Array),values:$r(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),bl(t.settings)&&(i.settings={inTangents:$r(t.settings.inTangents,Array),outTangents:$r(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new Yl(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new ql(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new $l(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Zl(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case jo:e=this.InterpolantFactoryMethodDiscrete;break;case Ul:e=this.InterpolantFactoryMethodLinear;break;case wl:e=this.InterpolantFactoryMethodSmooth;break;case _h:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return $t("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return jo;case this.InterpolantFactoryMethodLinear:return Ul;case this.InterpolantFactoryMethodSmooth:return wl;case this.InterpolantFactoryMethodBezier:return _h}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;bl(this.settings)&&(fp(this.settings.inTangents,t),fp(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;bl(this.settings)&&(pp(this.settings.inTangents,t),pp(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(jt("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(jt("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){jt("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){jt("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&C_(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){jt("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===wl,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],u=t[a+1];if(c!==u&&(a!==1||c!==t[0]))if(s)l=!0;else{let h=a*i,d=h-i,f=h+i;for(let p=0;p!==i;++p){let _=e[h+p];if(_!==e[d+p]||_!==e[f+p]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let h=a*i,d=o*i;for(let f=0;f!==i;++f)e[d+f]=e[h+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,bl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function fp(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function pp(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}ui.prototype.ValueTypeName="";ui.prototype.TimeBufferType=Float32Array;ui.prototype.ValueBufferType=Float32Array;ui.prototype.DefaultInterpolation=Ul;var Gs=class extends ui{constructor(t,e,i){super(t,e,i)}};Gs.prototype.ValueTypeName="bool";Gs.prototype.ValueBufferType=Array;Gs.prototype.DefaultInterpolation=jo;Gs.prototype.InterpolantFactoryMethodLinear=void 0;Gs.prototype.InterpolantFactoryMethodSmooth=void 0;var Jl=class extends ui{constructor(t,e,i,s){super(t,e,i,s)}};Jl.prototype.ValueTypeName="color";var Kl=class extends ui{constructor(t,e,i,s){super(t,e,i,s)}};Kl.prototype.ValueTypeName="number";var jl=class extends Vs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let u=c+a;c!==u;c+=4)ai.slerpFlat(r,0,o,c-a,o,c,l);return r}},fa=class extends ui{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new jl(this.times,this.values,this.getValueSize(),t)}};fa.prototype.ValueTypeName="quaternion";fa.prototype.InterpolantFactoryMethodSmooth=void 0;var Hs=class extends ui{constructor(t,e,i){super(t,e,i)}};Hs.prototype.ValueTypeName="string";Hs.prototype.ValueBufferType=Array;Hs.prototype.DefaultInterpolation=jo;Hs.prototype.InterpolantFactoryMethodLinear=void 0;Hs.prototype.InterpolantFactoryMethodSmooth=void 0;var Ql=class extends ui{constructor(t,e,i,s){super(t,e,i,s)}};Ql.prototype.ValueTypeName="vector";var tc=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,d=c.length;h<d;h+=2){let f=c[h],p=c[h+1];if(f.global&&(f.lastIndex=0),f.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},cm=new tc,ec=class{constructor(t){this.manager=t!==void 0?t:cm,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};ec.DEFAULT_MATERIAL_NAME="__DEFAULT";var pa=class extends Ln{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new Qt(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},ma=class extends pa{constructor(t,e,i){super(t,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Ln.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Qt(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},xh=new pe,mp=new W,gp=new W,nc=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Yt(512,512),this.mapType=Kn,this.map=null,this.mapPass=null,this.matrix=new pe,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Bs,this._frameExtents=new Yt(1,1),this._viewportCount=1,this._viewports=[new qe(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;mp.setFromMatrixPosition(t.matrixWorld),e.position.copy(mp),gp.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(gp),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,i,s){xh.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),i.setFromProjectionMatrix(xh,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===Kr||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(xh)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},Sl=new W,Ml=new ai,Hi=new W,ga=class extends Ln{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new pe,this.projectionMatrix=new pe,this.projectionMatrixInverse=new pe,this.coordinateSystem=xi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(Sl,Ml,Hi),Hi.x===1&&Hi.y===1&&Hi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Sl,Ml,Hi.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(Sl,Ml,Hi),Hi.x===1&&Hi.y===1&&Hi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Sl,Ml,Hi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Os=new W,xp=new Yt,_p=new Yt,$n=class extends ga{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Qr*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(Jo*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Qr*2*Math.atan(Math.tan(Jo*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){Os.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Os.x,Os.y).multiplyScalar(-t/Os.z),Os.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Os.x,Os.y).multiplyScalar(-t/Os.z)}getViewSize(t,e){return this.getViewBounds(t,xp,_p),e.subVectors(_p,xp)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(Jo*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var xa=class extends ga{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Sh=class extends nc{constructor(){super(new xa(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},_a=class extends pa{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Ln.DEFAULT_UP),this.updateMatrix(),this.target=new Ln,this.shadow=new Sh}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}};var qr=-90,Yr=1,ro=class extends Ln{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new $n(qr,Yr,t,e);s.layers=this.layers,this.add(s);let r=new $n(qr,Yr,t,e);r.layers=this.layers,this.add(r);let o=new $n(qr,Yr,t,e);o.layers=this.layers,this.add(o);let a=new $n(qr,Yr,t,e);a.layers=this.layers,this.add(a);let l=new $n(qr,Yr,t,e);l.layers=this.layers,this.add(l);let c=new $n(qr,Yr,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===xi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===Kr)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let _=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let g=!1;t.isWebGLRenderer===!0?g=t.state.buffers.depth.getReversed():g=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=_,t.setRenderTarget(i,5,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,u),t.setRenderTarget(h,d,f),t.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},ic=class extends $n{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var sd="\\[\\]\\.:\\/",py=new RegExp("["+sd+"]","g"),rd="[^"+sd+"]",my="[^"+sd.replace("\\.","")+"]",gy=/((?:WC+[\/:])*)/.source.replace("WC",rd),xy=/(WCOD+)?/.source.replace("WCOD",my),_y=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",rd),yy=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",rd),vy=new RegExp("^"+gy+xy+_y+yy+"$"),by=["material","materials","bones","map"],Mh=class{constructor(t,e,i){let s=i||He.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},He=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(py,"")}static parseTrackName(t){let e=vy.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);by.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){$t("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){jt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){jt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){jt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let u=0;u<t.length;u++)if(t[u].name===c){c=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){jt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){jt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){jt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){jt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;jt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){jt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){jt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};He.Composite=Mh;He.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};He.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};He.prototype.GetterByBindingType=[He.prototype._getValue_direct,He.prototype._getValue_array,He.prototype._getValue_arrayElement,He.prototype._getValue_toArray];He.prototype.SetterByBindingTypeAndVersioning=[[He.prototype._setValue_direct,He.prototype._setValue_direct_setNeedsUpdate,He.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[He.prototype._setValue_array,He.prototype._setValue_array_setNeedsUpdate,He.prototype._setValue_array_setMatrixWorldNeedsUpdate],[He.prototype._setValue_arrayElement,He.prototype._setValue_arrayElement_setNeedsUpdate,He.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[He.prototype._setValue_fromArray,He.prototype._setValue_fromArray_setNeedsUpdate,He.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var lR=new Float32Array(1);var yp=new pe,ya=class{constructor(t,e,i=0,s=1/0){this.ray=new ks(t,e),this.near=i,this.far=s,this.camera=null,this.layers=new eo,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):jt("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return yp.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(yp),this}intersectObject(t,e=!0,i=[]){return wh(t,this,i,e),i.sort(vp),i}intersectObjects(t,e=!0,i=[]){for(let s=0,r=t.length;s<r;s++)wh(t[s],this,i,e);return i.sort(vp),i}};function vp(n,t){return n.distance-t.distance}function wh(n,t,e,i){let s=!0;if(n.layers.test(t.layers)&&n.raycast(t,e)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)wh(r[o],t,e,!0)}}var oo=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=fe(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(fe(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Ah=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var va=class extends Ci{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function od(n,t,e,i){let s=Sy(i);switch(e){case Wh:return n*t;case hc:return n*t/s.components*s.byteLength;case dc:return n*t/s.components*s.byteLength;case qs:return n*t*2/s.components*s.byteLength;case fc:return n*t*2/s.components*s.byteLength;case Xh:return n*t*3/s.components*s.byteLength;case Ii:return n*t*4/s.components*s.byteLength;case pc:return n*t*4/s.components*s.byteLength;case Ma:case wa:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Aa:case Ea:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case gc:case _c:return Math.max(n,16)*Math.max(t,8)/4;case mc:case xc:return Math.max(n,8)*Math.max(t,8)/2;case yc:case vc:case Sc:case Mc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case bc:case Ta:case wc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Ac:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Ec:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case Tc:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case Cc:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case Rc:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case Pc:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case Ic:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case Lc:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case Nc:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case Dc:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case Uc:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case Oc:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case Fc:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case kc:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case Bc:case zc:case Vc:return Math.ceil(n/4)*Math.ceil(t/4)*16;case Gc:case Hc:return Math.ceil(n/4)*Math.ceil(t/4)*8;case Ca:case Wc:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function Sy(n){switch(n){case Kn:case zh:return{byteLength:1,components:1};case uo:case Vh:case Pi:return{byteLength:2,components:1};case cc:case uc:return{byteLength:2,components:4};case Ri:case lc:case _i:return{byteLength:4,components:1};case Gh:case Hh:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?$t("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Im(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function wy(n){let t=new WeakMap;function e(a,l){let c=a.array,u=a.usage,h=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<h.length;f++){let p=h[d],_=h[f];_.start<=p.start+p.count+1?p.count=Math.max(p.count,_.start+_.count-p.start):(++d,h[d]=_)}h.length=d+1;for(let f=0,p=h.length;f<p;f++){let _=h[f];n.bufferSubData(c,_.start*u.BYTES_PER_ELEMENT,u,_.start,_.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Ay=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Ey=`#ifdef USE_ALPHAHASH
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
#endif`,Ty=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Cy=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Ry=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Py=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Iy=`#ifdef USE_AOMAP
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
#endif`,Ly=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Ny=`#ifdef USE_BATCHING
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
#endif`,Dy=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Uy=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Oy=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Fy=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,ky=`#ifdef USE_IRIDESCENCE
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
#endif`,By=`#ifdef USE_BUMPMAP
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
#endif`,zy=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,Vy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Gy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Hy=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Wy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Xy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,$y=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,qy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,Yy=`#define PI 3.141592653589793
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
} // validated`,Zy=`vec3 transformedNormal = objectNormal;
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
#endif`,Jy=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Ky=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,jy=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Qy=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,tv="gl_FragColor = linearToOutputTexel( gl_FragColor );",ev=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,nv=`#ifdef USE_ENVMAP
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
#endif`,iv=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,sv=`#ifdef USE_ENVMAP
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
#endif`,rv=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,ov=`#ifdef USE_ENVMAP
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
#endif`,av=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,lv=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,cv=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,uv=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,hv=`#ifdef USE_GRADIENTMAP
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
}`,dv=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,fv=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,pv=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,mv=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,gv=`#ifdef USE_ENVMAP
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
#endif`,xv=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,_v=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,yv=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,vv=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,bv=`PhysicalMaterial material;
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
#endif`,Sv=`uniform sampler2D dfgLUT;
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
}`,Mv=`
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
#endif`,wv=`#if defined( RE_IndirectDiffuse )
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
#endif`,Av=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Ev=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,Tv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Cv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Rv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Pv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Iv=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Lv=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Nv=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,Dv=`#if defined( USE_POINTS_UV )
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
#endif`,Uv=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Ov=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Fv=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,kv=`#if defined( USE_MORPHCOLORS )
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
#endif`,Bv=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,zv=`#ifdef USE_MORPHTARGETS
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
#endif`,Vv=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Gv=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,Hv=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,Wv=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Xv=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,$v=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,qv=`#ifdef USE_NORMALMAP
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
#endif`,Yv=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Zv=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Jv=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Kv=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,jv=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Qv=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,tb=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,eb=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,nb=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,ib=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,sb=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,rb=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,ob=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,ab=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,lb=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,cb=`float getShadowMask() {
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
}`,ub=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,hb=`#ifdef USE_SKINNING
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
#endif`,db=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,fb=`#ifdef USE_SKINNING
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
#endif`,pb=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,mb=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,gb=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,xb=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,_b=`#ifdef USE_TRANSMISSION
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
#endif`,yb=`#ifdef USE_TRANSMISSION
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
#endif`,vb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,bb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Sb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Mb=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,wb=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Ab=`uniform sampler2D t2D;
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
}`,Eb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Tb=`uniform float backgroundBlurriness;
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
}`,Cb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Rb=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Pb=`#include <common>
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
}`,Ib=`#if DEPTH_PACKING == 3200
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
}`,Lb=`#define DISTANCE
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
}`,Nb=`#define DISTANCE
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
}`,Db=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Ub=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Ob=`uniform float scale;
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
}`,Fb=`uniform vec3 diffuse;
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
}`,kb=`#include <common>
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
}`,Bb=`uniform vec3 diffuse;
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
}`,zb=`#define LAMBERT
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
}`,Vb=`#define LAMBERT
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
}`,Gb=`#define MATCAP
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
}`,Hb=`#define MATCAP
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
}`,Wb=`#define NORMAL
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
}`,Xb=`#define NORMAL
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
}`,$b=`#define PHONG
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
}`,qb=`#define PHONG
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
}`,Yb=`#define STANDARD
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
}`,Zb=`#define STANDARD
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
}`,Jb=`#define TOON
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
}`,Kb=`#define TOON
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
}`,jb=`uniform float size;
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
}`,Qb=`uniform vec3 diffuse;
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
}`,tS=`#include <common>
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
}`,eS=`uniform vec3 color;
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
}`,nS=`uniform float rotation;
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
}`,iS=`uniform vec3 diffuse;
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
}`,ce={alphahash_fragment:Ay,alphahash_pars_fragment:Ey,alphamap_fragment:Ty,alphamap_pars_fragment:Cy,alphatest_fragment:Ry,alphatest_pars_fragment:Py,aomap_fragment:Iy,aomap_pars_fragment:Ly,batching_pars_vertex:Ny,batching_vertex:Dy,begin_vertex:Uy,beginnormal_vertex:Oy,bsdfs:Fy,iridescence_fragment:ky,bumpmap_pars_fragment:By,clipping_planes_fragment:zy,clipping_planes_pars_fragment:Vy,clipping_planes_pars_vertex:Gy,clipping_planes_vertex:Hy,color_fragment:Wy,color_pars_fragment:Xy,color_pars_vertex:$y,color_vertex:qy,common:Yy,defaultnormal_vertex:Zy,displacementmap_pars_vertex:Jy,displacementmap_vertex:Ky,emissivemap_fragment:jy,emissivemap_pars_fragment:Qy,colorspace_fragment:tv,colorspace_pars_fragment:ev,envmap_fragment:nv,envmap_common_pars_fragment:iv,envmap_pars_fragment:sv,envmap_pars_vertex:rv,envmap_physical_pars_fragment:gv,envmap_vertex:ov,fog_vertex:av,fog_pars_vertex:lv,fog_fragment:cv,fog_pars_fragment:uv,gradientmap_pars_fragment:hv,lightmap_pars_fragment:dv,lights_lambert_fragment:fv,lights_lambert_pars_fragment:pv,lights_pars_begin:mv,lights_toon_fragment:xv,lights_toon_pars_fragment:_v,lights_phong_fragment:yv,lights_phong_pars_fragment:vv,lights_physical_fragment:bv,lights_physical_pars_fragment:Sv,lights_fragment_begin:Mv,lights_fragment_maps:wv,lights_fragment_end:Av,lightprobes_pars_fragment:Ev,logdepthbuf_fragment:Tv,logdepthbuf_pars_fragment:Cv,logdepthbuf_pars_vertex:Rv,logdepthbuf_vertex:Pv,map_fragment:Iv,map_pars_fragment:Lv,map_particle_fragment:Nv,map_particle_pars_fragment:Dv,metalnessmap_fragment:Uv,metalnessmap_pars_fragment:Ov,morphinstance_vertex:Fv,morphcolor_vertex:kv,morphnormal_vertex:Bv,morphtarget_pars_vertex:zv,morphtarget_vertex:Vv,normal_fragment_begin:Gv,normal_fragment_maps:Hv,normal_pars_fragment:Wv,normal_pars_vertex:Xv,normal_vertex:$v,normalmap_pars_fragment:qv,clearcoat_normal_fragment_begin:Yv,clearcoat_normal_fragment_maps:Zv,clearcoat_pars_fragment:Jv,iridescence_pars_fragment:Kv,opaque_fragment:jv,packing:Qv,premultiplied_alpha_fragment:tb,project_vertex:eb,dithering_fragment:nb,dithering_pars_fragment:ib,roughnessmap_fragment:sb,roughnessmap_pars_fragment:rb,shadowmap_pars_fragment:ob,shadowmap_pars_vertex:ab,shadowmap_vertex:lb,shadowmask_pars_fragment:cb,skinbase_vertex:ub,skinning_pars_vertex:hb,skinning_vertex:db,skinnormal_vertex:fb,specularmap_fragment:pb,specularmap_pars_fragment:mb,tonemapping_fragment:gb,tonemapping_pars_fragment:xb,transmission_fragment:_b,transmission_pars_fragment:yb,uv_pars_fragment:vb,uv_pars_vertex:bb,uv_vertex:Sb,worldpos_vertex:Mb,background_vert:wb,background_frag:Ab,backgroundCube_vert:Eb,backgroundCube_frag:Tb,cube_vert:Cb,cube_frag:Rb,depth_vert:Pb,depth_frag:Ib,distance_vert:Lb,distance_frag:Nb,equirect_vert:Db,equirect_frag:Ub,linedashed_vert:Ob,linedashed_frag:Fb,meshbasic_vert:kb,meshbasic_frag:Bb,meshlambert_vert:zb,meshlambert_frag:Vb,meshmatcap_vert:Gb,meshmatcap_frag:Hb,meshnormal_vert:Wb,meshnormal_frag:Xb,meshphong_vert:$b,meshphong_frag:qb,meshphysical_vert:Yb,meshphysical_frag:Zb,meshtoon_vert:Jb,meshtoon_frag:Kb,points_vert:jb,points_frag:Qb,shadow_vert:tS,shadow_frag:eS,sprite_vert:nS,sprite_frag:iS},Lt={common:{diffuse:{value:new Qt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ee},alphaMap:{value:null},alphaMapTransform:{value:new ee},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ee}},envmap:{envMap:{value:null},envMapRotation:{value:new ee},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ee}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ee}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ee},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ee},normalScale:{value:new Yt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ee},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ee}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ee}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ee}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Qt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Qt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ee},alphaTest:{value:0},uvTransform:{value:new ee}},sprite:{diffuse:{value:new Qt(16777215)},opacity:{value:1},center:{value:new Yt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ee},alphaMap:{value:null},alphaMapTransform:{value:new ee},alphaTest:{value:0}}},Ji={basic:{uniforms:zn([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.fog]),vertexShader:ce.meshbasic_vert,fragmentShader:ce.meshbasic_frag},lambert:{uniforms:zn([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,Lt.lights,{emissive:{value:new Qt(0)},envMapIntensity:{value:1}}]),vertexShader:ce.meshlambert_vert,fragmentShader:ce.meshlambert_frag},phong:{uniforms:zn([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,Lt.lights,{emissive:{value:new Qt(0)},specular:{value:new Qt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ce.meshphong_vert,fragmentShader:ce.meshphong_frag},standard:{uniforms:zn([Lt.common,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.roughnessmap,Lt.metalnessmap,Lt.fog,Lt.lights,{emissive:{value:new Qt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ce.meshphysical_vert,fragmentShader:ce.meshphysical_frag},toon:{uniforms:zn([Lt.common,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.gradientmap,Lt.fog,Lt.lights,{emissive:{value:new Qt(0)}}]),vertexShader:ce.meshtoon_vert,fragmentShader:ce.meshtoon_frag},matcap:{uniforms:zn([Lt.common,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,{matcap:{value:null}}]),vertexShader:ce.meshmatcap_vert,fragmentShader:ce.meshmatcap_frag},points:{uniforms:zn([Lt.points,Lt.fog]),vertexShader:ce.points_vert,fragmentShader:ce.points_frag},dashed:{uniforms:zn([Lt.common,Lt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ce.linedashed_vert,fragmentShader:ce.linedashed_frag},depth:{uniforms:zn([Lt.common,Lt.displacementmap]),vertexShader:ce.depth_vert,fragmentShader:ce.depth_frag},normal:{uniforms:zn([Lt.common,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,{opacity:{value:1}}]),vertexShader:ce.meshnormal_vert,fragmentShader:ce.meshnormal_frag},sprite:{uniforms:zn([Lt.sprite,Lt.fog]),vertexShader:ce.sprite_vert,fragmentShader:ce.sprite_frag},background:{uniforms:{uvTransform:{value:new ee},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ce.background_vert,fragmentShader:ce.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ee}},vertexShader:ce.backgroundCube_vert,fragmentShader:ce.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ce.cube_vert,fragmentShader:ce.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ce.equirect_vert,fragmentShader:ce.equirect_frag},distance:{uniforms:zn([Lt.common,Lt.displacementmap,{referencePosition:{value:new W},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ce.distance_vert,fragmentShader:ce.distance_frag},shadow:{uniforms:zn([Lt.lights,Lt.fog,{color:{value:new Qt(0)},opacity:{value:1}}]),vertexShader:ce.shadow_vert,fragmentShader:ce.shadow_frag}};Ji.physical={uniforms:zn([Ji.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ee},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ee},clearcoatNormalScale:{value:new Yt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ee},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ee},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ee},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ee},sheen:{value:0},sheenColor:{value:new Qt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ee},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ee},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ee},transmissionSamplerSize:{value:new Yt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ee},attenuationDistance:{value:0},attenuationColor:{value:new Qt(0)},specularColor:{value:new Qt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ee},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ee},anisotropyVector:{value:new Yt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ee}}]),vertexShader:ce.meshphysical_vert,fragmentShader:ce.meshphysical_frag};var $c={r:0,b:0,g:0},sS=new pe,Lm=new ee;Lm.set(-1,0,0,0,1,0,0,0,1);function rS(n,t,e,i,s,r){let o=new Qt(0),a=s===!0?0:1,l,c,u=null,h=0,d=null;function f(x){let w=x.isScene===!0?x.background:null;if(w&&w.isTexture){let b=x.backgroundBlurriness>0;w=t.get(w,b)}return w}function p(x){let w=!1,b=f(x);b===null?g(o,a):b&&b.isColor&&(g(b,1),w=!0);let S=n.xr.getEnvironmentBlendMode();S==="additive"?e.buffers.color.setClear(0,0,0,1,r):S==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||w)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function _(x,w){let b=f(w);b&&b.isCubeTexture?(c===void 0&&(c=new Nn(new io(1,1,1),new qi({name:"BackgroundCubeMaterial",uniforms:pr(Ji.backgroundCube.uniforms),vertexShader:Ji.backgroundCube.vertexShader,fragmentShader:Ji.backgroundCube.fragmentShader,side:Yn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(S,M,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=w.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(sS.makeRotationFromEuler(w.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Lm),c.material.toneMapped=xe.getTransfer(b.colorSpace)!==Ae,(u!==b||h!==b.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,u=b,h=b.version,d=n.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new Nn(new da(2,2),new qi({name:"BackgroundMaterial",uniforms:pr(Ji.background.uniforms),vertexShader:Ji.background.vertexShader,fragmentShader:Ji.background.fragmentShader,side:$s,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,l.material.toneMapped=xe.getTransfer(b.colorSpace)!==Ae,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(u!==b||h!==b.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,u=b,h=b.version,d=n.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function g(x,w){x.getRGB($c,id(n)),e.buffers.color.setClear($c.r,$c.g,$c.b,w,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,w=1){o.set(x),a=w,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,g(o,a)},render:p,addToRenderList:_,dispose:m}}function oS(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(P,F,z,U,G){let $=!1,H=h(P,U,z,F);r!==H&&(r=H,c(r.object)),$=f(P,U,z,G),$&&p(P,U,z,G),G!==null&&t.update(G,n.ELEMENT_ARRAY_BUFFER),($||o)&&(o=!1,b(P,F,z,U),G!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(G).buffer))}function l(){return n.createVertexArray()}function c(P){return n.bindVertexArray(P)}function u(P){return n.deleteVertexArray(P)}function h(P,F,z,U){let G=U.wireframe===!0,$=i[F.id];$===void 0&&($={},i[F.id]=$);let H=P.isInstancedMesh===!0?P.id:0,lt=$[H];lt===void 0&&(lt={},$[H]=lt);let J=lt[z.id];J===void 0&&(J={},lt[z.id]=J);let Q=J[G];return Q===void 0&&(Q=d(l()),J[G]=Q),Q}function d(P){let F=[],z=[],U=[];for(let G=0;G<e;G++)F[G]=0,z[G]=0,U[G]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:F,enabledAttributes:z,attributeDivisors:U,object:P,attributes:{},index:null}}function f(P,F,z,U){let G=r.attributes,$=F.attributes,H=0,lt=z.getAttributes();for(let J in lt)if(lt[J].location>=0){let it=G[J],ft=$[J];if(ft===void 0&&(J==="instanceMatrix"&&P.instanceMatrix&&(ft=P.instanceMatrix),J==="instanceColor"&&P.instanceColor&&(ft=P.instanceColor)),it===void 0||it.attribute!==ft||ft&&it.data!==ft.data)return!0;H++}return r.attributesNum!==H||r.index!==U}function p(P,F,z,U){let G={},$=F.attributes,H=0,lt=z.getAttributes();for(let J in lt)if(lt[J].location>=0){let it=$[J];it===void 0&&(J==="instanceMatrix"&&P.instanceMatrix&&(it=P.instanceMatrix),J==="instanceColor"&&P.instanceColor&&(it=P.instanceColor));let ft={};ft.attribute=it,it&&it.data&&(ft.data=it.data),G[J]=ft,H++}r.attributes=G,r.attributesNum=H,r.index=U}function _(){let P=r.newAttributes;for(let F=0,z=P.length;F<z;F++)P[F]=0}function g(P){m(P,0)}function m(P,F){let z=r.newAttributes,U=r.enabledAttributes,G=r.attributeDivisors;z[P]=1,U[P]===0&&(n.enableVertexAttribArray(P),U[P]=1),G[P]!==F&&(n.vertexAttribDivisor(P,F),G[P]=F)}function x(){let P=r.newAttributes,F=r.enabledAttributes;for(let z=0,U=F.length;z<U;z++)F[z]!==P[z]&&(n.disableVertexAttribArray(z),F[z]=0)}function w(P,F,z,U,G,$,H){H===!0?n.vertexAttribIPointer(P,F,z,G,$):n.vertexAttribPointer(P,F,z,U,G,$)}function b(P,F,z,U){_();let G=U.attributes,$=z.getAttributes(),H=F.defaultAttributeValues;for(let lt in $){let J=$[lt];if(J.location>=0){let Q=G[lt];if(Q===void 0&&(lt==="instanceMatrix"&&P.instanceMatrix&&(Q=P.instanceMatrix),lt==="instanceColor"&&P.instanceColor&&(Q=P.instanceColor)),Q!==void 0){let it=Q.normalized,ft=Q.itemSize,dt=t.get(Q);if(dt===void 0)continue;let tt=dt.buffer,ht=dt.type,gt=dt.bytesPerElement,St=ht===n.INT||ht===n.UNSIGNED_INT||Q.gpuType===lc;if(Q.isInterleavedBufferAttribute){let Mt=Q.data,Ht=Mt.isInterleavedBuffer===!0?Mt.stride:Mt.itemSize,se=Q.offset;if(Mt.isInstancedInterleavedBuffer||Mt.isInstancedBufferAttribute){for(let Vt=0;Vt<J.locationSize;Vt++)m(J.location+Vt,Mt.meshPerAttribute);P.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=Mt.meshPerAttribute*Mt.count)}else for(let Vt=0;Vt<J.locationSize;Vt++)g(J.location+Vt);n.bindBuffer(n.ARRAY_BUFFER,tt);for(let Vt=0;Vt<J.locationSize;Vt++)w(J.location+Vt,ft/J.locationSize,ht,it,Ht*gt,(se+ft/J.locationSize*Vt)*gt,St)}else{if(Q.isInstancedBufferAttribute){for(let Mt=0;Mt<J.locationSize;Mt++)m(J.location+Mt,Q.meshPerAttribute);P.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let Mt=0;Mt<J.locationSize;Mt++)g(J.location+Mt);n.bindBuffer(n.ARRAY_BUFFER,tt);for(let Mt=0;Mt<J.locationSize;Mt++)w(J.location+Mt,ft/J.locationSize,ht,it,ft*gt,ft/J.locationSize*Mt*gt,St)}}else if(H!==void 0){let it=H[lt];if(it!==void 0)switch(it.length){case 2:n.vertexAttrib2fv(J.location,it);break;case 3:n.vertexAttrib3fv(J.location,it);break;case 4:n.vertexAttrib4fv(J.location,it);break;default:n.vertexAttrib1fv(J.location,it)}}}}x()}function S(){I();for(let P in i){let F=i[P];for(let z in F){let U=F[z];for(let G in U){let $=U[G];for(let H in $)u($[H].object),delete $[H];delete U[G]}}delete i[P]}}function M(P){if(i[P.id]===void 0)return;let F=i[P.id];for(let z in F){let U=F[z];for(let G in U){let $=U[G];for(let H in $)u($[H].object),delete $[H];delete U[G]}}delete i[P.id]}function y(P){for(let F in i){let z=i[F];for(let U in z){let G=z[U];if(G[P.id]===void 0)continue;let $=G[P.id];for(let H in $)u($[H].object),delete $[H];delete G[P.id]}}}function A(P){for(let F in i){let z=i[F],U=P.isInstancedMesh===!0?P.id:0,G=z[U];if(G!==void 0){for(let $ in G){let H=G[$];for(let lt in H)u(H[lt].object),delete H[lt];delete G[$]}delete z[U],Object.keys(z).length===0&&delete i[F]}}}function I(){L(),o=!0,r!==s&&(r=s,c(r.object))}function L(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:I,resetDefaultState:L,dispose:S,releaseStatesOfGeometry:M,releaseStatesOfObject:A,releaseStatesOfProgram:y,initAttributes:_,enableAttribute:g,disableUnusedAttributes:x}}function aS(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),e.update(c,i,u))}function a(l,c,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let d=0;for(let f=0;f<u;f++)d+=c[f];e.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function lS(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let y=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==Ii&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let A=y===Pi&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(y!==Kn&&y!==_i&&!A&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",u=l(c);u!==c&&($t("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&h===!1;e.reversedDepthBuffer===!0&&h===!1&&$t("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&h===!0&&$t("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_TEXTURE_SIZE),g=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),x=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),w=n.getParameter(n.MAX_VARYING_VECTORS),b=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),S=n.getParameter(n.MAX_SAMPLES),M=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:p,maxTextureSize:_,maxCubemapSize:g,maxAttributes:m,maxVertexUniforms:x,maxVaryings:w,maxFragmentUniforms:b,maxSamples:S,samples:M}}function cS(n){let t=this,e=null,i=0,s=!1,r=!1,o=new oi,a=new ee,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){let f=h.length!==0||d||i!==0||s;return s=d,i=h.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,d){e=u(h,d,0)},this.setState=function(h,d,f){let p=h.clippingPlanes,_=h.clipIntersection,g=h.clipShadows,m=n.get(h);if(!s||p===null||p.length===0||r&&!g)r?u(null):c();else{let x=r?0:i,w=x*4,b=m.clippingState||null;l.value=b,b=u(p,d,w,f);for(let S=0;S!==w;++S)b[S]=e[S];m.clippingState=b,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function u(h,d,f,p){let _=h!==null?h.length:0,g=null;if(_!==0){if(g=l.value,p!==!0||g===null){let m=f+_*4,x=d.matrixWorldInverse;a.getNormalMatrix(x),(g===null||g.length<m)&&(g=new Float32Array(m));for(let w=0,b=f;w!==_;++w,b+=4)o.copy(h[w]).applyMatrix4(x,a),o.normal.toArray(g,b),g[b+3]=o.constant}l.value=g,l.needsUpdate=!0}return t.numPlanes=_,t.numIntersection=0,g}}var La=class extends li{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new la(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new io(5,5,5),r=new qi({name:"CubemapFromEquirect",uniforms:pr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Yn,blending:ur});r.uniforms.tEquirect.value=e;let o=new Nn(s,r),a=e.minFilter;return e.minFilter===xs&&(e.minFilter=qn),new ro(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},um=256,uS=3,hS=20,Nm=256,Dm=16,dS=3,fS=new W,pS=new Qt,Yc=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new ro(1,10,null),this._boxMesh=new Nn(new io(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=fS}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);e>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,_=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,_===null&&(t.background=l.getClearColor(pS));let g=new ro(i,s,u);return g.position.copy(a),g.update(l,t),l.autoClear=h,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=p,t.background=_,e>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=fm(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=dm(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(um,td(t))}_fromTexture(t,e){t.mapping===dr||t.mapping===co?this._setSize(t.image.length===0?um:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=hm(t,!1,!1),i=Math.log2(t)-uS;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=hm(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===dr||t.mapping===co?(this._cubemapMaterial===null&&(this._cubemapMaterial=fm()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=dm()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=mS(),this._integrationMaterial=gS());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/Dm);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-dS)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(Nm*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=xS());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function hm(n,t,e){return new La(n,{minFilter:xs,generateMipmaps:t,type:Pi,colorSpace:Qo,depthBuffer:e})}function Na(n,t,e){return new qi({name:n,uniforms:t,vertexShader:ce.cube_vert,fragmentShader:e,side:Yn,blending:ur,depthTest:!1,depthWrite:!1})}function mS(){return Na("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Nm}u

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
	`)}function gS(){return Na("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Dm}},`

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
	`)}function xS(){return Na("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${hS}
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
	`)}function dm(){return Na("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function fm(){return Na("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function _S(n){let t=new WeakMap,e=new WeakMap,i=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===rc||f===oc)if(t.has(d)){let p=t.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let _=new La(p.height);return _.fromEquirectangularTexture(n,d),t.set(d,_),d.addEventListener("dispose",c),a(_.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===rc||f===oc,_=f===dr||f===co;if(p||_){let g=e.get(d),m=g!==void 0?g.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==m)return i===null&&(i=new Yc(n)),g=p?i.fromEquirectangular(d,g):i.fromCubemap(d,g),g.texture.pmremVersion=d.pmremVersion,e.set(d,g),g.texture;if(g!==void 0)return g.texture;{let x=d.image;return p&&x&&x.height>0||_&&x&&l(x)?(i===null&&(i=new Yc(n)),g=p?i.fromEquirectangular(d):i.fromCubemap(d),g.texture.pmremVersion=d.pmremVersion,e.set(d,g),d.addEventListener("dispose",u),g.texture):null}}}return d}function a(d,f){return f===rc?d.mapping=dr:f===oc&&(d.mapping=co),d}function l(d){let f=0,p=6;for(let _=0;_<p;_++)d[_]!==void 0&&f++;return f===p}function c(d){let f=d.target;f.removeEventListener("dispose",c);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function u(d){let f=d.target;f.removeEventListener("dispose",u);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function h(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function yS(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&Zo("WebGLRenderer: "+i+" extension not supported."),s}}}function vS(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&t.remove(p.index);for(let g in p.attributes)t.remove(p.attributes[g]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let _=r.get(p);_&&(t.remove(_),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function c(p,_){return s[_.id]!==void 0||(_.addEventListener("dispose",a),s[_.id]=new WeakRef(_),o.register(_,_.id,_),e.memory.geometries++),_}function u(p){let _=p.attributes;for(let g in _)t.update(_[g],n.ARRAY_BUFFER)}function h(p){let _=p.index,g=p.attributes.position,m=0;if(g===void 0)return;let x=_!==null?_.array.length:g.array.length/3-1,w=g.count>=65535?ra:sa,b=new w(Math.ceil(x/3)*6,1),S=b.array;if(_!==null){let y=_.array;m=_.version;for(let A=0,I=0;A<x;A+=3){let L=y[A+0],P=y[A+1],F=y[A+2];S[I++]=L,S[I++]=P,S[I++]=P,S[I++]=F,S[I++]=F,S[I++]=L}}else{m=g.version;for(let y=0,A=0;y<x;y+=3){let I=y+0,L=y+1,P=y+2;S[A++]=I,S[A++]=L,S[A++]=L,S[A++]=P,S[A++]=P,S[A++]=I}}b.version=m;let M=r.get(p);M&&t.remove(M),r.set(p,b)}function d(p){let _=r.get(p);if(_){let g=p.index;g!==null&&_.version<g.version&&h(p)}else h(p);return r.get(p)}function f(){for(let p in s){let _=s[p].deref();_!==void 0&&l(_)}}return{get:c,update:u,getWireframeAttribute:d,dispose:f}}function bS(n,t,e){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,d){n.drawElements(i,d,r,h*o),e.update(d,i,1)}function c(h,d,f){f!==0&&(n.drawElementsInstanced(i,d,r,h*o,f),e.update(d,i,f))}function u(h,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,h,0,f);let _=0;for(let g=0;g<f;g++)_+=d[g];e.update(_,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function SS(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:jt("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function MS(n,t,e){let i=new WeakMap,s=new qe;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,d=i.get(a);if(d===void 0||d.count!==h){let I=function(){y.dispose(),i.delete(a),a.removeEventListener("dispose",I)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,_=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],x=a.morphAttributes.color||[],w=0;f===!0&&(w=1),p===!0&&(w=2),_===!0&&(w=3);let b=a.attributes.position.count*w,S=1;b>t.maxTextureSize&&(S=Math.ceil(b/t.maxTextureSize),b=t.maxTextureSize);let M=new Float32Array(b*S*4*h),y=new na(M,b,S,h);y.type=_i,y.needsUpdate=!0;let A=w*4;for(let L=0;L<h;L++){let P=g[L],F=m[L],z=x[L],U=b*S*4*L;for(let G=0;G<P.count;G++){let $=G*A;f===!0&&(s.fromBufferAttribute(P,G),M[U+$+0]=s.x,M[U+$+1]=s.y,M[U+$+2]=s.z,M[U+$+3]=0),p===!0&&(s.fromBufferAttribute(F,G),M[U+$+4]=s.x,M[U+$+5]=s.y,M[U+$+6]=s.z,M[U+$+7]=0),_===!0&&(s.fromBufferAttribute(z,G),M[U+$+8]=s.x,M[U+$+9]=s.y,M[U+$+10]=s.z,M[U+$+11]=z.itemSize===4?s.w:1)}}d={count:h,texture:y,size:new Yt(b,S)},i.set(a,d),a.addEventListener("dispose",I)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let f=0;for(let _=0;_<c.length;_++)f+=c[_];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function wS(n,t,e,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,d=t.get(c,h);if(r.get(d)!==u&&(t.update(d),r.set(d,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return d}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),e.remove(u.instanceMatrix),u.instanceColor!==null&&e.remove(u.instanceColor)}return{update:o,dispose:a}}var AS={[Lh]:"LINEAR_TONE_MAPPING",[Nh]:"REINHARD_TONE_MAPPING",[Dh]:"CINEON_TONE_MAPPING",[Uh]:"ACES_FILMIC_TONE_MAPPING",[Fh]:"AGX_TONE_MAPPING",[kh]:"NEUTRAL_TONE_MAPPING",[Oh]:"CUSTOM_TONE_MAPPING"};function ES(n,t,e,i,s,r){let o=new li(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new xn;u.setAttribute("position",new tn([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new tn([0,2,0,0,2,0],2));let h=new Hl({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new Nn(u,h),f=new xa(-1,1,1,-1,0,1),p=null,_=null,g=!1,m,x=null,w=[],b=!1;this.setSize=function(S,M){o.setSize(S,M),a!==null&&a.setSize(S,M),l!==null&&l.setSize(S,M);for(let y=0;y<w.length;y++){let A=w[y];A.setSize&&A.setSize(S,M)}},this.setEffects=function(S){w=S,b=w.length>0&&w[0].isRenderPass===!0;let M=o.width,y=o.height;w.length>0&&a===null&&(a=new li(M,y,{type:Pi,depthBuffer:!1,stencilBuffer:!1}),l=new li(M,y,{type:Pi,depthBuffer:!1,stencilBuffer:!1}));let A=s===!0&&w.some(I=>I.needsDepthTexture===!0);A!==(o.depthTexture!==null)&&(A===!0&&c===null&&(c=new ms(M,y),r===!0&&(c.format=_s,c.type=fr)),o.dispose(),o.depthTexture=A?c:null,o.resolveDepthBuffer=A,o.storeMultisampledDepthBuffer=A);for(let I=0;I<w.length;I++){let L=w[I];L.setSize&&L.setSize(M,y),A&&L.needsDepthTexture===!0&&L.setDepthTexture&&L.setDepthTexture(c)}},this.begin=function(S,M){if(g||S.toneMapping===Yi&&w.length===0)return!1;if(x=M,M!==null){let y=M.width,A=M.height;(o.width!==y||o.height!==A)&&this.setSize(y,A)}return b===!1&&S.setRenderTarget(o),m=S.toneMapping,S.toneMapping=Yi,!0},this.hasRenderPass=function(){return b},this.end=function(S,M){S.toneMapping=m,g=!0;let y=o,A=a;for(let I=0;I<w.length;I++){let L=w[I];L.enabled!==!1&&(L.render(S,A,y,M),L.needsSwap!==!1&&(y=A,A=A===a?l:a))}if(p!==S.outputColorSpace||_!==S.toneMapping){p=S.outputColorSpace,_=S.toneMapping,h.defines={},xe.getTransfer(p)===Ae&&(h.defines.SRGB_TRANSFER="");let I=AS[_];I&&(h.defines[I]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=y.texture,S.setRenderTarget(x),S.render(d,f),x=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var Um=new Jn,Om=new ms(1,1),Fm=new ca(1),km=new na,Bm=new kl,zm=new la,pm=[],mm=[],gm=new Float32Array(16),xm=new Float32Array(9),_m=new Float32Array(4);function po(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=pm[s];if(r===void 0&&(r=new Float32Array(s),pm[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function _n(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function yn(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function Jc(n,t){let e=mm[t];e===void 0&&(e=new Int32Array(t),mm[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function TS(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function CS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(_n(e,t))return;n.uniform2fv(this.addr,t),yn(e,t)}}function RS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(_n(e,t))return;n.uniform3fv(this.addr,t),yn(e,t)}}function PS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(_n(e,t))return;n.uniform4fv(this.addr,t),yn(e,t)}}function IS(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(_n(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),yn(e,t)}else{if(_n(e,i))return;_m.set(i),n.uniformMatrix2fv(this.addr,!1,_m),yn(e,i)}}function LS(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(_n(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),yn(e,t)}else{if(_n(e,i))return;xm.set(i),n.uniformMatrix3fv(this.addr,!1,xm),yn(e,i)}}function NS(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(_n(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),yn(e,t)}else{if(_n(e,i))return;gm.set(i),n.uniformMatrix4fv(this.addr,!1,gm),yn(e,i)}}function DS(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function US(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(_n(e,t))return;n.uniform2iv(this.addr,t),yn(e,t)}}function OS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(_n(e,t))return;n.uniform3iv(this.addr,t),yn(e,t)}}function FS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(_n(e,t))return;n.uniform4iv(this.addr,t),yn(e,t)}}function kS(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function BS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(_n(e,t))return;n.uniform2uiv(this.addr,t),yn(e,t)}}function zS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(_n(e,t))return;n.uniform3uiv(this.addr,t),yn(e,t)}}function VS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(_n(e,t))return;n.uniform4uiv(this.addr,t),yn(e,t)}}function Kc(n){return n.version===0&&(n.compareFunction=Jh,n.needsUpdate=!0),n}function GS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Kc(Om):r=Um,e.setTexture2D(t||r,s)}function HS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||Bm,s)}function WS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Kc(Fm):r=zm,e.setTextureCube(t||r,s)}function XS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||km,s)}function $S(n){switch(n){case 5126:return TS;case 35664:return CS;case 35665:return RS;case 35666:return PS;case 35674:return IS;case 35675:return LS;case 35676:return NS;case 5124:case 35670:return DS;case 35667:case 35671:return US;case 35668:case 35672:return OS;case 35669:case 35673:return FS;case 5125:return kS;case 36294:return BS;case 36295:return zS;case 36296:return VS;case 35678:case 36198:case 36298:case 36306:case 35682:return GS;case 35679:case 36299:case 36307:return HS;case 35680:case 36300:case 36308:case 36293:return WS;case 36289:case 36303:case 36311:case 36292:return XS}}function qS(n,t){n.uniform1fv(this.addr,t)}function YS(n,t){let e=po(t,this.size,2);n.uniform2fv(this.addr,e)}function ZS(n,t){let e=po(t,this.size,3);n.uniform3fv(this.addr,e)}function JS(n,t){let e=po(t,this.size,4);n.uniform4fv(this.addr,e)}function KS(n,t){let e=po(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function jS(n,t){let e=po(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function QS(n,t){let e=po(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function tM(n,t){n.uniform1iv(this.addr,t)}function eM(n,t){n.uniform2iv(this.addr,t)}function nM(n,t){n.uniform3iv(this.addr,t)}function iM(n,t){n.uniform4iv(this.addr,t)}function sM(n,t){n.uniform1uiv(this.addr,t)}function rM(n,t){n.uniform2uiv(this.addr,t)}function oM(n,t){n.uniform3uiv(this.addr,t)}function aM(n,t){n.uniform4uiv(this.addr,t)}function lM(n,t,e){let i=this.cache,s=t.length,r=Jc(e,s);_n(i,r)||(n.uniform1iv(this.addr,r),yn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Kc(Om):o=Um;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function cM(n,t,e){let i=this.cache,s=t.length,r=Jc(e,s);_n(i,r)||(n.uniform1iv(this.addr,r),yn(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||Bm,r[o])}function uM(n,t,e){let i=this.cache,s=t.length,r=Jc(e,s);_n(i,r)||(n.uniform1iv(this.addr,r),yn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Kc(Fm):o=zm;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function hM(n,t,e){let i=this.cache,s=t.length,r=Jc(e,s);_n(i,r)||(n.uniform1iv(this.addr,r),yn(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||km,r[o])}function dM(n){switch(n){case 5126:return qS;case 35664:return YS;case 35665:return ZS;case 35666:return JS;case 35674:return KS;case 35675:return jS;case 35676:return QS;case 5124:case 35670:return tM;case 35667:case 35671:return eM;case 35668:case 35672:return nM;case 35669:case 35673:return iM;case 5125:return sM;case 36294:return rM;case 36295:return oM;case 36296:return aM;case 35678:case 36198:case 36298:case 36306:case 35682:return lM;case 35679:case 36299:case 36307:return cM;case 35680:case 36300:case 36308:case 36293:return uM;case 36289:case 36303:case 36311:case 36292:return hM}}var cd=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=$S(e.type)}},ud=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=dM(e.type)}},hd=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},ad=/(\w+)(\])?(\[|\.)?/g;function ym(n,t){n.seq.push(t),n.map[t.id]=t}function fM(n,t,e){let i=n.name,s=i.length;for(ad.lastIndex=0;;){let r=ad.exec(i),o=ad.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){ym(e,c===void 0?new cd(a,n,t):new ud(a,n,t));break}else{let h=e.map[a];h===void 0&&(h=new hd(a),ym(e,h)),e=h}}}var fo=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);fM(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function vm(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var pM=37297,mM=0;function gM(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var bm=new ee;function xM(n){xe._getMatrix(bm,xe.workingColorSpace,n);let t=`mat3( ${bm.elements.map(e=>e.toFixed(4))} )`;switch(xe.getTransfer(n)){case ta:return[t,"LinearTransferOETF"];case Ae:return[t,"sRGBTransferOETF"];default:return $t("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function Sm(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+gM(n.getShaderSource(t),a)}else return r}function _M(n,t){let e=xM(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var yM={[Lh]:"Linear",[Nh]:"Reinhard",[Dh]:"Cineon",[Uh]:"ACESFilmic",[Fh]:"AgX",[kh]:"Neutral",[Oh]:"Custom"};function vM(n,t){let e=yM[t];return e===void 0?($t("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var qc=new W;function bM(){xe.getLuminanceCoefficients(qc);let n=qc.x.toFixed(4),t=qc.y.toFixed(4),e=qc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function SM(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ia).join(`
`)}function MM(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function wM(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function Ia(n){return n!==""}function Mm(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function wm(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var AM=/^[ \t]*#include +<([\w\d./]+)>/gm;function dd(n){return n.replace(AM,EM)}function EM(n,t){let e=ce[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return dd(e)}var TM=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Am(n){return n.replace(TM,CM)}function CM(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Em(n){let t=`precision ${n.precision} float;
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
#define LOW_PRECISION`),t}var RM={[ba]:"SHADOWMAP_TYPE_PCF",[ao]:"SHADOWMAP_TYPE_VSM"};function PM(n){return RM[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var IM={[co]:"ENVMAP_MODE_REFRACTION"};function LM(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":IM[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var NM={[sc]:"ENVMAP_BLENDING_MULTIPLY",[Gp]:"ENVMAP_BLENDING_MIX",[Hp]:"ENVMAP_BLENDING_ADD"};function DM(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":NM[n.combine]||"ENVMAP_BLENDING_NONE"}function UM(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=PM(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=LM(e),h=DM(e),d=SM(e),f=MM(r),p=s.createProgram(),_,g,m=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(_=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Ia).join(`
`),_.length>0&&(_+=`
`),g=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Ia).join(`
`),g.length>0&&(g+=`
`)):(_=[Em(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ia).join(`
`),g=[Em(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+h:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==Yi?"#define TONE_MAPPING":"",e.toneMapping!==Yi?ce.tonemapping_pars_fragment:"",e.toneMapping!==Yi?vM("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",ce.colorspace_pars_fragment,_M("linearToOutputTexel",e.outputColorSpace),bM(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Ia).join(`
`)),o=dd(o),o=Mm(o,e),o=wm(o,e),a=dd(a),a=Mm(a,e),a=wm(a,e),o=Am(o),a=Am(a),e.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,_=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+_,g=["#define varying in",e.glslVersion===Kh?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Kh?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let x=m+_+o,w=m+g+a,b=vm(s,s.VERTEX_SHADER,x),S=vm(s,s.FRAGMENT_SHADER,w);s.attachShader(p,b),s.attachShader(p,S),e.index0AttributeName!==void 0?s.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function M(L){if(n.debug.checkShaderErrors){let P=s.getProgramInfoLog(p)||"",F=s.getShaderInfoLog(b)||"",z=s.getShaderInfoLog(S)||"",U=P.trim(),G=F.trim(),$=z.trim(),H=!0,lt=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(H=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,b,S);else{let J=Sm(s,b,"vertex"),Q=Sm(s,S,"fragment");jt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+L.name+`
Material Type: `+L.type+`

Program Info Log: `+U+`
`+J+`
`+Q)}else U!==""?$t("WebGLProgram: Program Info Log:",U):(G===""||$==="")&&(lt=!1);lt&&(L.diagnostics={runnable:H,programLog:U,vertexShader:{log:G,prefix:_},fragmentShader:{log:$,prefix:g}})}s.deleteShader(b),s.deleteShader(S),y=new fo(s,p),A=wM(s,p)}let y;this.getUniforms=function(){return y===void 0&&M(this),y};let A;this.getAttributes=function(){return A===void 0&&M(this),A};let I=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return I===!1&&(I=s.getProgramParameter(p,pM)),I},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=mM++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=b,this.fragmentShader=S,this}var OM=0,fd=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new pd(t),e.set(t,i)),i}},pd=class{constructor(t){this.id=OM++,this.code=t,this.usedTimes=0}};function FM(n){return n===qs||n===Ta||n===Ca}function kM(n,t,e,i,s,r){let o=new eo,a=new fd,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(y){return l.add(y),y===0?"uv":`uv${y}`}function p(y,A,I,L,P,F){let z=L.fog,U=P.geometry,G=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?L.environment:null,$=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,H=t.get(y.envMap||G,$),lt=d[y.type],J=i.precision;y.precision!==null&&(J=i.getMaxPrecision(y.precision),J!==y.precision&&$t("WebGLProgram.getParameters:",y.precision,"not supported, using",J,"instead."));let Q=U.morphAttributes.position||U.morphAttributes.normal||U.morphAttributes.color,it=Q!==void 0?Q.length:0,ft=0;U.morphAttributes.position!==void 0&&(ft=1),U.morphAttributes.normal!==void 0&&(ft=2),U.morphAttributes.color!==void 0&&(ft=3);let dt,tt,ht,gt;if(lt){let Ct=Ji[lt];dt=Ct.vertexShader,tt=Ct.fragmentShader}else{dt=y.vertexShader,tt=y.fragmentShader;let Ct=a.getVertexShaderStage(y),oe=a.getFragmentShaderStage(y);a.update(y,Ct,oe),ht=Ct.id,gt=oe.id}let St=n.getRenderTarget(),Mt=n.state.buffers.depth.getReversed(),Ht=P.isInstancedMesh===!0,se=P.isBatchedMesh===!0,Vt=!!y.map,ue=!!y.matcap,ae=!!H,ne=ae&&H.isPMREMTexture===!0,Xe=!!y.aoMap,Fe=!!y.lightMap,an=!!y.bumpMap&&y.wireframe===!1,Le=!!y.normalMap,wn=!!y.displacementMap,ye=!!y.emissiveMap,mn=!!y.metalnessMap,Ze=!!y.roughnessMap,ln=y.anisotropy>0,B=y.clearcoat>0,Rt=y.diffuseRoughness>0,qt=y.dispersion>0,re=y.retroreflectivity>0,wt=y.iridescence>0,De=y.sheen>0,zt=y.transmission>0,Xt=ln&&!!y.anisotropyMap,N=B&&!!y.clearcoatMap,E=B&&!!y.clearcoatNormalMap,q=B&&!!y.clearcoatRoughnessMap,ut=Rt&&!!y.diffuseRoughnessMap,ot=wt&&!!y.iridescenceMap,_t=wt&&!!y.iridescenceThicknessMap,yt=De&&!!y.sheenColorMap,et=De&&!!y.sheenRoughnessMap,st=!!y.specularMap,mt=!!y.specularColorMap,k=!!y.specularIntensityMap,rt=zt&&!!y.transmissionMap,nt=zt&&!!y.thicknessMap,At=!!y.gradientMap,xt=!!y.alphaMap,bt=y.alphaTest>0,Gt=!!y.alphaHash,Jt=!!y.extensions,ct=Yi;y.toneMapped&&(St===null||St.isXRRenderTarget===!0)&&(ct=n.toneMapping);let Ft=ne?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,Kt={shaderID:lt,shaderType:y.type,shaderName:y.name,vertexShader:dt,fragmentShader:tt,defines:y.defines,customVertexShaderID:ht,customFragmentShaderID:gt,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:J,batching:se,batchingColor:se&&P._colorsTexture!==null,instancing:Ht,instancingColor:Ht&&P.instanceColor!==null,instancingMorph:Ht&&P.morphTexture!==null,outputColorSpace:St===null?n.outputColorSpace:St.isXRRenderTarget===!0?St.texture.colorSpace:xe.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:Vt,matcap:ue,envMap:ae,envMapMode:ae&&H.mapping,envMapPMREM:ne,envMapMaxLod:ne?Ft.length-1:null,envMapSize:ne?Ft[0].width:null,aoMap:Xe,lightMap:Fe,bumpMap:an,normalMap:Le,displacementMap:wn,emissiveMap:ye,normalMapObjectSpace:Le&&y.normalMapType===$p,normalMapTangentSpace:Le&&y.normalMapType===Xc,packedNormalMap:Le&&y.normalMapType===Xc&&FM(y.normalMap.format),metalnessMap:mn,roughnessMap:Ze,anisotropy:ln,anisotropyMap:Xt,clearcoat:B,clearcoatMap:N,clearcoatNormalMap:E,clearcoatRoughnessMap:q,diffuseRoughness:Rt,diffuseRoughnessMap:ut,dispersion:qt,retroreflection:re,iridescence:wt,iridescenceMap:ot,iridescenceThicknessMap:_t,sheen:De,sheenColorMap:yt,sheenRoughnessMap:et,specularMap:st,specularColorMap:mt,specularIntensityMap:k,transmission:zt,transmissionMap:rt,thicknessMap:nt,gradientMap:At,opaque:y.transparent===!1&&y.blending===lo&&y.alphaToCoverage===!1,alphaMap:xt,alphaTest:bt,alphaHash:Gt,combine:y.combine,mapUv:Vt&&f(y.map.channel),aoMapUv:Xe&&f(y.aoMap.channel),lightMapUv:Fe&&f(y.lightMap.channel),bumpMapUv:an&&f(y.bumpMap.channel),normalMapUv:Le&&f(y.normalMap.channel),displacementMapUv:wn&&f(y.displacementMap.channel),emissiveMapUv:ye&&f(y.emissiveMap.channel),metalnessMapUv:mn&&f(y.metalnessMap.channel),roughnessMapUv:Ze&&f(y.roughnessMap.channel),anisotropyMapUv:Xt&&f(y.anisotropyMap.channel),clearcoatMapUv:N&&f(y.clearcoatMap.channel),clearcoatNormalMapUv:E&&f(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&f(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ut&&f(y.diffuseRoughnessMap.channel),iridescenceMapUv:ot&&f(y.iridescenceMap.channel),iridescenceThicknessMapUv:_t&&f(y.iridescenceThicknessMap.channel),sheenColorMapUv:yt&&f(y.sheenColorMap.channel),sheenRoughnessMapUv:et&&f(y.sheenRoughnessMap.channel),specularMapUv:st&&f(y.specularMap.channel),specularColorMapUv:mt&&f(y.specularColorMap.channel),specularIntensityMapUv:k&&f(y.specularIntensityMap.channel),transmissionMapUv:rt&&f(y.transmissionMap.channel),thicknessMapUv:nt&&f(y.thicknessMap.channel),alphaMapUv:xt&&f(y.alphaMap.channel),vertexTangents:!!U.attributes.tangent&&(Le||ln),vertexNormals:!!U.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!U.attributes.color&&U.attributes.color.itemSize===4,pointsUvs:P.isPoints===!0&&!!U.attributes.uv&&(Vt||xt),fog:!!z,useFog:y.fog===!0,fogExp2:!!z&&z.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||U.attributes.normal===void 0&&Le===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:Mt,skinning:P.isSkinnedMesh===!0,hasPositionAttribute:U.attributes.position!==void 0,morphTargets:U.morphAttributes.position!==void 0,morphNormals:U.morphAttributes.normal!==void 0,morphColors:U.morphAttributes.color!==void 0,morphTargetsCount:it,morphTextureStride:ft,numSunLights:A.sun.length,numDirLights:A.directional.length,numPointLights:A.point.length,numSpotLights:A.spot.length,numSpotLightMaps:A.spotLightMap.length,numRectAreaLights:A.rectArea.length,numHemiLights:A.hemi.length,numSunLightShadows:A.sunShadowMap.length,numDirLightShadows:A.directionalShadowMap.length,numPointLightShadows:A.pointShadowMap.length,numSpotLightShadows:A.spotShadowMap.length,numSpotLightShadowsWithMaps:A.numSpotLightShadowsWithMaps,numLightProbes:A.numLightProbes,numLightProbeGrids:F.filter(Ct=>Ct.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:n.shadowMap.enabled&&I.length>0,shadowMapType:n.shadowMap.type,toneMapping:ct,decodeVideoTexture:Vt&&y.map.isVideoTexture===!0&&xe.getTransfer(y.map.colorSpace)===Ae,decodeVideoTextureEmissive:ye&&y.emissiveMap.isVideoTexture===!0&&xe.getTransfer(y.emissiveMap.colorSpace)===Ae,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===Bn,flipSided:y.side===Yn,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:Jt&&y.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Jt&&y.extensions.multiDraw===!0||se)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return Kt.vertexUv1s=l.has(1),Kt.vertexUv2s=l.has(2),Kt.vertexUv3s=l.has(3),l.clear(),Kt}function _(y){let A=[];if(y.shaderID?A.push(y.shaderID):(A.push(y.customVertexShaderID),A.push(y.customFragmentShaderID)),y.defines!==void 0)for(let I in y.defines)A.push(I),A.push(y.defines[I]);return y.isRawShaderMaterial===!1&&(g(A,y),m(A,y),A.push(n.outputColorSpace)),A.push(y.customProgramCacheKey),A.join()}function g(y,A){y.push(A.precision),y.push(A.outputColorSpace),y.push(A.envMapMode),y.push(A.envMapPMREM),y.push(A.envMapMaxLod),y.push(A.envMapSize),y.push(A.mapUv),y.push(A.alphaMapUv),y.push(A.lightMapUv),y.push(A.aoMapUv),y.push(A.bumpMapUv),y.push(A.normalMapUv),y.push(A.displacementMapUv),y.push(A.emissiveMapUv),y.push(A.metalnessMapUv),y.push(A.roughnessMapUv),y.push(A.anisotropyMapUv),y.push(A.clearcoatMapUv),y.push(A.clearcoatNormalMapUv),y.push(A.clearcoatRoughnessMapUv),y.push(A.diffuseRoughnessMapUv),y.push(A.iridescenceMapUv),y.push(A.iridescenceThicknessMapUv),y.push(A.sheenColorMapUv),y.push(A.sheenRoughnessMapUv),y.push(A.specularMapUv),y.push(A.specularColorMapUv),y.push(A.specularIntensityMapUv),y.push(A.transmissionMapUv),y.push(A.thicknessMapUv),y.push(A.combine),y.push(A.fogExp2),y.push(A.sizeAttenuation),y.push(A.morphTargetsCount),y.push(A.numSunLights),y.push(A.numDirLights),y.push(A.numPointLights),y.push(A.numSpotLights),y.push(A.numSpotLightMaps),y.push(A.numHemiLights),y.push(A.numRectAreaLights),y.push(A.numSunLightShadows),y.push(A.numDirLightShadows),y.push(A.numPointLightShadows),y.push(A.numSpotLightShadows),y.push(A.numSpotLightShadowsWithMaps),y.push(A.numLightProbes),y.push(A.numLightProbeGrids),y.push(A.shadowMapType),y.push(A.toneMapping),y.push(A.numClippingPlanes),y.push(A.numClipIntersection),y.push(A.depthPacking)}function m(y,A){o.disableAll(),A.instancing&&o.enable(0),A.instancingColor&&o.enable(1),A.instancingMorph&&o.enable(2),A.matcap&&o.enable(3),A.envMap&&o.enable(4),A.normalMapObjectSpace&&o.enable(5),A.normalMapTangentSpace&&o.enable(6),A.clearcoat&&o.enable(7),A.iridescence&&o.enable(8),A.alphaTest&&o.enable(9),A.vertexColors&&o.enable(10),A.vertexAlphas&&o.enable(11),A.vertexUv1s&&o.enable(12),A.vertexUv2s&&o.enable(13),A.vertexUv3s&&o.enable(14),A.vertexTangents&&o.enable(15),A.anisotropy&&o.enable(16),A.alphaHash&&o.enable(17),A.batching&&o.enable(18),A.dispersion&&o.enable(19),A.retroreflection&&o.enable(24),A.diffuseRoughness&&o.enable(25),A.batchingColor&&o.enable(20),A.gradientMap&&o.enable(21),A.packedNormalMap&&o.enable(22),A.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),A.fog&&o.enable(0),A.useFog&&o.enable(1),A.flatShading&&o.enable(2),A.logarithmicDepthBuffer&&o.enable(3),A.reversedDepthBuffer&&o.enable(4),A.skinning&&o.enable(5),A.morphTargets&&o.enable(6),A.morphNormals&&o.enable(7),A.morphColors&&o.enable(8),A.premultipliedAlpha&&o.enable(9),A.shadowMapEnabled&&o.enable(10),A.doubleSided&&o.enable(11),A.flipSided&&o.enable(12),A.useDepthPacking&&o.enable(13),A.dithering&&o.enable(14),A.transmission&&o.enable(15),A.sheen&&o.enable(16),A.opaque&&o.enable(17),A.pointsUvs&&o.enable(18),A.decodeVideoTexture&&o.enable(19),A.decodeVideoTextureEmissive&&o.enable(20),A.alphaToCoverage&&o.enable(21),A.numLightProbeGrids>0&&o.enable(22),A.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function x(y){let A=d[y.type],I;if(A){let L=Ji[A];I=am.clone(L.uniforms)}else I=y.uniforms;return I}function w(y,A){let I=u.get(A);return I!==void 0?++I.usedTimes:(I=new UM(n,A,y,s),c.push(I),u.set(A,I)),I}function b(y){if(--y.usedTimes===0){let A=c.indexOf(y);c[A]=c[c.length-1],c.pop(),u.delete(y.cacheKey),y.destroy()}}function S(y){a.remove(y)}function M(){a.dispose()}return{getParameters:p,getProgramCacheKey:_,getUniforms:x,acquireProgram:w,releaseProgram:b,releaseShaderCache:S,programs:c,dispose:M}}function BM(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function zM(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function Tm(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function Cm(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,_,g,m){let x=n[t];return x===void 0?(x={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:_,renderOrder:d.renderOrder,z:g,group:m},n[t]=x):(x.id=d.id,x.object=d,x.geometry=f,x.material=p,x.materialVariant=o(d),x.groupOrder=_,x.renderOrder=d.renderOrder,x.z=g,x.group=m),t++,x}function l(d,f,p,_,g,m,x){x.reversedDepth===!0&&(g=-g);let w=a(d,f,p,_,g,m);p.transmission>0?i.push(w):p.transparent===!0?s.push(w):e.push(w)}function c(d,f,p,_,g,m){let x=a(d,f,p,_,g,m);p.transmission>0?i.unshift(x):p.transparent===!0?s.unshift(x):e.unshift(x)}function u(d,f){e.length>1&&e.sort(d||zM),i.length>1&&i.sort(f||Tm),s.length>1&&s.sort(f||Tm)}function h(){for(let d=t,f=n.length;d<f;d++){let p=n[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function VM(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new Cm,n.set(i,[o])):s>=r.length?(o=new Cm,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function GM(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new W,color:new Qt};break;case"SpotLight":e={position:new W,direction:new W,color:new Qt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new W,color:new Qt,distance:0,decay:0};break;case"HemisphereLight":e={direction:new W,skyColor:new Qt,groundColor:new Qt};break;case"RectAreaLight":e={color:new Qt,position:new W,halfWidth:new W,halfHeight:new W};break}return n[t.id]=e,e}}}function HM(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Yt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Yt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Yt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var WM=0;function XM(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function $M(n){let t=new GM,e=HM(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new W);let s=new W,r=new pe,o=new pe;function a(c){let u=0,h=0,d=0;for(let F=0;F<9;F++)i.probe[F].set(0,0,0);let f=0,p=0,_=0,g=0,m=0,x=0,w=0,b=0,S=0,M=0,y=0,A=0,I=0,L=0;c.sort(XM);for(let F=0,z=c.length;F<z;F++){let U=c[F],G=U.color,$=U.intensity,H=U.distance,lt=null;if(U.shadow&&U.shadow.map&&(U.shadow.map.texture.format===qs?lt=U.shadow.map.texture:lt=U.shadow.map.depthTexture||U.shadow.map.texture),U.isAmbientLight)u+=G.r*$,h+=G.g*$,d+=G.b*$;else if(U.isLightProbe){for(let J=0;J<9;J++)i.probe[J].addScaledVector(U.sh.coefficients[J],$);L++}else if(U.isSunLight){let J=t.get(U);if(J.color.copy(U.color).multiplyScalar(U.intensity),U.castShadow){let Q=U.shadow,it=e.get(U);it.shadowIntensity=Q.intensity,it.shadowBias=Q.bias,it.shadowNormalBias=Q.normalBias,it.shadowRadius=Q.radius,it.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[p]=it,i.sunShadowMap[p]=lt;let ft=Q.getViewportCount();for(let dt=0;dt<ft;dt++)i.sunShadowMatrix[_+dt]=Q.getMatrix(dt),i.sunShadowCascade[_+dt]=Q._cascadeData[dt];_+=ft,p++}i.sun[f]=J,f++}else if(U.isDirectionalLight){let J=t.get(U);if(J.color.copy(U.color).multiplyScalar(U.intensity),U.castShadow){let Q=U.shadow,it=e.get(U);it.shadowIntensity=Q.intensity,it.shadowBias=Q.bias,it.shadowNormalBias=Q.normalBias,it.shadowRadius=Q.radius,it.shadowMapSize=Q.mapSize,i.directionalShadow[g]=it,i.directionalShadowMap[g]=lt,i.directionalShadowMatrix[g]=U.shadow.matrix,S++}i.directional[g]=J,g++}else if(U.isSpotLight){let J=t.get(U);J.position.setFromMatrixPosition(U.matrixWorld),J.color.copy(G).multiplyScalar($),J.distance=H,J.coneCos=Math.cos(U.angle),J.penumbraCos=Math.cos(U.angle*(1-U.penumbra)),J.decay=U.decay,i.spot[x]=J;let Q=U.shadow;if(U.map&&(i.spotLightMap[A]=U.map,A++,Q.updateMatrices(U),U.castShadow&&I++),i.spotLightMatrix[x]=Q.matrix,U.castShadow){let it=e.get(U);it.shadowIntensity=Q.intensity,it.shadowBias=Q.bias,it.shadowNormalBias=Q.normalBias,it.shadowRadius=Q.radius,it.shadowMapSize=Q.mapSize,i.spotShadow[x]=it,i.spotShadowMap[x]=lt,y++}x++}else if(U.isRectAreaLight){let J=t.get(U);J.color.copy(G).multiplyScalar($),J.halfWidth.set(U.width*.5,0,0),J.halfHeight.set(0,U.height*.5,0),i.rectArea[w]=J,w++}else if(U.isPointLight){let J=t.get(U);if(J.color.copy(U.color).multiplyScalar(U.intensity),J.distance=U.distance,J.decay=U.decay,U.castShadow){let Q=U.shadow,it=e.get(U);it.shadowIntensity=Q.intensity,it.shadowBias=Q.bias,it.shadowNormalBias=Q.normalBias,it.shadowRadius=Q.radius,it.shadowMapSize=Q.mapSize,it.shadowCameraNear=Q.camera.near,it.shadowCameraFar=Q.camera.far,i.pointShadow[m]=it,i.pointShadowMap[m]=lt,i.pointShadowMatrix[m]=U.shadow.matrix,M++}i.point[m]=J,m++}else if(U.isHemisphereLight){let J=t.get(U);J.skyColor.copy(U.color).multiplyScalar($),J.groundColor.copy(U.groundColor).multiplyScalar($),i.hemi[b]=J,b++}}w>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Lt.LTC_FLOAT_1,i.rectAreaLTC2=Lt.LTC_FLOAT_2):(i.rectAreaLTC1=Lt.LTC_HALF_1,i.rectAreaLTC2=Lt.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=d;let P=i.hash;(P.sunLength!==f||P.directionalLength!==g||P.pointLength!==m||P.spotLength!==x||P.rectAreaLength!==w||P.hemiLength!==b||P.numSunShadows!==p||P.numDirectionalShadows!==S||P.numPointShadows!==M||P.numSpotShadows!==y||P.numSpotMaps!==A||P.numLightProbes!==L)&&(i.sun.length=f,i.directional.length=g,i.spot.length=x,i.rectArea.length=w,i.point.length=m,i.hemi.length=b,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=_,i.sunShadowCascade.length=_,i.directionalShadow.length=S,i.directionalShadowMap.length=S,i.directionalShadowMatrix.length=S,i.pointShadow.length=M,i.pointShadowMap.length=M,i.pointShadowMatrix.length=M,i.spotShadow.length=y,i.spotShadowMap.length=y,i.spotLightMatrix.length=y+A-I,i.spotLightMap.length=A,i.numSpotLightShadowsWithMaps=I,i.numLightProbes=L,P.sunLength=f,P.directionalLength=g,P.pointLength=m,P.spotLength=x,P.rectAreaLength=w,P.hemiLength=b,P.numSunShadows=p,P.numDirectionalShadows=S,P.numPointShadows=M,P.numSpotShadows=y,P.numSpotMaps=A,P.numLightProbes=L,i.version=WM++)}function l(c,u){let h=0,d=0,f=0,p=0,_=0,g=0,m=u.matrixWorldInverse;for(let x=0,w=c.length;x<w;x++){let b=c[x];if(b.isSunLight){let S=i.sun[h];S.direction.setFromMatrixPosition(b.matrixWorld),S.direction.transformDirection(m),h++}else if(b.isDirectionalLight){let S=i.directional[d];S.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),S.direction.sub(s),S.direction.transformDirection(m),d++}else if(b.isSpotLight){let S=i.spot[p];S.position.setFromMatrixPosition(b.matrixWorld),S.position.applyMatrix4(m),S.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),S.direction.sub(s),S.direction.transformDirection(m),p++}else if(b.isRectAreaLight){let S=i.rectArea[_];S.position.setFromMatrixPosition(b.matrixWorld),S.position.applyMatrix4(m),o.identity(),r.copy(b.matrixWorld),r.premultiply(m),o.extractRotation(r),S.halfWidth.set(b.width*.5,0,0),S.halfHeight.set(0,b.height*.5,0),S.halfWidth.applyMatrix4(o),S.halfHeight.applyMatrix4(o),_++}else if(b.isPointLight){let S=i.point[f];S.position.setFromMatrixPosition(b.matrixWorld),S.position.applyMatrix4(m),f++}else if(b.isHemisphereLight){let S=i.hemi[g];S.direction.setFromMatrixPosition(b.matrixWorld),S.direction.transformDirection(m),g++}}}return{setup:a,setupView:l,state:i}}function Rm(n){let t=new $M(n),e=[],i=[],s=[];function r(h){u.camera=h,e.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):e.push(h)}function a(h){i.push(h)}function l(){t.setup(e),s.sort((h,d)=>h.priority-d.priority||h.id-d.id)}function c(h){t.setupView(e,h)}let u={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function qM(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new Rm(n),t.set(s,[a])):r>=o.length?(a=new Rm(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var YM=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,ZM=`uniform sampler2D shadow_pass;
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
}`,JM=[new W(1,0,0),new W(-1,0,0),new W(0,1,0),new W(0,-1,0),new W(0,0,1),new W(0,0,-1)],KM=[new W(0,-1,0),new W(0,-1,0),new W(0,0,1),new W(0,0,-1),new W(0,-1,0),new W(0,-1,0)],Pm=new pe,Pa=new W,ld=new W;function jM(n,t,e){let i=new Bs,s=new Yt,r=new Yt,o=new qe,a=new Wl,l=new Xl,c={},u=e.maxTextureSize,h={[$s]:Yn,[Yn]:$s,[Bn]:Bn},d=new qi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Yt},radius:{value:4}},vertexShader:YM,fragmentShader:ZM}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new xn;p.setAttribute("position",new rn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new Nn(p,d),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=ba;let m=this.type;this.render=function(M,y,A){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||M.length===0)return;this.type===Mp&&($t("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=ba);let I=n.getRenderTarget(),L=n.getActiveCubeFace(),P=n.getActiveMipmapLevel(),F=n.state;F.setBlending(ur),F.buffers.depth.getReversed()===!0?F.buffers.color.setClear(0,0,0,0):F.buffers.color.setClear(1,1,1,1),F.buffers.depth.setTest(!0),F.setScissorTest(!1);let z=m!==this.type;z&&y.traverse(function(U){U.material&&(Array.isArray(U.material)?U.material.forEach(G=>G.needsUpdate=!0):U.material.needsUpdate=!0)});for(let U=0,G=M.length;U<G;U++){let $=M[U],H=$.shadow;if(H===void 0){$t("WebGLShadowMap:",$,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let lt=H.getFrameExtents();s.multiply(lt),r.copy(H.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/lt.x),s.x=r.x*lt.x,H.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/lt.y),s.y=r.y*lt.y,H.mapSize.y=r.y));let J=n.state.buffers.depth.getReversed();if(H.camera._reversedDepth=J,H.map===null||z===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===ao){if($.isPointLight){$t("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new li(s.x,s.y,{format:qs,type:Pi,minFilter:qn,magFilter:qn,generateMipmaps:!1}),H.map.texture.name=$.name+".shadowMap",H.map.depthTexture=new ms(s.x,s.y,_i),H.map.depthTexture.name=$.name+".shadowMapDepth",H.map.depthTexture.format=hs,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Pn,H.map.depthTexture.magFilter=Pn}else $.isPointLight?(H.map=new La(s.x),H.map.depthTexture=new ca(s.x,Ri)):(H.map=new li(s.x,s.y),H.map.depthTexture=new ms(s.x,s.y,Ri)),H.map.depthTexture.name=$.name+".shadowMap",H.map.depthTexture.format=hs,this.type===ba?(H.map.depthTexture.compareFunction=J?Zh:Yh,H.map.depthTexture.minFilter=qn,H.map.depthTexture.magFilter=qn):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Pn,H.map.depthTexture.magFilter=Pn);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==s.x||H.map.height!==s.y)&&H.map.setSize(s.x,s.y);let Q=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();$.isPointLight!==!0&&H.updateMatrices($,A);let it=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:A.layers;for(let ft=0;ft<Q;ft++){let dt=H.getCamera(ft);if($.isPointLight){let tt=H.camera,ht=H.matrix,gt=$.distance||tt.far;gt!==tt.far&&(tt.far=gt,tt.updateProjectionMatrix()),Pa.setFromMatrixPosition($.matrixWorld),tt.position.copy(Pa),ld.copy(tt.position),ld.add(JM[ft]),tt.up.copy(KM[ft]),tt.lookAt(ld),tt.updateMatrixWorld(),ht.makeTranslation(-Pa.x,-Pa.y,-Pa.z),Pm.multiplyMatrices(tt.projectionMatrix,tt.matrixWorldInverse),H._frustum.setFromProjectionMatrix(Pm,tt.coordinateSystem,tt.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)n.setRenderTarget(H.map,ft),n.clear();else{ft===0&&(n.setRenderTarget(H.map),n.clear());let tt=H.getViewport(ft);o.set(r.x*tt.x,r.y*tt.y,r.x*tt.z,r.y*tt.w),F.viewport(o)}i=H.getFrustum(ft),b(y,A,dt,$,it,this.type)}H.isPointLightShadow!==!0&&this.type===ao&&x(H,A),H.needsUpdate=!1}m=this.type,g.needsUpdate=!1,n.setRenderTarget(I,L,P)};function x(M,y){let A=t.update(_);d.defines.VSM_SAMPLES!==M.blurSamples&&(d.defines.VSM_SAMPLES=M.blurSamples,f.defines.VSM_SAMPLES=M.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),M.mapPass===null?M.mapPass=new li(s.x,s.y,{format:qs,type:Pi}):(M.mapPass.width!==M.map.width||M.mapPass.height!==M.map.height)&&M.mapPass.setSize(M.map.width,M.map.height),d.uniforms.shadow_pass.value=M.map.depthTexture,d.uniforms.resolution.value.set(M.map.width,M.map.height),d.uniforms.radius.value=M.radius,n.setRenderTarget(M.mapPass),n.clear(),n.renderBufferDirect(y,null,A,d,_,null),f.uniforms.shadow_pass.value=M.mapPass.texture,f.uniforms.resolution.value.set(M.map.width,M.map.height),f.uniforms.radius.value=M.radius,n.setRenderTarget(M.map),n.clear(),n.renderBufferDirect(y,null,A,f,_,null)}function w(M,y,A,I){let L=null,P=A.isPointLight===!0?M.customDistanceMaterial:M.customDepthMaterial;if(P!==void 0)L=P;else if(L=A.isPointLight===!0?l:a,n.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let F=L.uuid,z=y.uuid,U=c[F];U===void 0&&(U={},c[F]=U);let G=U[z];G===void 0&&(G=L.clone(),U[z]=G,y.addEventListener("dispose",S)),L=G}if(L.visible=y.visible,L.wireframe=y.wireframe,I===ao?L.side=y.shadowSide!==null?y.shadowSide:y.side:L.side=y.shadowSide!==null?y.shadowSide:h[y.side],L.alphaMap=y.alphaMap,L.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,L.map=y.map,L.clipShadows=y.clipShadows,L.clippingPlanes=y.clippingPlanes,L.clipIntersection=y.clipIntersection,L.displacementMap=y.displacementMap,L.displacementScale=y.displacementScale,L.displacementBias=y.displacementBias,L.wireframeLinewidth=y.wireframeLinewidth,L.linewidth=y.linewidth,A.isPointLight===!0&&L.isMeshDistanceMaterial===!0){let F=n.properties.get(L);F.light=A}return L}function b(M,y,A,I,L,P){if(M.visible===!1)return;if(M.layers.test(L)&&(M.isMesh||M.isLine||M.isPoints)&&(M.castShadow||M.receiveShadow&&P===ao)&&(!M.frustumCulled||M.intersectsFrustum(i))){M.modelViewMatrix.multiplyMatrices(A.matrixWorldInverse,M.matrixWorld);let U=t.update(M),G=M.material;if(Array.isArray(G)){let $=U.groups;for(let H=0,lt=$.length;H<lt;H++){let J=$[H],Q=G[J.materialIndex];if(Q&&Q.visible){let it=w(M,Q,I,P);M.onBeforeShadow(n,M,y,A,U,it,J),n.renderBufferDirect(A,null,U,it,M,J),M.onAfterShadow(n,M,y,A,U,it,J)}}}else if(G.visible){let $=w(M,G,I,P);M.onBeforeShadow(n,M,y,A,U,$,null),n.renderBufferDirect(A,null,U,$,M,null),M.onAfterShadow(n,M,y,A,U,$,null)}}let z=M.children;for(let U=0,G=z.length;U<G;U++)b(z[U],y,A,I,L,P)}function S(M){M.target.removeEventListener("dispose",S);for(let A in c){let I=c[A],L=M.target.uuid;L in I&&(I[L].dispose(),delete I[L])}}}function QM(n,t){function e(){let k=!1,rt=new qe,nt=null,At=new qe(0,0,0,0);return{setMask:function(xt){nt!==xt&&!k&&(n.colorMask(xt,xt,xt,xt),nt=xt)},setLocked:function(xt){k=xt},setClear:function(xt,bt,Gt,Jt,ct){ct===!0&&(xt*=Jt,bt*=Jt,Gt*=Jt),rt.set(xt,bt,Gt,Jt),At.equals(rt)===!1&&(n.clearColor(xt,bt,Gt,Jt),At.copy(rt))},reset:function(){k=!1,nt=null,At.set(-1,0,0,0)}}}function i(){let k=!1,rt=!1,nt=null,At=null,xt=null;return{setReversed:function(bt){if(rt!==bt){let Gt=t.get("EXT_clip_control");bt?Gt.clipControlEXT(Gt.LOWER_LEFT_EXT,Gt.ZERO_TO_ONE_EXT):Gt.clipControlEXT(Gt.LOWER_LEFT_EXT,Gt.NEGATIVE_ONE_TO_ONE_EXT),rt=bt;let Jt=xt;xt=null,this.setClear(Jt)}},getReversed:function(){return rt},setTest:function(bt){bt?Mt(n.DEPTH_TEST):Ht(n.DEPTH_TEST)},setMask:function(bt){nt!==bt&&!k&&(n.depthMask(bt),nt=bt)},setFunc:function(bt){if(rt&&(bt=im[bt]),At!==bt){switch(bt){case El:n.depthFunc(n.NEVER);break;case Tl:n.depthFunc(n.ALWAYS);break;case Cl:n.depthFunc(n.LESS);break;case Jr:n.depthFunc(n.LEQUAL);break;case Rl:n.depthFunc(n.EQUAL);break;case Pl:n.depthFunc(n.GEQUAL);break;case Il:n.depthFunc(n.GREATER);break;case Ll:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}At=bt}},setLocked:function(bt){k=bt},setClear:function(bt){xt!==bt&&(xt=bt,rt&&(bt=1-bt),n.clearDepth(bt))},reset:function(){k=!1,nt=null,At=null,xt=null,rt=!1}}}function s(){let k=!1,rt=null,nt=null,At=null,xt=null,bt=null,Gt=null,Jt=null,ct=null;return{setTest:function(Ft){k||(Ft?Mt(n.STENCIL_TEST):Ht(n.STENCIL_TEST))},setMask:function(Ft){rt!==Ft&&!k&&(n.stencilMask(Ft),rt=Ft)},setFunc:function(Ft,Kt,Ct){(nt!==Ft||At!==Kt||xt!==Ct)&&(n.stencilFunc(Ft,Kt,Ct),nt=Ft,At=Kt,xt=Ct)},setOp:function(Ft,Kt,Ct){(bt!==Ft||Gt!==Kt||Jt!==Ct)&&(n.stencilOp(Ft,Kt,Ct),bt=Ft,Gt=Kt,Jt=Ct)},setLocked:function(Ft){k=Ft},setClear:function(Ft){ct!==Ft&&(n.clearStencil(Ft),ct=Ft)},reset:function(){k=!1,rt=null,nt=null,At=null,xt=null,bt=null,Gt=null,Jt=null,ct=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,u={},h={},d={},f=new WeakMap,p=[],_=null,g=!1,m=null,x=null,w=null,b=null,S=null,M=null,y=null,A=new Qt(0,0,0),I=0,L=!1,P=null,F=null,z=null,U=null,G=null,$=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,lt=0,J=n.getParameter(n.VERSION);J.indexOf("WebGL")!==-1?(lt=parseFloat(/^WebGL (\d)/.exec(J)[1]),H=lt>=1):J.indexOf("OpenGL ES")!==-1&&(lt=parseFloat(/^OpenGL ES (\d)/.exec(J)[1]),H=lt>=2);let Q=null,it={},ft=n.getParameter(n.SCISSOR_BOX),dt=n.getParameter(n.VIEWPORT),tt=new qe().fromArray(ft),ht=new qe().fromArray(dt);function gt(k,rt,nt,At){let xt=new Uint8Array(4),bt=n.createTexture();n.bindTexture(k,bt),n.texParameteri(k,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(k,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Gt=0;Gt<nt;Gt++)k===n.TEXTURE_3D||k===n.TEXTURE_2D_ARRAY?n.texImage3D(rt,0,n.RGBA,1,1,At,0,n.RGBA,n.UNSIGNED_BYTE,xt):n.texImage2D(rt+Gt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,xt);return bt}let St={};St[n.TEXTURE_2D]=gt(n.TEXTURE_2D,n.TEXTURE_2D,1),St[n.TEXTURE_CUBE_MAP]=gt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),St[n.TEXTURE_2D_ARRAY]=gt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),St[n.TEXTURE_3D]=gt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Mt(n.DEPTH_TEST),o.setFunc(Jr),an(!1),Le(Eh),Mt(n.CULL_FACE),Xe(ur);function Mt(k){u[k]!==!0&&(n.enable(k),u[k]=!0)}function Ht(k){u[k]!==!1&&(n.disable(k),u[k]=!1)}function se(k,rt){return d[k]!==rt?(n.bindFramebuffer(k,rt),d[k]=rt,k===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=rt),k===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=rt),!0):!1}function Vt(k,rt){let nt=p,At=!1;if(k){nt=f.get(rt),nt===void 0&&(nt=[],f.set(rt,nt));let xt=k.textures;if(nt.length!==xt.length||nt[0]!==n.COLOR_ATTACHMENT0){for(let bt=0,Gt=xt.length;bt<Gt;bt++)nt[bt]=n.COLOR_ATTACHMENT0+bt;nt.length=xt.length,At=!0}}else nt[0]!==n.BACK&&(nt[0]=n.BACK,At=!0);At&&n.drawBuffers(nt)}function ue(k){return _!==k?(n.useProgram(k),_=k,!0):!1}let ae={[hr]:n.FUNC_ADD,[Ap]:n.FUNC_SUBTRACT,[Ep]:n.FUNC_REVERSE_SUBTRACT};ae[Tp]=n.MIN,ae[Cp]=n.MAX;let ne={[Rp]:n.ZERO,[Pp]:n.ONE,[Ip]:n.SRC_COLOR,[Ph]:n.SRC_ALPHA,[Fp]:n.SRC_ALPHA_SATURATE,[Up]:n.DST_COLOR,[Np]:n.DST_ALPHA,[Lp]:n.ONE_MINUS_SRC_COLOR,[Ih]:n.ONE_MINUS_SRC_ALPHA,[Op]:n.ONE_MINUS_DST_COLOR,[Dp]:n.ONE_MINUS_DST_ALPHA,[kp]:n.CONSTANT_COLOR,[Bp]:n.ONE_MINUS_CONSTANT_COLOR,[zp]:n.CONSTANT_ALPHA,[Vp]:n.ONE_MINUS_CONSTANT_ALPHA};function Xe(k,rt,nt,At,xt,bt,Gt,Jt,ct,Ft){if(k===ur){g===!0&&(Ht(n.BLEND),g=!1);return}if(g===!1&&(Mt(n.BLEND),g=!0),k!==wp){if(k!==m||Ft!==L){if((x!==hr||S!==hr)&&(n.blendEquation(n.FUNC_ADD),x=hr,S=hr),Ft)switch(k){case lo:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Th:n.blendFunc(n.ONE,n.ONE);break;case Ch:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Rh:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:jt("WebGLState: Invalid blending: ",k);break}else switch(k){case lo:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Th:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Ch:jt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Rh:jt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:jt("WebGLState: Invalid blending: ",k);break}w=null,b=null,M=null,y=null,A.set(0,0,0),I=0,m=k,L=Ft}return}xt=xt||rt,bt=bt||nt,Gt=Gt||At,(rt!==x||xt!==S)&&(n.blendEquationSeparate(ae[rt],ae[xt]),x=rt,S=xt),(nt!==w||At!==b||bt!==M||Gt!==y)&&(n.blendFuncSeparate(ne[nt],ne[At],ne[bt],ne[Gt]),w=nt,b=At,M=bt,y=Gt),(Jt.equals(A)===!1||ct!==I)&&(n.blendColor(Jt.r,Jt.g,Jt.b,ct),A.copy(Jt),I=ct),m=k,L=!1}function Fe(k,rt){k.side===Bn?Ht(n.CULL_FACE):Mt(n.CULL_FACE);let nt=k.side===Yn;rt&&(nt=!nt),an(nt),k.blending===lo&&k.transparent===!1?Xe(ur):Xe(k.blending,k.blendEquation,k.blendSrc,k.blendDst,k.blendEquationAlpha,k.blendSrcAlpha,k.blendDstAlpha,k.blendColor,k.blendAlpha,k.premultipliedAlpha),o.setFunc(k.depthFunc),o.setTest(k.depthTest),o.setMask(k.depthWrite),r.setMask(k.colorWrite);let At=k.stencilWrite;a.setTest(At),At&&(a.setMask(k.stencilWriteMask),a.setFunc(k.stencilFunc,k.stencilRef,k.stencilFuncMask),a.setOp(k.stencilFail,k.stencilZFail,k.stencilZPass)),ye(k.polygonOffset,k.polygonOffsetFactor,k.polygonOffsetUnits),k.alphaToCoverage===!0?Mt(n.SAMPLE_ALPHA_TO_COVERAGE):Ht(n.SAMPLE_ALPHA_TO_COVERAGE)}function an(k){P!==k&&(k?n.frontFace(n.CW):n.frontFace(n.CCW),P=k)}function Le(k){k!==bp?(Mt(n.CULL_FACE),k!==F&&(k===Eh?n.cullFace(n.BACK):k===Sp?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Ht(n.CULL_FACE),F=k}function wn(k){k!==z&&(H&&n.lineWidth(k),z=k)}function ye(k,rt,nt){k?(Mt(n.POLYGON_OFFSET_FILL),(U!==rt||G!==nt)&&(U=rt,G=nt,o.getReversed()&&(rt=-rt,nt=-nt),n.polygonOffset(rt,nt))):Ht(n.POLYGON_OFFSET_FILL)}function mn(k){k?Mt(n.SCISSOR_TEST):Ht(n.SCISSOR_TEST)}function Ze(k){k===void 0&&(k=n.TEXTURE0+$-1),Q!==k&&(n.activeTexture(k),Q=k)}function ln(k,rt,nt){nt===void 0&&(Q===null?nt=n.TEXTURE0+$-1:nt=Q);let At=it[nt];At===void 0&&(At={type:void 0,texture:void 0},it[nt]=At),(At.type!==k||At.texture!==rt)&&(Q!==nt&&(n.activeTexture(nt),Q=nt),n.bindTexture(k,rt||St[k]),At.type=k,At.texture=rt)}function B(){let k=it[Q];k!==void 0&&k.type!==void 0&&(n.bindTexture(k.type,null),k.type=void 0,k.texture=void 0)}function Rt(){try{n.compressedTexImage2D(...arguments)}catch(k){jt("WebGLState:",k)}}function qt(){try{n.compressedTexImage3D(...arguments)}catch(k){jt("WebGLState:",k)}}function re(){try{n.texSubImage2D(...arguments)}catch(k){jt("WebGLState:",k)}}function wt(){try{n.texSubImage3D(...arguments)}catch(k){jt("WebGLState:",k)}}function De(){try{n.compressedTexSubImage2D(...arguments)}catch(k){jt("WebGLState:",k)}}function zt(){try{n.compressedTexSubImage3D(...arguments)}catch(k){jt("WebGLState:",k)}}function Xt(){try{n.texStorage2D(...arguments)}catch(k){jt("WebGLState:",k)}}function N(){try{n.texStorage3D(...arguments)}catch(k){jt("WebGLState:",k)}}function E(){try{n.texImage2D(...arguments)}catch(k){jt("WebGLState:",k)}}function q(){try{n.texImage3D(...arguments)}catch(k){jt("WebGLState:",k)}}function ut(k){return h[k]!==void 0?h[k]:n.getParameter(k)}function ot(k,rt){h[k]!==rt&&(n.pixelStorei(k,rt),h[k]=rt)}function _t(k){tt.equals(k)===!1&&(n.scissor(k.x,k.y,k.z,k.w),tt.copy(k))}function yt(k){ht.equals(k)===!1&&(n.viewport(k.x,k.y,k.z,k.w),ht.copy(k))}function et(k,rt){let nt=c.get(rt);nt===void 0&&(nt=new WeakMap,c.set(rt,nt));let At=nt.get(k);At===void 0&&(At=n.getUniformBlockIndex(rt,k.name),n.uniformBlockBinding(rt,At,At),nt.set(k,At))}function st(k,rt,nt){let xt=c.get(rt).get(k);l[xt]!==nt&&(n.bindBufferBase(n.UNIFORM_BUFFER,xt,nt),l[xt]=nt)}function mt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},Q=null,it={},d={},l={},f=new WeakMap,p=[],_=null,g=!1,m=null,x=null,w=null,b=null,S=null,M=null,y=null,A=new Qt(0,0,0),I=0,L=!1,P=null,F=null,z=null,U=null,G=null,tt.set(0,0,n.canvas.width,n.canvas.height),ht.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Mt,disable:Ht,bindFramebuffer:se,drawBuffers:Vt,useProgram:ue,setBlending:Xe,setMaterial:Fe,setFlipSided:an,setCullFace:Le,setLineWidth:wn,setPolygonOffset:ye,setScissorTest:mn,activeTexture:Ze,bindTexture:ln,unbindTexture:B,compressedTexImage2D:Rt,compressedTexImage3D:qt,texImage2D:E,texImage3D:q,pixelStorei:ot,getParameter:ut,updateUBOMapping:et,uniformBlockBinding:st,texStorage2D:Xt,texStorage3D:N,texSubImage2D:re,texSubImage3D:wt,compressedTexSubImage2D:De,compressedTexSubImage3D:zt,scissor:_t,viewport:yt,reset:mt}}function tw(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Yt,u=new WeakMap,h=new Set,d,f=new WeakMap,p=new Set,_=new FinalizationRegistry(N=>p.delete(N)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(N,E){return g?new OffscreenCanvas(N,E):ea("canvas")}function x(N,E,q){let ut=1,ot=Xt(N);if((ot.width>q||ot.height>q)&&(ut=q/Math.max(ot.width,ot.height)),ut<1)if(typeof HTMLImageElement<"u"&&N instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&N instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&N instanceof ImageBitmap||typeof VideoFrame<"u"&&N instanceof VideoFrame){let _t=Math.floor(ut*ot.width),yt=Math.floor(ut*ot.height);d===void 0&&(d=m(_t,yt));let et=E?m(_t,yt):d;return et.width=_t,et.height=yt,et.getContext("2d").drawImage(N,0,0,_t,yt),$t("WebGLRenderer: Texture has been resized from ("+ot.width+"x"+ot.height+") to ("+_t+"x"+yt+")."),et}else return"data"in N&&$t("WebGLRenderer: Image in DataTexture is too big ("+ot.width+"x"+ot.height+")."),N;return N}function w(N){return N.generateMipmaps}function b(N){n.generateMipmap(N)}function S(N){return N.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:N.isWebGL3DRenderTarget?n.TEXTURE_3D:N.isWebGLArrayRenderTarget||N.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function M(N,E,q,ut,ot,_t=!1){if(N!==null){if(n[N]!==void 0)return n[N];$t("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+N+"'")}let yt;ut&&(yt=t.get("EXT_texture_norm16"),yt||$t("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let et=E;if(E===n.RED&&(q===n.FLOAT&&(et=n.R32F),q===n.HALF_FLOAT&&(et=n.R16F),q===n.UNSIGNED_BYTE&&(et=n.R8),q===n.UNSIGNED_SHORT&&yt&&(et=yt.R16_EXT),q===n.SHORT&&yt&&(et=yt.R16_SNORM_EXT)),E===n.RED_INTEGER&&(q===n.UNSIGNED_BYTE&&(et=n.R8UI),q===n.UNSIGNED_SHORT&&(et=n.R16UI),q===n.UNSIGNED_INT&&(et=n.R32UI),q===n.BYTE&&(et=n.R8I),q===n.SHORT&&(et=n.R16I),q===n.INT&&(et=n.R32I)),E===n.RG&&(q===n.FLOAT&&(et=n.RG32F),q===n.HALF_FLOAT&&(et=n.RG16F),q===n.UNSIGNED_BYTE&&(et=n.RG8),q===n.UNSIGNED_SHORT&&yt&&(et=yt.RG16_EXT),q===n.SHORT&&yt&&(et=yt.RG16_SNORM_EXT)),E===n.RG_INTEGER&&(q===n.UNSIGNED_BYTE&&(et=n.RG8UI),q===n.UNSIGNED_SHORT&&(et=n.RG16UI),q===n.UNSIGNED_INT&&(et=n.RG32UI),q===n.BYTE&&(et=n.RG8I),q===n.SHORT&&(et=n.RG16I),q===n.INT&&(et=n.RG32I)),E===n.RGB_INTEGER&&(q===n.UNSIGNED_BYTE&&(et=n.RGB8UI),q===n.UNSIGNED_SHORT&&(et=n.RGB16UI),q===n.UNSIGNED_INT&&(et=n.RGB32UI),q===n.BYTE&&(et=n.RGB8I),q===n.SHORT&&(et=n.RGB16I),q===n.INT&&(et=n.RGB32I)),E===n.RGBA_INTEGER&&(q===n.UNSIGNED_BYTE&&(et=n.RGBA8UI),q===n.UNSIGNED_SHORT&&(et=n.RGBA16UI),q===n.UNSIGNED_INT&&(et=n.RGBA32UI),q===n.BYTE&&(et=n.RGBA8I),q===n.SHORT&&(et=n.RGBA16I),q===n.INT&&(et=n.RGBA32I)),E===n.RGB&&(q===n.UNSIGNED_SHORT&&yt&&(et=yt.RGB16_EXT),q===n.SHORT&&yt&&(et=yt.RGB16_SNORM_EXT),q===n.UNSIGNED_INT_5_9_9_9_REV&&(et=n.RGB9_E5),q===n.UNSIGNED_INT_10F_11F_11F_REV&&(et=n.R11F_G11F_B10F)),E===n.RGBA){let st=_t?ta:xe.getTransfer(ot);q===n.FLOAT&&(et=n.RGBA32F),q===n.HALF_FLOAT&&(et=n.RGBA16F),q===n.UNSIGNED_BYTE&&(et=st===Ae?n.SRGB8_ALPHA8:n.RGBA8),q===n.UNSIGNED_SHORT&&yt&&(et=yt.RGBA16_EXT),q===n.SHORT&&yt&&(et=yt.RGBA16_SNORM_EXT),q===n.UNSIGNED_SHORT_4_4_4_4&&(et=n.RGBA4),q===n.UNSIGNED_SHORT_5_5_5_1&&(et=n.RGB5_A1)}return(et===n.R16F||et===n.R32F||et===n.RG16F||et===n.RG32F||et===n.RGBA16F||et===n.RGBA32F)&&t.get("EXT_color_buffer_float"),et}function y(N,E){let q;return N?E===null||E===Ri||E===fr?q=n.DEPTH24_STENCIL8:E===_i?q=n.DEPTH32F_STENCIL8:E===uo&&(q=n.DEPTH24_STENCIL8,$t("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):E===null||E===Ri||E===fr?q=n.DEPTH_COMPONENT24:E===_i?q=n.DEPTH_COMPONENT32F:E===uo&&(q=n.DEPTH_COMPONENT16),q}function A(N,E){return w(N)===!0||N.isFramebufferTexture&&N.minFilter!==Pn&&N.minFilter!==qn?Math.log2(Math.max(E.width,E.height))+1:N.mipmaps.length>0?N.mipmaps.length:N.isCompressedTexture&&Array.isArray(N.image)?E.mipmaps.length:1}function I(N){let E=new WeakRef(N);i.get(N).__ref=E,p.add(E),_.register(N,E,E)}function L(N){let E=i.get(N).__ref;E!==void 0&&(p.delete(E),_.unregister(E))}function P(N){z(N.target)}function F(N){U(N.target)}function z(N){N.removeEventListener("dispose",P),L(N),$(N),N.isVideoTexture&&u.delete(N),N.isHTMLTexture&&h.delete(N)}function U(N){N.removeEventListener("dispose",F),L(N),lt(N)}function G(){for(let N of p){let E=N.deref();E!==void 0&&(E.isRenderTarget===!0?U(E):z(E))}p.clear(),h.clear()}function $(N){let E=i.get(N);if(E.__webglInit===void 0)return;let q=N.source,ut=f.get(q);if(ut){let ot=ut[E.__cacheKey];ot.usedTimes--,ot.usedTimes===0&&H(N),Object.keys(ut).length===0&&f.delete(q)}i.remove(N)}function H(N){let E=i.get(N);n.deleteTexture(E.__webglTexture);let q=N.source,ut=f.get(q);delete ut[E.__cacheKey],o.memory.textures--}function lt(N){let E=i.get(N);E.__depthDisposeCallback&&E.__depthDisposeCallback();let q=N.depthTexture;if(q&&q.renderTarget===N&&z(q),N.isWebGLCubeRenderTarget)for(let ot=0;ot<6;ot++){if(Array.isArray(E.__webglFramebuffer[ot]))for(let _t=0;_t<E.__webglFramebuffer[ot].length;_t++)n.deleteFramebuffer(E.__webglFramebuffer[ot][_t]);else n.deleteFramebuffer(E.__webglFramebuffer[ot]);E.__webglDepthbuffer&&n.deleteRenderbuffer(E.__webglDepthbuffer[ot])}else{if(Array.isArray(E.__webglFramebuffer))for(let ot=0;ot<E.__webglFramebuffer.length;ot++)n.deleteFramebuffer(E.__webglFramebuffer[ot]);else n.deleteFramebuffer(E.__webglFramebuffer);if(E.__webglDepthbuffer&&n.deleteRenderbuffer(E.__webglDepthbuffer),E.__webglMultisampledFramebuffer&&n.deleteFramebuffer(E.__webglMultisampledFramebuffer),E.__webglColorRenderbuffer)for(let ot=0;ot<E.__webglColorRenderbuffer.length;ot++)E.__webglColorRenderbuffer[ot]&&n.deleteRenderbuffer(E.__webglColorRenderbuffer[ot]);E.__webglDepthRenderbuffer&&n.deleteRenderbuffer(E.__webglDepthRenderbuffer)}let ut=N.textures;for(let ot=0,_t=ut.length;ot<_t;ot++){let yt=i.get(ut[ot]);yt.__webglTexture&&(n.deleteTexture(yt.__webglTexture),o.memory.textures--),i.remove(ut[ot])}i.remove(N)}let J=0;function Q(){J=0}function it(){return J}function ft(N){J=N}function dt(){let N=J;return N>=s.maxTextures&&$t("WebGLTextures: Trying to use "+(N+1)+" texture units while this GPU supports only "+s.maxTextures),J+=1,N}function tt(N){let E=[];return E.push(N.wrapS),E.push(N.wrapT),E.push(N.wrapR||0),E.push(N.magFilter),E.push(N.minFilter),E.push(N.anisotropy),E.push(N.internalFormat),E.push(N.format),E.push(N.type),E.push(N.generateMipmaps),E.push(N.mipmapsAutoUpdate),E.push(N.premultiplyAlpha),E.push(N.flipY),E.push(N.unpackAlignment),E.push(N.colorSpace),E.join()}function ht(N,E){let q=i.get(N);if(N.isVideoTexture&&De(N),N.isRenderTargetTexture===!1&&N.isExternalTexture!==!0&&N.version>0&&q.__version!==N.version){let ut=N.image;if(ut===null)$t("WebGLRenderer: Texture marked for update but no image data found.");else if(ut.complete===!1)$t("WebGLRenderer: Texture marked for update but image is incomplete");else{Fe(q,N,E);return}}else N.isExternalTexture&&(q.__webglTexture=N.sourceTexture?N.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,q.__webglTexture,n.TEXTURE0+E)}function gt(N,E){let q=i.get(N);if(N.isRenderTargetTexture===!1&&N.version>0&&q.__version!==N.version){Fe(q,N,E);return}else N.isExternalTexture&&(q.__webglTexture=N.sourceTexture?N.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,q.__webglTexture,n.TEXTURE0+E)}function St(N,E){let q=i.get(N);if(N.isRenderTargetTexture===!1&&N.version>0&&q.__version!==N.version){Fe(q,N,E);return}e.bindTexture(n.TEXTURE_3D,q.__webglTexture,n.TEXTURE0+E)}function Mt(N,E){let q=i.get(N);if(N.version>0&&q.__version!==N.version){an(q,N,E);return}e.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture,n.TEXTURE0+E)}let Ht={[Nl]:n.REPEAT,[Wi]:n.CLAMP_TO_EDGE,[Dl]:n.MIRRORED_REPEAT},se={[Pn]:n.NEAREST,[Wp]:n.NEAREST_MIPMAP_NEAREST,[Sa]:n.NEAREST_MIPMAP_LINEAR,[qn]:n.LINEAR,[ac]:n.LINEAR_MIPMAP_NEAREST,[xs]:n.LINEAR_MIPMAP_LINEAR},Vt={[Yp]:n.NEVER,[Jh]:n.ALWAYS,[Zp]:n.LESS,[Yh]:n.LEQUAL,[Jp]:n.EQUAL,[Zh]:n.GEQUAL,[Kp]:n.GREATER,[jp]:n.NOTEQUAL};function ue(N,E){if(E.type===_i&&t.has("OES_texture_float_linear")===!1&&(E.magFilter===qn||E.magFilter===ac||E.magFilter===Sa||E.magFilter===xs||E.minFilter===qn||E.minFilter===ac||E.minFilter===Sa||E.minFilter===xs)&&$t("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(N,n.TEXTURE_WRAP_S,Ht[E.wrapS]),n.texParameteri(N,n.TEXTURE_WRAP_T,Ht[E.wrapT]),(N===n.TEXTURE_3D||N===n.TEXTURE_2D_ARRAY)&&n.texParameteri(N,n.TEXTURE_WRAP_R,Ht[E.wrapR]),n.texParameteri(N,n.TEXTURE_MAG_FILTER,se[E.magFilter]),n.texParameteri(N,n.TEXTURE_MIN_FILTER,se[E.minFilter]),E.compareFunction&&(n.texParameteri(N,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(N,n.TEXTURE_COMPARE_FUNC,Vt[E.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(E.magFilter===Pn||E.minFilter!==Sa&&E.minFilter!==xs||E.type===_i&&t.has("OES_texture_float_linear")===!1)return;if(E.anisotropy>1||i.get(E).__currentAnisotropy){let q=t.get("EXT_texture_filter_anisotropic");n.texParameterf(N,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(E.anisotropy,s.getMaxAnisotropy())),i.get(E).__currentAnisotropy=E.anisotropy}}}function ae(N,E){let q=!1;N.__webglInit===void 0&&(N.__webglInit=!0,E.addEventListener("dispose",P),I(E));let ut=E.source,ot=f.get(ut);ot===void 0&&(ot={},f.set(ut,ot));let _t=tt(E);if(_t!==N.__cacheKey){ot[_t]===void 0&&(ot[_t]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,q=!0),ot[_t].usedTimes++;let yt=ot[N.__cacheKey];yt!==void 0&&(ot[N.__cacheKey].usedTimes--,yt.usedTimes===0&&H(E)),N.__cacheKey=_t,N.__webglTexture=ot[_t].texture}return q}function ne(N,E,q){return Math.floor(Math.floor(N/q)/E)}function Xe(N,E,q,ut){let _t=N.updateRanges;if(_t.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,E.width,E.height,q,ut,E.data);else{_t.sort((k,rt)=>k.start-rt.start);let yt=0;for(let k=1;k<_t.length;k++){let rt=_t[yt],nt=_t[k],At=rt.start+rt.count,xt=ne(nt.start,E.width,4),bt=ne(rt.start,E.width,4);nt.start<=At+1&&xt===bt&&ne(nt.start+nt.count-1,E.width,4)===xt?rt.count=Math.max(rt.count,nt.start+nt.count-rt.start):(++yt,_t[yt]=nt)}_t.length=yt+1;let et=e.getParameter(n.UNPACK_ROW_LENGTH),st=e.getParameter(n.UNPACK_SKIP_PIXELS),mt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,E.width);for(let k=0,rt=_t.length;k<rt;k++){let nt=_t[k],At=Math.floor(nt.start/4),xt=Math.ceil(nt.count/4),bt=At%E.width,Gt=Math.floor(At/E.width),Jt=xt,ct=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,bt),e.pixelStorei(n.UNPACK_SKIP_ROWS,Gt),e.texSubImage2D(n.TEXTURE_2D,0,bt,Gt,Jt,ct,q,ut,E.data)}N.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,et),e.pixelStorei(n.UNPACK_SKIP_PIXELS,st),e.pixelStorei(n.UNPACK_SKIP_ROWS,mt)}}function Fe(N,E,q){let ut=n.TEXTURE_2D;(E.isDataArrayTexture||E.isCompressedArrayTexture)&&(ut=n.TEXTURE_2D_ARRAY),E.isData3DTexture&&(ut=n.TEXTURE_3D);let ot=ae(N,E),_t=E.source;e.bindTexture(ut,N.__webglTexture,n.TEXTURE0+q);let yt=i.get(_t);if(_t.version!==yt.__version||ot===!0){if(e.activeTexture(n.TEXTURE0+q),(typeof ImageBitmap<"u"&&E.image instanceof ImageBitmap)===!1){let ct=xe.getPrimaries(xe.workingColorSpace),Ft=E.colorSpace===ys?null:xe.getPrimaries(E.colorSpace),Kt=E.colorSpace===ys||ct===Ft?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,E.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Kt)}e.pixelStorei(n.UNPACK_ALIGNMENT,E.unpackAlignment);let st=x(E.image,!1,s.maxTextureSize);st=zt(E,st);let mt=r.convert(E.format,E.colorSpace),k=r.convert(E.type),rt=M(E.internalFormat,mt,k,E.normalized,E.colorSpace,E.isVideoTexture);ue(ut,E);let nt,At=E.mipmaps,xt=E.isVideoTexture!==!0,bt=yt.__version===void 0||ot===!0,Gt=_t.dataReady,Jt=A(E,st);if(E.isDepthTexture)rt=y(E.format===_s,E.type),bt&&(xt?e.texStorage2D(n.TEXTURE_2D,1,rt,st.width,st.height):e.texImage2D(n.TEXTURE_2D,0,rt,st.width,st.height,0,mt,k,null));else if(E.isDataTexture)if(At.length>0){xt&&bt&&e.texStorage2D(n.TEXTURE_2D,Jt,rt,At[0].width,At[0].height);for(let ct=0,Ft=At.length;ct<Ft;ct++)nt=At[ct],xt?Gt&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,nt.width,nt.height,mt,k,nt.data):e.texImage2D(n.TEXTURE_2D,ct,rt,nt.width,nt.height,0,mt,k,nt.data);E.generateMipmaps=!1}else xt?(bt&&e.texStorage2D(n.TEXTURE_2D,Jt,rt,st.width,st.height),Gt&&Xe(E,st,mt,k)):e.texImage2D(n.TEXTURE_2D,0,rt,st.width,st.height,0,mt,k,st.data);else if(E.isCompressedTexture)if(E.isCompressedArrayTexture){xt&&bt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Jt,rt,At[0].width,At[0].height,st.depth);for(let ct=0,Ft=At.length;ct<Ft;ct++)if(nt=At[ct],E.format!==Ii)if(mt!==null)if(xt){if(Gt)if(E.layerUpdates.size>0){let Kt=od(nt.width,nt.height,E.format,E.type);for(let Ct of E.layerUpdates){let oe=nt.data.subarray(Ct*Kt/nt.data.BYTES_PER_ELEMENT,(Ct+1)*Kt/nt.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,Ct,nt.width,nt.height,1,mt,oe)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,0,nt.width,nt.height,st.depth,mt,nt.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ct,rt,nt.width,nt.height,st.depth,0,nt.data,0,0);else $t("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else xt?Gt&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,0,nt.width,nt.height,st.depth,mt,k,nt.data):e.texImage3D(n.TEXTURE_2D_ARRAY,ct,rt,nt.width,nt.height,st.depth,0,mt,k,nt.data);E.layerUpdates.size>0&&E.clearLayerUpdates()}else{xt&&bt&&e.texStorage2D(n.TEXTURE_2D,Jt,rt,At[0].width,At[0].height);for(let ct=0,Ft=At.length;ct<Ft;ct++)nt=At[ct],E.format!==Ii?mt!==null?xt?Gt&&e.compressedTexSubImage2D(n.TEXTURE_2D,ct,0,0,nt.width,nt.height,mt,nt.data):e.compressedTexImage2D(n.TEXTURE_2D,ct,rt,nt.width,nt.height,0,nt.data):$t("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):xt?Gt&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,nt.width,nt.height,mt,k,nt.data):e.texImage2D(n.TEXTURE_2D,ct,rt,nt.width,nt.height,0,mt,k,nt.data)}else if(E.isDataArrayTexture)if(xt){if(bt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Jt,rt,st.width,st.height,st.depth),Gt)if(E.layerUpdates.size>0){let ct=od(st.width,st.height,E.format,E.type);for(let Ft of E.layerUpdates){let Kt=st.data.subarray(Ft*ct/st.data.BYTES_PER_ELEMENT,(Ft+1)*ct/st.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Ft,st.width,st.height,1,mt,k,Kt)}E.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,st.width,st.height,st.depth,mt,k,st.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,rt,st.width,st.height,st.depth,0,mt,k,st.data);else if(E.isData3DTexture)xt?(bt&&e.texStorage3D(n.TEXTURE_3D,Jt,rt,st.width,st.height,st.depth),Gt&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,st.width,st.height,st.depth,mt,k,st.data)):e.texImage3D(n.TEXTURE_3D,0,rt,st.width,st.height,st.depth,0,mt,k,st.data);else if(E.isFramebufferTexture){if(bt)if(xt)e.texStorage2D(n.TEXTURE_2D,Jt,rt,st.width,st.height);else{let ct=st.width,Ft=st.height;for(let Kt=0;Kt<Jt;Kt++)e.texImage2D(n.TEXTURE_2D,Kt,rt,ct,Ft,0,mt,k,null),ct>>=1,Ft>>=1}}else if(E.isHTMLTexture){if("texElementImage2D"in n){let ct=n.canvas;if(ct.hasAttribute("layoutsubtree")||ct.setAttribute("layoutsubtree","true"),st.parentNode!==ct){ct.appendChild(st),h.add(E),ct.onpaint=Ft=>{let Kt=Ft.changedElements;for(let Ct of h)Kt.includes(Ct.image)&&(Ct.needsUpdate=!0)},ct.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,st);else{let Kt=n.RGBA,Ct=n.RGBA,oe=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,Kt,Ct,oe,st)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(At.length>0){if(xt&&bt){let ct=Xt(At[0]);e.texStorage2D(n.TEXTURE_2D,Jt,rt,ct.width,ct.height)}for(let ct=0,Ft=At.length;ct<Ft;ct++)nt=At[ct],xt?Gt&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,mt,k,nt):e.texImage2D(n.TEXTURE_2D,ct,rt,mt,k,nt);E.generateMipmaps=!1}else if(xt){if(bt){let ct=Xt(st);e.texStorage2D(n.TEXTURE_2D,Jt,rt,ct.width,ct.height)}Gt&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,mt,k,st)}else e.texImage2D(n.TEXTURE_2D,0,rt,mt,k,st);w(E)&&E.mipmapsAutoUpdate===!0&&b(ut),yt.__version=_t.version,E.onUpdate&&E.onUpdate(E)}N.__version=E.version}function an(N,E,q){if(E.image.length!==6)return;let ut=ae(N,E),ot=E.source;e.bindTexture(n.TEXTURE_CUBE_MAP,N.__webglTexture,n.TEXTURE0+q);let _t=i.get(ot);if(ot.version!==_t.__version||ut===!0){e.activeTexture(n.TEXTURE0+q);let yt=xe.getPrimaries(xe.workingColorSpace),et=E.colorSpace===ys?null:xe.getPrimaries(E.colorSpace),st=E.colorSpace===ys||yt===et?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,E.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,E.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,st);let mt=E.isCompressedTexture||E.image[0].isCompressedTexture,k=E.image[0]&&E.image[0].isDataTexture,rt=[];for(let Ct=0;Ct<6;Ct++)!mt&&!k?rt[Ct]=x(E.image[Ct],!0,s.maxCubemapSize):rt[Ct]=k?E.image[Ct].image:E.image[Ct],rt[Ct]=zt(E,rt[Ct]);let nt=rt[0],At=r.convert(E.format,E.colorSpace),xt=r.convert(E.type),bt=M(E.internalFormat,At,xt,E.normalized,E.colorSpace),Gt=E.isVideoTexture!==!0,Jt=_t.__version===void 0||ut===!0,ct=ot.dataReady,Ft=A(E,nt);ue(n.TEXTURE_CUBE_MAP,E);let Kt;if(E.isDepthTexture){if(bt=y(E.format===_s,E.type),Jt)if(Gt)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,bt,nt.width,nt.height);else for(let Ct=0;Ct<6;Ct++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,nt.width,nt.height,0,At,xt,null)}else if(mt){Gt&&Jt&&e.texStorage2D(n.TEXTURE_CUBE_MAP,Ft,bt,nt.width,nt.height);for(let Ct=0;Ct<6;Ct++){Kt=rt[Ct].mipmaps;for(let oe=0;oe<Kt.length;oe++){let Be=Kt[oe];E.format!==Ii?At!==null?Gt?ct&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe,0,0,Be.width,Be.height,At,Be.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe,bt,Be.width,Be.height,0,Be.data):$t("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Gt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe,0,0,Be.width,Be.height,At,xt,Be.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe,bt,Be.width,Be.height,0,At,xt,Be.data)}}}else{if(Kt=E.mipmaps,Gt&&Jt){Kt.length>0&&Ft++;let Ct=Xt(rt[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,Ft,bt,Ct.width,Ct.height)}for(let Ct=0;Ct<6;Ct++)if(k){Gt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,rt[Ct].width,rt[Ct].height,At,xt,rt[Ct].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,rt[Ct].width,rt[Ct].height,0,At,xt,rt[Ct].data);for(let oe=0;oe<Kt.length;oe++){let Vn=Kt[oe].image[Ct].image;Gt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe+1,0,0,Vn.width,Vn.height,At,xt,Vn.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe+1,bt,Vn.width,Vn.height,0,At,xt,Vn.data)}}else{Gt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,At,xt,rt[Ct]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,At,xt,rt[Ct]);for(let oe=0;oe<Kt.length;oe++){let Be=Kt[oe];Gt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe+1,0,0,At,xt,Be.image[Ct]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe+1,bt,At,xt,Be.image[Ct])}}}w(E)&&E.mipmapsAutoUpdate===!0&&b(n.TEXTURE_CUBE_MAP),_t.__version=ot.version,E.onUpdate&&E.onUpdate(E)}N.__version=E.version}function Le(N,E,q,ut,ot,_t){let yt=r.convert(q.format,q.colorSpace),et=r.convert(q.type),st=M(q.internalFormat,yt,et,q.normalized,q.colorSpace),mt=i.get(E),k=i.get(q);if(k.__renderTarget=E,!mt.__hasExternalTextures){let rt=Math.max(1,E.width>>_t),nt=Math.max(1,E.height>>_t);ot===n.TEXTURE_3D||ot===n.TEXTURE_2D_ARRAY?e.texImage3D(ot,_t,st,rt,nt,E.depth,0,yt,et,null):e.texImage2D(ot,_t,st,rt,nt,0,yt,et,null)}e.bindFramebuffer(n.FRAMEBUFFER,N),wt(E)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ut,ot,k.__webglTexture,0,re(E)):(ot===n.TEXTURE_2D||ot>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ot<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ut,ot,k.__webglTexture,_t),e.bindFramebuffer(n.FRAMEBUFFER,null)}function wn(N,E,q){if(n.bindRenderbuffer(n.RENDERBUFFER,N),E.depthBuffer){let ut=E.depthTexture,ot=ut&&ut.isDepthTexture?ut.type:null,_t=y(E.stencilBuffer,ot),yt=E.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;wt(E)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,re(E),_t,E.width,E.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,re(E),_t,E.width,E.height):n.renderbufferStorage(n.RENDERBUFFER,_t,E.width,E.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,yt,n.RENDERBUFFER,N)}else{let ut=E.textures;for(let ot=0;ot<ut.length;ot++){let _t=ut[ot],yt=r.convert(_t.format,_t.colorSpace),et=r.convert(_t.type),st=M(_t.internalFormat,yt,et,_t.normalized,_t.colorSpace);wt(E)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,re(E),st,E.width,E.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,re(E),st,E.width,E.height):n.renderbufferStorage(n.RENDERBUFFER,st,E.width,E.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function ye(N,E,q){let ut=E.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,N),!(E.depthTexture&&E.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ot=i.get(E.depthTexture);ot.__renderTarget=E;let _t=ut?E.depthTexture.image[0]:E.depthTexture.image;(!ot.__webglTexture||_t.width!==E.width||_t.height!==E.height)&&(_t.width=E.width,_t.height=E.height,E.depthTexture.needsUpdate=!0),ut?Mt(E.depthTexture,0):ht(E.depthTexture,0);let yt=ot.__webglTexture,et=re(E),st=ut?n.TEXTURE_CUBE_MAP_POSITIVE_X+q:n.TEXTURE_2D,mt=E.depthTexture.format===_s?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(E.depthTexture.format===hs)wt(E)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,mt,st,yt,0,et):n.framebufferTexture2D(n.FRAMEBUFFER,mt,st,yt,0);else if(E.depthTexture.format===_s)wt(E)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,mt,st,yt,0,et):n.framebufferTexture2D(n.FRAMEBUFFER,mt,st,yt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function mn(N){let E=i.get(N),q=N.isWebGLCubeRenderTarget===!0;if(E.__boundDepthTexture!==N.depthTexture){let ut=N.depthTexture;if(E.__depthDisposeCallback&&E.__depthDisposeCallback(),ut){let ot=()=>{delete E.__boundDepthTexture,delete E.__depthDisposeCallback,ut.removeEventListener("dispose",ot)};ut.addEventListener("dispose",ot),E.__depthDisposeCallback=ot}E.__boundDepthTexture=ut}if(N.depthTexture&&!E.__autoAllocateDepthBuffer)if(q)for(let ut=0;ut<6;ut++)ye(E.__webglFramebuffer[ut],N,ut);else N.texture.mipmaps.length>0?ye(E.__webglFramebuffer[0],N,0):ye(E.__webglFramebuffer,N,0);else if(q){E.__webglDepthbuffer=[];for(let ut=0;ut<6;ut++)if(e.bindFramebuffer(n.FRAMEBUFFER,E.__webglFramebuffer[ut]),E.__webglDepthbuffer[ut]===void 0)E.__webglDepthbuffer[ut]=n.createRenderbuffer(),wn(E.__webglDepthbuffer[ut],N,!1);else{let ot=N.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_t=E.__webglDepthbuffer[ut];n.bindRenderbuffer(n.RENDERBUFFER,_t),n.framebufferRenderbuffer(n.FRAMEBUFFER,ot,n.RENDERBUFFER,_t)}}else if(N.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,E.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,E.__webglFramebuffer),E.__webglDepthbuffer===void 0)E.__webglDepthbuffer=n.createRenderbuffer(),wn(E.__webglDepthbuffer,N,!1);else{let ot=N.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_t=E.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,_t),n.framebufferRenderbuffer(n.FRAMEBUFFER,ot,n.RENDERBUFFER,_t)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function Ze(N,E,q){let ut=i.get(N);E!==void 0&&Le(ut.__webglFramebuffer,N,N.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),q!==void 0&&mn(N)}function ln(N){let E=N.texture,q=i.get(N),ut=i.get(E);N.addEventListener("dispose",F),I(N);let ot=N.textures,_t=N.isWebGLCubeRenderTarget===!0,yt=ot.length>1;if(yt||(ut.__webglTexture===void 0&&(ut.__webglTexture=n.createTexture()),ut.__version=E.version,o.memory.textures++),_t){q.__webglFramebuffer=[];for(let et=0;et<6;et++)if(E.mipmaps.length>0){q.__webglFramebuffer[et]=[];for(let st=0;st<E.mipmaps.length;st++)q.__webglFramebuffer[et][st]=n.createFramebuffer()}else q.__webglFramebuffer[et]=n.createFramebuffer()}else{if(E.mipmaps.length>0){q.__webglFramebuffer=[];for(let et=0;et<E.mipmaps.length;et++)q.__webglFramebuffer[et]=n.createFramebuffer()}else q.__webglFramebuffer=n.createFramebuffer();if(yt)for(let et=0,st=ot.length;et<st;et++){let mt=i.get(ot[et]);mt.__webglTexture===void 0&&(mt.__webglTexture=n.createTexture(),o.memory.textures++)}if(N.samples>0&&wt(N)===!1){q.__webglMultisampledFramebuffer=n.createFramebuffer(),q.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let et=0;et<ot.length;et++){let st=ot[et];q.__webglColorRenderbuffer[et]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,q.__webglColorRenderbuffer[et]);let mt=r.convert(st.format,st.colorSpace),k=r.convert(st.type),rt=M(st.internalFormat,mt,k,st.normalized,st.colorSpace,N.isXRRenderTarget===!0),nt=re(N);n.renderbufferStorageMultisample(n.RENDERBUFFER,nt,rt,N.width,N.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+et,n.RENDERBUFFER,q.__webglColorRenderbuffer[et])}n.bindRenderbuffer(n.RENDERBUFFER,null),N.depthBuffer&&(q.__webglDepthRenderbuffer=n.createRenderbuffer(),wn(q.__webglDepthRenderbuffer,N,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(_t){e.bindTexture(n.TEXTURE_CUBE_MAP,ut.__webglTexture),ue(n.TEXTURE_CUBE_MAP,E);for(let et=0;et<6;et++)if(E.mipmaps.length>0)for(let st=0;st<E.mipmaps.length;st++)Le(q.__webglFramebuffer[et][st],N,E,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+et,st);else Le(q.__webglFramebuffer[et],N,E,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+et,0);w(E)?b(n.TEXTURE_CUBE_MAP):E.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,E.mipmaps.length-1),e.unbindTexture()}else if(yt){for(let et=0,st=ot.length;et<st;et++){let mt=ot[et],k=i.get(mt),rt=n.TEXTURE_2D;(N.isWebGL3DRenderTarget||N.isWebGLArrayRenderTarget)&&(rt=N.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(rt,k.__webglTexture),ue(rt,mt),Le(q.__webglFramebuffer,N,mt,n.COLOR_ATTACHMENT0+et,rt,0),w(mt)&&b(rt)}e.unbindTexture()}else{let et=n.TEXTURE_2D;if((N.isWebGL3DRenderTarget||N.isWebGLArrayRenderTarget)&&(et=N.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(et,ut.__webglTexture),ue(et,E),E.mipmaps.length>0)for(let st=0;st<E.mipmaps.length;st++)Le(q.__webglFramebuffer[st],N,E,n.COLOR_ATTACHMENT0,et,st);else Le(q.__webglFramebuffer,N,E,n.COLOR_ATTACHMENT0,et,0);w(E)?b(et):E.mipmaps.length>0&&n.texParameteri(et,n.TEXTURE_MAX_LEVEL,E.mipmaps.length-1),e.unbindTexture()}N.depthBuffer&&mn(N)}function B(N){let E=N.textures;for(let q=0,ut=E.length;q<ut;q++){let ot=E[q];if(w(ot)&&ot.mipmapsAutoUpdate===!0){let _t=S(N),yt=i.get(ot).__webglTexture;e.bindTexture(_t,yt),b(_t),e.unbindTexture()}}}let Rt=[];function qt(N){if(N.samples>0){if(wt(N)===!1){let E=N.textures,q=N.width,ut=N.height,ot=n.COLOR_BUFFER_BIT,_t=N.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,yt=i.get(N),et=E.length>1;if(et)for(let mt=0;mt<E.length;mt++)e.bindFramebuffer(n.FRAMEBUFFER,yt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,yt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,yt.__webglMultisampledFramebuffer),N.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,yt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,yt.__webglFramebuffer);for(let mt=0;mt<E.length;mt++){if(N.resolveDepthBuffer&&(N.depthBuffer&&(ot|=n.DEPTH_BUFFER_BIT),N.stencilBuffer&&N.resolveStencilBuffer&&(ot|=n.STENCIL_BUFFER_BIT)),et){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,yt.__webglColorRenderbuffer[mt]);let k=i.get(E[mt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,k,0)}n.blitFramebuffer(0,0,q,ut,0,0,q,ut,ot,n.NEAREST),l===!0&&(Rt.length=0,Rt.push(n.COLOR_ATTACHMENT0+mt),N.depthBuffer&&N.storeMultisampledDepthBuffer===!1&&Rt.push(_t),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Rt))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),et)for(let mt=0;mt<E.length;mt++){e.bindFramebuffer(n.FRAMEBUFFER,yt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.RENDERBUFFER,yt.__webglColorRenderbuffer[mt]);let k=i.get(E[mt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,yt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.TEXTURE_2D,k,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,yt.__webglMultisampledFramebuffer)}else if(N.depthBuffer&&N.storeMultisampledDepthBuffer===!1&&l){let E=N.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[E])}}}function re(N){return Math.min(s.maxSamples,N.samples)}function wt(N){let E=i.get(N);return N.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&E.__useRenderToTexture!==!1}function De(N){let E=o.render.frame;u.get(N)!==E&&(u.set(N,E),N.update())}function zt(N,E){let q=N.colorSpace,ut=N.format,ot=N.type;return N.isCompressedTexture===!0||N.isVideoTexture===!0||q!==Qo&&q!==ys&&(xe.getTransfer(q)===Ae?(ut!==Ii||ot!==Kn)&&$t("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):jt("WebGLTextures: Unsupported texture color space:",q)),E}function Xt(N){return typeof HTMLImageElement<"u"&&N instanceof HTMLImageElement?(c.width=N.naturalWidth||N.width,c.height=N.naturalHeight||N.height):typeof VideoFrame<"u"&&N instanceof VideoFrame?(c.width=N.displayWidth,c.height=N.displayHeight):(c.width=N.width,c.height=N.height),c}this.allocateTextureUnit=dt,this.resetTextureUnits=Q,this.getTextureUnits=it,this.setTextureUnits=ft,this.setTexture2D=ht,this.setTexture2DArray=gt,this.setTexture3D=St,this.setTextureCube=Mt,this.rebindTextures=Ze,this.setupRenderTarget=ln,this.updateRenderTargetMipmap=B,this.updateMultisampleRenderTarget=qt,this.setupDepthRenderbuffer=mn,this.setupFrameBufferTexture=Le,this.useMultisampledRTT=wt,this.dispose=G}function ew(n,t){function e(i,s=ys){let r,o=xe.getTransfer(s);if(i===Kn)return n.UNSIGNED_BYTE;if(i===cc)return n.UNSIGNED_SHORT_4_4_4_4;if(i===uc)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Gh)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Hh)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===zh)return n.BYTE;if(i===Vh)return n.SHORT;if(i===uo)return n.UNSIGNED_SHORT;if(i===lc)return n.INT;if(i===Ri)return n.UNSIGNED_INT;if(i===_i)return n.FLOAT;if(i===Pi)return n.HALF_FLOAT;if(i===Wh)return n.ALPHA;if(i===Xh)return n.RGB;if(i===Ii)return n.RGBA;if(i===hs)return n.DEPTH_COMPONENT;if(i===_s)return n.DEPTH_STENCIL;if(i===hc)return n.RED;if(i===dc)return n.RED_INTEGER;if(i===qs)return n.RG;if(i===fc)return n.RG_INTEGER;if(i===pc)return n.RGBA_INTEGER;if(i===Ma||i===wa||i===Aa||i===Ea)if(o===Ae)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Ma)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===wa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Aa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Ea)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Ma)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===wa)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Aa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Ea)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===mc||i===gc||i===xc||i===_c)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===mc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===gc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===xc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===_c)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===yc||i===vc||i===bc||i===Sc||i===Mc||i===Ta||i===wc)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===yc||i===vc)return o===Ae?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===bc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Sc)return r.COMPRESSED_R11_EAC;if(i===Mc)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Ta)return r.COMPRESSED_RG11_EAC;if(i===wc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Ac||i===Ec||i===Tc||i===Cc||i===Rc||i===Pc||i===Ic||i===Lc||i===Nc||i===Dc||i===Uc||i===Oc||i===Fc||i===kc)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Ac)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Ec)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Tc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Cc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Rc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Pc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Ic)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Lc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Nc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Dc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Uc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Oc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Fc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===kc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Bc||i===zc||i===Vc)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===Bc)return o===Ae?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===zc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Vc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Gc||i===Hc||i===Ca||i===Wc)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===Gc)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Hc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Ca)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Wc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===fr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var nw=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,iw=`
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

}`,md=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new ua(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new qi({vertexShader:nw,fragmentShader:iw,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Nn(new da(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},gd=class extends Ci{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,d=null,f=null,p=null,_=typeof XRWebGLBinding<"u",g=new md,m={},x=e.getContextAttributes(),w=null,b=null,S=[],M=[],y=new Yt,A=null,I=null,L=new $n;L.viewport=new qe;let P=new $n;P.viewport=new qe;let F=[L,P],z=new ic,U=null,G=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(tt){let ht=S[tt];return ht===void 0&&(ht=new no,S[tt]=ht),ht.getTargetRaySpace()},this.getControllerGrip=function(tt){let ht=S[tt];return ht===void 0&&(ht=new no,S[tt]=ht),ht.getGripSpace()},this.getHand=function(tt){let ht=S[tt];return ht===void 0&&(ht=new no,S[tt]=ht),ht.getHandSpace()};function $(tt){let ht=M.indexOf(tt.inputSource);if(ht===-1)return;let gt=S[ht];gt!==void 0&&(gt.update(tt.inputSource,tt.frame,c||o),gt.dispatchEvent({type:tt.type,data:tt.inputSource}))}function H(){s.removeEventListener("select",$),s.removeEventListener("selectstart",$),s.removeEventListener("selectend",$),s.removeEventListener("squeeze",$),s.removeEventListener("squeezestart",$),s.removeEventListener("squeezeend",$),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",lt);for(let tt=0;tt<S.length;tt++){let ht=M[tt];ht!==null&&(M[tt]=null,S[tt].disconnect(ht))}U=null,G=null,g.reset();for(let tt in m)delete m[tt];if(t.setRenderTarget(w),f=null,d=null,h=null,s=null,b=null,dt.stop(),i.isPresenting=!1,t.setPixelRatio(A),t.setSize(y.width,y.height,!1),I!==null){let tt=I.camera;tt.fov=I.fov,tt.zoom=I.zoom,tt.updateProjectionMatrix(),I=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(tt){r=tt,i.isPresenting===!0&&$t("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(tt){a=tt,i.isPresenting===!0&&$t("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(tt){c=tt},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h===null&&_&&(h=new XRWebGLBinding(s,e)),h},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(tt){if(s=tt,s!==null){if(w=t.getRenderTarget(),s.addEventListener("select",$),s.addEventListener("selectstart",$),s.addEventListener("selectend",$),s.addEventListener("squeeze",$),s.addEventListener("squeezestart",$),s.addEventListener("squeezeend",$),s.addEventListener("end",H),s.addEventListener("inputsourceschange",lt),x.xrCompatible!==!0&&await e.makeXRCompatible(),A=t.getPixelRatio(),t.getSize(y),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let gt=null,St=null,Mt=null;x.depth&&(Mt=x.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,gt=x.stencil?_s:hs,St=x.stencil?fr:Ri);let Ht={colorFormat:e.RGBA8,depthFormat:Mt,scaleFactor:r};h=this.getBinding(),d=h.createProjectionLayer(Ht),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),b=new li(d.textureWidth,d.textureHeight,{format:Ii,type:Kn,depthTexture:new ms(d.textureWidth,d.textureHeight,St,void 0,void 0,void 0,void 0,void 0,void 0,gt),stencilBuffer:x.stencil,colorSpace:t.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let gt={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,gt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new li(f.framebufferWidth,f.framebufferHeight,{format:Ii,type:Kn,colorSpace:t.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),dt.setContext(s),dt.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function lt(tt){for(let ht=0;ht<tt.removed.length;ht++){let gt=tt.removed[ht],St=M.indexOf(gt);St>=0&&(M[St]=null,S[St].disconnect(gt))}for(let ht=0;ht<tt.added.length;ht++){let gt=tt.added[ht],St=M.indexOf(gt);if(St===-1){for(let Ht=0;Ht<S.length;Ht++)if(Ht>=M.length){M.push(gt),St=Ht;break}else if(M[Ht]===null){M[Ht]=gt,St=Ht;break}if(St===-1)break}let Mt=S[St];Mt&&Mt.connect(gt)}}function J(tt,ht){ht===null?tt.matrixWorld.copy(tt.matrix):tt.matrixWorld.multiplyMatrices(ht.matrixWorld,tt.matrix),tt.matrixWorldInverse.copy(tt.matrixWorld).invert()}this.updateCamera=function(tt){if(s===null)return;let ht=tt.near,gt=tt.far;g.texture!==null&&(g.depthNear>0&&(ht=g.depthNear),g.depthFar>0&&(gt=g.depthFar)),z.near=P.near=L.near=ht,z.far=P.far=L.far=gt,(U!==z.near||G!==z.far)&&(s.updateRenderState({depthNear:z.near,depthFar:z.far}),U=z.near,G=z.far),z.layers.mask=tt.layers.mask|6,L.layers.mask=z.layers.mask&-5,P.layers.mask=z.layers.mask&-3;let St=tt.parent,Mt=z.cameras;J(z,St);for(let Ht=0;Ht<Mt.length;Ht++)J(Mt[Ht],St);z.projectionMatrix.copy(L.projectionMatrix),z.projectionMatrixInverse.copy(L.projectionMatrixInverse),I===null&&tt.isPerspectiveCamera&&(I={camera:tt,fov:tt.fov,zoom:tt.zoom}),Q(tt,z,St)};function Q(tt,ht,gt){gt===null?tt.matrix.copy(ht.matrixWorld):(tt.matrix.copy(gt.matrixWorld),tt.matrix.invert(),tt.matrix.multiply(ht.matrixWorld)),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.updateMatrixWorld(!0),tt.projectionMatrix.copy(ht.projectionMatrix),tt.projectionMatrixInverse.copy(ht.projectionMatrixInverse),tt.isPerspectiveCamera&&(tt.fov=Qr*2*Math.atan(1/tt.projectionMatrix.elements[5]),tt.zoom=1)}this.getCamera=function(){return z},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(tt){l=tt,d!==null&&(d.fixedFoveation=tt),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=tt)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(z)},this.getCameraTexture=function(tt){return m[tt]};let it=null;function ft(tt,ht){if(u=ht.getViewerPose(c||o),p=ht,u!==null){let gt=u.views;f!==null&&(t.setRenderTargetFramebuffer(b,f.framebuffer),t.setRenderTarget(b));let St=!1;gt.length!==z.cameras.length&&(z.cameras.length=0,St=!0);for(let Vt=0;Vt<gt.length;Vt++){let ue=gt[Vt],ae=null;if(f!==null)ae=f.getViewport(ue);else{let Xe=h.getViewSubImage(d,ue);ae=Xe.viewport,Vt===0&&(t.setRenderTargetTextures(b,Xe.colorTexture,Xe.depthStencilTexture),t.setRenderTarget(b))}let ne=F[Vt];ne===void 0&&(ne=new $n,ne.layers.enable(Vt),ne.viewport=new qe,F[Vt]=ne),ne.matrix.fromArray(ue.transform.matrix),ne.matrix.decompose(ne.position,ne.quaternion,ne.scale),ne.projectionMatrix.fromArray(ue.projectionMatrix),ne.projectionMatrixInverse.copy(ne.projectionMatrix).invert(),ne.viewport.set(ae.x,ae.y,ae.width,ae.height),Vt===0&&(z.matrix.copy(ne.matrix),z.matrix.decompose(z.position,z.quaternion,z.scale)),St===!0&&z.cameras.push(ne)}let Mt=s.enabledFeatures;if(Mt&&Mt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&_){h=i.getBinding();let Vt=h.getDepthInformation(gt[0]);Vt&&Vt.isValid&&Vt.texture&&g.init(Vt,s.renderState)}if(Mt&&Mt.includes("camera-access")&&_){t.state.unbindTexture(),h=i.getBinding();for(let Vt=0;Vt<gt.length;Vt++){let ue=gt[Vt].camera;if(ue){let ae=m[ue];ae||(ae=new ua,m[ue]=ae);let ne=h.getCameraImage(ue);ae.sourceTexture=ne}}}}for(let gt=0;gt<S.length;gt++){let St=M[gt],Mt=S[gt];St!==null&&Mt!==void 0&&Mt.update(St,ht,c||o)}it&&it(tt,ht),ht.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:ht}),p=null}let dt=new Im;dt.setAnimationLoop(ft),this.setAnimationLoop=function(tt){it=tt},this.dispose=function(){}}},sw=new pe,Vm=new ee;Vm.set(-1,0,0,0,1,0,0,0,1);function rw(n,t){function e(g,m){g.matrixAutoUpdate===!0&&g.updateMatrix(),m.value.copy(g.matrix)}function i(g,m){m.color.getRGB(g.fogColor.value,id(n)),m.isFog?(g.fogNear.value=m.near,g.fogFar.value=m.far):m.isFogExp2&&(g.fogDensity.value=m.density)}function s(g,m,x,w,b){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(g,m):m.isMeshLambertMaterial?(r(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(g,m),h(g,m)):m.isMeshPhongMaterial?(r(g,m),u(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(g,m),d(g,m),m.isMeshPhysicalMaterial&&f(g,m,b)):m.isMeshMatcapMaterial?(r(g,m),p(g,m)):m.isMeshDepthMaterial?r(g,m):m.isMeshDistanceMaterial?(r(g,m),_(g,m)):m.isMeshNormalMaterial?r(g,m):m.isLineBasicMaterial?(o(g,m),m.isLineDashedMaterial&&a(g,m)):m.isPointsMaterial?l(g,m,x,w):m.isSpriteMaterial?c(g,m):m.isShadowMaterial?(g.color.value.copy(m.color),g.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(g,m){g.opacity.value=m.opacity,m.color&&g.diffuse.value.copy(m.color),m.emissive&&g.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(g.map.value=m.map,e(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.bumpMap&&(g.bumpMap.value=m.bumpMap,e(m.bumpMap,g.bumpMapTransform),g.bumpScale.value=m.bumpScale,m.side===Yn&&(g.bumpScale.value*=-1)),m.normalMap&&(g.normalMap.value=m.normalMap,e(m.normalMap,g.normalMapTransform),g.normalScale.value.copy(m.normalScale),m.side===Yn&&g.normalScale.value.negate()),m.displacementMap&&(g.displacementMap.value=m.displacementMap,e(m.displacementMap,g.displacementMapTransform),g.displacementScale.value=m.displacementScale,g.displacementBias.value=m.displacementBias),m.emissiveMap&&(g.emissiveMap.value=m.emissiveMap,e(m.emissiveMap,g.emissiveMapTransform)),m.specularMap&&(g.specularMap.value=m.specularMap,e(m.specularMap,g.specularMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest);let x=t.get(m),w=x.envMap,b=x.envMapRotation;w&&(g.envMap.value=w,g.envMapRotation.value.setFromMatrix4(sw.makeRotationFromEuler(b)).transpose(),w.isCubeTexture&&w.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(Vm),g.reflectivity.value=m.reflectivity,g.ior.value=m.ior,g.refractionRatio.value=m.refractionRatio),m.lightMap&&(g.lightMap.value=m.lightMap,g.lightMapIntensity.value=m.lightMapIntensity,e(m.lightMap,g.lightMapTransform)),m.aoMap&&(g.aoMap.value=m.aoMap,g.aoMapIntensity.value=m.aoMapIntensity,e(m.aoMap,g.aoMapTransform))}function o(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,m.map&&(g.map.value=m.map,e(m.map,g.mapTransform))}function a(g,m){g.dashSize.value=m.dashSize,g.totalSize.value=m.dashSize+m.gapSize,g.scale.value=m.scale}function l(g,m,x,w){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.size.value=m.size*x,g.scale.value=w*.5,m.map&&(g.map.value=m.map,e(m.map,g.uvTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function c(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.rotation.value=m.rotation,m.map&&(g.map.value=m.map,e(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function u(g,m){g.specular.value.copy(m.specular),g.shininess.value=Math.max(m.shininess,1e-4)}function h(g,m){m.gradientMap&&(g.gradientMap.value=m.gradientMap)}function d(g,m){g.metalness.value=m.metalness,m.metalnessMap&&(g.metalnessMap.value=m.metalnessMap,e(m.metalnessMap,g.metalnessMapTransform)),g.roughness.value=m.roughness,m.roughnessMap&&(g.roughnessMap.value=m.roughnessMap,e(m.roughnessMap,g.roughnessMapTransform)),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)}function f(g,m,x){g.ior.value=m.ior,m.diffuseRoughness>0&&(g.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=m.diffuseRoughnessMap,e(m.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),m.sheen>0&&(g.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),g.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(g.sheenColorMap.value=m.sheenColorMap,e(m.sheenColorMap,g.sheenColorMapTransform)),m.sheenRoughnessMap&&(g.sheenRoughnessMap.value=m.sheenRoughnessMap,e(m.sheenRoughnessMap,g.sheenRoughnessMapTransform))),m.clearcoat>0&&(g.clearcoat.value=m.clearcoat,g.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(g.clearcoatMap.value=m.clearcoatMap,e(m.clearcoatMap,g.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,e(m.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(g.clearcoatNormalMap.value=m.clearcoatNormalMap,e(m.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===Yn&&g.clearcoatNormalScale.value.negate())),m.dispersion>0&&(g.dispersion.value=m.dispersion),m.retroreflectivity>0&&(g.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(g.iridescence.value=m.iridescence,g.iridescenceIOR.value=m.iridescenceIOR,g.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(g.iridescenceMap.value=m.iridescenceMap,e(m.iridescenceMap,g.iridescenceMapTransform)),m.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=m.iridescenceThicknessMap,e(m.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),m.transmission>0&&(g.transmission.value=m.transmission,g.transmissionSamplerMap.value=x.texture,g.transmissionSamplerSize.value.set(x.width,x.height),m.transmissionMap&&(g.transmissionMap.value=m.transmissionMap,e(m.transmissionMap,g.transmissionMapTransform)),g.thickness.value=m.thickness,m.thicknessMap&&(g.thicknessMap.value=m.thicknessMap,e(m.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=m.attenuationDistance,g.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(g.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(g.anisotropyMap.value=m.anisotropyMap,e(m.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=m.specularIntensity,g.specularColor.value.copy(m.specularColor),m.specularColorMap&&(g.specularColorMap.value=m.specularColorMap,e(m.specularColorMap,g.specularColorMapTransform)),m.specularIntensityMap&&(g.specularIntensityMap.value=m.specularIntensityMap,e(m.specularIntensityMap,g.specularIntensityMapTransform))}function p(g,m){m.matcap&&(g.matcap.value=m.matcap)}function _(g,m){let x=t.get(m).light;g.referencePosition.value.setFromMatrixPosition(x.matrixWorld),g.nearDistance.value=x.shadow.camera.near,g.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function ow(n,t,e,i){let s={},r={};function o(x,w){let b=w.program;i.uniformBlockBinding(x,b,s[x.id])}function a(x,w){let b=s[x.id];b===void 0&&(p(x),b=l(x),s[x.id]=b,x.addEventListener("dispose",g));let S=w.program;i.updateUBOMapping(x,S);let M=t.render.frame;r[x.id]!==M&&(c(x),r[x.id]=M)}function l(x){let w=n.createBuffer(),b=x.__size,S=x.usage;return n.bindBuffer(n.UNIFORM_BUFFER,w),n.bufferData(n.UNIFORM_BUFFER,b,S),n.bindBuffer(n.UNIFORM_BUFFER,null),w}function c(x){let w=s[x.id],b=x.uniforms,S=x.__cache;n.bindBuffer(n.UNIFORM_BUFFER,w);for(let M=0,y=b.length;M<y;M++){let A=b[M];if(Array.isArray(A))for(let I=0,L=A.length;I<L;I++)u(A[I],M,I,S);else u(A,M,0,S)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(x,w,b,S){if(d(x,w,b,S)===!0){let M=x.__offset,y=x.value;if(Array.isArray(y)){let A=0;for(let I=0;I<y.length;I++){let L=y[I],P=_(L,!0);h(L,x.__data,A),A+=P.storage/Float32Array.BYTES_PER_ELEMENT}}else h(y,x.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,M,x.__data)}}function h(x,w,b){typeof x=="number"||typeof x=="boolean"?w[b]=x:x.isMatrix3?(w[b]=x.elements[0],w[b+1]=x.elements[1],w[b+2]=x.elements[2],w[b+3]=0,w[b+4]=x.elements[3],w[b+5]=x.elements[4],w[b+6]=x.elements[5],w[b+7]=0,w[b+8]=x.elements[6],w[b+9]=x.elements[7],w[b+10]=x.elements[8],w[b+11]=0):ArrayBuffer.isView(x)?w.set(x.subarray(0,w.length-b),b):x.toArray(w,b)}function d(x,w,b,S){let M=x.value,y=w+"_"+b;if(Array.isArray(M)){S[y]===void 0&&(S[y]=[]);let A=S[y],I=!1;for(let L=0;L<M.length;L++)f(M[L],A,L)===!0&&(I=!0);return I}return f(M,S,y)}function f(x,w,b){if(w[b]===void 0)return typeof x=="number"||typeof x=="boolean"?w[b]=x:ArrayBuffer.isView(x)?w[b]=x.slice():w[b]=x.clone(),!0;{let S=w[b];if(typeof x=="number"||typeof x=="boolean"){if(S!==x)return w[b]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(S.equals(x)===!1)return S.copy(x),!0}}return!1}function p(x){let w=x.uniforms,b=0,S=16;for(let y=0,A=w.length;y<A;y++){let I=Array.isArray(w[y])?w[y]:[w[y]];for(let L=0,P=I.length;L<P;L++){let F=I[L],z=Array.isArray(F.value)?F.value:[F.value],U=Array.isArray(w[y])||Array.isArray(F.value),G=b;for(let H=0,lt=z.length;H<lt;H++){let J=z[H],Q=_(J,U),it=b%S,ft=it%Q.boundary,dt=it+ft;b+=ft,dt!==0&&S-dt<Q.storage&&(b+=S-dt),H===0&&(G=b),b+=Q.storage}let $=F.type==="int"?Int32Array:F.type==="uint"?Uint32Array:Float32Array;F.__data=new $((b-G)/Float32Array.BYTES_PER_ELEMENT),F.__offset=G}}let M=b%S;return M>0&&(b+=S-M),x.__size=b,x.__cache={},this}function _(x,w){let b={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(b.boundary=4,b.storage=4):x.isVector2?(b.boundary=8,b.storage=8):x.isVector3||x.isColor?(b.boundary=16,b.storage=12):x.isVector4?(b.boundary=16,b.storage=16):x.isMatrix3?(b.boundary=16,b.storage=48):x.isMatrix4?(b.boundary=16,b.storage=64):x.isTexture?$t("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(b.boundary=16,b.storage=x.byteLength):$t("WebGLRenderer: Unsupported uniform value type.",x),w===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function g(x){let w=x.target;w.removeEventListener("dispose",g),n.deleteBuffer(s[w.id]),delete s[w.id],delete r[w.id]}function m(){for(let x in s)n.deleteBuffer(s[x]);s={},r={}}return{bind:o,update:a,dispose:m}}var aw=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Zi=null;function lw(){return Zi===null&&(Zi=new oa(aw,16,16,qs,Pi),Zi.name="DFG_LUT",Zi.minFilter=qn,Zi.magFilter=qn,Zi.wrapS=Wi,Zi.wrapT=Wi,Zi.generateMipmaps=!1,Zi.needsUpdate=!0),Zi}var Zc=class{constructor(t={}){let{canvas:e=tm(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1,outputBufferType:f=Kn}=t;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let _=f,g=new Set([pc,fc,dc]),m=new Set([Kn,Ri,uo,fr,cc,uc]),x=new Uint32Array(4),w=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},S=null,M=null,y=[],A=[],I=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Yi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let L=this,P=!1,F=null,z=null,U=null,G=null;this._outputColorSpace=ri;let $=0,H=0,lt=null,J=-1,Q=null,it=new qe,ft=new qe,dt=null,tt=new Qt(0),ht=0,gt=e.width,St=e.height,Mt=1,Ht=null,se=null,Vt=new qe(0,0,gt,St),ue=new qe(0,0,gt,St),ae=!1,ne=new Bs,Xe=new Bl,Fe=!1,an=!1,Le=new pe,wn=new W,ye=new qe,mn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Ze=!1;function ln(){return lt===null?Mt:1}let B=i;function Rt(C,V){return e.getContext(C,V)}let qt,re,wt,De,zt,Xt,N,E,q,ut,ot,_t,yt,et,st,mt,k,rt,nt,At,xt,bt,Gt;try{let C={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Ft,!1),e.addEventListener("webglcontextrestored",Kt,!1),e.addEventListener("webglcontextcreationerror",Ct,!1),B===null){let V="webgl2";if(B=Rt(V,C),B===null)throw Rt(V)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Jt()}catch(C){throw e.removeEventListener("webglcontextlost",Ft,!1),e.removeEventListener("webglcontextrestored",Kt,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),jt("WebGLRenderer: "+C.message),C}function Jt(){qt=new yS(B),qt.init(),xt=new ew(B,qt),re=new lS(B,qt,t,xt),wt=new QM(B,qt),re.reversedDepthBuffer&&d&&wt.buffers.depth.setReversed(!0),z=B.createFramebuffer(),U=B.createFramebuffer(),G=B.createFramebuffer(),De=new SS(B),zt=new BM,Xt=new tw(B,qt,wt,zt,re,xt,De),N=new _S(L),E=new wy(B),bt=new oS(B,E),q=new vS(B,E,De,bt),ut=new wS(B,q,E,bt,De),rt=new MS(B,re,Xt),st=new cS(zt),ot=new kM(L,N,qt,re,bt,st),_t=new rw(L,zt),yt=new VM,et=new qM(qt),k=new rS(L,N,wt,ut,p,l),mt=new jM(L,ut,re),Gt=new ow(B,De,re,wt),nt=new aS(B,qt,De),At=new bS(B,qt,De),De.programs=ot.programs,L.capabilities=re,L.extensions=qt,L.properties=zt,L.renderLists=yt,L.shadowMap=mt,L.state=wt,L.info=De}_!==Kn&&(I=new ES(_,e.width,e.height,a,s,r));let ct=new gd(L,B);this.xr=ct,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let C=qt.get("WEBGL_lose_context");C&&C.loseContext()},this.forceContextRestore=function(){let C=qt.get("WEBGL_lose_context");C&&C.restoreContext()},this.getPixelRatio=function(){return Mt},this.setPixelRatio=function(C){C!==void 0&&(Mt=C,this.setSize(gt,St,!1))},this.getSize=function(C){return C.set(gt,St)},this.setSize=function(C,V,j=!0){if(ct.isPresenting){$t("WebGLRenderer: Can't change size while VR device is presenting.");return}gt=C,St=V,e.width=Math.floor(C*Mt),e.height=Math.floor(V*Mt),j===!0&&(e.style.width=C+"px",e.style.height=V+"px"),I!==null&&I.setSize(e.width,e.height),this.setViewport(0,0,C,V)},this.getDrawingBufferSize=function(C){return C.set(gt*Mt,St*Mt).floor()},this.setDrawingBufferSize=function(C,V,j){gt=C,St=V,Mt=j,e.width=Math.floor(C*j),e.height=Math.floor(V*j),this.setViewport(0,0,C,V)},this.setEffects=function(C){if(_===Kn){jt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(C){for(let V=0;V<C.length;V++)if(C[V].isOutputPass===!0){$t("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}I.setEffects(C||[])},this.getCurrentViewport=function(C){return C.copy(it)},this.getViewport=function(C){return C.copy(Vt)},this.setViewport=function(C,V,j,Y){C.isVector4?Vt.set(C.x,C.y,C.z,C.w):Vt.set(C,V,j,Y),wt.viewport(it.copy(Vt).multiplyScalar(ln()).round())},this.getScissor=function(C){return C.copy(ue)},this.setScissor=function(C,V,j,Y){C.isVector4?ue.set(C.x,C.y,C.z,C.w):ue.set(C,V,j,Y),wt.scissor(ft.copy(ue).multiplyScalar(ln()).round())},this.getScissorTest=function(){return ae},this.setScissorTest=function(C){wt.setScissorTest(ae=C)},this.setOpaqueSort=function(C){Ht=C},this.setTransparentSort=function(C){se=C},this.getClearColor=function(C){return C.copy(k.getClearColor())},this.setClearColor=function(){k.setClearColor(...arguments)},this.getClearAlpha=function(){return k.getClearAlpha()},this.setClearAlpha=function(){k.setClearAlpha(...arguments)},this.clear=function(C=!0,V=!0,j=!0){let Y=0;if(C){let Z=!1;if(lt!==null){let Et=lt.texture.format;Z=g.has(Et)}if(Z){let Et=lt.texture.type,Pt=m.has(Et),Tt=k.getClearColor(),It=k.getClearAlpha(),Bt=Tt.r,te=Tt.g,he=Tt.b;Pt?(x[0]=Bt,x[1]=te,x[2]=he,x[3]=It,B.clearBufferuiv(B.COLOR,0,x)):(w[0]=Bt,w[1]=te,w[2]=he,w[3]=It,B.clearBufferiv(B.COLOR,0,w))}else Y|=B.COLOR_BUFFER_BIT}V&&(Y|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(Y|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&B.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(C){C.setRenderer(this),F=C},this.dispose=function(){e.removeEventListener("webglcontextlost",Ft,!1),e.removeEventListener("webglcontextrestored",Kt,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),k.dispose(),yt.dispose(),et.dispose(),Xt.dispose(),zt.dispose(),N.dispose(),ut.dispose(),q.dispose(),bt.dispose(),Gt.dispose(),ot.dispose(),ct.dispose(),ct.removeEventListener("sessionstart",Ja),ct.removeEventListener("sessionend",Oi),ts.stop()};function Ft(C){C.preventDefault(),jh("WebGLRenderer: Context Lost."),P=!0}function Kt(){jh("WebGLRenderer: Context Restored."),P=!1;let C=De.autoReset,V=mt.enabled,j=mt.autoUpdate,Y=mt.needsUpdate,Z=mt.type;Jt(),De.autoReset=C,mt.enabled=V,mt.autoUpdate=j,mt.needsUpdate=Y,mt.type=Z}function Ct(C){jt("WebGLRenderer: A WebGL context could not be created. Reason: ",C.statusMessage)}function oe(C){let V=C.target;V.removeEventListener("dispose",oe),Be(V)}function Be(C){Vn(C),zt.remove(C)}function Vn(C){let V=zt.get(C).programs;V!==void 0&&(V.forEach(function(j){ot.releaseProgram(j)}),C.isShaderMaterial&&ot.releaseShaderCache(C))}this.renderBufferDirect=function(C,V,j,Y,Z,Et){V===null&&(V=mn);let Pt=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Tt=Fo(C,V,j,Y,Z);wt.setMaterial(Y,Pt);let It=j.index,Bt=1;if(Y.wireframe===!0){if(It=q.getWireframeAttribute(j),It===void 0)return;Bt=2}let te=j.drawRange,he=j.attributes.position,kt=te.start*Bt,de=(te.start+te.count)*Bt;Et!==null&&(kt=Math.max(kt,Et.start*Bt),de=Math.min(de,(Et.start+Et.count)*Bt)),It!==null?(kt=Math.max(kt,0),de=Math.min(de,It.count)):he!=null&&(kt=Math.max(kt,0),de=Math.min(de,he.count));let Ye=de-kt;if(Ye<0||Ye===1/0)return;bt.setup(Z,Y,Tt,j,It);let Ce,Re=nt;if(It!==null&&(Ce=E.get(It),Re=At,Re.setIndex(Ce)),Z.isMesh)Y.wireframe===!0?(wt.setLineWidth(Y.wireframeLinewidth*ln()),Re.setMode(B.LINES)):Re.setMode(B.TRIANGLES);else if(Z.isLine){let gn=Y.linewidth;gn===void 0&&(gn=1),wt.setLineWidth(gn*ln()),Z.isLineSegments?Re.setMode(B.LINES):Z.isLineLoop?Re.setMode(B.LINE_LOOP):Re.setMode(B.LINE_STRIP)}else Z.isPoints?Re.setMode(B.POINTS):Z.isSprite&&Re.setMode(B.TRIANGLES);if(Z.isBatchedMesh)if(qt.get("WEBGL_multi_draw"))Re.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let gn=Z._multiDrawStarts,Ut=Z._multiDrawCounts,cn=Z._multiDrawCount,ge=It?E.get(It).bytesPerElement:1,ns=zt.get(Y).currentProgram.getUniforms();for(let un=0;un<cn;un++)ns.setValue(B,"_gl_DrawID",un),Re.render(gn[un]/ge,Ut[un])}else if(Z.isInstancedMesh)Re.renderInstances(kt,Ye,Z.count);else if(j.isInstancedBufferGeometry){let gn=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Ut=Math.min(j.instanceCount,gn);Re.renderInstances(kt,Ye,Ut)}else Re.render(kt,Ye)};function Do(C,V,j,Y){F!==null&&C.isNodeMaterial&&F.setObject(Y,C),Fe===!0&&st.setState(C,j,!1),C.transparent===!0&&C.side===Bn&&C.forceSinglePass===!1?(C.side=Yn,C.needsUpdate=!0,Fi(C,V,Y),C.side=$s,C.needsUpdate=!0,Fi(C,V,Y),C.side=Bn):Fi(C,V,Y)}this.compile=function(C,V,j=null){j===null&&(j=C),F!==null&&F.renderStart(C,V,j),M=et.get(j),M.init(V),A.push(M),j.traverseVisible(function(Z){Z.isLight&&Z.layers.test(V.layers)&&(M.pushLight(Z),Z.castShadow&&M.pushShadow(Z))}),C!==j&&C.traverseVisible(function(Z){Z.isLight&&Z.layers.test(V.layers)&&(M.pushLight(Z),Z.castShadow&&M.pushShadow(Z))}),M.setupLights(),F!==null&&F.updateLights(M.state.lightsArray),an=this.localClippingEnabled,Fe=st.init(this.clippingPlanes,an),Fe===!0&&st.setGlobalState(this.clippingPlanes,V),F!==null&&mt.render(M.state.shadowsArray,j,V);let Y=new Set;return C.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let Et=Z.material;if(Et)if(Array.isArray(Et))for(let Pt=0;Pt<Et.length;Pt++){let Tt=Et[Pt];Do(Tt,j,V,Z),Y.add(Tt)}else Do(Et,j,V,Z),Y.add(Et)}),M=A.pop(),F!==null&&F.renderEnd(),Y},this.compileAsync=function(C,V,j=null){let Y=this.compile(C,V,j);return new Promise(Z=>{function Et(){if(Y.forEach(function(Pt){let It=zt.get(Pt).currentProgram;(It===void 0||It.isReady())&&Y.delete(Pt)}),Y.size===0){Z(C);return}setTimeout(Et,10)}qt.get("KHR_parallel_shader_compile")!==null?Et():setTimeout(Et,10)})};let wr=null;function Vu(C){wr&&wr(C)}function Ja(){ts.stop()}function Oi(){ts.start()}let ts=new Im;ts.setAnimationLoop(Vu),typeof self<"u"&&ts.setContext(self),this.setAnimationLoop=function(C){wr=C,ct.setAnimationLoop(C),C===null?ts.stop():ts.start()},ct.addEventListener("sessionstart",Ja),ct.addEventListener("sessionend",Oi),this.render=function(C,V){if(V!==void 0&&V.isCamera!==!0){jt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(P===!0)return;F!==null&&F.renderStart(C,V);let j=ct.enabled===!0&&ct.isPresenting===!0,Y=I!==null&&(lt===null||j)&&I.begin(L,lt);if(C.matrixWorldAutoUpdate===!0&&C.updateMatrixWorld(),V.parent===null&&V.matrixWorldAutoUpdate===!0&&V.updateMatrixWorld(),ct.enabled===!0&&ct.isPresenting===!0&&(I===null||I.isCompositing()===!1)&&(ct.cameraAutoUpdate===!0&&ct.updateCamera(V),V=ct.getCamera()),C.isScene===!0&&C.onBeforeRender(L,C,V,lt),M=et.get(C,A.length),M.init(V),M.state.textureUnits=Xt.getTextureUnits(),A.push(M),Le.multiplyMatrices(V.projectionMatrix,V.matrixWorldInverse),V.isArrayCamera?Xe.setFromArrayCamera(V):ne.setFromProjectionMatrix(Le,xi,V.reversedDepth),an=this.localClippingEnabled,Fe=st.init(this.clippingPlanes,an),S=yt.get(C,y.length),S.init(),y.push(S),this.info.render.frame++,ct.enabled===!0&&ct.isPresenting===!0){let Pt=L.xr.getDepthSensingMesh();Pt!==null&&es(Pt,V,-1/0,L.sortObjects)}es(C,V,0,L.sortObjects),S.finish(),F!==null&&F.updateLights(M.state.lightsArray),L.sortObjects===!0&&S.sort(Ht,se),Ze=ct.enabled===!1||ct.isPresenting===!1||ct.hasDepthSensing()===!1,Ze&&k.addToRenderList(S,C),this.info.autoReset===!0&&this.info.reset(),Fe===!0&&st.beginShadows();let Z=M.state.shadowsArray;if(mt.render(Z,C,V),Fe===!0&&st.endShadows(),(Y&&I.hasRenderPass())===!1){let Pt=S.opaque,Tt=S.transmissive;if(M.setupLights(),V.isArrayCamera){let It=V.cameras;if(Tt.length>0)for(let Bt=0,te=It.length;Bt<te;Bt++){let he=It[Bt];Si(Pt,Tt,C,he)}Ze&&k.render(C);for(let Bt=0,te=It.length;Bt<te;Bt++){let he=It[Bt];Uo(S,C,he,he.viewport)}}else Tt.length>0&&Si(Pt,Tt,C,V),Ze&&k.render(C),Uo(S,C,V)}lt!==null&&H===0&&(Xt.updateMultisampleRenderTarget(lt),Xt.updateRenderTargetMipmap(lt)),Y&&I.end(L),C.isScene===!0&&C.onAfterRender(L,C,V),bt.resetDefaultState(),J=-1,Q=null,A.pop(),A.length>0?(M=A[A.length-1],Xt.setTextureUnits(M.state.textureUnits),Fe===!0&&st.setGlobalState(L.clippingPlanes,M.state.camera)):M=null,y.pop(),y.length>0?S=y[y.length-1]:S=null,F!==null&&F.renderEnd()};function es(C,V,j,Y){if(C.visible===!1)return;if(C.layers.test(V.layers)){if(C.isGroup)j=C.renderOrder;else if(C.isLOD)C.autoUpdate===!0&&C.update(V);else if(C.isLight)M.pushLight(C),C.castShadow&&M.pushShadow(C);else if(C.isSprite){let Pt=V.isArrayCamera?Xe:ne;if(!C.frustumCulled||C.intersectsFrustum(Pt)){Y&&ye.setFromMatrixPosition(C.matrixWorld).applyMatrix4(Le);let Tt=ut.update(C),It=C.material;It.visible&&S.push(C,Tt,It,j,ye.z,null,V)}}else if(C.isMesh||C.isLine||C.isPoints){let Pt=V.isArrayCamera?Xe:ne;if(!C.frustumCulled||C.intersectsFrustum(Pt)){let Tt=ut.update(C),It=C.material;if(Y&&(C.boundingSphere!==void 0?(C.boundingSphere===null&&C.computeBoundingSphere(),ye.copy(C.boundingSphere.center)):(Tt.boundingSphere===null&&Tt.computeBoundingSphere(),ye.copy(Tt.boundingSphere.center)),ye.applyMatrix4(C.matrixWorld).applyMatrix4(Le)),Array.isArray(It)){let Bt=Tt.groups;for(let te=0,he=Bt.length;te<he;te++){let kt=Bt[te],de=It[kt.materialIndex];de&&de.visible&&S.push(C,Tt,de,j,ye.z,kt,V)}}else It.visible&&S.push(C,Tt,It,j,ye.z,null,V)}}}let Et=C.children;for(let Pt=0,Tt=Et.length;Pt<Tt;Pt++)es(Et[Pt],V,j,Y)}function Uo(C,V,j,Y){let{opaque:Z,transmissive:Et,transparent:Pt}=C;M.setupLightsView(j),Fe===!0&&st.setGlobalState(L.clippingPlanes,j),Y&&wt.viewport(it.copy(Y)),Z.length>0&&Je(Z,V,j),Et.length>0&&Je(Et,V,j),Pt.length>0&&Je(Pt,V,j),wt.buffers.depth.setTest(!0),wt.buffers.depth.setMask(!0),wt.buffers.color.setMask(!0),wt.setPolygonOffset(!1)}function Si(C,V,j,Y){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(M.state.transmissionRenderTarget[Y.id]===void 0){let kt=qt.has("EXT_color_buffer_half_float")||qt.has("EXT_color_buffer_float");M.state.transmissionRenderTarget[Y.id]=new li(1,1,{generateMipmaps:!0,type:kt?Pi:Kn,minFilter:xs,samples:Math.max(4,re.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:xe.workingColorSpace})}let Et=M.state.transmissionRenderTarget[Y.id],Pt=Y.viewport||it;Et.setSize(Pt.z*L.transmissionResolutionScale,Pt.w*L.transmissionResolutionScale);let Tt=L.getRenderTarget(),It=L.getActiveCubeFace(),Bt=L.getActiveMipmapLevel();L.setRenderTarget(Et),L.getClearColor(tt),ht=L.getClearAlpha(),ht<1&&L.setClearColor(16777215,.5),L.clear(),Ze&&k.render(j);let te=L.toneMapping;L.toneMapping=Yi;let he=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),M.setupLightsView(Y),Fe===!0&&st.setGlobalState(L.clippingPlanes,Y),Je(C,j,Y),Xt.updateMultisampleRenderTarget(Et),Xt.updateRenderTargetMipmap(Et),qt.has("WEBGL_multisampled_render_to_texture")===!1){let kt=!1;for(let de=0,Ye=V.length;de<Ye;de++){let Ce=V[de],{object:Re,geometry:gn,material:Ut,group:cn}=Ce;if(Ut.side===Bn&&Re.layers.test(Y.layers)){let ge=Ut.side;Ut.side=Yn,Ut.needsUpdate=!0,nn(Re,j,Y,gn,Ut,cn),Ut.side=ge,Ut.needsUpdate=!0,kt=!0}}kt===!0&&(Xt.updateMultisampleRenderTarget(Et),Xt.updateRenderTargetMipmap(Et))}L.setRenderTarget(Tt,It,Bt),L.setClearColor(tt,ht),he!==void 0&&(Y.viewport=he),L.toneMapping=te}function Je(C,V,j){let Y=V.isScene===!0?V.overrideMaterial:null;for(let Z=0,Et=C.length;Z<Et;Z++){let Pt=C[Z],{object:Tt,geometry:It,group:Bt}=Pt,te=Pt.material;te.allowOverride===!0&&Y!==null&&(te=Y),Tt.layers.test(j.layers)&&nn(Tt,V,j,It,te,Bt)}}function nn(C,V,j,Y,Z,Et){F!==null&&Z.isNodeMaterial&&F.setObject(C,Z),C.onBeforeRender(L,V,j,Y,Z,Et),C.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,C.matrixWorld),C.normalMatrix.getNormalMatrix(C.modelViewMatrix),Z.onBeforeRender(L,V,j,Y,C,Et),Z.transparent===!0&&Z.side===Bn&&Z.forceSinglePass===!1?(Z.side=Yn,Z.needsUpdate=!0,L.renderBufferDirect(j,V,Y,Z,C,Et),Z.side=$s,Z.needsUpdate=!0,L.renderBufferDirect(j,V,Y,Z,C,Et),Z.side=Bn):L.renderBufferDirect(j,V,Y,Z,C,Et),C.onAfterRender(L,V,j,Y,Z,Et)}function sn(C){let V=0;for(let j of C)j.texture!==null&&V++;return V}function Fi(C,V,j){V.isScene!==!0&&(V=mn);let Y=zt.get(C),Z=M.state.lights,Et=M.state.shadowsArray,Pt=Z.state.version,Tt=ot.getParameters(C,Z.state,Et,V,j,M.state.lightProbeGridArray),It=ot.getProgramCacheKey(Tt),Bt=Y.programs;Y.environment=C.isMeshStandardMaterial||C.isMeshLambertMaterial||C.isMeshPhongMaterial?V.environment:null,Y.fog=V.fog;let te=C.isMeshStandardMaterial||C.isMeshLambertMaterial&&!C.envMap||C.isMeshPhongMaterial&&!C.envMap;Y.envMap=N.get(C.envMap||Y.environment,te),Y.envMapRotation=Y.environment!==null&&C.envMap===null?V.environmentRotation:C.envMapRotation,Bt===void 0&&(C.addEventListener("dispose",oe),Bt=new Map,Y.programs=Bt,Y.programVariants=new Map);let he=Bt.get(It);if(he!==void 0){if(Y.currentProgram===he&&Y.lightsStateVersion===Pt)return Oo(C,Tt),he}else Tt.uniforms=ot.getUniforms(C),F!==null&&C.isNodeMaterial&&F.build(C,j,Tt),C.onBeforeCompile(Tt,L),he=ot.acquireProgram(Tt,It),Bt.set(It,he),Y.uniforms=Tt.uniforms;let kt=Y.uniforms;return(!C.isShaderMaterial&&!C.isRawShaderMaterial||C.clipping===!0)&&(kt.clippingPlanes=st.uniform),Oo(C,Tt),Y.needsLights=Ts(C),Y.lightsStateVersion=Pt,Y.needsLights&&(kt.ambientLightColor.value=Z.state.ambient,kt.lightProbe.value=Z.state.probe,kt.sunLights.value=Z.state.sun,kt.sunLightShadows.value=Z.state.sunShadow,kt.directionalLights.value=Z.state.directional,kt.directionalLightShadows.value=Z.state.directionalShadow,kt.spotLights.value=Z.state.spot,kt.spotLightShadows.value=Z.state.spotShadow,kt.rectAreaLights.value=Z.state.rectArea,kt.ltc_1.value=Z.state.rectAreaLTC1,kt.ltc_2.value=Z.state.rectAreaLTC2,kt.pointLights.value=Z.state.point,kt.pointLightShadows.value=Z.state.pointShadow,kt.hemisphereLights.value=Z.state.hemi,kt.sunShadowMatrix.value=Z.state.sunShadowMatrix,kt.sunShadowCascade.value=Z.state.sunShadowCascade,kt.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,kt.spotLightMatrix.value=Z.state.spotLightMatrix,kt.spotLightMap.value=Z.state.spotLightMap,kt.pointShadowMatrix.value=Z.state.pointShadowMatrix),Y.numLightProbeGrids=sn(M.state.lightProbeGridArray),Y.currentProgram=he,Y.uniformsList=null,he}function Qn(C,V,j,Y,Z){let Et=zt.get(C),Pt=Et.currentProgram.id+","+Y+","+Z,Tt=Et.programVariants.get(Pt);return Tt===void 0?(Tt=Fi(C,V,j),Et.programVariants.set(Pt,Tt)):(Et.currentProgram=Tt,Et.uniformsList=null,Et.outputColorSpace=Y,Et.toneMapping=Z),Tt}function Es(C){if(C.uniformsList===null){let V=C.currentProgram.getUniforms();C.uniformsList=fo.seqWithValue(V.seq,C.uniforms)}return C.uniformsList}function Oo(C,V){let j=zt.get(C);j.outputColorSpace=V.outputColorSpace,j.batching=V.batching,j.batchingColor=V.batchingColor,j.instancing=V.instancing,j.instancingColor=V.instancingColor,j.instancingMorph=V.instancingMorph,j.skinning=V.skinning,j.morphTargets=V.morphTargets,j.morphNormals=V.morphNormals,j.morphColors=V.morphColors,j.morphTargetsCount=V.morphTargetsCount,j.numClippingPlanes=V.numClippingPlanes,j.numIntersection=V.numClipIntersection,j.vertexAlphas=V.vertexAlphas,j.vertexTangents=V.vertexTangents,j.toneMapping=V.toneMapping}function Fo(C,V,j,Y,Z){V.isScene!==!0&&(V=mn),Xt.resetTextureUnits();let Et=V.fog,Pt=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?V.environment:null,Tt=lt===null?L.outputColorSpace:lt.isXRRenderTarget===!0?lt.texture.colorSpace:xe.workingColorSpace,It=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,Bt=N.get(Y.envMap||Pt,It),te=Y.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,he=!!j.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),kt=!!j.morphAttributes.position,de=!!j.morphAttributes.normal,Ye=!!j.morphAttributes.color,Ce=Yi;Y.toneMapped&&(lt===null||lt.isXRRenderTarget===!0)&&(Ce=L.toneMapping);let Re=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,gn=Re!==void 0?Re.length:0,Ut=zt.get(Y),cn=M.state.lights;if(Fe===!0&&(an===!0||C!==Q)){let Pe=C===Q&&Y.id===J;st.setState(Y,C,Pe)}let ge=!1,ns=!1;Y.version===Ut.__version?Ut.needsLights&&Ut.lightsStateVersion!==cn.state.version||Z.isBatchedMesh&&Ut.batching===!1||!Z.isBatchedMesh&&Ut.batching===!0||Z.isBatchedMesh&&Ut.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Ut.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Ut.instancing===!1||!Z.isInstancedMesh&&Ut.instancing===!0||Z.isSkinnedMesh&&Ut.skinning===!1||!Z.isSkinnedMesh&&Ut.skinning===!0||Z.isInstancedMesh&&Ut.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&Ut.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Ut.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Ut.instancingMorph===!1&&Z.morphTexture!==null||Ut.envMap!==Bt||Y.fog===!0&&Ut.fog!==Et||Ut.numClippingPlanes!==void 0&&(Ut.numClippingPlanes!==st.numPlanes||Ut.numIntersection!==st.numIntersection)||Ut.vertexAlphas!==te||Ut.vertexTangents!==he||Ut.morphTargets!==kt||Ut.morphNormals!==de||Ut.morphColors!==Ye||Ut.morphTargetsCount!==gn||Ut.numLightProbeGrids!==sn(M.state.lightProbeGridArray)?ge=!0:(Ut.outputColorSpace!==Tt||Ut.toneMapping!==Ce)&&(ns=!0):(ge=!0,Ut.__version=Y.version);let un=Ut.currentProgram;(ge===!0||ns===!0)&&(un=ns===!0?Qn(Y,V,Z,Tt,Ce):Fi(Y,V,Z),F&&Y.isNodeMaterial&&F.onUpdateProgram(Y,un,Ut));let Tr=!1,ki=!1,is=!1,le=un.getUniforms(),Ke=Ut.uniforms;if(wt.useProgram(un.program)&&(Tr=!0,ki=!0,is=!0),Y.id!==J&&(J=Y.id,ki=!0),Tr||Q!==C){wt.buffers.depth.getReversed()&&C.reversedDepth!==!0&&(C._reversedDepth=!0,C.updateProjectionMatrix()),le.setValue(B,"projectionMatrix",C.projectionMatrix),le.setValue(B,"viewMatrix",C.matrixWorldInverse);let hn=le.map.cameraPosition;hn!==void 0&&hn.setValue(B,wn.setFromMatrixPosition(C.matrixWorld)),re.logarithmicDepthBuffer&&le.setValue(B,"logDepthBufFC",2/(Math.log(C.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&le.setValue(B,"isOrthographic",C.isOrthographicCamera===!0),Q!==C&&(Q=C,ki=!0,is=!0)}if(Ut.needsLights&&(cn.state.sunShadowMap.length>0&&le.setValue(B,"sunShadowMap",cn.state.sunShadowMap,Xt),cn.state.directionalShadowMap.length>0&&le.setValue(B,"directionalShadowMap",cn.state.directionalShadowMap,Xt),cn.state.spotShadowMap.length>0&&le.setValue(B,"spotShadowMap",cn.state.spotShadowMap,Xt),cn.state.pointShadowMap.length>0&&le.setValue(B,"pointShadowMap",cn.state.pointShadowMap,Xt)),Z.isSkinnedMesh){le.setOptional(B,Z,"bindMatrix"),le.setOptional(B,Z,"bindMatrixInverse");let Pe=Z.skeleton;Pe&&(Pe.boneTexture===null&&Pe.computeBoneTexture(),le.setValue(B,"boneTexture",Pe.boneTexture,Xt))}Z.isBatchedMesh&&(le.setOptional(B,Z,"batchingTexture"),le.setValue(B,"batchingTexture",Z._matricesTexture,Xt),le.setOptional(B,Z,"batchingIdTexture"),le.setValue(B,"batchingIdTexture",Z._indirectTexture,Xt),le.setOptional(B,Z,"batchingColorTexture"),Z._colorsTexture!==null&&le.setValue(B,"batchingColorTexture",Z._colorsTexture,Xt));let Gn=j.morphAttributes;if((Gn.position!==void 0||Gn.normal!==void 0||Gn.color!==void 0)&&rt.update(Z,j,un),(ki||Ut.receiveShadow!==Z.receiveShadow)&&(Ut.receiveShadow=Z.receiveShadow,le.setValue(B,"receiveShadow",Z.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&V.environment!==null&&(Ke.envMapIntensity.value=V.environmentIntensity),Ke.dfgLUT!==void 0&&(Ke.dfgLUT.value=lw()),ki){if(le.setValue(B,"toneMappingExposure",L.toneMappingExposure),Ut.needsLights&&Ar(Ke,is),Et&&Y.fog===!0&&_t.refreshFogUniforms(Ke,Et),_t.refreshMaterialUniforms(Ke,Y,Mt,St,M.state.transmissionRenderTarget[C.id]),Ut.needsLights&&Ut.numLightProbeGrids>0){let Pe=b,hn=0;for(let Un of M.state.lightProbeGridArray)Un.texture!==null&&(Pe.textures[hn]=Un.texture,Pe.min[hn]=Un.boundingBox.min,Pe.max[hn]=Un.boundingBox.max,Pe.resolution[hn]=Un.resolution,hn++);for(let Un in Pe)Pe[Un].length=hn;Ke.probesSH.value=Pe.textures,Ke.probesMin.value=Pe.min,Ke.probesMax.value=Pe.max,Ke.probesResolution.value=Pe.resolution}fo.upload(B,Es(Ut),Ke,Xt)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(fo.upload(B,Es(Ut),Ke,Xt),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&le.setValue(B,"center",Z.center),le.setValue(B,"modelViewMatrix",Z.modelViewMatrix),le.setValue(B,"normalMatrix",Z.normalMatrix),le.setValue(B,"modelMatrix",Z.matrixWorld),Y.uniformsGroups!==void 0){let Pe=Y.uniformsGroups;for(let hn=0,Un=Pe.length;hn<Un;hn++){let Ka=Pe[hn];Gt.update(Ka,un),Gt.bind(Ka,un)}}return un}function Ar(C,V){C.ambientLightColor.needsUpdate=V,C.lightProbe.needsUpdate=V,C.sunLights.needsUpdate=V,C.sunLightShadows.needsUpdate=V,C.directionalLights.needsUpdate=V,C.directionalLightShadows.needsUpdate=V,C.pointLights.needsUpdate=V,C.pointLightShadows.needsUpdate=V,C.spotLights.needsUpdate=V,C.spotLightShadows.needsUpdate=V,C.rectAreaLights.needsUpdate=V,C.hemisphereLights.needsUpdate=V}function Ts(C){return C.isMeshLambertMaterial||C.isMeshToonMaterial||C.isMeshPhongMaterial||C.isMeshStandardMaterial||C.isShadowMaterial||C.isShaderMaterial&&C.lights===!0}this.getActiveCubeFace=function(){return $},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return lt},this.setRenderTargetTextures=function(C,V,j){let Y=zt.get(C);Y.__autoAllocateDepthBuffer=C.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),zt.get(C.texture).__webglTexture=V,zt.get(C.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:j,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(C,V){let j=zt.get(C);j.__webglFramebuffer=V,j.__useDefaultFramebuffer=V===void 0},this.setRenderTarget=function(C,V=0,j=0){lt=C,$=V,H=j;let Y=null,Z=!1,Et=!1;if(C){let Tt=zt.get(C);if(Tt.__useDefaultFramebuffer!==void 0){wt.bindFramebuffer(B.FRAMEBUFFER,Tt.__webglFramebuffer),it.copy(C.viewport),ft.copy(C.scissor),dt=C.scissorTest,wt.viewport(it),wt.scissor(ft),wt.setScissorTest(dt),J=-1;return}else if(Tt.__webglFramebuffer===void 0)Xt.setupRenderTarget(C);else if(Tt.__hasExternalTextures)Xt.rebindTextures(C,zt.get(C.texture).__webglTexture,zt.get(C.depthTexture).__webglTexture);else if(C.depthBuffer){let te=C.depthTexture;if(Tt.__boundDepthTexture!==te){if(te!==null&&zt.has(te)&&(C.width!==te.image.width||C.height!==te.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Xt.setupDepthRenderbuffer(C)}}let It=C.texture;(It.isData3DTexture||It.isDataArrayTexture||It.isCompressedArrayTexture)&&(Et=!0);let Bt=zt.get(C).__webglFramebuffer;C.isWebGLCubeRenderTarget?(Array.isArray(Bt[V])?Y=Bt[V][j]:Y=Bt[V],Z=!0):C.samples>0&&Xt.useMultisampledRTT(C)===!1?Y=zt.get(C).__webglMultisampledFramebuffer:Array.isArray(Bt)?Y=Bt[j]:Y=Bt,it.copy(C.viewport),ft.copy(C.scissor),dt=C.scissorTest}else it.copy(Vt).multiplyScalar(Mt).floor(),ft.copy(ue).multiplyScalar(Mt).floor(),dt=ae;if(j!==0&&(Y=z),wt.bindFramebuffer(B.FRAMEBUFFER,Y)&&wt.drawBuffers(C,Y),wt.viewport(it),wt.scissor(ft),wt.setScissorTest(dt),Z){let Tt=zt.get(C.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+V,Tt.__webglTexture,j)}else if(Et){let Tt=V;for(let It=0;It<C.textures.length;It++){let Bt=zt.get(C.textures[It]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+It,Bt.__webglTexture,j,Tt)}}else if(C!==null&&j!==0){let Tt=zt.get(C.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,Tt.__webglTexture,j)}J=-1};function Er(C){let V=zt.get(C);return(V.__readFormat!==C.format||V.__readType!==C.type)&&(V.__readFormat=C.format,V.__readType=C.type,V.__formatReadable=re.textureFormatReadable(C.format),V.__typeReadable=re.textureTypeReadable(C.type)),V}this.readRenderTargetPixels=function(C,V,j,Y,Z,Et,Pt,Tt=0){if(!(C&&C.isWebGLRenderTarget)){jt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let It=zt.get(C).__webglFramebuffer;if(C.isWebGLCubeRenderTarget&&Pt!==void 0&&(It=It[Pt],Array.isArray(It)&&(It=It[0])),It){wt.bindFramebuffer(B.FRAMEBUFFER,It);try{let Bt=C.textures[Tt],te=Bt.format,he=Bt.type;C.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Tt);let kt=Er(Bt);if(kt.__formatReadable===!1){jt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(kt.__typeReadable===!1){jt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}V>=0&&V<=C.width-Y&&j>=0&&j<=C.height-Z&&B.readPixels(V,j,Y,Z,xt.convert(te),xt.convert(he),Et)}finally{let Bt=lt!==null?zt.get(lt).__webglFramebuffer:null;wt.bindFramebuffer(B.FRAMEBUFFER,Bt)}}},this.readRenderTargetPixelsAsync=async function(C,V,j,Y,Z,Et,Pt,Tt=0){if(!(C&&C.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let It=zt.get(C).__webglFramebuffer;if(C.isWebGLCubeRenderTarget&&Pt!==void 0&&(It=It[Pt],Array.isArray(It)&&(It=It[0])),It)if(V>=0&&V<=C.width-Y&&j>=0&&j<=C.height-Z){wt.bindFramebuffer(B.FRAMEBUFFER,It);let Bt=C.textures[Tt],te=Bt.format,he=Bt.type;C.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Tt);let kt=Er(Bt);if(kt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(kt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let de=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,de),B.bufferData(B.PIXEL_PACK_BUFFER,Et.byteLength,B.STREAM_READ),B.readPixels(V,j,Y,Z,xt.convert(te),xt.convert(he),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let Ye=lt!==null?zt.get(lt).__webglFramebuffer:null;wt.bindFramebuffer(B.FRAMEBUFFER,Ye);let Ce=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await nm(B,Ce,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,de),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,Et),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(de),B.deleteSync(Ce),Et}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(C,V=null,j=0){let Y=Math.pow(2,-j),Z=Math.floor(C.image.width*Y),Et=Math.floor(C.image.height*Y),Pt=V!==null?V.x:0,Tt=V!==null?V.y:0;Xt.setTexture2D(C,0),B.copyTexSubImage2D(B.TEXTURE_2D,j,0,0,Pt,Tt,Z,Et),wt.unbindTexture()},this.copyTextureToTexture=function(C,V,j=null,Y=null,Z=0,Et=0){let Pt,Tt,It,Bt,te,he,kt,de,Ye,Ce=C.isCompressedTexture?C.mipmaps[Et]:C.image;if(j!==null)Pt=j.max.x-j.min.x,Tt=j.max.y-j.min.y,It=j.isBox3?j.max.z-j.min.z:1,Bt=j.min.x,te=j.min.y,he=j.isBox3?j.min.z:0;else{let le=Math.pow(2,-Z);Pt=Math.floor(Ce.width*le),Tt=Math.floor(Ce.height*le),C.isDataArrayTexture?It=Ce.depth:C.isData3DTexture?It=Math.floor(Ce.depth*le):It=1,Bt=0,te=0,he=0}Y!==null?(kt=Y.x,de=Y.y,Ye=Y.z):(kt=0,de=0,Ye=0);let Re=xt.convert(V.format),gn=xt.convert(V.type),Ut;V.isData3DTexture?(Xt.setTexture3D(V,0),Ut=B.TEXTURE_3D):V.isDataArrayTexture||V.isCompressedArrayTexture?(Xt.setTexture2DArray(V,0),Ut=B.TEXTURE_2D_ARRAY):(Xt.setTexture2D(V,0),Ut=B.TEXTURE_2D),wt.activeTexture(B.TEXTURE0),wt.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,V.flipY),wt.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,V.premultiplyAlpha),wt.pixelStorei(B.UNPACK_ALIGNMENT,V.unpackAlignment);let cn=wt.getParameter(B.UNPACK_ROW_LENGTH),ge=wt.getParameter(B.UNPACK_IMAGE_HEIGHT),ns=wt.getParameter(B.UNPACK_SKIP_PIXELS),un=wt.getParameter(B.UNPACK_SKIP_ROWS),Tr=wt.getParameter(B.UNPACK_SKIP_IMAGES);wt.pixelStorei(B.UNPACK_ROW_LENGTH,Ce.width),wt.pixelStorei(B.UNPACK_IMAGE_HEIGHT,Ce.height),wt.pixelStorei(B.UNPACK_SKIP_PIXELS,Bt),wt.pixelStorei(B.UNPACK_SKIP_ROWS,te),wt.pixelStorei(B.UNPACK_SKIP_IMAGES,he);let ki=C.isDataArrayTexture||C.isData3DTexture,is=V.isDataArrayTexture||V.isData3DTexture;if(C.isDepthTexture){let le=zt.get(C),Ke=zt.get(V),Gn=zt.get(le.__renderTarget),Pe=zt.get(Ke.__renderTarget);wt.bindFramebuffer(B.READ_FRAMEBUFFER,Gn.__webglFramebuffer),wt.bindFramebuffer(B.DRAW_FRAMEBUFFER,Pe.__webglFramebuffer);for(let hn=0;hn<It;hn++)ki&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,zt.get(C).__webglTexture,Z,he+hn),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,zt.get(V).__webglTexture,Et,Ye+hn)),B.blitFramebuffer(Bt,te,Bt+Pt,te+Tt,kt,de,kt+Pt,de+Tt,B.DEPTH_BUFFER_BIT,B.NEAREST);wt.bindFramebuffer(B.READ_FRAMEBUFFER,null),wt.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if(Z!==0||C.isRenderTargetTexture||zt.has(C)){let le=zt.get(C),Ke=zt.get(V);wt.bindFramebuffer(B.READ_FRAMEBUFFER,U),wt.bindFramebuffer(B.DRAW_FRAMEBUFFER,G);for(let Gn=0;Gn<It;Gn++)ki?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,le.__webglTexture,Z,he+Gn):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,le.__webglTexture,Z),is?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Ke.__webglTexture,Et,Ye+Gn):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,Ke.__webglTexture,Et),Z!==0?B.blitFramebuffer(Bt,te,Bt+Pt,te+Tt,kt,de,kt+Pt,de+Tt,B.COLOR_BUFFER_BIT,B.NEAREST):is?B.copyTexSubImage3D(Ut,Et,kt,de,Ye+Gn,Bt,te,Pt,Tt):B.copyTexSubImage2D(Ut,Et,kt,de,Bt,te,Pt,Tt);wt.bindFramebuffer(B.READ_FRAMEBUFFER,null),wt.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else is?C.isDataTexture||C.isData3DTexture?B.texSubImage3D(Ut,Et,kt,de,Ye,Pt,Tt,It,Re,gn,Ce.data):V.isCompressedArrayTexture?B.compressedTexSubImage3D(Ut,Et,kt,de,Ye,Pt,Tt,It,Re,Ce.data):B.texSubImage3D(Ut,Et,kt,de,Ye,Pt,Tt,It,Re,gn,Ce):C.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,Et,kt,de,Pt,Tt,Re,gn,Ce.data):C.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,Et,kt,de,Ce.width,Ce.height,Re,Ce.data):B.texSubImage2D(B.TEXTURE_2D,Et,kt,de,Pt,Tt,Re,gn,Ce);wt.pixelStorei(B.UNPACK_ROW_LENGTH,cn),wt.pixelStorei(B.UNPACK_IMAGE_HEIGHT,ge),wt.pixelStorei(B.UNPACK_SKIP_PIXELS,ns),wt.pixelStorei(B.UNPACK_SKIP_ROWS,un),wt.pixelStorei(B.UNPACK_SKIP_IMAGES,Tr),Et===0&&V.generateMipmaps===!0&&V.mipmapsAutoUpdate===!0&&B.generateMipmap(Ut),wt.unbindTexture()},this.initRenderTarget=function(C){zt.get(C).__webglFramebuffer===void 0&&Xt.setupRenderTarget(C)},this.initTexture=function(C){C.isCubeTexture?Xt.setTextureCube(C,0):C.isData3DTexture?Xt.setTexture3D(C,0):C.isDataArrayTexture||C.isCompressedArrayTexture?Xt.setTexture2DArray(C,0):Xt.setTexture2D(C,0),wt.unbindTexture()},this.resetState=function(){$=0,H=0,lt=null,wt.reset(),bt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return xi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=xe._getDrawingBufferColorSpace(t),e.unpackColorSpace=xe._getUnpackColorSpace()}};function mr(n){let t=new gs;return n===0||(t.onBeforeCompile=e=>{e.vertexShader=e.vertexShader.replace("#include <project_vertex>",`#include <project_vertex>
      vec4 pulled = vec4(mvPosition.xyz - normalize(mvPosition.xyz) * ${n.toExponential()}, 1.0);
      vec4 there = projectionMatrix * pulled;
      gl_Position.z = there.z / there.w * gl_Position.w;`)},t.customProgramCacheKey=()=>`nearer ${n}`),t}function mo(n,t,e,i,s,r){let o=n[e]-n[t],a=n[e+1]-n[t+1],l=n[e+2]-n[t+2],c=Math.hypot(o,a,l)||1e-12;o/=c,a/=c,l/=c;let u=Math.abs(l)<.9,[h,d,f]=u?[a,-o,0]:[0,l,-a],p=Math.hypot(h,d,f);h/=p,d/=p,f/=p,s[r]=i*h,s[r+1]=i*d,s[r+2]=i*f,s[r+4]=c*o,s[r+5]=c*a,s[r+6]=c*l,s[r+8]=i*(d*l-f*a),s[r+9]=i*(f*o-h*l),s[r+10]=i*(h*a-d*o);for(let _=0;_<3;_++)s[r+12+_]=(n[t+_]+n[e+_])/2;s[r+15]=1}var jc="#d55e00",Qc="#0072b2",Gm=["#e2cf9f","#c5bcd9","#b7cfa2","#d6aeb9","#9cc4dd","#cfcfcf"];function Da(n){return Gm[n%Gm.length]}var cw=["#453781","#39568c","#2d708e","#20908d","#29af7f","#73d055","#b8de29","#fde725"],uw=["#00224e","#083370","#35456c","#4f576c","#666970","#7d7c78","#948e77","#aea371","#c8b866","#e5cf52","#fee838"],hw=["#ffffcc","#ffeda0","#fed976","#feb24c","#fd8c3c","#fc4d2a","#e2191c","#bb0026","#800026"];function xd(n){let t=n.map(i=>[1,3,5].map(s=>parseInt(i.slice(s,s+2),16)/255));function e(i,s=[0,0,0]){let r=Math.min(1,Math.max(0,i))*(n.length-1),o=Math.min(n.length-2,Math.floor(r));for(let a=0;a<3;a++){let l=t[o][a];s[a]=l+(r-o)*(t[o+1][a]-l)}return s}return{at:e,gradient:`linear-gradient(to right, ${n.join(", ")})`}}var go=xd(cw),Wm=xd(uw),tu=xd(hw);function ke(n){return getComputedStyle(document.documentElement).getPropertyValue(n).trim()}function Ys(n){let t=matchMedia("(prefers-color-scheme: dark)");return t.addEventListener("change",n),()=>t.removeEventListener("change",n)}var Hm=[[],[8,4],[8,3,2,3],[2,3]],dw=7;function vs(n){return{colour:ke(`--line-${n%dw}`),dash:Hm[n%Hm.length]}}var fw=32767,Zs=24,pw=5/3*Math.PI,mw=.22,_d=.11,Xm=.7,$m=3,qm=1e-6;function Ym(n){let t=n.turns.map(l=>({...l,pivot:en(l.pivot,Float32Array),axis:Float32Array.from(en(l.axis,Int16Array),c=>c/fw),left:l.left&&en(l.left,Float32Array)})),e=n.pushes.map(l=>({...l,force:l.force&&en(l.force,Float32Array)})),{drives:i,stages:s}=n;function r(l){let c=s.find(({start:u,end:h})=>l>u&&l<=h);return i.map(({strength:u,rise:h},d)=>c?.drives.includes(d)?u*(h>0?Math.min(1,(l-c.start)/h):1):0)}let o=(l,c)=>l.reduce((u,h,d)=>u+h*c[d],0),a=l=>l.reduce((c,{shares:u})=>{let h=s.map(d=>Math.abs(o(u,i.map(({strength:f},p)=>d.drives.includes(p)?f:0))));return Math.max(c,...h)},0);return{...n,time:en(n.time,Float64Array),turns:t,pushes:e,strengthsAt:r,summed:o,largestTurn:a(t),largestPush:a(e)}}function Zm({drives:n,strengthsAt:t},e,i){let s=t(e);return n.flatMap(({text:r,unit:o,factor:a},l)=>s[l]?[`${r}: ${i(a*s[l])} ${o}`]:[])}function Jm(n){let{time:t,turns:e,pushes:i,strengthsAt:s,summed:r,largestTurn:o,largestPush:a}=n.efforts,l=Math.max(0,...e.map(I=>I.radius)),c=.05*n.mesh.span_m,u=mr(Math.max(l,c)),h=new ci(new $i(1,1,1,10),u,e.length*Zs+i.length),d=new ci(new ha(1,1,16),u,e.length+i.length),f=new kn;for(let I of[h,d])I.frustumCulled=!1,f.add(I);let p=new Float32Array(3*(Zs+2)),[_,g]=[0,0],m=(I,L,P,F,z)=>mo(p,3*L,3*P,F,I.instanceMatrix.array,16*z);function x(I,L){for(let P=0;P<3;P++)p[3*I+P]=L[P]}function w(I,L,P,F){let[z,U]=Ki(t,P),$=(I.left?yd(I.left,1,z,U)[0]:1)*r(I.shares,F)/o;if(!(Math.abs($)>qm))return;let[H,lt]=I.ends?gw(L,I.ends):[I.pivot,I.axis].map(ht=>yd(ht,3,z,U)),J=_w(lt,I),Q=xw(lt,J),it=pw*Math.min(1.2,Math.abs($))*Math.sign($),ft=ht=>H.map((gt,St)=>gt+I.radius*(Math.cos(ht)*J[St]+Math.sin(ht)*Q[St]));for(let ht=0;ht<=Zs;ht++)x(ht,ft(it*(ht/Zs-.5)));let dt=it/2;x(Zs+1,ft(dt+Math.sign($)*Xm));let tt=_d*I.radius;for(let ht=0;ht<Zs;ht++)m(h,ht,ht+1,tt,_++);m(d,Zs,Zs+1,$m*tt,g++)}function b(I,L,P,F){let[z,U]=Ki(t,P),G=I.force?yd(I.force,1,z,U)[0]:r(I.shares,F)/a;if(!(Math.abs(G)>qm))return;let $=mw*n.mesh.span_m*G,H=L.subarray(3*I.point,3*I.point+3),lt=J=>I.direction.map((Q,it)=>H[it]+J*Q);x(0,H),x(1,lt($)),x(2,lt($+Math.sign(G)*Xm*c)),m(h,0,1,_d*c,_++),m(d,1,2,$m*_d*c,g++)}function S(I){[_,g]=[0,0];let L=s(I),P=n.pointsAt(I);for(let F of e)w(F,P,I,L);for(let F of i)b(F,P,I,L);[h.count,d.count]=[_,g];for(let F of[h,d])F.instanceMatrix.needsUpdate=!0}let M=()=>u.color.set(new Qt(ke("--effort")));function y(){for(let I of[h,d])I.dispose(),I.geometry.dispose();u.dispose()}return{group:f,pose:S,paint:M,count:()=>g,dispose:y}}function yd(n,t,e,i){if(n.length===t)return Array.from(n);let s=Math.min(e+1,n.length/t-1);return Array.from({length:t},(r,o)=>{let a=n[e*t+o];return a+i*(n[s*t+o]-a)})}function gw(n,[t,e]){let[i,s]=[t,e].map(a=>Array.from(n.subarray(3*a,3*a+3))),r=i.map((a,l)=>s[l]-a),o=Math.hypot(...r)||1;return[i.map((a,l)=>(a+s[l])/2),r.map(a=>a/o)]}function xw(n,t){return[0,1,2].map(e=>n[(e+1)%3]*t[(e+2)%3]-n[(e+2)%3]*t[(e+1)%3])}function _w(n,t){t.side??=n.map(Math.abs).reduce((r,o,a,l)=>o<l[r]-.001?a:r,2);let e=n[t.side],i=n.map((r,o)=>(o===t.side?1:0)-e*r),s=Math.hypot(...i)||1;return i.map(r=>r/s)}var bs="tendon energy";function en(n,t){let e=atob(n),i=new Uint8Array(e.length);for(let s=0;s<e.length;s++)i[s]=e.charCodeAt(s);return new t(i.buffer)}function yi(n){let t=en(n.time,Float64Array),e=en(n.points,Float32Array),i=3*n.pointCount,s={[bs]:{width:n.tendonParts.length,values:en(n.tendonEnergy_J,Float32Array)}};for(let g of n.readings)s[g.name]={width:g.parts.length,values:en(g.values,Float32Array)};let r=Int32Array.from(n.between),o=Float64Array.from(n.share),a=new Float32Array(i);function l(g,m=a){return vd(t,e,i,g,m),m}function c(g,m=new Float32Array(3*o.length)){return u(l(g),m)}function u(g,m){for(let x=0;x<o.length;x++){let w=3*r[2*x],b=3*r[2*x+1];for(let S=0;S<3;S++){let M=g[w+S];m[3*x+S]=M+o[x]*(g[b+S]-M)}}return m}function h(g,m,x=new Float32Array(s[g].width)){return vd(t,s[g].values,s[g].width,m,x),x}function d(g,m){let{width:x,values:w}=s[g];return Float32Array.from(t,(b,S)=>w[S*x+m])}let f=en(n.restLength_m,Float32Array);function p(g,m){f.length===m.length?m.set(f):vd(t,f,m.length,g,m)}let _=n.efforts&&Ym(n.efforts);return{name:n.name,reach:Math.max(n.base.radius,_?.pushes.length?.12*n.span_m:0,...(_?.turns??[]).map(g=>.4*g.radius)),mesh:n,marks:n.marks,stages:n.stages,tendons:n.tendonParts.length,readings:n.readings,time:t,start:t[0],end:t[t.length-1],efforts:_,strained:n.built!==null,builtVertices:()=>u(en(n.built,Float32Array),new Float32Array(3*o.length)),restLengthsAt:p,pointsAt:l,verticesAt:c,verticesOf:u,valuesAt:h,line:d,stageAt:g=>n.stages.findLast(m=>m.start<=g)??n.stages[0],markAt:g=>n.marks.find(m=>Math.abs(m.time-g)<1e-9)}}function vd(n,t,e,i,s){let[r,o]=Ki(n,i),a=r*e,l=Math.min(r+1,n.length-1)*e;for(let c=0;c<e;c++){let u=t[a+c];s[c]=o===0?u:u+o*(t[l+c]-u)}}function Ki(n,t){if(!(t>n[0]))return[0,0];let e=n.length-1;if(t>=n[e])return[e,0];let i=0,s=e;for(;s-i>1;){let r=i+s>>1;n[r]<=t?i=r:s=r}return[i,(t-n[i])/(n[i+1]-n[i])]}function eu(){return document.getElementById("engine-program")!==null}async function nu(n,t){let e=new Blob([en(document.getElementById("engine-script").textContent,Uint8Array)]).stream(),i=await new Response(e.pipeThrough(new DecompressionStream("deflate"))).text(),s=URL.createObjectURL(new Blob([i],{type:"text/javascript"})),r=new Worker(s),o=new Map,a=0;r.onmessage=({data:u})=>{let h=o.get(u.to);h?(o.delete(u.to),u.said==="refused"?h.refuse(new Error(u.why)):h.take(u)):t(u)},r.onerror=u=>{u.preventDefault();let h=new Error(u.message||"the engine stopped");for(let{refuse:d}of o.values())d(h);o.clear(),t({said:"refused",why:h.message})};function l(u){let h=++a;return new Promise((d,f)=>{o.set(h,{take:d,refuse:f}),r.postMessage({...u,number:h})})}function c(){r.terminate(),URL.revokeObjectURL(s)}try{let u=document.getElementById("engine-program").textContent,{frame:h,version:d}=await l({act:"load",program:u,text:n});return{first:h,version:d,ask:l,tell:f=>r.postMessage(f),end:c}}catch(u){throw c(),u}}var Km={type:"change"},Sd={type:"start"},Qm={type:"end"},iu=new ks,jm=new oi,yw=Math.cos(70*nd.DEG2RAD),vn=new W,jn=2*Math.PI,Me={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},bd=1e-6,su=class extends va{constructor(t,e=null){super(t,e),this.state=Me.NONE,this.target=new W,this.cursor=new W,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Ws.ROTATE,MIDDLE:Ws.DOLLY,RIGHT:Ws.PAN},this.touches={ONE:Xs.ROTATE,TWO:Xs.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new W,this._lastQuaternion=new ai,this._lastTargetPosition=new W,this._quat=new ai().setFromUnitVectors(t.up,new W(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new oo,this._sphericalDelta=new oo,this._scale=1,this._panOffset=new W,this._rotateStart=new Yt,this._rotateEnd=new Yt,this._rotateDelta=new Yt,this._panStart=new Yt,this._panEnd=new Yt,this._panDelta=new Yt,this._dollyStart=new Yt,this._dollyEnd=new Yt,this._dollyDelta=new Yt,this._dollyDirection=new W,this._mouse=new Yt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=bw.bind(this),this._onPointerDown=vw.bind(this),this._onPointerUp=Sw.bind(this),this._onContextMenu=Rw.bind(this),this._onMouseWheel=Aw.bind(this),this._onKeyDown=Ew.bind(this),this._onTouchStart=Tw.bind(this),this._onTouchMove=Cw.bind(this),this._onMouseDown=Mw.bind(this),this._onMouseMove=ww.bind(this),this._interceptControlDown=Pw.bind(this),this._interceptControlUp=Iw.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Me.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Km),this.update(),this.state=Me.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;vn.copy(e).sub(this.target),vn.applyQuaternion(this._quat),this._spherical.setFromVector3(vn),this.autoRotate&&this.state===Me.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=jn:i>Math.PI&&(i-=jn),s<-Math.PI?s+=jn:s>Math.PI&&(s-=jn),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(vn.setFromSpherical(this._spherical),vn.applyQuaternion(this._quatInverse),e.copy(this.target).add(vn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=vn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new W(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new W(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=vn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(iu.origin.copy(this.object.position),iu.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(iu.direction))<yw?this.object.lookAt(this.target):(jm.setFromNormalAndCoplanarPoint(this.object.up,this.target),iu.intersectPlane(jm,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>bd||8*(1-this._lastQuaternion.dot(this.object.quaternion))>bd||this._lastTargetPosition.distanceToSquared(this.target)>bd?(this.dispatchEvent(Km),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?jn/60*this.autoRotateSpeed*t:jn/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){vn.setFromMatrixColumn(e,0),vn.multiplyScalar(-t),this._panOffset.add(vn)}_panUp(t,e){this.screenSpacePanning===!0?vn.setFromMatrixColumn(e,1):(vn.setFromMatrixColumn(e,0),vn.crossVectors(this.object.up,vn)),vn.multiplyScalar(t),this._panOffset.add(vn)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;vn.copy(s).sub(this.target);let r=vn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(jn*this._rotateDelta.x/e.clientHeight),this._rotateUp(jn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(jn*this._rotateDelta.x/e.clientHeight),this._rotateUp(jn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Yt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function vw(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function bw(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function Sw(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Qm),this.state=Me.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function Mw(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Ws.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Me.DOLLY;break;case Ws.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Me.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Me.ROTATE}break;case Ws.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Me.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Me.PAN}break;default:this.state=Me.NONE}this.state!==Me.NONE&&this.dispatchEvent(Sd)}function ww(n){switch(this.state){case Me.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Me.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Me.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function Aw(n){this.enabled===!1||this.enableZoom===!1||this.state!==Me.NONE||(n.preventDefault(),this.dispatchEvent(Sd),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(Qm))}function Ew(n){this.enabled!==!1&&this._handleKeyDown(n)}function Tw(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case Xs.ROTATE:if(this.enableRotate===!1){this.state=Me.NONE;break}this._handleTouchStartRotate(n),this.state=Me.TOUCH_ROTATE;break;case Xs.PAN:if(this.enablePan===!1){this.state=Me.NONE;break}this._handleTouchStartPan(n),this.state=Me.TOUCH_PAN;break;default:this.state=Me.NONE}break;case 2:switch(this.touches.TWO){case Xs.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Me.TOUCH_DOLLY_PAN;break;case Xs.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Me.TOUCH_DOLLY_ROTATE;break;default:this.state=Me.NONE}break;default:this.state=Me.NONE}this.state!==Me.NONE&&this.dispatchEvent(Sd)}function Cw(n){switch(this._trackPointer(n),this.state){case Me.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Me.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Me.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Me.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Me.NONE}}function Rw(n){this.enabled!==!1&&n.preventDefault()}function Pw(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Iw(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Md=120,tg=2,eg=6;function wd(n,t,e){let i=new WeakMap,s=t.reduce((l,c)=>n[c].mesh.tubes.reduce((u,h)=>Math.max(u,h.radius),Math.max(l,n[c].reach)),Math.max(...t.map(l=>n[l].mesh.joints.length?n[l].mesh.jointRadius:0))),r=null;function o(){let{span:l}=e;if(!i.has(l)){let c=Array.from({length:Md+1},(u,h)=>e.timeAt(h/Md));i.set(l,c.map(u=>t.map(h=>n[h].pointsAt(e.clipTime(h,u)).slice())))}return i.get(l)}function a(l,c){let u=[...l.flatMap(d=>d.toArray()),...c].join();if(r?.key===u&&r.span===e.span)return r;let h=o().map(d=>Lw(d,l,c,s));return r={key:u,span:e.span,rows:Nw(h),whole:ng(h)},r}return function(c,u,h,d){let f=new W().crossVectors(u,c).normalize(),p=[f,new W().crossVectors(c,f),c],{rows:_,whole:g}=a(p,h),m=d?Dw(_,e.wayAt(e.time)*Md):g,[x,w,b,S,M,y]=m,A=[(x-w)/2,(b-S)/2,(M-y)/2],I=Math.max((x+w)/(2*h[0]),(b+S)/(2*h[1])),L=new W;for(let[P,F]of p.entries())L.addScaledVector(F,A[P]);return{target:L,distance:I-A[2]||1}}}function Lw(n,t,e,i){let s=new Float64Array(eg).fill(-1/0),r=e.map(h=>i*Math.hypot(1,h)),o=[r[0],r[0],r[1],r[1],0,0],[a,l,c]=t.map(h=>h.toArray()),u=(h,d,f)=>h[0]*d[f]+h[1]*d[f+1]+h[2]*d[f+2];for(let h of n)for(let d=0;d<h.length;d+=3){let[f,p,_]=[u(a,h,d),u(l,h,d),u(c,h,d)],[g,m]=[e[0]*_,e[1]*_],x=[f+g,g-f,p+m,m-p,_,-_];for(let w=0;w<eg;w++)x[w]>s[w]&&(s[w]=x[w])}return s.map((h,d)=>h+o[d])}function ng(n){return n.reduce((t,e)=>t.map((i,s)=>Math.max(i,e[s])))}function Nw(n){let t=(i,s)=>i.slice(Math.max(0,s-tg),s+tg+1),e=n.map((i,s)=>ng(t(n,s)));return n.map((i,s)=>{let r=t(e,s);return r[0].map((o,a)=>r.reduce((l,c)=>l+c[a],0)/r.length)})}function Dw(n,t){let e=Math.min(n.length-2,Math.max(0,Math.floor(t))),i=Math.min(1,Math.max(0,t-e));return n[e].map((s,r)=>s+i*(n[e+1][r]-s))}var ig=28,Uw=1.05,sg=Math.PI/24,Ow=1.15,gr=[{name:"3-D",text:"obliquely from above",towards:[.37,-.695,.616]},{name:"top",text:"from above",towards:[0,-5e-4,1]},{name:"side",text:"from the side, level with what lies flat",towards:[0,-1,1e-4]},{name:"along",text:"from the far end, along the middle",towards:[1,0,1e-4]}];function rg(n,t,e,i,s=Ua()){let{size:r,target:o}=Fw(t),a=t.map((S,M)=>M),l=wd(t,a,e),c=a.map(S=>wd(t,[S],e)),u=new $n(ig,1,.02*r,60*r);u.up.set(0,0,1);let h=new su(u,n);h.minDistance=.1*r,h.maxDistance=20*r;let d=null;function f(S=0){let M=s.oneScale?l:c[S],y=Math.tan(ig*Math.PI/360)/Uw;d=M(s.towards,u.up,[y*u.aspect,y],s.following),s.oneScale&&(d.distance*=s.scale),h.target.copy(d.target).addScaledVector(s.aside,d.distance),u.position.copy(h.target).addScaledVector(s.towards,s.closer*d.distance),u.lookAt(h.target),u.updateMatrixWorld()}function p(){f(),i()}h.addEventListener("change",()=>{let S=u.position.clone().sub(h.target);s.closer=S.length()/d.distance,s.towards.copy(S).normalize(),s.aside.copy(h.target).sub(d.target).divideScalar(d.distance),p()});let _=S=>{document.activeElement!==n&&!S.ctrlKey&&S.stopImmediatePropagation()};n.parentElement.addEventListener("wheel",_,{capture:!0});function g({towards:S}){s.towards.set(...S).normalize(),s.closer=1,s.aside.set(0,0,0),p()}function m(S,M){let y=s.towards.clone().applyAxisAngle(u.up,S*sg),A=new W().crossVectors(u.up,y).normalize(),I=y.clone().applyAxisAngle(A,-M*sg);s.towards.copy(Math.abs(I.z)<.9999?I:y),p()}function x(S){let M=s.closer*d.distance*Ow**-S;s.closer=Math.min(h.maxDistance,Math.max(h.minDistance,M))/d.distance,p()}function w(S){Object.assign(s,S),p()}function b(S,M){u.aspect=S,u.updateProjectionMatrix(),h.rotateSpeed=M,h.panSpeed=M,p()}return{camera:u,controls:h,look:s,size:r,target:o,aim:f,show:g,turn:m,zoom:x,choose:w,resize:b,dispose:()=>h.dispose()}}function Ua(){return{towards:new W(...gr[0].towards).normalize(),closer:1,aside:new W,following:!0,oneScale:!0,scale:1}}function Fw(n){let t=new W(1/0,1/0,1/0),e=new W(-1/0,-1/0,-1/0),i=new W;for(let r of n){let o=Math.max(1,Math.floor(r.time.length/60));for(let a=0;a<r.time.length;a+=o){let l=r.pointsAt(r.time[a]);for(let c=0;c<l.length;c+=3)i.fromArray(l,c),t.min(i),e.max(i)}}let s=t.clone().add(e).multiplyScalar(.5);return{target:s,size:e.distanceTo(s)||1}}function bn(n){return`${n[0]?.toUpperCase()??""}${n.slice(1)}`}function Dn(n,t){let e=n.toFixed(t);return(Number(e)===0?0 .toFixed(t):e).replace("-","−")}function Ee(n){let t=Number(n.toPrecision(4)),e=Math.abs(t);return(e!==0&&(e>=1e5||e<.001)?n.toExponential(2):String(t)).replaceAll("-","−")}function Oa(n){let t=Math.max(Math.abs(n.start),Math.abs(n.end));return t>=.2?{unit:"s",factor:1}:t>=2e-4?{unit:"ms",factor:1e3}:{unit:"µs",factor:1e6}}function xr(n,t){let{unit:e,factor:i}=Oa(t),s=Math.ceil(2.7-Math.log10(i*(t.end-t.start)));return`${Dn(i*n,Math.min(6,Math.max(0,s)))} ${e}`}var Fa=1/0,kw={m:1,cm:100,mm:1e3,µm:1e6};function og(n,t,e){let i=new Set,s=n.readings.map(({unit:f})=>f==="deg"?180/Math.PI:t.units.length*kw[f]),r={start:n.start,end:Math.max(n.end,n.start+1),origins:[0],whole:!0},o=e,a=0;function l(){a||=requestAnimationFrame(()=>{a=0;for(let f of i)f()})}let c=(f,p)=>f!==Fa?n.pointsAt(f,p):p?(p.set(o.points),p):o.points,u={...n,marks:[],efforts:null,reach:n.mesh.base.radius,pointsAt:c,verticesAt:(f,p)=>f===Fa?n.verticesOf(o.points,p):n.verticesAt(f,p),valuesAt(f,p,_){if(p!==Fa)return n.valuesAt(f,p,_);let g=n.readings.findIndex(x=>x.name===f),m=f===bs?o.energies_J:o.readings[g].map(x=>s[g]*x);return _?(_.set(m),_):Float32Array.from(m)},restLengthsAt(f,p){f===Fa?p.set(o.restLengths_m):n.restLengthsAt(f,p)},markAt:()=>{}},h={get time(){return o.time_s},span:r,clipTime:(f,p=Fa)=>p,timeAt:f=>r.start+f*(r.end-r.start),wayAt:()=>0,onChange(f){return i.add(f),l(),()=>i.delete(f)}};function d(f){o=f,l()}return{clip:u,clock:h,show:d,get frame(){return o}}}var Bw=[["space","play or pause"],["← →","a little back or on"],["page down, page up","further back or on"],["home, end","start, end"]],zw="shift with ← → ↑ ↓",Vw=[["+ −","nearer, further"],["0","the first view again"]];function ru(n,t,e){let s=(n.length===1?n[0].marks:[]).map((o,a)=>[String(a+1),o.name]),r=[...Bw,...s,...t?[[zw,`turn the ${e}`],...Vw]:[]].map(([o,a])=>R("tr",{},R("th",{scope:"row"},o),R("td",{},a)));return R("details",{className:"keys"},R("summary",{},"Keys"),R("table",{},R("tbody",{},...r)),R("p",{},"Space and arrows act wherever nothing else on the page has the keys, the others in the player."))}var ag={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]};function lg({key:n,shiftKey:t},e,i,s){if(t&&n in ag)e?.turn(...ag[n]);else if(s)if(n==="+"||n==="=")e?.zoom(1);else if(n==="-"||n==="−")e?.zoom(-1);else if(n==="0")e?.show(i);else return!1;else return!1;return!0}function cg(n,t,e){n.addEventListener("keydown",i=>{!i.ctrlKey&&!i.metaKey&&!i.altKey&&lg(i,t,e,!0)&&i.preventDefault()})}function ou(n,t,e,i,s){let r={ArrowLeft:-1,ArrowRight:1,PageUp:10,PageDown:-10};function o(c){e.pause(),c()}function a(c,u){let{key:h}=c;if(lg(c,i,s,u))return!0;if(h in r)o(()=>e.step(r[h]));else if(h===" ")e.playing?e.pause():e.play();else if(h==="Home")o(()=>e.seek(e.span.start));else if(h==="End")o(()=>e.seek(e.span.end));else if(u)if(t.length===1&&t[0].marks[Number(h)-1])o(()=>e.seekClip(0,t[0].marks[Number(h)-1].time));else return!1;else return!1;return!0}function l(c){let u=document.activeElement,h=n.contains(u);!(h||u===document.body||u===null)||c.ctrlKey||c.metaKey||c.altKey||u instanceof HTMLSelectElement||u?.dataset?.keys==="own"||c.key===" "&&/^(BUTTON|SUMMARY|A)$/.test(u?.tagName??"")||u===document.body&&/^(Home|End|PageUp|PageDown)$/.test(c.key)||a(c,h)&&c.preventDefault()}return document.addEventListener("keydown",l),()=>document.removeEventListener("keydown",l)}var ug=2.4;function ka(n){let t=10**Math.floor(Math.log10(n/ug));return t*[5,2,1].find(e=>e*t<=n/ug)}function hg(n,t){let e=ka(n),i=e*Math.ceil(1.25*n/e),s=[],[r,o]=[t.x,t.y].map(c=>e*Math.round(c/e));for(let c=-i;c<=i+e/2;c+=e)s.push(r+c,o-i,0,r+c,o+i,0,r-i,o+c,0,r+i,o+c,0);let a=new xn().setAttribute("position",new tn(s,3)),l=new cr(a,new zs({transparent:!0,opacity:.5,depthWrite:!1}));return l.frustumCulled=!1,l}function Ad(n,t,e,i){let s=i?["marks on the time line: the states of each run, in its colour"]:[];return R("ul",{className:"legend"},...n.map(({sample:r,text:o})=>r==="tendon"?Hw(o,t):Gw(r,o)),...n.some(({sample:r})=>r==="tendon")?[R("li",{},"slack tendons hang, drawn with their resting length")]:[],R("li",{},`squares of the grid: ${Ww(ka(e))}`),...s.map(r=>R("li",{},r)))}function Gw(n,t){let[e,i]=n.split(" "),s={mountain:{color:jc},valley:{color:Qc},region:{background:Da(i)}};return R("li",{className:e==="region"?"of-region":""},dg(e==="region"?"panel":e,s[e]??{}),t)}function Hw(n,t){let e=R("li",{className:"energy"},`${n}: 0`,Ed(go));return e.append(`${Ee(t.factor*t.largest_J)} ${t.unit}`),e}function Ed(n){return dg("bar",{background:n.gradient})}function dg(n,t){let e=R("span",{className:`swatch ${n}`,"aria-hidden":"true"});return Object.assign(e.style,t),e}function Ww(n){let[t,e]=n>=1?["m",1]:n>=.01?["cm",100]:n>=1e-4?["mm",1e3]:["µm",1e6];return`${Ee(e*n)} ${t}`}function fg(n,t){if(!(t>n*(1+1e-6)))return 0;let[e,i]=[0,t/2];for(let s=0;s<40;s++){let r=(e+i)/2;Xw(n,r)<t?e=r:i=r}return(e+i)/2}function Xw(n,t){return t===0?n:Math.hypot(n,4*t)/2+n*n*Math.asinh(4*t/(n||1e-12))/(8*t)}function mg(n){let{triangles:t,faces:e}=n.mesh,i=n.builtVertices(),s=Array.from({length:e.length},(c,u)=>pg(i,t,u)),r=new Float32Array(e.reduce((c,u)=>Math.max(c,u),0)+1),o=new Float32Array(e.length);function a(c){r.fill(-1/0);for(let u=0;u<e.length;u++){let[h,d,f]=s[u],p=h*f-d*d;if(p<=1e-9*(h+f)**2)continue;let[_,g,m]=pg(c,t,u),x=(f*_-2*d*g+h*m)/(2*p),w=(_*m-g*g)/p,b=(x+Math.sqrt(Math.max(x*x-w,0))-1)/2;r[e[u]]=Math.max(r[e[u]],b)}for(let u=0;u<e.length;u++)o[u]=Math.max(0,r[e[u]]);return o}function l(){let c=new Float32Array(i.length),u=0;for(let h of n.time)u=a(n.verticesAt(h,c)).reduce((d,f)=>Math.max(d,f),u);return u}return{at:a,largest:l}}function pg(n,t,e){let[i,s,r]=[0,1,2].map(c=>3*t[3*e+c]),[o,a,l]=[0,0,0];for(let c=0;c<3;c++){let u=n[s+c]-n[i+c],h=n[r+c]-n[i+c];o+=u*u,a+=u*h,l+=h*h}return[o,a,l]}var $w=.9,gg=.4,qw=.02,Yw=["crease","rim","edge"],Js=12;function Td(n,t){let{mesh:e}=n,i=new Float32Array(3*e.share.length),s=new Float32Array(n.tendons),r=Math.max(0,...e.tubes.map(I=>I.radius)),[o,a]=[!1,!0].map(I=>Jw(e,I)),l=xg(e.tubes.filter(I=>I.kind==="bar"),20,0),c=xg(e.tubes.filter(I=>Yw.includes(I.kind)),8,.4*r),u=Kw(n,2.4*r),h=Qw(e.base),d=n.efforts?Jm(n):null,f=n.strained?mg(n):null,p=0,_=t1(e),g=new kn;g.add(h.object,a.object,l.object,_.object,c.object,u.object,o.object),d&&g.add(d.group);let m=Zw(o.object,a.object,l.object),x=[0,0,0],w=new Qt;function b(I){n.verticesAt(I,i),o.pose(i),a.pose(i);for(let P of[l,c,_])P.pose(i);n.valuesAt(bs,I,s);let L=s.map(P=>t>0?P/t:0);u.pose(i,I,P=>gg+(1-gg)*Math.min(1,Math.max(0,L[P])/qw));for(let P=0;P<n.tendons;P++)go.at(L[P],x),u.colour(P,w.setRGB(...x,"srgb"));n.tendons&&(u.object.instanceColor.needsUpdate=!0),d?.pose(I),p&&S()}function S(){let I=f.at(i),L=[0,0,0];for(let P of[o,a])P.colour(F=>w.setRGB(...tu.at(I[F]/p,L),"srgb"))}function M(I){p=f?I:0;for(let L of[o,a])L.flat(p>0),p||L.colour(P=>w.set(Da(e.regions[P])));p&&S()}function y(){for(let I of[l,c,_,h])I.paint();d?.paint(),m.children[0].material.color.set(ke("--shadow"))}function A(){for(let I of[l,c,u,_])I.object.dispose();for(let I of[o,a])I.dispose();d?.dispose(),h.dispose();for(let I of[l,c,u,_])I.object.geometry.dispose(),I.object.material.dispose();m.children[0].material.dispose()}return{group:g,shadow:m,pose:b,paint:y,sort:o.sort,vertices:i,tendons:u.object,efforts:d,strains:f,showStrain:M,dispose:A}}function Zw(...n){let t=new lr({side:Bn,transparent:!0,opacity:.12,depthWrite:!1,stencilWrite:!0,stencilRef:1,stencilFunc:qh,stencilZPass:$h}),e=new kn;for(let i of n){let s=i.isInstancedMesh?new ci(i.geometry,t,i.count):new Nn(i.geometry,t);i.isInstancedMesh&&(s.instanceMatrix=i.instanceMatrix),s.frustumCulled=!1,e.add(s)}return e.scale.z=1e-5,e}function Jw(n,t){let e=n.regions.flatMap((b,S)=>n.solid[b]===t?[S]:[]),i=e.flatMap(b=>n.triangles.slice(3*b,3*b+3)),s=e.length,r=new rn(new Float32Array(3*i.length),3).setUsage(Ra),o=new rn(new Float32Array(3*i.length),3).setUsage(Ra),a=new rn(new Uint32Array(i.length),1).setUsage(Ra);for(let b=0;b<i.length;b++)a.array[b]=b;let l=new xn;l.setAttribute("position",r),l.setAttribute("color",o),l.setIndex(a);let c=new gs({vertexColors:!0,side:Bn,flatShading:!0,transparent:!t,opacity:t?1:$w,depthWrite:t,forceSinglePass:!0});c.onBeforeCompile=b=>{b.fragmentShader=b.fragmentShader.replace("#include <color_fragment>",`#include <color_fragment>
if (!gl_FrontFacing) diffuseColor.rgb *= 0.84;`)};let u=new lr({vertexColors:!0,side:Bn}),h=new Nn(l,c);h.frustumCulled=!1,h.renderOrder=t?0:1;let d=new Qt;f(b=>d.set(Da(n.regions[b])));function f(b){for(let[S,M]of e.entries()){let y=b(M);for(let A=0;A<3;A++)y.toArray(o.array,9*S+3*A)}o.needsUpdate=!0}let p=b=>{h.material=b?u:c};function _(){l.dispose(),c.dispose(),u.dispose()}function g(b){for(let S=0;S<i.length;S++)for(let M=0;M<3;M++)r.array[3*S+M]=b[3*i[S]+M];r.needsUpdate=!0}let m=new Float32Array(s),x=Array.from({length:s},(b,S)=>S);function w(b){let S=r.array;for(let M=0;M<s;M++){let y=0;for(let A=0;A<3;A++){let I=9*M+A;y+=((S[I]+S[I+3]+S[I+6])/3-b.getComponent(A))**2}m[M]=y}x.sort((M,y)=>m[y]-m[M]);for(let M=0;M<s;M++)for(let y=0;y<3;y++)a.array[3*M+y]=3*x[M]+y;a.needsUpdate=!0}return{object:h,pose:g,sort:w,colour:f,flat:p,dispose:_}}function xg(n,t,e){let i=new ci(new $i(1,1,1,t),mr(e),n.length);i.frustumCulled=!1,o();let s=n.map(a=>[3*a.ends[0],3*a.ends[1],a.radius]);function r(a,l=()=>1){let c=i.instanceMatrix.array;for(let[u,[h,d,f]]of s.entries())mo(a,h,d,l(u)*f,c,16*u);i.instanceMatrix.needsUpdate=!0}function o(){let a={M:new Qt(jc),V:new Qt(Qc),B:new Qt(ke("--bar"))};for(let[l,c]of n.entries())i.setColorAt(l,a[c.crease]);n.length&&(i.instanceColor.needsUpdate=!0)}return{object:i,pose:r,paint:o}}function Kw(n,t){let e=n.mesh.tubes.filter(l=>l.kind==="tendon"),i=new ci(new $i(1,1,1,12),mr(t),e.length*Js);i.frustumCulled=!1;let s=new Float32Array(e.length),r=new Float32Array(3*(Js+1));function o(l,c,u){n.restLengthsAt(c,s);let h=i.instanceMatrix.array;for(let[d,{ends:f,radius:p}]of e.entries()){jw(l,3*f[0],3*f[1],s[d],r);for(let _=0;_<Js;_++)mo(r,3*_,3*_+3,u(d)*p,h,16*(d*Js+_))}i.instanceMatrix.needsUpdate=!0}function a(l,c){for(let u=0;u<Js;u++)i.setColorAt(l*Js+u,c)}return{object:i,pose:o,colour:a}}function jw(n,t,e,i,s){let r=[0,1,2].map(d=>n[e+d]-n[t+d]),o=Math.hypot(...r),a=fg(o,i),l=Math.abs(r[2])>.999*o?[1,0,0]:[0,0,-1],c=l.reduce((d,f,p)=>d+f*r[p],0)/(o*o||1),u=l.map((d,f)=>d-c*r[f]),h=Math.hypot(...u)||1;for(let d=0;d<=Js;d++){let f=d/Js,p=4*a*f*(1-f)/h;for(let _=0;_<3;_++)s[3*d+_]=n[t+_]+f*r[_]+p*u[_]}}function Qw({rods:n,radius:t}){let e=new Float32Array(n.flat(2)),i=mr(0),s=new ci(new $i(1,1,1,16),i,n.length),r=new ci(new so(1,16,12),i,2*n.length),o=new kn;for(let l of[s,r])l.frustumCulled=!1,o.add(l);for(let l=0;l<n.length;l++)mo(e,6*l,6*l+3,t,s.instanceMatrix.array,16*l);for(let l=0;l<2*n.length;l++){let c=r.instanceMatrix.array;for(let u=0;u<3;u++)[c[16*l+5*u],c[16*l+12+u]]=[t,e[3*l+u]];c[16*l+15]=1}function a(){for(let l of[s,r])l.dispose(),l.geometry.dispose();i.dispose()}return{object:o,paint:()=>i.color.set(ke("--base")),dispose:a}}function t1(n){let t=new ci(new so(1,16,12),mr(0),n.joints.length);t.frustumCulled=!1;let e=()=>t.material.color.set(ke("--joint"));e();function i(s){let r=t.instanceMatrix.array;for(let[o,a]of n.joints.entries()){for(let l=0;l<3;l++)r[16*o+5*l]=n.jointRadius,r[16*o+12+l]=s[3*a+l];r[16*o+15]=1}t.instanceMatrix.needsUpdate=!0}return{object:t,pose:i,paint:e}}var e1=4096,n1=3.2,i1=new W(-.45,.75,1),s1=.42*Math.PI,r1=.64*Math.PI,o1=.5,a1=.14;function Ba(n,t,e,i,s){let r=R("canvas",{tabIndex:0,role:"img","aria-label":`${i} ${l1}`}),o=r.getContext("webgl2",{antialias:!0,alpha:!0,stencil:!0});if(!o)return null;let a=n.map(()=>R("div",{className:"cell"})),l=n.length>1,c=R("div",{className:l?"stage several":"stage"},r,...a);c.style.setProperty("--columns",String(n.length===4?2:Math.min(n.length,n.length>6?4:3)));let u=()=>l?Math.ceil(n1*parseFloat(getComputedStyle(a[0]).fontSize)):0,h=new Zc({canvas:r,context:o,antialias:!0,alpha:!0,stencil:!0});h.setScissorTest(!0);let d=rg(r,n,t,g,s),f=n.map(L=>c1(L,e(L),d)),p=0,_=!1;function g(){p||(p=requestAnimationFrame(x))}function m(){for(let[L,P]of f.entries())P.shape.pose(t.clipTime(L));_=!0}function x(){cancelAnimationFrame(p),p=0,_||m();let L=r.clientHeight,P=u();h.setScissor(0,0,r.clientWidth,L),h.setViewport(0,0,r.clientWidth,L),h.clear();for(let[F,z]of f.entries()){d.aim(F);let U=a[F],G=[U.offsetLeft,L-U.offsetTop-U.offsetHeight,U.offsetWidth,U.offsetHeight-P];h.setViewport(...G),h.setScissor(...G),z.light.position.copy(i1).applyQuaternion(d.camera.quaternion);let $=d.camera.position.z>z.floor.position.z;z.floor.material.opacity=$?o1:a1,z.shape.shadow.visible=$,z.shape.sort(d.camera.position),h.render(z.scene,d.camera)}d.aim()}function w(){for(let L of f)L.floor.material.color.set(ke("--floor")),L.shape.paint();g()}function b(){let[L,P]=[c.clientWidth,c.clientHeight];if(!L||!P)return;h.setPixelRatio(Math.min(devicePixelRatio,2,e1/Math.max(L,P))),h.setSize(L,P,!1);let F=a[0].offsetHeight-u();d.resize(a[0].offsetWidth/F,P/F),x()}let S=new ResizeObserver(b);S.observe(c);let M=t.onChange(()=>{_=!1,x()}),y=Ys(w);r.addEventListener("webglcontextrestored",g),w();function A(){cancelAnimationFrame(p),M(),y(),S.disconnect(),d.dispose();for(let{shape:L,floor:P}of f)L.dispose(),P.geometry.dispose(),P.material.dispose();h.dispose(),h.forceContextLoss(),c.remove()}function I(L){let P=L?f.reduce((F,{shape:z})=>Math.max(F,z.strains?.largest()??0),0):0;for(let{shape:F}of f)F.showStrain(P||(L?Number.MIN_VALUE:0));return g(),P}return{element:c,canvas:r,cells:a,eye:d,pose:m,draw:x,views:f,showStrain:I,statistics:()=>h.info.render,dispose:A}}var l1="Drag to turn it, pinch to zoom; keys are listed below.";function c1(n,t,e){let i=hg(e.size,e.target);i.position.z=u1(n)-.06*e.size,t.shadow.position.z=i.position.z+.001*e.size;let s=new _a("#ffffff",s1),r=new ia;return r.add(t.group,t.shadow,i,s,new ma("#ffffff","#dde2e8",r1)),{shape:t,floor:i,light:s,scene:r}}function u1(n){let t=1/0,e=Math.max(1,Math.floor(n.time.length/200));for(let i=0;i<n.time.length;i+=e){let s=n.pointsAt(n.time[i]);for(let r=2;r<s.length;r+=3)t=Math.min(t,s[r])}return t}var h1=.3,d1=4,f1=4,yg=[{name:"even motion",value:"even"},{name:"real time",value:1},{name:"1/2",value:1/2},{name:"1/5",value:1/5},{name:"1/10",value:1/10},{name:"1/20",value:1/20},{name:"1/50",value:1/50},{name:"1/100",value:1/100}];function vg(n,t){let e=p1(n,t),i=new Float64Array(e.length);for(let[l,c]of n.entries())m1(c,t.origins[l],e,i);for(let l=1;l<i.length;l++)i[l]+=i[l-1];let s=i[i.length-1],r=s>0?h1:1;for(let l=0;l<i.length;l++){let c=(e[l]-e[0])/(e[e.length-1]-e[0]||1);i[l]=r*c+(1-r)*(i[l]/(s||1))}let o=l=>l.drive!=="none"&&l.start-t.origins[0]<t.end&&l.end-t.origins[0]>t.start,a=n[0].stages.filter(o).length;return{seconds:d1+f1*a,wayAt:l=>_g(e,i,l),timeAt:l=>_g(i,e,l)}}function p1(n,t){let e=new Set([t.start,t.end]);for(let[i,s]of n.entries())for(let r of s.time){let o=r-t.origins[i];o>t.start&&o<t.end&&e.add(o)}return Float64Array.from(e).sort()}function m1(n,t,e,i){let s=n.pointsAt(e[0]+t).slice(),r=s.slice();for(let o=1;o<e.length;o++){n.pointsAt(e[o]+t,r);let a=0;for(let l=0;l<r.length;l+=3){let c=Math.hypot(r[l]-s[l],r[l+1]-s[l+1],r[l+2]-s[l+2]);c>a&&(a=c)}i[o]=Math.max(i[o],a),[s,r]=[r,s]}}function _g(n,t,e){let[i,s]=Ki(n,e);return s===0?t[i]:t[i]+s*(t[i+1]-t[i])}var g1="M7 4.5v15l12-7.5z",x1="M7 5h3.5v14H7zM13.5 5H17v14h-3.5z",Cd=1e4;function au(n,t){let e=R("button",{type:"button",className:"play"}),i=R("input",{type:"range",min:0,max:Cd,step:1,"aria-label":"time"}),s=R("div",{className:"bands","aria-hidden":"true"}),r=R("div",{className:"ticks","aria-hidden":"true"}),o=R("p",{className:"time"}),a=R("p",{className:"spoken",role:"status"}),l=n.length===1?n[0].marks.map(f=>_1(f,t)):[],c=R("div",{className:"transport"},R("div",{className:"line"},e,R("div",{className:"track"},s,i,r)),R("div",{className:"choices"},o,...l.length?[R("div",{className:"states"},...l)]:[],y1(t),...v1(t),a));e.addEventListener("click",()=>t.playing?t.pause():t.play()),i.addEventListener("input",()=>{t.pause(),t.seek(t.momentAt(i.value/Cd))});let u=null,h=null,d=0;return t.onChange(()=>{let f=`${t.spans.indexOf(t.span)} ${t.stretched}`;f!==u&&b1(n,t,s,r),u=f,i.value=Math.round(Cd*t.shareAt(t.time)),i.setAttribute("aria-valuetext",bg(n,t));let p=n.length===1?` · ${lu(n[0],t.clipTime(0))}`:t.span.label.replace("time",""),_=t.playing?`, ${S1(t.slowness)}`:"";o.textContent=`${xr(t.time,t.span)}${p}${_}`;for(let[g,m]of(n.length===1?n[0].marks:[]).entries())l[g].setAttribute("aria-pressed",String(Math.abs(m.time-t.clipTime(0))<1e-9));t.playing!==h&&(e.replaceChildren(tl(t.playing?x1:g1)),e.setAttribute("aria-label",t.playing?"pause":"play"),h=t.playing),clearTimeout(d),t.playing||(d=setTimeout(()=>{a.textContent=bg(n,t)},600))}),c}function _1(n,t){let e=R("button",{type:"button",className:"state"},R("b",{},n.letter),` ${n.name}`);return e.addEventListener("click",()=>{t.pause(),t.seekClip(0,n.time)}),e}function y1(n){let t=yg.map(({name:i,value:s})=>R("option",{value:String(s)},i)),e=R("select",{},...t);return e.addEventListener("change",()=>n.setSpeed(e.value==="even"?"even":Number(e.value))),R("label",{},"speed ",e)}function v1(n){if(n.spans.length<2)return[];let t=n.spans.map((i,s)=>R("option",{value:String(s)},i.name)),e=R("select",{},...t);return e.addEventListener("change",()=>n.setSpan(n.spans[Number(e.value)])),n.onChange(()=>{e.value=String(n.spans.indexOf(n.span))}),[R("label",{},"show ",e)]}function b1(n,t,e,i){let{span:s}=t,r=o=>Math.min(1,Math.max(0,t.shareAt(o)));e.replaceChildren(),i.replaceChildren();for(let[o,a]of n.entries()){let l=s.origins[o];for(let c of a.stages.filter(u=>u.driven&&n.length===1)){let[u,h]=[r(c.start-l),r(c.end-l)],d=R("span",{className:"band"});d.style.left=`${100*u}%`,d.style.width=`${100*(h-u)}%`,h>u&&e.append(d)}for(let c of a.marks){let u=c.time-l;if(u<s.start-1e-9||u>s.end+1e-9)continue;let h=R("span",{className:"tick"},n.length===1?c.letter:"");h.style.left=`${100*r(u)}%`,n.length>1&&h.style.setProperty("--tick",`var(--line-${o%7})`),i.append(h)}}}function S1(n){return n<1.05?"real time":`${n<10?Dn(n,1):Math.round(n)} times slower`}function lu(n,t){let e=n.markAt(t);return e?`${e.letter} ${e.name}`:n.stageAt(t).name}function bg(n,t){let e=n.map((i,s)=>{let r=t.clipTime(s);return`${n.length>1?`${i.name}: `:""}${lu(i,r)}${M1(i,r)}`});return`${xr(t.time,t.span)}: ${e.join("; ")}`}function M1(n,t){let[e]=n.readings;if(!e)return"";let i=n.markAt(t)?.readings[e.name]?.mean??n.valuesAt(e.name,t),s=e.unit==="deg"?"degrees":e.unit,r=[Math.min(...i),Math.max(...i)].map(a=>Dn(a,1)),o=i.length>1;return`, ${e.label}${o?"s":""} ${o?r.join(" to "):r[0]} ${s}`}function xo(n,t,e,{energy:i,legend:s,text:r,whole:o},a){let l=Ba(t,e,f=>Td(f,i.largest_J),r,a),c=l?R("div",{className:"picture"},l.element,hu(l.eye,t.length>1||a?o:null)):R("p",{className:"note"},uu(o));l&&t.length===1&&w1(l.cells[0],t[0],e);let u=l?[Ad(s,i,l.eye.size,t.length>1?o:null)]:[];l&&t.some(f=>f.strained)&&u.unshift(Mg(l,u[0])),l&&t.length===1&&t[0].efforts?.drives.length&&A1(u.at(-1),t[0],e),l&&t.length>1&&t.some(f=>f.efforts?.drives.some(p=>p.arrow))&&u.at(-1).append(R("li",{className:"effort"},Sg(),"torque or force of a drive, while it acts")),n.replaceChildren(c,au(t,e),...u,ru(t,l!==null,o)),n.classList.add("player"),n.setAttribute("role","region"),n.setAttribute("aria-label",`the ${o} moving`);let h=ou(n,t,e,l?.eye,gr[0]);function d(){e.pause(),h(),l?.dispose(),n.replaceChildren()}return{stage:l,dispose:d}}function cu(n,t,e,{energy:i,legend:s,text:r,whole:o},a){let l=Ba(t,e,h=>Td(h,i.largest_J),r,a);if(!l)return n.replaceChildren(R("p",{className:"note"},uu(o))),{stage:l};let c=R("div",{className:"picture"},l.element,hu(l.eye,null,!a)),u=[Ad(s,i,l.eye.size,null)];return t.some(h=>h.strained)&&u.unshift(Mg(l,u[0])),n.replaceChildren(c,...u),n.classList.add("player"),n.setAttribute("role","region"),n.setAttribute("aria-label",`the ${o} where the sliders are`),cg(n,l.eye,gr[0]),{stage:l}}function w1(n,t,e){let i=R("p",{className:"now","aria-hidden":"true"});n.append(i),e.onChange(()=>{i.textContent=lu(t,e.clipTime(0))})}function Sg(){return R("span",{className:"swatch arrow","aria-hidden":"true"})}function A1(n,t,e){let i=t.efforts.drives.some(r=>r.arrow),s=R("span");n.append(R("li",{className:"effort"},...i?[Sg()]:[],s)),e.onChange(()=>{s.textContent=Zm(t.efforts,e.clipTime(0),Ee).join("; ")||"no drive acts now"})}function Mg(n,t){let e=["panels","membrane strain"],i=R("li",{className:"energy",hidden:!0});t.append(i);let s=e.map((r,o)=>{let a=R("button",{type:"button","aria-pressed":String(!o)},r);return a.addEventListener("click",()=>{let l=n.showStrain(!!o);i.replaceChildren("membrane strain, Green’s: 0",Ed(tu),`${Ee(100*l)} %`),i.hidden=!o;for(let c of t.querySelectorAll(".of-region"))c.hidden=!!o;for(let c of s)c.setAttribute("aria-pressed",String(c===a))}),a});return R("div",{className:"colours",role:"group","aria-label":"colour of the sheet"},"colour:",R("span",{},...s))}function uu(n){return`This browser has no WebGL, so the ${n} cannot be drawn in 3-D. The plots and all numbers are here.`}function hu(n,t,e=!0){let i=(c,u,h)=>{let d=R("button",{type:"button",title:u,"aria-label":u},c);return d.addEventListener("click",h),d},s=gr.map(c=>i(c.name,`${c.name}: view ${c.text}`,()=>n.show(c))),r=[["←","turn left",[-1,0]],["→","turn right",[1,0]],["↑","turn up",[0,1]],["↓","turn down",[0,-1]]].map(([c,u,h])=>i(c,u,()=>n.turn(...h))),o=(c,u,h)=>{let d=i(c,u,()=>{n.choose({[h]:!n.look[h]}),d.setAttribute("aria-pressed",String(n.look[h]))});return d.setAttribute("aria-pressed",String(n.look[h])),d},a=[...e?[o("follow","follow: keep the picture filled as it moves","following")]:[],...t?[o("one scale",`one scale: all ${t}s as large as they are by each other`,"oneScale")]:[]],l=[i("+","nearer",()=>n.zoom(1)),i("−","further",()=>n.zoom(-1))];return R("div",{className:"views",role:"group","aria-label":"view"},...a.length?[R("span",{},...a)]:[],R("span",{},...s),R("span",{className:"turns"},...r),R("span",{},...l))}var E1={deg:.05};function _o(n,t,e,i,s=0,r=!1){let{heading:o,names:a}=t.mesh.parts,l=t.readings.map(_=>({name:_.name,title:_.row,parts:_.parts,text:g=>Rd(g,_.unit),ofState:g=>g.readings[_.name]&&T1(g.readings[_.name],_.unit)})),c=_=>Ee(i.factor*_);t.tendons&&l.push({name:bs,title:`tendon energy (${i.unit})`,parts:t.mesh.tendonParts,text:c,ofState:_=>_.tendonEnergy_J.map(c)});let u=l.map(()=>a.map(()=>R("td"))),h=R("caption"),d=R("tr",{},o?R("th",{scope:"col"},o):R("td"),...a.map(_=>R("th",{scope:"col"},_))),f=l.map((_,g)=>R("tr",{},R("th",{scope:"row"},_.title),...u[g])),p=R("table",{className:"numbers"},h,R("thead",{},d),R("tbody",{},...f));return n.replaceChildren(R("div",{className:"table"},p)),n.classList.add("readout"),e.onChange(()=>{let _=e.clipTime(s),g=t.markAt(_),m=g?`, ${g.name} (means)`:"",x=r?`${t.name}: `:"",w=o?`every ${o}`:"everything";h.textContent=`${bn(`${x}${w}`)} at ${xr(e.time,e.span)}${m}`;for(let[b,S]of l.entries()){let M=g&&S.ofState(g)||Array.from(t.valuesAt(S.name,_),S.text);for(let[y,A]of S.parts.entries())u[b][A].textContent=M[y]}})}function Rd(n,t){return t==="deg"?Dn(n,1):Ee(n)}function T1({mean:n,swing:t},e){return n.map((i,s)=>{let r=t[s]>(E1[e]??.005*Math.abs(i));return`${Rd(i,e)}${r?` ± ${Rd(t[s],e)}`:""}`})}var C1=0;function yo(n=document){let t=new ResizeObserver(e=>{for(let{target:i}of e)if(i.scrollWidth>i.clientWidth||i.scrollHeight>i.clientHeight)R1(i);else for(let s of["tabindex","role","aria-label","aria-labelledby"])i.removeAttribute(s)});for(let e of n.querySelectorAll(".table"))t.observe(e)}function R1(n){let{caption:t}=n.querySelector("table");if(n.tabIndex=0,n.setAttribute("role","group"),!t){let e=[...n.querySelectorAll("thead th")].map(i=>i.textContent);return n.setAttribute("aria-label",e.join(", ")||"table")}return t.id||=`caption-${++C1}`,n.setAttribute("aria-labelledby",t.id)}function P1(n,t){let e=n.design.text.split(`
`);for(let{key:i,unit:s,factor:r,line:o}of n.knobs)i in t&&(e[o.number]=`${o.before}${I1(t[i],s,r)}${o.after}`);return e.join(`
`)}function I1(n,t,e){return`${Number((e*n).toPrecision(12))} ${t}`}function wg(n){let t=R("a",{className:"button",download:"design.toml"},"This setting as a design file"),e=R("code"),i=R("p",{className:"note"},"Whether its energy balance closes is not looked at here: a run of the file tells."),s=R("div",{className:"setting"},t,R("pre",{},e),i);function r(o){let a=new TextEncoder().encode(P1(n,o));t.href=`data:application/toml;base64,${btoa(String.fromCharCode(...a))}`,e.textContent="forficula run design.toml"}return r({}),{element:s,refresh:r}}var L1=22,N1=.25;function Ag(n,t,e,i,s){let{canvas:r,eye:o}=n,a=document.createElementNS("http://www.w3.org/2000/svg","line"),l=document.createElementNS("http://www.w3.org/2000/svg","svg");l.classList.add("push"),l.setAttribute("aria-hidden","true"),l.append(a);let c=R("p",{className:"pushed","aria-hidden":"true"});n.element.append(l,c),l.style.display="none";let u=new W,h=null;function d(x){let w=u.fromArray(t.frame.points,3*x).project(o.camera);return[(w.x+1)/2*r.clientWidth,(1-w.y)/2*r.clientHeight]}function f(x){let w=r.getBoundingClientRect();return[x.clientX-w.left,x.clientY-w.top]}function p([x,w]){let b={point:-1,away:L1};for(let S=0;S<t.movable.length;S++){if(!t.movable[S])continue;let[M,y]=d(S),A=Math.hypot(M-x,y-w);A<b.away&&(b={point:S,away:A})}return b.point}function _(x){let[w,b]=f(x),S=new W().fromArray(t.frame.points,3*h),M=S.clone().project(o.camera).z;return new W(2*w/r.clientWidth-1,1-2*b/r.clientHeight,M).unproject(o.camera).sub(S).multiplyScalar(i/(N1*e)).clampLength(0,i).toArray()}function g(x,w){let[b,S]=[d(h),f(x)];for(let[M,y]of[["x1",b[0]],["y1",b[1]],["x2",S[0]],["y2",S[1]]])a.setAttribute(M,y);l.style.display="",c.textContent=`pushed with ${Ee(w)} N`}r.addEventListener("pointerdown",x=>{let w=x.button===0?p(f(x)):-1;w<0||(h=w,o.controls.enabled=!1,r.setPointerCapture(x.pointerId),x.stopImmediatePropagation())},{capture:!0}),r.addEventListener("pointermove",x=>{if(h===null){r.classList.toggle("grip",p(f(x))>=0);return}let w=_(x);s(h,w),g(x,Math.hypot(...w))});let m=()=>{h!==null&&(h=null,o.controls.enabled=!0,l.style.display="none",c.textContent="",s(0,null))};r.addEventListener("pointerup",m),r.addEventListener("pointercancel",m)}var za=200,D1=20,U1=3;function Eg(n,t,e){let i=n.map(o=>O1(o,t,e)),s=R("button",{type:"button",disabled:!0},`All as in ${t}`);s.addEventListener("click",()=>i.forEach(o=>o.reset()));let r=R("div",{className:"sliders",role:"group","aria-label":"what can be changed"});return r.append(...i.map(o=>o.element),s),{element:r,set(o){for(let a of i)a.put(o[a.knob.key]??a.knob.value)},get changes(){let o=i.filter(a=>a.value!==a.knob.value);return Object.fromEntries(o.map(a=>[a.knob.key,a.value]))},refresh(){s.disabled=i.every(o=>o.value===o.knob.value)}}}function O1(n,t,e){let{key:i,title:s,unit:r,factor:o,lowest:a,highest:l}=n,c=a>0&&l/a>=D1,u=S=>c?a*(l/a)**S:a+S*(l-a),h=S=>c?Math.log(S/a)/Math.log(l/a):(S-a)/(l-a),d=Math.round(za*h(n.value)),f=bn(i.replace("protocol.","").replace("youngs","Young's").replaceAll(/[._]/g," ")),p=R("input",{type:"range",min:0,max:za,step:1,"aria-label":f,"aria-description":s}),_=R("output"),g=R("span",{className:"home",title:`in ${t}`,"aria-hidden":"true"});g.style.left=`${100*d/za}%`,p.dataset.keys="own";let m=n.value;function x(){let S=`${Ee(o*m)} ${r}`;_.textContent=S,p.setAttribute("aria-valuetext",m===n.value?`${S}, as in ${t}`:S),b.classList.toggle("changed",m!==n.value)}function w(S){m=S,p.value=Math.round(za*h(m)),x(),e(i,m)}p.addEventListener("input",()=>{let S=Number(p.value);m=S===d?n.value:Number((o*u(S/za)).toPrecision(U1))/o,x(),e(i,m)});let b=R("label",{className:"slider",title:`${i}: ${s}`},R("span",{className:"name"},f),_,R("span",{className:"rail"},p,g));return p.value=d,x(),{element:b,knob:n,get value(){return m},put:w,reset:()=>w(n.value)}}var F1=[["real time",1],["1/2",.5],["1/5",.2],["1/20",.05],["1/100",.01]],Tg=.2,k1=1.4,B1=[["J",1,.1],["mJ",1e3,1e-4],["µJ",1e6,1e-7],["nJ",1e9,0]];async function du(n,t,e,i){let s=JSON.parse(e),r={frame:null,engine:null},o=await i(e,S=>w(S)),a=og(n,s,o.first),l=R("p",{className:"verdict",role:"status"}),c=R("p",{className:"note"}),u=R("p",{className:"time"}),h=R("p",{className:"account"}),d=R("div"),f=R("div"),p=wg(s),_=Eg(s.knobs,t.kind==="bench"?"the design":"this run",(S,M)=>{o.tell({act:"set",values:{[S]:M}}),_.refresh(),p.refresh(_.changes)}),g=V1(s,o,()=>{l.textContent="",c.textContent=""}),m=s.motors.every(S=>S.kind==="torque")?"torques":"drives",x=null;function w(S){if(S.said==="refused"){l.textContent=`The simulator stopped: ${S.why}.`;return}S.said==="frame"&&b(S.frame)}function b(S){r.frame=S,a.show(S),u.textContent=`${xr(S.time_s,{start:0,end:Math.max(1,S.time_s)})}${G1(S)}`;let M=S.energies_J.reduce((P,F)=>P+F,0),y=S.works_J.reduce((P,F)=>P+F,0),A=[...n.tendons?[`tendon energy ${Pd(M)}`]:[],`work of the ${m} ${Pd(y)}`];h.textContent=A.join(" · ");let I=S.stageNumber===null?S.ended:null,L=I&&JSON.stringify(I.stages.map(P=>P.end_s));L!==x&&(l.textContent=I?H1(I,t.whole):"",c.textContent=I?.advice??""),x=L}return r.element=R("div",{className:"trial"},R("div",{className:"seen"},R("div",{className:"choices"},...g),R("div",{className:"told"},u,h),l,c,d,f),R("div",{className:"hands"},_.element,p.element)),r.begin=()=>{let S={...Ua(),following:!1,closer:t.kind==="bench"?k1:1},{stage:M}=cu(d,[a.clip],a.clock,{...t,text:t.text.replace("which moves with the time","live")},S);r.stage=M,_o(f,a.clip,a.clock,t.energy),yo(r.element),M&&(a.movable=s.anchors.bodies.map(y=>y>0),Ag(M,a,n.mesh.span_m,z1(s,n.mesh.span_m),(y,A)=>o.tell({act:"push",point:y,force:A}))),b(o.first),o.tell({act:"pace",value:Tg}),o.tell({act:"restart",through:!1}),t.kind!=="bench"&&g[0].focus()},Object.assign(r,{engine:o,live:a,sliders:_,design:p,own:s})}function z1({protocol:n,motors:t},e){let i=n.drives.map(({strength:s,torques:r})=>{let o=t[r.findIndex(a=>a!==0)];return o?.kind==="torque"?Math.abs(s)/e:o?.kind==="force"?Math.abs(s):0});return Math.max(...i)||1}function V1({protocol:n},t,e){let i=(o,a,l)=>{let c=R("button",{type:"button",title:l});return c.append(o),c.addEventListener("click",()=>{e(),t.tell(a)}),c},s=n.stages.flatMap(({name:o,drives:a},l)=>{if(!a.length)return[];let c=n.stages.findIndex((h,d)=>d>l&&h.drives.length>0),u=(c<0?n.stages.length:c)-1;return[i(bn(o),{act:"stages",from:l,to:u},`the stage "${o}" of the protocol, and what follows without a drive`)]}),r=R("select",{},...F1.map(([o,a])=>R("option",{value:a,selected:a===Tg},o)));return r.addEventListener("change",()=>t.tell({act:"pace",value:Number(r.value)})),[i("Start again",{act:"restart",through:!1},"from where the run begins"),...s,i("Let go",{act:"release"},"without any drive"),i("Whole protocol",{act:"restart",through:!0},"all stages, as in the run"),R("label",{},"speed ",r)]}function G1({stage:n,running:t}){return n?` · ${n}`:t?" · no drive acts":" · at rest"}function H1({status:n,verdict:t,transitions:e},i){let s=e.filter(({took:o})=>o?.succeeded&&o.time_s!==null).map(({words:o,took:a})=>`${o.did||o.done} in ${W1(a.time_s)} for ${Pd(a.work_J)} of work`);if(!s.length)return`${bn(n)}.`;let r=t==="reached"?"":`; then: ${n}`;return`The ${i} ${s.join(", then ")}${r}.`}function W1(n){return n>=1?`${Dn(n,3)} s`:`${Ee(1e3*n)} ms`}function Pd(n){let[t,e]=B1.find(([,,i])=>Math.abs(n)>=i);return n===0?"0 J":`${Ee(e*n)} ${t}`}function fu(n,t,e,i){if(!n)return null;let s={panel:null,failed:"",start:null},r=document.getElementById("live").textContent,o=R("button",{type:"button",className:"try"},"Try it"),a=R("p",{className:"note"});a.textContent=`Move this ${e.whole} yourself: change it, drive it, let go, push it; the simulator runs in this page.`,n.append(R("div",{className:"offer"},o,a));function l(u){s.failed=u,o.disabled=!0,a.textContent=`This ${e.whole} cannot be moved here: ${u}. The command line can: forficula run.`}let c=JSON.parse(r.startsWith('{"refused"')?r:"null");return c!==null?l(c.refused):eu()||l("this page was written without the engine"),s.start=async()=>{if(!o.disabled){o.disabled=!0,a.setAttribute("role","status"),a.textContent="Starting the simulator …",i();try{s.panel=await du(t,e,r,nu),n.replaceChildren(R("h2",{},"Try it"),s.panel.element),s.panel.begin()}catch(u){l(u.message)}}},o.addEventListener("click",s.start),s}function Cg(n){let t=yi(n.clips[0]),e=fu(document.getElementById("try"),t,n,()=>{});return e.start(),{clips:[t],trial:e}}var X1=200;function Ss(n,t){let e=new Set,i=t[0].start,s=t[0],r="even",o=!1,a=0,l=0,c=new Map;function u(){return c.has(s)||c.set(s,vg(n,s)),c.get(s)}let h=()=>r==="even"&&s.whole;function d(x){return h()?u().wayAt(x):(x-s.start)/(s.end-s.start||1)}function f(x){return h()?u().timeAt(x):s.start+x*(s.end-s.start)}function p(){l||(l=requestAnimationFrame(_))}function _(x){if(l=0,o){let w=Math.min((x-a)/1e3,.1);a=x,g(w),l=requestAnimationFrame(_)}for(let w of e)w()}function g(x){r==="even"?i=u().timeAt(Math.min(1,u().wayAt(i)+x/u().seconds)):i=Math.min(s.end,i+r*x),i>=s.end&&(o=!1)}function m(x){i=Math.min(s.end,Math.max(s.start,x)),p()}return{get time(){return i},get span(){return s},get speed(){return r},get playing(){return o},spans:t,clipTime:(x,w=i)=>Math.min(n[x].end,Math.max(n[x].start,w+s.origins[x])),get stretched(){return h()},shareAt:d,momentAt:f,wayAt:x=>u().wayAt(x),timeAt:x=>u().timeAt(x),get slowness(){if(r!=="even")return 1/r;let x=u().wayAt(i),[w,b]=[Math.max(0,x-5e-4),Math.min(1,x+5e-4)];return(b-w)*u().seconds/(u().timeAt(b)-u().timeAt(w)||1e-12)},onChange(x){return e.add(x),p(),()=>e.delete(x)},seek:m,seekClip(x,w){(w<s.start+s.origins[x]||w>s.end+s.origins[x])&&(s=t.find(b=>w>=b.start+b.origins[x]&&w<=b.end+b.origins[x])??t[0]),m(w-s.origins[x])},step:x=>m(f(d(i)+x/X1)),play(){i>=s.end&&(i=s.start),o=!0,a=performance.now(),p()},pause(){o=!1,p()},setSpeed(x){r=x,p()},setSpan(x){s=x,m(i<s.start||i>s.end?s.start:i)},redraw:p}}var $1="uplot",q1="u-hz",Y1="u-vt",Z1="u-title",J1="u-wrap",K1="u-under",j1="u-over",Q1="u-axis",vr="u-off",tA="u-select",eA="u-cursor-x",nA="u-cursor-y",iA="u-cursor-pt",sA="u-legend",rA="u-live",oA="u-inline",aA="u-series",lA="u-marker",Rg="u-label",cA="u-value",Ga="width",Ha="height";var Pg="bottom",vo="left",Id="right",Yd="#000",Ig=Yd+"0",Ld="mousemove",Lg="mousedown",Nd="mouseup",Ng="mouseenter",Dg="mouseleave",Ug="dblclick",uA="resize",hA="scroll",Og="change",_u="dppxchange",Zd="--",To=typeof window<"u",kd=To?document:null,So=To?window:null,dA=To?navigator:null,we,pu;function Bd(){let n=devicePixelRatio;we!=n&&(we=n,pu&&Vd(Og,pu,Bd),pu=matchMedia(`(min-resolution: ${we-.001}dppx) and (max-resolution: ${we+.001}dppx)`),br(Og,pu,Bd),So.dispatchEvent(new CustomEvent(_u)))}function hi(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function zd(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function We(n,t,e){n.style[t]=e+"px"}function Li(n,t,e,i){let s=kd.createElement(n);return t!=null&&hi(s,t),e?.insertBefore(s,i),s}function vi(n,t){return Li("div",n,t)}var Fg=new WeakMap;function ji(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=Fg.get(n);r!=o&&(n.style.transform=r,Fg.set(n,r),t<0||e<0||t>i||e>s?hi(n,vr):zd(n,vr))}var kg=new WeakMap;function Bg(n,t,e){let i=t+e,s=kg.get(n);i!=s&&(kg.set(n,i),n.style.background=t,n.style.borderColor=e)}var zg=new WeakMap;function Vg(n,t,e,i){let s=t+""+e,r=zg.get(n);s!=r&&(zg.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var Jd={passive:!0},fA={...Jd,capture:!0};function br(n,t,e,i){t.addEventListener(n,e,i?fA:Jd)}function Vd(n,t,e,i){t.removeEventListener(n,e,Jd)}To&&Bd();function Ni(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:di((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function m0(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var g0=n=>n!=null,x0=n=>n!=null&&n>0,bu=m0(g0),pA=m0(x0);function mA(n,t,e,i=0,s=!1){let r=s?pA:bu,o=s?x0:g0;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Ue,l??-Ue]}function Su(n,t,e,i){let s=Wg(n),r=Wg(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?Ms:_0,a=s==1?di:bi,l=r==1?bi:di,c=a(o(Mn(n))),u=l(o(Mn(t))),h=Mo(e,c),d=Mo(e,u);return e==10&&(c<0&&(h=Oe(h,-c)),u<0&&(d=Oe(d,-u))),i||e==2?(n=h*s,t=d*r):(n=S0(n,h),t=Mu(t,d)),[n,t]}function Kd(n,t,e,i){let s=Su(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var jd=.1,Gg={mode:3,pad:jd},Xa={pad:0,soft:null,mode:0},gA={min:Xa,max:Xa};function yu(n,t,e,i){return wu(e)?Hg(n,t,e):(Xa.pad=e,Xa.soft=i?0:null,Xa.mode=i?3:0,Hg(n,t,gA))}function be(n,t){return n??t}function xA(n,t,e){for(t=be(t,0),e=be(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function Hg(n,t,e){let i=e.min,s=e.max,r=be(i.pad,0),o=be(s.pad,0),a=be(i.hard,-Ue),l=be(s.hard,Ue),c=be(i.soft,Ue),u=be(s.soft,-Ue),h=be(i.mode,0),d=be(s.mode,0),f=t-n,p=Ms(f),_=Zn(Mn(n),Mn(t)),g=Ms(_),m=Mn(g-p);(f<1e-24||m>10)&&(f=0,(n==0||t==0)&&(f=1e-24,h==2&&c!=Ue&&(r=0),d==2&&u!=-Ue&&(o=0)));let x=f||_||1e3,w=Ms(x),b=Mo(10,di(w)),S=x*(f==0?n==0?.1:1:r),M=Oe(S0(n-S,b/10),24),y=n>=c&&(h==1||h==3&&M<=c||h==2&&M>=c)?c:Ue,A=Zn(a,M<y&&n>=y?y:Di(y,M)),I=x*(f==0?t==0?.1:1:o),L=Oe(Mu(t+I,b/10),24),P=t<=u&&(d==1||d==3&&L>=u||d==2&&L<=u)?u:-Ue,F=Di(l,L>P&&t<=P?P:Zn(P,L));return A==F&&A==0&&(F=100),[A,F]}var _A=new Intl.NumberFormat(To?dA.language:"en-US"),Qd=n=>_A.format(n),fi=Math,xu=fi.PI,Mn=fi.abs,di=fi.floor,Sn=fi.round,bi=fi.ceil,Di=fi.min,Zn=fi.max,Mo=fi.pow,Wg=fi.sign,Ms=fi.log10,_0=fi.log2,yA=(n,t=1)=>fi.sinh(n)*t,Dd=(n,t=1)=>fi.asinh(n/t),Ue=1/0;function Xg(n){return(Ms((n^n>>31)-(n>>31))|0)+1}function Gd(n,t,e){return Di(Zn(n,t),e)}function y0(n){return typeof n=="function"}function _e(n){return y0(n)?n:()=>n}var vA=()=>{},v0=n=>n,b0=(n,t)=>t,bA=n=>null,$g=n=>!0,qg=(n,t)=>n==t,SA=/\.\d*?(?=9{6,}|0{6,})/gm,Sr=n=>{if(w0(n)||js.has(n))return n;let t=`${n}`,e=t.match(SA);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Sr(s)}e${r}`}return Oe(n,i)};function _r(n,t){return Sr(Oe(Sr(n/t))*t)}function Mu(n,t){return Sr(bi(Sr(n/t))*t)}function S0(n,t){return Sr(di(Sr(n/t))*t)}function Oe(n,t=0){if(w0(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return Sn(i)/e}var js=new Map;function M0(n){return((""+n).split(".")[1]||"").length}function qa(n,t,e,i){let s=[],r=i.map(M0);for(let o=t;o<e;o++){let a=Mn(o),l=Oe(Mo(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=n==10?u:Oe(u,h);s.push(d),js.set(d,h)}}return s}var $a={},tf=[],wo=[null,null],Ks=Array.isArray,w0=Number.isInteger,MA=n=>n===void 0;function Yg(n){return typeof n=="string"}function wu(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function wA(n){return n!=null&&typeof n=="object"}var AA=Object.getPrototypeOf(Uint8Array),A0="__proto__";function Ao(n,t=wu){let e;if(Ks(n)){let i=n.find(s=>s!=null);if(Ks(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=Ao(n[s],t)}else e=n.slice()}else if(n instanceof AA)e=n.slice();else if(t(n)){e={};for(let i in n)i!=A0&&(e[i]=Ao(n[i],t))}else e=n;return e}function pn(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=A0&&(wu(n[s])?pn(n[s],Ao(i[s])):n[s]=Ao(i[s]))}return n}var EA=0,TA=1,CA=2;function RA(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function PA(n,t){if(NA(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return DA(o[0])||(o=LA(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),d=t?t[o][c]:TA,f=[];for(let p=0;p<u.length;p++){let _=u[p],g=r.get(l[p]);_===null?d!=EA&&(h[g]=_,d==CA&&f.push(g)):h[g]=_}RA(h,f,s),i.push(h)}}return i}var IA=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function LA(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function NA(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function DA(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Zn(1,di((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var E0=["January","February","March","April","May","June","July","August","September","October","November","December"],T0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function C0(n){return n.slice(0,3)}var UA=T0.map(C0),OA=E0.map(C0),FA={MMMM:E0,MMM:OA,WWWW:T0,WWW:UA};function Va(n){return(n<10?"0":"")+n}function kA(n){return(n<10?"00":n<100?"0":"")+n}var BA={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>Va(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Va(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>Va(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Va(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Va(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>kA(n.getMilliseconds())};function ef(n,t){t=t||FA;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?BA[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var zA=new Intl.DateTimeFormat().resolvedOptions().timeZone;function VA(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==zA?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var R0=n=>n%1==0,vu=[1,2,2.5,5],GA=qa(10,-32,0,vu),P0=qa(10,0,32,vu),HA=P0.filter(R0),yr=GA.concat(P0),nf=`
`,I0="{YYYY}",Zg=nf+I0,L0="{M}/{D}",Wa=nf+L0,mu=Wa+"/{YY}",N0="{aa}",WA="{h}:{mm}",bo=WA+N0,Jg=nf+bo,Kg=":{ss}",Te=null;function D0(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?qa(10,0,3,vu).filter(R0):qa(10,-3,0,vu)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,I0,Te,Te,Te,Te,Te,Te,1],[s*28,"{MMM}",Zg,Te,Te,Te,Te,Te,1],[s,L0,Zg,Te,Te,Te,Te,Te,1],[i,"{h}"+N0,mu,Te,Wa,Te,Te,Te,1],[e,bo,mu,Te,Wa,Te,Te,Te,1],[t,Kg,mu+" "+bo,Te,Wa+" "+bo,Te,Jg,Te,1],[n,Kg+".{fff}",mu+" "+bo,Te,Wa+" "+bo,Te,Jg,Te,1]];function u(h){return(d,f,p,_,g,m)=>{let x=[],w=g>=o,b=g>=r&&g<o,S=h(p),M=Oe(S*n,3),y=Ud(S.getFullYear(),w?0:S.getMonth(),b||w?1:S.getDate()),A=Oe(y*n,3);if(b||w){let I=b?g/r:0,L=w?g/o:0,P=M==A?M:Oe(Ud(y.getFullYear()+L,y.getMonth()+I,1)*n,3),F=new Date(Sn(P/n)),z=F.getFullYear(),U=F.getMonth();for(let G=0;P<=_;G++){let $=Ud(z+L*G,U+I*G,1),H=$-h(Oe($*n,3));P=Oe((+$+H)*n,3),P<=_&&x.push(P)}}else{let I=g>=s?s:g,L=di(p)-di(M),P=A+L+Mu(M-A,I);x.push(P);let F=h(P),z=F.getHours()+F.getMinutes()/e+F.getSeconds()/i,U=g/i,G=d.axes[f]._space,$=m/G;for(;P=Oe(P+g,n==1?0:3),!(P>_);)if(U>1){let H=di(Oe(z+U,6))%24,Q=h(P).getHours()-H;Q>1&&(Q=-1),P-=Q*i,z=(z+U)%24;let it=x[x.length-1];Oe((P-it)/g,3)*$>=.7&&x.push(P)}else x.push(P)}return x}}return[l,c,u]}var[XA,$A,qA]=D0(1),[YA,ZA,JA]=D0(.001);qa(2,-53,53,[1]);function jg(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function Qg(n,t){return(e,i,s,r,o)=>{let a=t.find(p=>o>=p[0])||t[t.length-1],l,c,u,h,d,f;return i.map(p=>{let _=n(p),g=_.getFullYear(),m=_.getMonth(),x=_.getDate(),w=_.getHours(),b=_.getMinutes(),S=_.getSeconds(),M=g!=l&&a[2]||m!=c&&a[3]||x!=u&&a[4]||w!=h&&a[5]||b!=d&&a[6]||S!=f&&a[7]||a[1];return l=g,c=m,u=x,h=w,d=b,f=S,M(_)})}}function KA(n,t){let e=ef(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function Ud(n,t,e){return new Date(n,t,e)}function t0(n,t){return t(n)}var jA="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function e0(n,t){return(e,i,s,r)=>r==null?Zd:t(n(i))}function QA(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function tE(n,t){return n.series[t].fill(n,t)}var eE={show:!0,live:!0,isolate:!1,mount:vA,markers:{show:!0,width:2,stroke:QA,fill:tE,dash:"solid"},idx:null,idxs:null,values:[]};function nE(n,t){let e=n.cursor.points,i=vi(),s=e.size(n,t);We(i,Ga,s),We(i,Ha,s);let r=s/-2;We(i,"marginLeft",r),We(i,"marginTop",r);let o=e.width(n,t,s);return o&&We(i,"borderWidth",o),i}function iE(n,t){let e=n.series[t].points;return e._fill||e._stroke}function sE(n,t){let e=n.series[t].points;return e._stroke||e._fill}function rE(n,t){return n.series[t].points.size}var Od=[0,0];function oE(n,t,e){return Od[0]=t,Od[1]=e,Od}function gu(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function Fd(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var aE={show:!0,x:!0,y:!0,lock:!1,move:oE,points:{one:!1,show:nE,size:rE,width:0,stroke:sE,fill:iE},bind:{mousedown:gu,mouseup:gu,click:gu,dblclick:gu,mousemove:Fd,mouseleave:Fd,mouseenter:Fd},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},U0={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},sf=pn({},U0,{filter:b0}),O0=pn({},sf,{size:10}),F0=pn({},U0,{show:!1}),rf='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',k0="bold "+rf,B0=1.5,n0={show:!0,scale:"x",stroke:Yd,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:k0,side:2,grid:sf,ticks:O0,border:F0,font:rf,lineGap:B0,rotate:0},lE="Value",cE="Time",i0={show:!0,scale:"x",auto:!1,sorted:1,min:Ue,max:-Ue,idxs:[]};function uE(n,t,e,i,s){return t.map(r=>r==null?"":Qd(r))}function hE(n,t,e,i,s,r,o){let a=[],l=js.get(s)||0;e=o?e:Oe(Mu(e,s),l);for(let c=e;c<=i;c=Oe(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Hd(n,t,e,i,s,r,o){let a=[],l=n.scales[n.axes[t].scale].log,c=l==10?Ms:_0,u=di(c(e));s=Mo(l,u),l==10&&(s=yr[Ni(s,yr)]);let h=e,d=s*l;l==10&&(d=yr[Ni(d,yr)]);do a.push(h),h=h+s,l==10&&!js.has(h)&&(h=Oe(h,js.get(s))),h>=d&&(s=h,d=s*l,l==10&&(d=yr[Ni(d,yr)]));while(h<=i);return a}function dE(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?Hd(n,t,Zn(l,e),i,s):[l],u=i>=0&&e<=0?[0]:[];return(e<-l?Hd(n,t,Zn(l,-i),-e,s):[l]).reverse().map(d=>-d).concat(u,c)}var z0=/./,fE=/[12357]/,pE=/[125]/,s0=/1/,Wd=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function mE(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?z0:l(7,o)-u>=c?fE:l(5,o)-u>=c?pE:s0;if(h==s0){let d=Mn(l(1,o)-u);if(d<c)return Wd(t.slice().reverse(),a.distr,h,bi(c/d)).reverse()}return Wd(t,a.distr,h,1)}function gE(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=Mn(l(1,o)-l(2,o));return c<a?Wd(t.slice().reverse(),3,z0,bi(a/c)).reverse():t}function xE(n,t,e,i){return i==null?Zd:t==null?"":Qd(t)}var r0={show:!0,scale:"y",stroke:Yd,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:k0,side:3,grid:sf,ticks:O0,border:F0,font:rf,lineGap:B0,rotate:0};function _E(n,t){let e=3+(n||1)*2;return Oe(e*t,3)}function yE(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=Mn(o-r),l=n.series[t],c=a/(l.points.space*we);return i[1]-i[0]<=c}var o0={scale:null,auto:!0,sorted:0,min:Ue,max:-Ue},V0=(n,t,e,i,s)=>s,a0={show:!0,auto:!0,sorted:0,gaps:V0,alpha:1,facets:[pn({},o0,{scale:"x"}),pn({},o0,{scale:"y"})]},l0={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:V0,alpha:1,points:{show:yE,filter:null},values:null,min:Ue,max:-Ue,idxs:[],path:null,clip:null};function vE(n,t,e,i,s){return e/10}var G0={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},bE=pn({},G0,{time:!1,ori:1}),c0={};function H0(n,t){let e=c0[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(c0[n]=e)),e}var Eo=1,Xd=2;function Mr(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[t],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,p=a.width,_=a.height,g=n.valToPosH,m=n.valToPosV;return u.ori==0?e(s,l,c,u,h,g,m,d,f,p,_,Eu,Co,Cu,X0,q0):e(s,l,c,u,h,m,g,f,d,_,p,Tu,Ro,lf,$0,Y0)}function of(n,t){let e=0,i=0,s=be(n.bands,tf);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function SE(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function ws(n,t,e,i,s,r){return Mr(n,t,(o,a,l,c,u,h,d,f,p,_,g)=>{let m=o.pxRound,x=c.dir*(c.ori==0?1:-1),w=c.ori==0?Co:Ro,b,S;x==1?(b=e,S=i):(b=i,S=e);let M=m(h(a[b],c,_,f)),y=m(d(l[b],u,g,p)),A=m(h(a[S],c,_,f)),I=m(d(r==1?u.max:u.min,u,g,p)),L=new Path2D(s);return w(L,A,I),w(L,M,I),w(L,M,y),L})}function Au(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?Cu:lf,l=e;for(let h=0;h<n.length;h++){let d=n[h];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,i,f,i+r),l=d[1]}}let c=e+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function ME(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function af(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let h=c,d=c;if(s==1)for(;++c<=i&&t[c]===null;)d=c;else for(;--c>=e&&t[c]===null;)d=c;let f=r(n[h]),p=d==h?f:r(n[d]),_=h-s;f=o<=0&&_>=0&&_<l?r(n[_]):f;let m=d+s;p=o>=0&&m>=0&&m<l?r(n[m]):p,p>=f&&a.push([f,p])}return a}function u0(n){return n==0?v0:n==1?Sn:t=>_r(t,n)}function W0(n){let t=n==0?Eu:Tu,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Di(c,a/2,l/2),u=Di(u,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,u),e(s,r,o+l,r,o,u),e(s,r,o,r+a,o,c),s.closePath())}}var Eu=(n,t,e)=>{n.moveTo(t,e)},Tu=(n,t,e)=>{n.moveTo(e,t)},Co=(n,t,e)=>{n.lineTo(t,e)},Ro=(n,t,e)=>{n.lineTo(e,t)},Cu=W0(0),lf=W0(1),X0=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},$0=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},q0=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},Y0=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function Z0(n){return(t,e,i,s,r)=>Mr(t,e,(o,a,l,c,u,h,d,f,p,_,g)=>{let{pxRound:m,points:x}=o,w,b;c.ori==0?(w=Eu,b=X0):(w=Tu,b=$0);let S=Oe(x.width*we,3),M=(x.size-x.width)/2*we,y=Oe(M*2,3),A=new Path2D,I=new Path2D,{left:L,top:P,width:F,height:z}=t.bbox;Cu(I,L-y,P-y,F+y*2,z+y*2);let U=G=>{if(l[G]!=null){let $=m(h(a[G],c,_,f)),H=m(d(l[G],u,g,p));w(A,$+M,H),b(A,$,H,M,0,xu*2)}};if(r)r.forEach(U);else for(let G=i;G<=s;G++)U(G);return{stroke:S>0?A:null,fill:A,clip:I,flags:Eo|Xd}})}function J0(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var wE=J0(Co),AE=J0(Ro);function K0(n){let t=be(n?.alignGaps,0);return(e,i,s,r)=>Mr(e,i,(o,a,l,c,u,h,d,f,p,_,g)=>{[s,r]=bu(l,s,r);let m=o.pxRound,x=z=>m(h(z,c,_,f)),w=z=>m(d(z,u,g,p)),b,S;c.ori==0?(b=Co,S=wE):(b=Ro,S=AE);let M=c.dir*(c.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Eo},A=y.stroke,I=!1;if(r-s>=_*4){let z=dt=>e.posToVal(dt,c.key,!0),U=null,G=null,$,H,lt,J=x(a[M==1?s:r]),Q=x(a[s]),it=x(a[r]),ft=z(M==1?Q+1:it-1);for(let dt=M==1?s:r;dt>=s&&dt<=r;dt+=M){let tt=a[dt],gt=(M==1?tt<ft:tt>ft)?J:x(tt),St=l[dt];gt==J?St!=null?(H=St,U==null?(b(A,gt,w(H)),$=U=G=H):H<U?U=H:H>G&&(G=H)):St===null&&(I=!0):(U!=null&&S(A,J,w(U),w(G),w($),w(H)),St!=null?(H=St,b(A,gt,w(H)),U=G=$=H):(U=G=null,St===null&&(I=!0)),J=gt,ft=z(J+M))}U!=null&&U!=G&&lt!=J&&S(A,J,w(U),w(G),w($),w(H))}else for(let z=M==1?s:r;z>=s&&z<=r;z+=M){let U=l[z];U===null?I=!0:U!=null&&b(A,x(a[z]),w(U))}let[P,F]=of(e,i);if(o.fill!=null||P!=0){let z=y.fill=new Path2D(A),U=o.fillTo(e,i,o.min,o.max,P),G=w(U),$=x(a[s]),H=x(a[r]);M==-1&&([H,$]=[$,H]),b(z,H,G),b(z,$,G)}if(!o.spanGaps){let z=[];I&&z.push(...af(a,l,s,r,M,x,t)),y.gaps=z=o.gaps(e,i,s,r,z),y.clip=Au(z,c.ori,f,p,_,g)}return F!=0&&(y.band=F==2?[ws(e,i,s,r,A,-1),ws(e,i,s,r,A,1)]:ws(e,i,s,r,A,F)),y})}function EE(n){let t=be(n.align,1),e=be(n.ascDesc,!1),i=be(n.alignGaps,0),s=be(n.extend,!1);return(r,o,a,l)=>Mr(r,o,(c,u,h,d,f,p,_,g,m,x,w)=>{[a,l]=bu(h,a,l);let b=c.pxRound,{left:S,width:M}=r.bbox,y=Q=>b(p(Q,d,x,g)),A=Q=>b(_(Q,f,w,m)),I=d.ori==0?Co:Ro,L={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Eo},P=L.stroke,F=d.dir*(d.ori==0?1:-1),z=A(h[F==1?a:l]),U=y(u[F==1?a:l]),G=U,$=U;s&&t==-1&&($=S,I(P,$,z)),I(P,U,z);for(let Q=F==1?a:l;Q>=a&&Q<=l;Q+=F){let it=h[Q];if(it==null)continue;let ft=y(u[Q]),dt=A(it);t==1?I(P,ft,z):I(P,G,dt),I(P,ft,dt),z=dt,G=ft}let H=G;s&&t==1&&(H=S+M,I(P,H,z));let[lt,J]=of(r,o);if(c.fill!=null||lt!=0){let Q=L.fill=new Path2D(P),it=c.fillTo(r,o,c.min,c.max,lt),ft=A(it);I(Q,H,ft),I(Q,$,ft)}if(!c.spanGaps){let Q=[];Q.push(...af(u,h,a,l,F,y,i));let it=c.width*we/2,ft=e||t==1?it:-it,dt=e||t==-1?-it:it;Q.forEach(tt=>{tt[0]+=ft,tt[1]+=dt}),L.gaps=Q=c.gaps(r,o,a,l,Q),L.clip=Au(Q,d.ori,g,m,x,w)}return J!=0&&(L.band=J==2?[ws(r,o,a,l,P,-1),ws(r,o,a,l,P,1)]:ws(r,o,a,l,P,J)),L})}function h0(n,t,e,i,s,r,o=Ue){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let u=Mn(n[l]-n[a]);u<c&&(c=u,o=Mn(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function TE(n){n=n||$a;let t=be(n.size,[.6,Ue,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=_e(s),o=1-t[0],a=be(t[1],Ue),l=be(t[2],1),c=be(n.disp,$a),u=be(n.each,f=>{}),{fill:h,stroke:d}=c;return(f,p,_,g)=>Mr(f,p,(m,x,w,b,S,M,y,A,I,L,P)=>{let F=m.pxRound,z=e,U=i*we,G=a*we,$=l*we,H,lt;b.ori==0?[H,lt]=r(f,p):[lt,H]=r(f,p);let J=b.dir*(b.ori==0?1:-1),Q=b.ori==0?Cu:lf,it=b.ori==0?u:(Rt,qt,re,wt,De,zt,Xt)=>{u(Rt,qt,re,De,wt,Xt,zt)},ft=be(f.bands,tf).find(Rt=>Rt.series[0]==p),dt=ft!=null?ft.dir:0,tt=m.fillTo(f,p,m.min,m.max,dt),ht=F(y(tt,S,P,I)),gt,St,Mt,Ht=L,se=F(m.width*we),Vt=!1,ue=null,ae=null,ne=null,Xe=null;h!=null&&(se==0||d!=null)&&(Vt=!0,ue=h.values(f,p,_,g),ae=new Map,new Set(ue).forEach(Rt=>{Rt!=null&&ae.set(Rt,new Path2D)}),se>0&&(ne=d.values(f,p,_,g),Xe=new Map,new Set(ne).forEach(Rt=>{Rt!=null&&Xe.set(Rt,new Path2D)})));let{x0:Fe,size:an}=c;if(Fe!=null&&an!=null){z=1,x=Fe.values(f,p,_,g),Fe.unit==2&&(x=x.map(re=>f.posToVal(A+re*L,b.key,!0)));let Rt=an.values(f,p,_,g);an.unit==2?St=Rt[0]*L:St=M(Rt[0],b,L,A)-M(0,b,L,A),Ht=h0(x,w,M,b,L,A,Ht),Mt=Ht-St+U}else Ht=h0(x,w,M,b,L,A,Ht),Mt=Ht*o+U,St=Ht-Mt;Mt<1&&(Mt=0),se>=St/2&&(se=0),Mt<5&&(F=v0);let Le=Mt>0,wn=Ht-Mt-(Le?se:0);St=F(Gd(wn,$,G)),gt=(z==0?St/2:z==J?0:St)-z*J*((z==0?U/2:0)+(Le?se/2:0));let ye={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},mn=Vt?null:new Path2D,Ze=null;if(ft!=null)Ze=f.data[ft.series[1]];else{let{y0:Rt,y1:qt}=c;Rt!=null&&qt!=null&&(w=qt.values(f,p,_,g),Ze=Rt.values(f,p,_,g))}let ln=H*St,B=lt*St;for(let Rt=J==1?_:g;Rt>=_&&Rt<=g;Rt+=J){let qt=w[Rt];if(qt==null)continue;if(Ze!=null){let q=Ze[Rt]??0;if(qt-q==0)continue;ht=y(q,S,P,I)}let re=b.distr!=2||c!=null?x[Rt]:Rt,wt=M(re,b,L,A),De=y(be(qt,tt),S,P,I),zt=F(wt-gt),Xt=F(Zn(De,ht)),N=F(Di(De,ht)),E=Xt-N;if(qt!=null){let q=qt<0?B:ln,ut=qt<0?ln:B;Vt?(se>0&&ne[Rt]!=null&&Q(Xe.get(ne[Rt]),zt,N+di(se/2),St,Zn(0,E-se),q,ut),ue[Rt]!=null&&Q(ae.get(ue[Rt]),zt,N+di(se/2),St,Zn(0,E-se),q,ut)):Q(mn,zt,N+di(se/2),St,Zn(0,E-se),q,ut),it(f,p,Rt,zt-se/2,N,St+se,E)}}return se>0?ye.stroke=Vt?Xe:mn:Vt||(ye._fill=m.width==0?m._fill:m._stroke??m._fill,ye.width=0),ye.fill=Vt?ae:mn,ye})}function CE(n,t){let e=be(t?.alignGaps,0);return(i,s,r,o)=>Mr(i,s,(a,l,c,u,h,d,f,p,_,g,m)=>{[r,o]=bu(c,r,o);let x=a.pxRound,w=H=>x(d(H,u,g,p)),b=H=>x(f(H,h,m,_)),S,M,y;u.ori==0?(S=Eu,y=Co,M=q0):(S=Tu,y=Ro,M=Y0);let A=u.dir*(u.ori==0?1:-1),I=w(l[A==1?r:o]),L=I,P=[],F=[];for(let H=A==1?r:o;H>=r&&H<=o;H+=A)if(c[H]!=null){let J=l[H],Q=w(J);P.push(L=Q),F.push(b(c[H]))}let z={stroke:n(P,F,S,y,M,x),fill:null,clip:null,band:null,gaps:null,flags:Eo},U=z.stroke,[G,$]=of(i,s);if(a.fill!=null||G!=0){let H=z.fill=new Path2D(U),lt=a.fillTo(i,s,a.min,a.max,G),J=b(lt);y(H,L,J),y(H,I,J)}if(!a.spanGaps){let H=[];H.push(...af(l,c,r,o,A,w,e)),z.gaps=H=a.gaps(i,s,r,o,H),z.clip=Au(H,u.ori,p,_,g,m)}return $!=0&&(z.band=$==2?[ws(i,s,r,o,U,-1),ws(i,s,r,o,U,1)]:ws(i,s,r,o,U,$)),z})}function RE(n){return CE(PE,n)}function PE(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let d=0;d<o-1;d++)u[d]=t[d+1]-t[d],h[d]=n[d+1]-n[d],c[d]=u[d]/h[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(h[d-1]+h[d])/((2*h[d]+h[d-1])/c[d-1]+(h[d]+2*h[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,n[d]+h[d]/3,t[d]+l[d]*h[d]/3,n[d+1]-h[d]/3,t[d+1]-l[d+1]*h[d]/3,n[d+1],t[d+1])}return a}var $d=new Set;function d0(){for(let n of $d)n.syncRect(!0)}To&&(br(uA,So,d0),br(hA,So,d0,!0),br(_u,So,()=>{on.pxRatio=we}));var IE=K0(),LE=Z0();function f0(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>qd(r,o,t,e))}function NE(n,t){return n.map((e,i)=>i==0?{}:pn({},t,e))}function qd(n,t,e,i){return pn({},t==0?e:i,n)}function j0(n,t,e){return t==null?wo:[t,e]}var DE=j0;function UE(n,t,e){return t==null?wo:yu(t,e,jd,!0)}function Q0(n,t,e,i){return t==null?wo:Su(t,e,n.scales[i].log,!1)}var OE=Q0;function tx(n,t,e,i){return t==null?wo:Kd(t,e,n.scales[i].log,!1)}var FE=tx;function kE(n,t,e,i,s){let r=Zn(Xg(n),Xg(t)),o=t-n,a=Ni(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?js.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function p0(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=Sn((e=+s)*we))+"px"),[n,t,e]}function BE(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=Oe(t[2]*we,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function on(n,t,e){let i={mode:be(n.mode,1)},s=i.mode;function r(v,T,D,O){let X=T.valToPct(v);return O+D*(T.dir==-1?1-X:X)}function o(v,T,D,O){let X=T.valToPct(v);return O+D*(T.dir==-1?X:1-X)}function a(v,T,D,O){return T.ori==0?r(v,T,D,O):o(v,T,D,O)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=vi($1);if(n.id!=null&&(c.id=n.id),hi(c,n.class),n.title){let v=vi(Z1,c);v.textContent=n.title}let u=Li("canvas"),h=i.ctx=u.getContext("2d"),d=vi(J1,c);br("click",d,v=>{v.target===p&&(ze!=Pr||$e!=Ir)&&In.click(i,v)},!0);let f=i.under=vi(K1,d);d.appendChild(u);let p=i.over=vi(j1,d);n=Ao(n);let _=+be(n.pxAlign,1),g=u0(_);(n.plugins||[]).forEach(v=>{v.opts&&(n=v.opts(i,n)||n)});let m=n.ms||.001,x=i.series=s==1?f0(n.series||[],i0,l0,!1):NE(n.series||[null],a0),w=i.axes=f0(n.axes||[],n0,r0,!0),b=i.scales={},S=i.bands=n.bands||[];S.forEach(v=>{v.fill=_e(v.fill||null),v.dir=be(v.dir,-1)});let M=s==2?x[1].facets[0].scale:x[0].scale,y={axes:is,series:de},A=(n.drawOrder||["axes","series"]).map(v=>y[v]);function I(v){let T=v.distr==3?D=>Ms(D>0?D:v.clamp(i,D,v.min,v.max,v.key)):v.distr==4?D=>Dd(D,v.asinh):v.distr==100?D=>v.fwd(D):D=>D;return D=>{let O=T(D),{_min:X,_max:K}=v,at=K-X;return(O-X)/at}}function L(v){let T=b[v];if(T==null){let D=(n.scales||$a)[v]||$a;if(D.from!=null){L(D.from);let O=pn({},b[D.from],D,{key:v});O.valToPct=I(O),b[v]=O}else{T=b[v]=pn({},v==M?G0:bE,D),T.key=v;let O=T.time,X=T.range,K=Ks(X);if((v!=M||s==2&&!O)&&(K&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?Gg:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?Gg:{mode:1,hard:X[1],soft:X[1]}},K=!1),!K&&wu(X))){let at=X;X=(pt,vt,Nt)=>vt==null?wo:yu(vt,Nt,at)}T.range=_e(X||(O?DE:v==M?T.distr==3?OE:T.distr==4?FE:j0:T.distr==3?Q0:T.distr==4?tx:UE)),T.auto=_e(K?!1:T.auto),T.clamp=_e(T.clamp||vE),T._min=T._max=null,T.valToPct=I(T)}}}L("x"),L("y"),s==1&&x.forEach(v=>{L(v.scale)}),w.forEach(v=>{L(v.scale)});for(let v in n.scales)L(v);let P=b[M],F=P.distr,z,U;P.ori==0?(hi(c,q1),z=r,U=o):(hi(c,Y1),z=o,U=r);let G={};for(let v in b){let T=b[v];(T.min!=null||T.max!=null)&&(G[v]={min:T.min,max:T.max},T.min=T.max=null)}let $=n.tzDate||(v=>new Date(Sn(v/m))),H=n.fmtDate||ef,lt=m==1?qA($):JA($),J=Qg($,jg(m==1?$A:ZA,H)),Q=e0($,t0(jA,H)),it=[],ft=i.legend=pn({},eE,n.legend),dt=i.cursor=pn({},aE,{drag:{y:s==2}},n.cursor),tt=ft.show,ht=dt.show,gt=ft.markers;ft.idxs=it,gt.width=_e(gt.width),gt.dash=_e(gt.dash),gt.stroke=_e(gt.stroke),gt.fill=_e(gt.fill);let St,Mt,Ht,se=[],Vt=[],ue,ae=!1,ne={};if(ft.live){let v=x[1]?x[1].values:null;ae=v!=null,ue=ae?v(i,1,0):{_:0};for(let T in ue)ne[T]=Zd}if(tt)if(St=Li("table",sA,c),Ht=Li("tbody",null,St),ft.mount(i,St),ae){Mt=Li("thead",null,St,Ht);let v=Li("tr",null,Mt);Li("th",null,v);for(var Xe in ue)Li("th",Rg,v).textContent=Xe}else hi(St,oA),ft.live&&hi(St,rA);let Fe={show:!0},an={show:!1};function Le(v,T){if(T==0&&(ae||!ft.live||s==2))return wo;let D=[],O=Li("tr",aA,Ht,Ht.childNodes[T]);hi(O,v.class),v.show||hi(O,vr);let X=Li("th",null,O);if(gt.show){let pt=vi(lA,X);if(T>0){let vt=gt.width(i,T);vt&&(pt.style.border=vt+"px "+gt.dash(i,T)+" "+gt.stroke(i,T)),pt.style.background=gt.fill(i,T)}}let K=vi(Rg,X);v.label instanceof HTMLElement?K.appendChild(v.label):K.textContent=v.label,T>0&&(gt.show||(K.style.color=v.width>0?gt.stroke(i,T):gt.fill(i,T)),ye("click",X,pt=>{if(dt._lock)return;Jt(pt);let vt=x.indexOf(v);if((pt.ctrlKey||pt.metaKey)!=ft.isolate){let Nt=x.some((Dt,Ot)=>Ot>0&&Ot!=vt&&Dt.show);x.forEach((Dt,Ot)=>{Ot>0&&Bi(Ot,Nt?Ot==vt?Fe:an:Fe,!0,dn.setSeries)})}else Bi(vt,{show:!v.show},!0,dn.setSeries)},!1),Kt&&ye(Ng,X,pt=>{dt._lock||(Jt(pt),Bi(x.indexOf(v),Nr,!0,dn.setSeries))},!1));for(var at in ue){let pt=Li("td",cA,O);pt.textContent="--",D.push(pt)}return[O,D]}let wn=new Map;function ye(v,T,D,O=!0){let X=wn.get(T)||{},K=dt.bind[v](i,T,D,O);K&&(br(v,T,X[v]=K),wn.set(T,X))}function mn(v,T,D){let O=wn.get(T)||{};for(let X in O)(v==null||X==v)&&(Vd(X,T,O[X]),delete O[X]);v==null&&wn.delete(T)}let Ze=0,ln=0,B=0,Rt=0,qt=0,re=0,wt=qt,De=re,zt=B,Xt=Rt,N=0,E=0,q=0,ut=0;i.bbox={};let ot=!1,_t=!1,yt=!1,et=!1,st=!1,mt=!1;function k(v,T,D){(D||v!=i.width||T!=i.height)&&rt(v,T),le(!1),yt=!0,_t=!0,Un()}function rt(v,T){i.width=Ze=B=v,i.height=ln=Rt=T,qt=re=0,bt(),Gt();let D=i.bbox;N=D.left=_r(qt*we,.5),E=D.top=_r(re*we,.5),q=D.width=_r(B*we,.5),ut=D.height=_r(Rt*we,.5)}let nt=3;function At(){let v=!1,T=0;for(;!v;){T++;let D=Tr(T),O=ki(T);v=T==nt||D&&O,v||(rt(i.width,i.height),_t=!0)}}function xt({width:v,height:T}){k(v,T)}i.setSize=xt;function bt(){let v=!1,T=!1,D=!1,O=!1;w.forEach((X,K)=>{if(X.show&&X._show){let{side:at,_size:pt}=X,vt=at%2,Nt=X.label!=null?X.labelSize:0,Dt=pt+Nt;Dt>0&&(vt?(B-=Dt,at==3?(qt+=Dt,O=!0):D=!0):(Rt-=Dt,at==0?(re+=Dt,v=!0):T=!0))}}),Oi[0]=v,Oi[1]=D,Oi[2]=T,Oi[3]=O,B-=Si[1]+Si[3],qt+=Si[3],Rt-=Si[2]+Si[0],re+=Si[0]}function Gt(){let v=qt+B,T=re+Rt,D=qt,O=re;function X(K,at){switch(K){case 1:return v+=at,v-at;case 2:return T+=at,T-at;case 3:return D-=at,D+at;case 0:return O-=at,O+at}}w.forEach((K,at)=>{if(K.show&&K._show){let pt=K.side;K._pos=X(pt,K._size),K.label!=null&&(K._lpos=X(pt,K.labelSize))}})}if(dt.dataIdx==null){let v=dt.hover,T=v.skip=new Set(v.skip??[]);T.add(void 0);let D=v.prox=_e(v.prox),O=v.bias??=0;dt.dataIdx=(X,K,at,pt)=>{if(K==0)return at;let vt=at,Nt=D(X,K,at,pt)??Ue,Dt=Nt>=0&&Nt<Ue,Ot=P.ori==0?B:Rt,ie=dt.left,Se=t[0],ve=t[K];if(T.has(ve[at])){vt=null;let me=null,Zt=null,Wt;if(O==0||O==-1)for(Wt=at;me==null&&Wt-- >0;)T.has(ve[Wt])||(me=Wt);if(O==0||O==1)for(Wt=at;Zt==null&&Wt++<ve.length;)T.has(ve[Wt])||(Zt=Wt);if(me!=null||Zt!=null)if(Dt){let Ge=me==null?-1/0:z(Se[me],P,Ot,0),je=Zt==null?1/0:z(Se[Zt],P,Ot,0),Cn=ie-Ge,Ne=je-ie;Cn<=Ne?Cn<=Nt&&(vt=me):Ne<=Nt&&(vt=Zt)}else vt=Zt==null?me:me==null?Zt:at-me<=Zt-at?me:Zt}else Dt&&Mn(ie-z(Se[at],P,Ot,0))>Nt&&(vt=null);return vt}}let Jt=v=>{dt.event=v};dt.idxs=it,dt._lock=!1;let ct=dt.points;ct.show=_e(ct.show),ct.size=_e(ct.size),ct.stroke=_e(ct.stroke),ct.width=_e(ct.width),ct.fill=_e(ct.fill);let Ft=i.focus=pn({},n.focus||{alpha:.3},dt.focus),Kt=Ft.prox>=0,Ct=Kt&&ct.one,oe=[],Be=[],Vn=[];function Do(v,T){let D=ct.show(i,T);if(D instanceof HTMLElement)return hi(D,iA),hi(D,v.class),ji(D,-10,-10,B,Rt),p.insertBefore(D,oe[T]),D}function wr(v,T){if(s==1||T>0){let D=s==1&&b[v.scale].time,O=v.value;v.value=D?Yg(O)?e0($,t0(O,H)):O||Q:O||xE,v.label=v.label||(D?cE:lE)}if(Ct||T>0){v.width=v.width==null?1:v.width,v.paths=v.paths||IE||bA,v.fillTo=_e(v.fillTo||SE),v.pxAlign=+be(v.pxAlign,_),v.pxRound=u0(v.pxAlign),v.stroke=_e(v.stroke||null),v.fill=_e(v.fill||null),v._stroke=v._fill=v._paths=v._focus=null;let D=_E(Zn(1,v.width),1),O=v.points=pn({},{size:D,width:Zn(1,D*.2),stroke:v.stroke,space:D*2,paths:LE,_stroke:null,_fill:null},v.points);O.show=_e(O.show),O.filter=_e(O.filter),O.fill=_e(O.fill),O.stroke=_e(O.stroke),O.paths=_e(O.paths),O.pxAlign=v.pxAlign}if(tt){let D=Le(v,T);se.splice(T,0,D[0]),Vt.splice(T,0,D[1]),ft.values.push(null)}if(ht){it.splice(T,0,null);let D=null;Ct?T==0&&(D=Do(v,T)):T>0&&(D=Do(v,T)),oe.splice(T,0,D),Be.splice(T,0,0),Vn.splice(T,0,0)}Tn("addSeries",T)}function Vu(v,T){T=T??x.length,v=s==1?qd(v,T,i0,l0):qd(v,T,{},a0),x.splice(T,0,v),wr(x[T],T)}i.addSeries=Vu;function Ja(v){if(x.splice(v,1),tt){ft.values.splice(v,1),Vt.splice(v,1);let T=se.splice(v,1)[0];mn(null,T.firstChild),T.remove()}ht&&(it.splice(v,1),oe.splice(v,1)[0].remove(),Be.splice(v,1),Vn.splice(v,1)),Tn("delSeries",v)}i.delSeries=Ja;let Oi=[!1,!1,!1,!1];function ts(v,T){if(v._show=v.show,v.show){let D=v.side%2,O=b[v.scale];O==null&&(v.scale=D?x[1].scale:M,O=b[v.scale]);let X=O.time;v.size=_e(v.size),v.space=_e(v.space),v.rotate=_e(v.rotate),Ks(v.incrs)&&v.incrs.forEach(at=>{!js.has(at)&&js.set(at,M0(at))}),v.incrs=_e(v.incrs||(O.distr==2?HA:X?m==1?XA:YA:yr)),v.splits=_e(v.splits||(X&&O.distr==1?lt:O.distr==3?Hd:O.distr==4?dE:hE)),v.stroke=_e(v.stroke),v.grid.stroke=_e(v.grid.stroke),v.ticks.stroke=_e(v.ticks.stroke),v.border.stroke=_e(v.border.stroke);let K=v.values;v.values=Ks(K)&&!Ks(K[0])?_e(K):X?Ks(K)?Qg($,jg(K,H)):Yg(K)?KA($,K):K||J:K||uE,v.filter=_e(v.filter||(O.distr>=3&&O.log==10?mE:O.distr==3&&O.log==2?gE:b0)),v.font=p0(v.font),v.labelFont=p0(v.labelFont),v._size=v.size(i,null,T,0),v._space=v._rotate=v._incrs=v._found=v._splits=v._values=null,v._size>0&&(Oi[T]=!0,v._el=vi(Q1,d))}}function es(v,T,D,O){let[X,K,at,pt]=D,vt=T%2,Nt=0;return vt==0&&(pt||K)&&(Nt=T==0&&!X||T==2&&!at?Sn(n0.size/3):0),vt==1&&(X||at)&&(Nt=T==1&&!K||T==3&&!pt?Sn(r0.size/2):0),Nt}let Uo=i.padding=(n.padding||[es,es,es,es]).map(v=>_e(be(v,es))),Si=i._padding=Uo.map((v,T)=>v(i,T,Oi,0)),Je,nn=null,sn=null,Fi=s==1?x[0].idxs:null,Qn=null,Es=!1;function Oo(v,T){if(t=v??[],i.data=i._data=t,s==2){Je=0;for(let D=1;D<x.length;D++)Je+=t[D][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),Qn=t[0],Je=Qn.length;let D=t;if(F==2){D=t.slice();let O=D[0]=Array(Je);for(let X=0;X<Je;X++)O[X]=X}i._data=t=D}if(le(!0),Tn("setData"),F==2&&(yt=!0),T!==!1){let D=P;D.auto(i,Es)?Fo():Rs(M,D.min,D.max),et=et||dt.left>=0,mt=!0,Un()}}i.setData=Oo;function Fo(){Es=!0;let v,T;s==1&&(Je>0?(nn=Fi[0]=0,sn=Fi[1]=Je-1,v=t[0][nn],T=t[0][sn],F==2?(v=nn,T=sn):v==T&&(F==3?[v,T]=Su(v,v,P.log,!1):F==4?[v,T]=Kd(v,v,P.log,!1):P.time?T=v+Sn(86400/m):[v,T]=yu(v,T,jd,!0))):(nn=Fi[0]=v=null,sn=Fi[1]=T=null)),Rs(M,v,T)}let Ar,Ts,Er,C,V,j,Y,Z,Et,Pt;function Tt(v,T,D,O,X,K){v??=Ig,D??=tf,O??="butt",X??=Ig,K??="round",v!=Ar&&(h.strokeStyle=Ar=v),X!=Ts&&(h.fillStyle=Ts=X),T!=Er&&(h.lineWidth=Er=T),K!=V&&(h.lineJoin=V=K),O!=j&&(h.lineCap=j=O),D!=C&&h.setLineDash(C=D)}function It(v,T,D,O){T!=Ts&&(h.fillStyle=Ts=T),v!=Y&&(h.font=Y=v),D!=Z&&(h.textAlign=Z=D),O!=Et&&(h.textBaseline=Et=O)}function Bt(v,T,D,O,X=0){if(O.length>0&&v.auto(i,Es)&&(T==null||T.min==null)){let K=be(nn,0),at=be(sn,O.length-1),pt=D.min==null?mA(O,K,at,X,v.distr==3):[D.min,D.max];v.min=Di(v.min,D.min=pt[0]),v.max=Zn(v.max,D.max=pt[1])}}let te={min:null,max:null};function he(){for(let O in b){let X=b[O];G[O]==null&&(X.min==null||G[M]!=null&&X.auto(i,Es))&&(G[O]=te)}for(let O in b){let X=b[O];G[O]==null&&X.from!=null&&G[X.from]!=null&&(G[O]=te)}G[M]!=null&&le(!0);let v={};for(let O in G){let X=G[O];if(X!=null){let K=v[O]=Ao(b[O],wA);if(X.min!=null)pn(K,X);else if(O!=M||s==2)if(Je==0&&K.from==null){let at=K.range(i,null,null,O);K.min=at[0],K.max=at[1]}else K.min=Ue,K.max=-Ue}}if(Je>0){x.forEach((O,X)=>{if(s==1){let K=O.scale,at=G[K];if(at==null)return;let pt=v[K];if(X==0){let vt=pt.range(i,pt.min,pt.max,K);pt.min=vt[0],pt.max=vt[1],nn=Ni(pt.min,t[0]),sn=Ni(pt.max,t[0]),sn-nn>1&&(t[0][nn]<pt.min&&nn++,t[0][sn]>pt.max&&sn--),O.min=Qn[nn],O.max=Qn[sn]}else O.show&&O.auto&&Bt(pt,at,O,t[X],O.sorted);O.idxs[0]=nn,O.idxs[1]=sn}else if(X>0&&O.show&&O.auto){let[K,at]=O.facets,pt=K.scale,vt=at.scale,[Nt,Dt]=t[X],Ot=v[pt],ie=v[vt];Ot!=null&&Bt(Ot,G[pt],K,Nt,K.sorted),ie!=null&&Bt(ie,G[vt],at,Dt,at.sorted),O.min=at.min,O.max=at.max}});for(let O in v){let X=v[O],K=G[O];if(X.from==null&&(K==null||K.min==null)){let at=X.range(i,X.min==Ue?null:X.min,X.max==-Ue?null:X.max,O);X.min=at[0],X.max=at[1]}}}for(let O in v){let X=v[O];if(X.from!=null){let K=v[X.from];if(K.min==null)X.min=X.max=null;else{let at=X.range(i,K.min,K.max,O);X.min=at[0],X.max=at[1]}}}let T={},D=!1;for(let O in v){let X=v[O],K=b[O];if(K.min!=X.min||K.max!=X.max){K.min=X.min,K.max=X.max;let at=K.distr;K._min=at==3?Ms(K.min):at==4?Dd(K.min,K.asinh):at==100?K.fwd(K.min):K.min,K._max=at==3?Ms(K.max):at==4?Dd(K.max,K.asinh):at==100?K.fwd(K.max):K.max,T[O]=D=!0}}if(D){x.forEach((O,X)=>{s==2?X>0&&T.y&&(O._paths=null):T[O.scale]&&(O._paths=null)});for(let O in T)yt=!0,Tn("setScale",O);ht&&dt.left>=0&&(et=mt=!0)}for(let O in G)G[O]=null}function kt(v){let T=Gd(nn-1,0,Je-1),D=Gd(sn+1,0,Je-1);for(;v[T]==null&&T>0;)T--;for(;v[D]==null&&D<Je-1;)D++;return[T,D]}function de(){if(Je>0){let v=x.some(T=>T._focus)&&Pt!=Ft.alpha;v&&(h.globalAlpha=Pt=Ft.alpha),x.forEach((T,D)=>{if(D>0&&T.show&&(Ye(D,!1),Ye(D,!0),T._paths==null)){let O=Pt;Pt!=T.alpha&&(h.globalAlpha=Pt=T.alpha);let X=s==2?[0,t[D][0].length-1]:kt(t[D]);T._paths=T.paths(i,D,X[0],X[1]),Pt!=O&&(h.globalAlpha=Pt=O)}}),x.forEach((T,D)=>{if(D>0&&T.show){let O=Pt;Pt!=T.alpha&&(h.globalAlpha=Pt=T.alpha),T._paths!=null&&Ce(D,!1);{let X=T._paths!=null?T._paths.gaps:null,K=T.points.show(i,D,nn,sn,X),at=T.points.filter(i,D,K,X);(K||at)&&(T.points._paths=T.points.paths(i,D,nn,sn,at),Ce(D,!0))}Pt!=O&&(h.globalAlpha=Pt=O),Tn("drawSeries",D)}}),v&&(h.globalAlpha=Pt=1)}}function Ye(v,T){let D=T?x[v].points:x[v];D._stroke=D.stroke(i,v),D._fill=D.fill(i,v)}function Ce(v,T){let D=T?x[v].points:x[v],{stroke:O,fill:X,clip:K,flags:at,_stroke:pt=D._stroke,_fill:vt=D._fill,_width:Nt=D.width}=D._paths;Nt=Oe(Nt*we,3);let Dt=null,Ot=Nt%2/2;T&&vt==null&&(vt=Nt>0?"#fff":pt);let ie=D.pxAlign==1&&Ot>0;if(ie&&h.translate(Ot,Ot),!T){let Se=N-Nt/2,ve=E-Nt/2,me=q+Nt,Zt=ut+Nt;Dt=new Path2D,Dt.rect(Se,ve,me,Zt)}T?Ut(pt,Nt,D.dash,D.cap,vt,O,X,at,K):Re(v,pt,Nt,D.dash,D.cap,vt,O,X,at,Dt,K),ie&&h.translate(-Ot,-Ot)}function Re(v,T,D,O,X,K,at,pt,vt,Nt,Dt){let Ot=!1;vt!=0&&S.forEach((ie,Se)=>{if(ie.series[0]==v){let ve=x[ie.series[1]],me=t[ie.series[1]],Zt=(ve._paths||$a).band;Ks(Zt)&&(Zt=ie.dir==1?Zt[0]:Zt[1]);let Wt,Ge=null;ve.show&&Zt&&xA(me,nn,sn)?(Ge=ie.fill(i,Se)||K,Wt=ve._paths.clip):Zt=null,Ut(T,D,O,X,Ge,at,pt,vt,Nt,Dt,Wt,Zt),Ot=!0}}),Ot||Ut(T,D,O,X,K,at,pt,vt,Nt,Dt)}let gn=Eo|Xd;function Ut(v,T,D,O,X,K,at,pt,vt,Nt,Dt,Ot){Tt(v,T,D,O,X),(vt||Nt||Ot)&&(h.save(),vt&&h.clip(vt),Nt&&h.clip(Nt)),Ot?(pt&gn)==gn?(h.clip(Ot),Dt&&h.clip(Dt),ge(X,at),cn(v,K,T)):pt&Xd?(ge(X,at),h.clip(Ot),cn(v,K,T)):pt&Eo&&(h.save(),h.clip(Ot),Dt&&h.clip(Dt),ge(X,at),h.restore(),cn(v,K,T)):(ge(X,at),cn(v,K,T)),(vt||Nt||Ot)&&h.restore()}function cn(v,T,D){D>0&&(T instanceof Map?T.forEach((O,X)=>{h.strokeStyle=Ar=X,h.stroke(O)}):T!=null&&v&&h.stroke(T))}function ge(v,T){T instanceof Map?T.forEach((D,O)=>{h.fillStyle=Ts=O,h.fill(D)}):T!=null&&v&&h.fill(T)}function ns(v,T,D,O){let X=w[v],K;if(O<=0)K=[0,0];else{let at=X._space=X.space(i,v,T,D,O),pt=X._incrs=X.incrs(i,v,T,D,O,at);K=kE(T,D,pt,O,at)}return X._found=K}function un(v,T,D,O,X,K,at,pt,vt,Nt){let Dt=at%2/2;_==1&&h.translate(Dt,Dt),Tt(pt,at,vt,Nt,pt),h.beginPath();let Ot,ie,Se,ve,me=X+(O==0||O==3?-K:K);D==0?(ie=X,ve=me):(Ot=X,Se=me);for(let Zt=0;Zt<v.length;Zt++)T[Zt]!=null&&(D==0?Ot=Se=v[Zt]:ie=ve=v[Zt],h.moveTo(Ot,ie),h.lineTo(Se,ve));h.stroke(),_==1&&h.translate(-Dt,-Dt)}function Tr(v){let T=!0;return w.forEach((D,O)=>{if(!D.show)return;let X=b[D.scale];if(X.min==null){D._show&&(T=!1,D._show=!1,le(!1));return}else D._show||(T=!1,D._show=!0,le(!1));let K=D.side,at=K%2,{min:pt,max:vt}=X,[Nt,Dt]=ns(O,pt,vt,at==0?B:Rt);if(Dt==0)return;let Ot=X.distr==2,ie=D._splits=D.splits(i,O,pt,vt,Nt,Dt,Ot),Se=X.distr==2?ie.map(Wt=>Qn[Wt]):ie,ve=X.distr==2?Qn[ie[1]]-Qn[ie[0]]:Nt,me=D._values=D.values(i,D.filter(i,Se,O,Dt,ve),O,Dt,ve);D._rotate=K==2?D.rotate(i,me,O,Dt):0;let Zt=D._size;D._size=bi(D.size(i,me,O,v)),Zt!=null&&D._size!=Zt&&(T=!1)}),T}function ki(v){let T=!0;return Uo.forEach((D,O)=>{let X=D(i,O,Oi,v);X!=Si[O]&&(T=!1),Si[O]=X}),T}function is(){for(let v=0;v<w.length;v++){let T=w[v];if(!T.show||!T._show)continue;let D=T.side,O=D%2,X,K,at=T.stroke(i,v),pt=D==0||D==3?-1:1,[vt,Nt]=T._found;if(T.label!=null){let Wn=T.labelGap*pt,ni=Sn((T._lpos+Wn)*we);It(T.labelFont[0],at,"center",D==2?"top":Pg),h.save(),O==1?(X=K=0,h.translate(ni,Sn(E+ut/2)),h.rotate((D==3?-xu:xu)/2)):(X=Sn(N+q/2),K=ni);let nr=y0(T.label)?T.label(i,v,vt,Nt):T.label;h.fillText(nr,X,K),h.restore()}if(Nt==0)continue;let Dt=b[T.scale],Ot=O==0?q:ut,ie=O==0?N:E,Se=T._splits,ve=Dt.distr==2?Se.map(Wn=>Qn[Wn]):Se,me=Dt.distr==2?Qn[Se[1]]-Qn[Se[0]]:vt,Zt=T.ticks,Wt=T.border,Ge=Zt.show?Zt.size:0,je=Sn(Ge*we),Cn=Sn((T.alignTo==2?T._size-Ge-T.gap:T.gap)*we),Ne=T._rotate*-xu/180,Qe=g(T._pos*we),ti=(je+Cn)*pt,Hn=Qe+ti;K=O==0?Hn:0,X=O==1?Hn:0;let pi=T.font[0],Mi=T.align==1?vo:T.align==2?Id:Ne>0?vo:Ne<0?Id:O==0?"center":D==3?Id:vo,Vi=Ne||O==1?"middle":D==2?"top":Pg;It(pi,at,Mi,Vi);let ei=T.font[1]*T.lineGap,mi=Se.map(Wn=>g(a(Wn,Dt,Ot,ie))),wi=T._values;for(let Wn=0;Wn<wi.length;Wn++){let ni=wi[Wn];if(ni!=null){O==0?X=mi[Wn]:K=mi[Wn],ni=""+ni;let nr=ni.indexOf(`
`)==-1?[ni]:ni.split(/\n/gm);for(let Xn=0;Xn<nr.length;Xn++){let Gf=nr[Xn];Ne?(h.save(),h.translate(X,K+Xn*ei),h.rotate(Ne),h.fillText(Gf,0,0),h.restore()):h.fillText(Gf,X,K+Xn*ei)}}}Zt.show&&un(mi,Zt.filter(i,ve,v,Nt,me),O,D,Qe,je,Oe(Zt.width*we,3),Zt.stroke(i,v),Zt.dash,Zt.cap);let Gi=T.grid;Gi.show&&un(mi,Gi.filter(i,ve,v,Nt,me),O,O==0?2:1,O==0?E:N,O==0?ut:q,Oe(Gi.width*we,3),Gi.stroke(i,v),Gi.dash,Gi.cap),Wt.show&&un([Qe],[1],O==0?1:0,O==0?1:2,O==1?E:N,O==1?ut:q,Oe(Wt.width*we,3),Wt.stroke(i,v),Wt.dash,Wt.cap)}Tn("drawAxes")}function le(v){x.forEach((T,D)=>{D>0&&(T._paths=null,v&&(s==1?(T.min=null,T.max=null):T.facets.forEach(O=>{O.min=null,O.max=null})))})}let Ke=!1,Gn=!1,Pe=[];function hn(){Gn=!1;for(let v=0;v<Pe.length;v++)Tn(...Pe[v]);Pe.length=0}function Un(){Ke||(IA(wf),Ke=!0)}function Ka(v,T=!1){Ke=!0,Gn=T,v(i),wf(),T&&Pe.length>0&&queueMicrotask(hn)}i.batch=Ka;function wf(){if(ot&&(he(),ot=!1),yt&&(At(),yt=!1),_t){if(We(f,vo,qt),We(f,"top",re),We(f,Ga,B),We(f,Ha,Rt),We(p,vo,qt),We(p,"top",re),We(p,Ga,B),We(p,Ha,Rt),We(d,Ga,Ze),We(d,Ha,ln),u.width=Sn(Ze*we),u.height=Sn(ln*we),w.forEach(({_el:v,_show:T,_size:D,_pos:O,side:X})=>{if(v!=null)if(T){let K=X===3||X===0?D:0,at=X%2==1;We(v,at?"left":"top",O-K),We(v,at?"width":"height",D),We(v,at?"top":"left",at?re:qt),We(v,at?"height":"width",at?Rt:B),zd(v,vr)}else hi(v,vr)}),Ar=Ts=Er=V=j=Y=Z=Et=C=null,Pt=1,zo(!0),qt!=wt||re!=De||B!=zt||Rt!=Xt){le(!1);let v=B/zt,T=Rt/Xt;if(ht&&!et&&dt.left>=0){dt.left*=v,dt.top*=T,Cr&&ji(Cr,Sn(dt.left),0,B,Rt),Rr&&ji(Rr,0,Sn(dt.top),B,Rt);for(let D=0;D<oe.length;D++){let O=oe[D];O!=null&&(Be[D]*=v,Vn[D]*=T,ji(O,bi(Be[D]),bi(Vn[D]),B,Rt))}}if(Ve.show&&!st&&Ve.left>=0&&Ve.width>0){Ve.left*=v,Ve.width*=v,Ve.top*=T,Ve.height*=T;for(let D in qu)We(Lr,D,Ve[D])}wt=qt,De=re,zt=B,Xt=Rt}Tn("setSize"),_t=!1}Ze>0&&ln>0&&(h.clearRect(0,0,u.width,u.height),Tn("drawClear"),A.forEach(v=>v()),Tn("draw")),Ve.show&&st&&(ja(Ve),st=!1),ht&&et&&(er(null,!0,!1),et=!1),ft.show&&ft.live&&mt&&(Xu(),mt=!1),l||(l=!0,i.status=1,Tn("ready")),Es=!1,Ke=!1}i.redraw=(v,T)=>{yt=T||!1,v!==!1?Rs(M,P.min,P.max):Un()};function Gu(v,T){let D=b[v];if(D.from==null){if(Je==0){let O=D.range(i,T.min,T.max,v);T.min=O[0],T.max=O[1]}if(T.min>T.max){let O=T.min;T.min=T.max,T.max=O}if(Je>1&&T.min!=null&&T.max!=null&&T.max-T.min<1e-16)return;v==M&&D.distr==2&&Je>0&&(T.min=Ni(T.min,t[0]),T.max=Ni(T.max,t[0]),T.min==T.max&&T.max++),G[v]=T,ot=!0,Un()}}i.setScale=Gu;let Hu,Wu,Cr,Rr,Af,Ef,Pr,Ir,Tf,Cf,ze,$e,Cs=!1,In=dt.drag,An=In.x,En=In.y;ht&&(dt.x&&(Hu=vi(eA,p)),dt.y&&(Wu=vi(nA,p)),P.ori==0?(Cr=Hu,Rr=Wu):(Cr=Wu,Rr=Hu),ze=dt.left,$e=dt.top);let Ve=i.select=pn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Lr=Ve.show?vi(tA,Ve.over?p:f):null;function ja(v,T){if(Ve.show){for(let D in v)Ve[D]=v[D],D in qu&&We(Lr,D,v[D]);T!==!1&&Tn("setSelect")}}i.setSelect=ja;function m_(v){if(x[v].show)tt&&zd(se[v],vr);else if(tt&&hi(se[v],vr),ht){let D=Ct?oe[0]:oe[v];D!=null&&ji(D,-10,-10,B,Rt)}}function Rs(v,T,D){Gu(v,{min:T,max:D})}function Bi(v,T,D,O){T.focus!=null&&v_(v),T.show!=null&&x.forEach((X,K)=>{K>0&&(v==K||v==null)&&(X.show=T.show,m_(K),s==2?(Rs(X.facets[0].scale,null,null),Rs(X.facets[1].scale,null,null)):Rs(X.scale,null,null),Un())}),D!==!1&&Tn("setSeries",v,T),O&&Vo("setSeries",i,v,T)}i.setSeries=Bi;function g_(v,T){pn(S[v],T)}function x_(v,T){v.fill=_e(v.fill||null),v.dir=be(v.dir,-1),T=T??S.length,S.splice(T,0,v)}function __(v){v==null?S.length=0:S.splice(v,1)}i.addBand=x_,i.setBand=g_,i.delBand=__;function y_(v,T){x[v].alpha=T,ht&&oe[v]!=null&&(oe[v].style.opacity=T),tt&&se[v]&&(se[v].style.opacity=T)}let ss,Ps,tr,Nr={focus:!0};function v_(v){if(v!=tr){let T=v==null,D=Ft.alpha!=1;x.forEach((O,X)=>{if(s==1||X>0){let K=T||X==0||X==v;O._focus=T?null:K,D&&y_(X,K?1:Ft.alpha)}}),tr=v,D&&Un()}}tt&&Kt&&ye(Dg,St,v=>{dt._lock||(Jt(v),tr!=null&&Bi(null,Nr,!0,dn.setSeries))});function zi(v,T,D){let O=b[T];D&&(v=v/we-(O.ori==1?re:qt));let X=B;O.ori==1&&(X=Rt,v=X-v),O.dir==-1&&(v=X-v);let K=O._min,at=O._max,pt=v/X,vt=K+(at-K)*pt,Nt=O.distr;return Nt==3?Mo(10,vt):Nt==4?yA(vt,O.asinh):Nt==100?O.bwd(vt):vt}function b_(v,T){let D=zi(v,M,T);return Ni(D,t[0],nn,sn)}i.valToIdx=v=>Ni(v,t[0]),i.posToIdx=b_,i.posToVal=zi,i.valToPos=(v,T,D)=>b[T].ori==0?r(v,b[T],D?q:B,D?N:0):o(v,b[T],D?ut:Rt,D?E:0),i.setCursor=(v,T,D)=>{ze=v.left,$e=v.top,er(null,T,D)};function Rf(v,T){We(Lr,vo,Ve.left=v),We(Lr,Ga,Ve.width=T)}function Pf(v,T){We(Lr,"top",Ve.top=v),We(Lr,Ha,Ve.height=T)}let ko=P.ori==0?Rf:Pf,Bo=P.ori==1?Rf:Pf;function S_(){if(tt&&ft.live)for(let v=s==2?1:0;v<x.length;v++){if(v==0&&ae)continue;let T=ft.values[v],D=0;for(let O in T)Vt[v][D++].firstChild.nodeValue=T[O]}}function Xu(v,T){if(v!=null&&(v.idxs?v.idxs.forEach((D,O)=>{it[O]=D}):MA(v.idx)||it.fill(v.idx),ft.idx=it[0]),tt&&ft.live){for(let D=0;D<x.length;D++)(D>0||s==1&&!ae)&&M_(D,it[D]);S_()}mt=!1,T!==!1&&Tn("setLegend")}i.setLegend=Xu;function M_(v,T){let D=x[v],O=v==0&&F==2?Qn:t[v],X;ae?X=D.values(i,v,T)??ne:(X=D.value(i,T==null?null:O[T],v,T),X=X==null?ne:{_:X}),ft.values[v]=X}function er(v,T,D){Tf=ze,Cf=$e,[ze,$e]=dt.move(i,ze,$e),dt.left=ze,dt.top=$e,ht&&(Cr&&ji(Cr,Sn(ze),0,B,Rt),Rr&&ji(Rr,0,Sn($e),B,Rt));let O,X=nn>sn;ss=Ue,Ps=null;let K=P.ori==0?B:Rt,at=P.ori==1?B:Rt;if(ze<0||Je==0||X){O=dt.idx=null;for(let pt=0;pt<x.length;pt++){let vt=oe[pt];vt!=null&&ji(vt,-10,-10,B,Rt)}Kt&&Bi(null,Nr,!0,v==null&&dn.setSeries),ft.live&&(it.fill(O),mt=!0)}else{let pt,vt,Nt;s==1&&(pt=P.ori==0?ze:$e,vt=zi(pt,M),O=dt.idx=Ni(vt,t[0],nn,sn),Nt=z(t[0][O],P,K,0));let Dt=-10,Ot=-10,ie=0,Se=0,ve=!0,me="",Zt="";for(let Wt=s==2?1:0;Wt<x.length;Wt++){let Ge=x[Wt],je=it[Wt],Cn=je==null?null:s==1?t[Wt][je]:t[Wt][1][je],Ne=dt.dataIdx(i,Wt,O,vt),Qe=Ne==null?null:s==1?t[Wt][Ne]:t[Wt][1][Ne];if(mt=mt||Qe!=Cn||Ne!=je,it[Wt]=Ne,Wt>0&&Ge.show){let ti=Ne==null?-10:Ne==O?Nt:z(s==1?t[0][Ne]:t[Wt][0][Ne],P,K,0),Hn=Qe==null?-10:U(Qe,s==1?b[Ge.scale]:b[Ge.facets[1].scale],at,0);if(Kt&&Qe!=null){let pi=P.ori==1?ze:$e,Mi=Mn(Ft.dist(i,Wt,Ne,Hn,pi));if(Mi<ss){let Vi=Ft.bias;if(Vi!=0){let ei=zi(pi,Ge.scale),mi=Qe>=0?1:-1,wi=ei>=0?1:-1;wi==mi&&(wi==1?Vi==1?Qe>=ei:Qe<=ei:Vi==1?Qe<=ei:Qe>=ei)&&(ss=Mi,Ps=Wt)}else ss=Mi,Ps=Wt}}if(mt||Ct){let pi,Mi;P.ori==0?(pi=ti,Mi=Hn):(pi=Hn,Mi=ti);let Vi,ei,mi,wi,Gi,Wn,ni=!0,nr=ct.bbox;if(nr!=null){ni=!1;let Xn=nr(i,Wt);mi=Xn.left,wi=Xn.top,Vi=Xn.width,ei=Xn.height}else mi=pi,wi=Mi,Vi=ei=ct.size(i,Wt);if(Wn=ct.fill(i,Wt),Gi=ct.stroke(i,Wt),Ct)Wt==Ps&&ss<=Ft.prox&&(Dt=mi,Ot=wi,ie=Vi,Se=ei,ve=ni,me=Wn,Zt=Gi);else{let Xn=oe[Wt];Xn!=null&&(Be[Wt]=mi,Vn[Wt]=wi,Vg(Xn,Vi,ei,ni),Bg(Xn,Wn,Gi),ji(Xn,bi(mi),bi(wi),B,Rt))}}}}if(Ct){let Wt=Ft.prox,Ge=tr==null?ss<=Wt:ss>Wt||Ps!=tr;if(mt||Ge){let je=oe[0];je!=null&&(Be[0]=Dt,Vn[0]=Ot,Vg(je,ie,Se,ve),Bg(je,me,Zt),ji(je,bi(Dt),bi(Ot),B,Rt))}}}if(Ve.show&&Cs)if(v!=null){let[pt,vt]=dn.scales,[Nt,Dt]=dn.match,[Ot,ie]=v.cursor.sync.scales,Se=v.cursor.drag;if(An=Se._x,En=Se._y,An||En){let{left:ve,top:me,width:Zt,height:Wt}=v.select,Ge=v.scales[Ot].ori,je=v.posToVal,Cn,Ne,Qe,ti,Hn,pi=pt!=null&&Nt(pt,Ot),Mi=vt!=null&&Dt(vt,ie);pi&&An?(Ge==0?(Cn=ve,Ne=Zt):(Cn=me,Ne=Wt),Qe=b[pt],ti=z(je(Cn,Ot),Qe,K,0),Hn=z(je(Cn+Ne,Ot),Qe,K,0),ko(Di(ti,Hn),Mn(Hn-ti))):ko(0,K),Mi&&En?(Ge==1?(Cn=ve,Ne=Zt):(Cn=me,Ne=Wt),Qe=b[vt],ti=U(je(Cn,ie),Qe,at,0),Hn=U(je(Cn+Ne,ie),Qe,at,0),Bo(Di(ti,Hn),Mn(Hn-ti))):Bo(0,at)}else Yu()}else{let pt=Mn(Tf-Af),vt=Mn(Cf-Ef);if(P.ori==1){let ie=pt;pt=vt,vt=ie}An=In.x&&pt>=In.dist,En=In.y&&vt>=In.dist;let Nt=In.uni;Nt!=null?An&&En&&(An=pt>=Nt,En=vt>=Nt,!An&&!En&&(vt>pt?En=!0:An=!0)):In.x&&In.y&&(An||En)&&(An=En=!0);let Dt,Ot;An&&(P.ori==0?(Dt=Pr,Ot=ze):(Dt=Ir,Ot=$e),ko(Di(Dt,Ot),Mn(Ot-Dt)),En||Bo(0,at)),En&&(P.ori==1?(Dt=Pr,Ot=ze):(Dt=Ir,Ot=$e),Bo(Di(Dt,Ot),Mn(Ot-Dt)),An||ko(0,K)),!An&&!En&&(ko(0,0),Bo(0,0))}if(In._x=An,In._y=En,v==null){if(D){if(Vf!=null){let[pt,vt]=dn.scales;dn.values[0]=pt!=null?zi(P.ori==0?ze:$e,pt):null,dn.values[1]=vt!=null?zi(P.ori==1?ze:$e,vt):null}Vo(Ld,i,ze,$e,B,Rt,O)}if(Kt){let pt=D&&dn.setSeries,vt=Ft.prox;tr==null?ss<=vt&&Bi(Ps,Nr,!0,pt):ss>vt?Bi(null,Nr,!0,pt):Ps!=tr&&Bi(Ps,Nr,!0,pt)}}mt&&(ft.idx=O,Xu()),T!==!1&&Tn("setCursor")}let Is=null;Object.defineProperty(i,"rect",{get(){return Is==null&&zo(!1),Is}});function zo(v=!1){v?Is=null:(Is=p.getBoundingClientRect(),Tn("syncRect",Is))}function If(v,T,D,O,X,K,at){dt._lock||Cs&&v!=null&&v.movementX==0&&v.movementY==0||($u(v,T,D,O,X,K,at,!1,v!=null),v!=null?er(null,!0,!0):er(T,!0,!1))}function $u(v,T,D,O,X,K,at,pt,vt){if(Is==null&&zo(!1),Jt(v),v!=null)D=v.clientX-Is.left,O=v.clientY-Is.top;else{if(D<0||O<0){ze=-10,$e=-10;return}let[Nt,Dt]=dn.scales,Ot=T.cursor.sync,[ie,Se]=Ot.values,[ve,me]=Ot.scales,[Zt,Wt]=dn.match,Ge=T.axes[0].side%2==1,je=P.ori==0?B:Rt,Cn=P.ori==1?B:Rt,Ne=Ge?K:X,Qe=Ge?X:K,ti=Ge?O:D,Hn=Ge?D:O;if(ve!=null?D=Zt(Nt,ve)?a(ie,b[Nt],je,0):-10:D=je*(ti/Ne),me!=null?O=Wt(Dt,me)?a(Se,b[Dt],Cn,0):-10:O=Cn*(Hn/Qe),P.ori==1){let pi=D;D=O,O=pi}}vt&&(T==null||T.cursor.event.type==Ld)&&((D<=1||D>=B-1)&&(D=_r(D,B)),(O<=1||O>=Rt-1)&&(O=_r(O,Rt))),pt?(Af=D,Ef=O,[Pr,Ir]=dt.move(i,D,O)):(ze=D,$e=O)}let qu={width:0,height:0,left:0,top:0};function Yu(){ja(qu,!1)}let Lf,Nf,Df,Uf;function Of(v,T,D,O,X,K,at){Cs=!0,An=En=In._x=In._y=!1,$u(v,T,D,O,X,K,at,!0,!1),v!=null&&(ye(Nd,kd,Ff,!1),Vo(Lg,i,Pr,Ir,B,Rt,null));let{left:pt,top:vt,width:Nt,height:Dt}=Ve;Lf=pt,Nf=vt,Df=Nt,Uf=Dt}function Ff(v,T,D,O,X,K,at){Cs=In._x=In._y=!1,$u(v,T,D,O,X,K,at,!1,!0);let{left:pt,top:vt,width:Nt,height:Dt}=Ve,Ot=Nt>0||Dt>0,ie=Lf!=pt||Nf!=vt||Df!=Nt||Uf!=Dt;if(Ot&&ie&&ja(Ve),In.setScale&&Ot&&ie){let Se=pt,ve=Nt,me=vt,Zt=Dt;if(P.ori==1&&(Se=vt,ve=Dt,me=pt,Zt=Nt),An&&Rs(M,zi(Se,M),zi(Se+ve,M)),En)for(let Wt in b){let Ge=b[Wt];Wt!=M&&Ge.from==null&&Ge.min!=Ue&&Rs(Wt,zi(me+Zt,Wt),zi(me,Wt))}Yu()}else dt.lock&&(dt._lock=!dt._lock,er(T,!0,v!=null));v!=null&&(mn(Nd,kd),Vo(Nd,i,ze,$e,B,Rt,null))}function w_(v,T,D,O,X,K,at){if(dt._lock)return;Jt(v);let pt=Cs;if(Cs){let vt=!0,Nt=!0,Dt=10,Ot,ie;P.ori==0?(Ot=An,ie=En):(Ot=En,ie=An),Ot&&ie&&(vt=ze<=Dt||ze>=B-Dt,Nt=$e<=Dt||$e>=Rt-Dt),Ot&&vt&&(ze=ze<Pr?0:B),ie&&Nt&&($e=$e<Ir?0:Rt),er(null,!0,!0),Cs=!1}ze=-10,$e=-10,it.fill(null),er(null,!0,!0),pt&&(Cs=pt)}function kf(v,T,D,O,X,K,at){dt._lock||(Jt(v),Fo(),Yu(),v!=null&&Vo(Ug,i,ze,$e,B,Rt,null))}function Bf(){w.forEach(BE),k(i.width,i.height,!0)}br(_u,So,Bf);let Dr={};Dr.mousedown=Of,Dr.mousemove=If,Dr.mouseup=Ff,Dr.dblclick=kf,Dr.setSeries=(v,T,D,O)=>{let X=dn.match[2];D=X(i,T,D),D!=-1&&Bi(D,O,!0,!1)},ht&&(ye(Lg,p,Of),ye(Ld,p,If),ye(Ng,p,v=>{Jt(v),zo(!1)}),ye(Dg,p,w_),ye(Ug,p,kf),$d.add(i),i.syncRect=zo);let Qa=i.hooks=n.hooks||{};function Tn(v,T,D){Gn?Pe.push([v,T,D]):v in Qa&&Qa[v].forEach(O=>{O.call(null,i,T,D)})}(n.plugins||[]).forEach(v=>{for(let T in v.hooks)Qa[T]=(Qa[T]||[]).concat(v.hooks[T])});let zf=(v,T,D)=>D,dn=pn({key:null,setSeries:!1,filters:{pub:$g,sub:$g},scales:[M,x[1]?x[1].scale:null],match:[qg,qg,zf],values:[null,null]},dt.sync);dn.match.length==2&&dn.match.push(zf),dt.sync=dn;let Vf=dn.key,Zu=H0(Vf);function Vo(v,T,D,O,X,K,at){dn.filters.pub(v,T,D,O,X,K,at)&&Zu.pub(v,T,D,O,X,K,at)}Zu.sub(i);function A_(v,T,D,O,X,K,at){dn.filters.sub(v,T,D,O,X,K,at)&&Dr[v](null,T,D,O,X,K,at)}i.pub=A_;function E_(){Zu.unsub(i),$d.delete(i),wn.clear(),Vd(_u,So,Bf),c.remove(),St?.remove(),Tn("destroy")}i.destroy=E_;function Ju(){Tn("init",n,t),Oo(t||n.data,!1),G[M]?Gu(M,G[M]):Fo(),st=Ve.show&&(Ve.width>0||Ve.height>0),et=mt=!0,k(n.width,n.height)}return x.forEach(wr),w.forEach(ts),e?e instanceof HTMLElement?(e.appendChild(c),Ju()):e(i,Ju):Ju(),i}on.assign=pn;on.fmtNum=Qd;on.rangeNum=yu;on.rangeLog=Su;on.rangeAsinh=Kd;on.orient=Mr;on.pxRatio=we;on.join=PA;on.fmtDate=ef,on.tzDate=VA;on.sync=H0;{on.addGap=ME,on.clipGaps=Au;let n=on.paths={points:Z0};n.linear=K0,n.stepped=EE,n.bars=TE,n.spline=RE}var Ru=210,zE=64,VE=[.01,.02,.05,.1,.2,.5,1,2,5,10,15,30,45,90,180,360,...jE(3,20)];function Po(n,t,e,i){let s=t.map(o=>GE(o,e)),r=t.map((o,a)=>{let l=o.sharing?s.filter((c,u)=>t[u].sharing===o.sharing).flat():null;return WE(o,s[a].map(c=>c.values),l,e,i)});n.replaceChildren(...r.map(o=>o.element)),n.classList.add("plots");for(let o of r)o.start();return{charts:r.map(o=>o.chart),dispose:()=>r.forEach(o=>o.dispose())}}function GE(n,t){return n.lines.map(e=>({clip:e.clip,values:e.readings?t[e.clip].line(e.readings,e.part):en(e.values,Float32Array)}))}function HE(n,t,e){let i=[0,0];for(let{clip:s,values:r}of n){let o=t[s].time;for(let a=0;a<o.length;a++){let l=o[a]-e.origins[s];l<e.start||l>e.end||(r[a]<i[0]&&(i[0]=r[a]),r[a]>i[1]&&(i[1]=r[a]))}}return i}function cf(n){let[t,...e]=n.lines.map(i=>i.clip);return e.every(i=>i===t)?t??null:null}function WE(n,t,e,i,s){let{element:r,key:o,place:a}=uf(n,n.owner),l=R("div",{className:"cursor"}),c=null,u=null,h=!1,d=[],f=new ResizeObserver(()=>c?.setSize({width:a.clientWidth,height:Ru}));function p(){let{word:x}=n,w=n.lines.map((b,S)=>R("li",{},ir(vs(S)),x?b.name.slice(x.length+1):b.name));o.replaceChildren(...x?[R("li",{},x)]:[],...w)}function _(){(s.span!==u||s.stretched!==h)&&(u=s.span,h=s.stretched,c.setData(ex(n,t,i,u),!1),c.setScale("x",{min:u.start,max:u.end})),l.style.transform=`translateX(${c.valToPos(s.time,"x").toFixed(2)}px)`}function g(){u=s.span,h=s.stretched,c=new on(XE(n,e,i,s,a.clientWidth),ex(n,t,i,u),a),c.setScale("x",{min:u.start,max:u.end}),c.over.append(l),KE(c,s),f.observe(a),c.hooks.setSize=[_];let x=()=>{p(),c.redraw(!1)};d=[s.onChange(_),Ys(x)],p()}function m(){for(let x of d)x();f.disconnect(),c.destroy()}return{element:r,start:g,dispose:m,get chart(){return c}}}function uf(n,t=null){let e=t?`${bn(t)}. ${n.text}`:n.text,i=R("div",{className:"chart",role:"img","aria-label":e}),s=R("ul",{className:"key"}),r=R("h2",{},`${bn(n.title)} (${n.unit})`);return t&&r.append(R("small",{},t)),{element:R("figure",{},r,s,i,R("figcaption",{},n.text)),key:s,place:i}}function ex(n,t,e,i){let s=n.lines.map((r,o)=>[Float64Array.from(e[r.clip].time,a=>a-i.origins[r.clip]),t[o]]);return cf(n)!==null?[s[0]?.[0]??[],...s.map(r=>r[1])]:on.join(s)}function XE(n,t,e,i,s){let r=Pu(),o=(a,l,c)=>YE(n,...t?HE(t,e,i.span):[l,c]);return{width:s,height:Ru,legend:{show:!1},cursor:{show:!1},padding:[8,10,0,0],scales:{x:{time:!1,auto:!1,distr:100,fwd:i.shareAt,bwd:i.momentAt},y:{range:o}},series:[{},...hf(n.lines)],axes:[{...r,...df,labelFont:r.font,label:()=>`${i.span.label} (${Oa(i.span).unit})${i.stretched?", stretched":""}`,filter:(a,l)=>l,splits:(a,l,c,u,h)=>i.stretched?$E(a,i):qE(c,u,h),values:(a,l)=>l.map(c=>c===null?"":nx(c*Oa(i.span).factor)),space:56},ff(n)],hooks:{drawClear:[a=>ZE(a,e,cf(n),i.span)],draw:[a=>JE(a,e,cf(n),i.span)]}}}function $E(n,t){let e=Math.max(2,Math.floor(n.bbox.width/devicePixelRatio/zE)),{factor:i}=Oa(t.span),s=new Set;for(let r=0;r<=e;r++){let o=t.momentAt(r/e),a=[1,2,3,4,5,6].map(c=>Number((i*o).toPrecision(c))/i),l=c=>Math.abs(t.shareAt(c)-r/e)<.2/e;s.add(a.find(l)??a[a.length-1])}return[...s].filter(r=>r>=t.span.start&&r<=t.span.end)}function qE(n,t,e){let i=Math.ceil(n/e-1e-9);return Array.from({length:Math.floor(t/e+1e-9)-i+1},(s,r)=>(i+r)*e)}function hf(n){return n.map((t,e)=>({stroke:()=>vs(e).colour,dash:vs(e).dash,width:1.6,points:{show:!1},spanGaps:!0}))}var df={size:24,gap:3,labelSize:18,labelGap:0};function Pu(){return{stroke:()=>ke("--muted"),grid:{stroke:()=>ke("--grid"),width:1},ticks:{stroke:()=>ke("--grid"),width:1,size:4},font:"12px system-ui, sans-serif"}}function ff(n){return{...Pu(),size:(t,e)=>Math.max(48,16+7*Math.max(0,...(e??[]).map(i=>i.length))),gap:3,values:(t,e)=>e.map(i=>i===null?"":nx(i)),...n.unit==="deg"?{incrs:VE,space:26}:{space:30}}}function YE(n,t,e){let[i,s]=[Math.min(0,t??0),Math.max(0,e??0)],r=.06*(s-i||1);return[n.unit==="deg"||i<0?i-r:i,s+2*r]}function nx(n){let t=Math.abs(n)<1e-12?"0":String(Number(n.toPrecision(6)));return t.length>7?Ee(n):t.replace("-","−")}function ZE(n,t,e,i){if(e===null)return;let{ctx:s,bbox:r}=n;s.save(),s.fillStyle=ke("--band");for(let o of t[e].stages.filter(a=>a.driven)){let[a,l]=[o.start,o.end].map(u=>n.valToPos(u-i.origins[e],"x",!0)),c=Math.max(a,r.left);s.fillRect(c,r.top,Math.max(0,Math.min(l,r.left+r.width)-c),r.height)}s.restore()}function JE(n,t,e,i){if(e===null)return;let{ctx:s,bbox:r}=n,o=devicePixelRatio;s.save(),s.strokeStyle=ke("--muted"),s.font=`bold ${12*o}px system-ui, sans-serif`,s.setLineDash([2*o,3*o]);for(let a of t[e].marks){let l=n.valToPos(a.time-i.origins[e],"x",!0);if(l<r.left-1||l>r.left+r.width+1)continue;s.beginPath(),s.moveTo(l,r.top),s.lineTo(l,r.top+r.height),s.stroke();let c=l>r.left+r.width-16*o?-1:1;s.fillStyle=ke("--page"),s.fillRect(l+(c>0?2:-14)*o,r.top+1*o,12*o,15*o),s.fillStyle=ke("--ink"),s.textAlign="center",s.fillText(a.letter,l+c*8*o,r.top+13*o)}s.restore()}function KE(n,t){let e=i=>{t.pause(),t.seek(n.posToVal(i.clientX-n.over.getBoundingClientRect().left,"x"))};n.over.addEventListener("pointerdown",i=>{i.button===0&&(n.over.setPointerCapture(i.pointerId),e(i))}),n.over.addEventListener("pointermove",i=>{n.over.hasPointerCapture(i.pointerId)&&e(i)})}function jE(n,t){return Array.from({length:t-n},(e,i)=>[1,2,5].map(s=>s*10**(n+i))).flat()}function Iu(n,t){if(matchMedia("(prefers-reduced-motion: reduce)").matches)return;let e=new IntersectionObserver(i=>{i.some(s=>s.isIntersecting)&&(e.disconnect(),t.play())},{threshold:.3});e.observe(n.querySelector(".picture")??n),n.addEventListener("pointerdown",()=>e.disconnect(),{once:!0})}function ix(n){let t=n.clips.map(yi),e=Ss(t,n.spans),i=xo(document.getElementById("player"),t,e,n);i.stage&&pf(i.stage.cells,t,e,n.energy);let s=Po(document.getElementById("plots"),n.plots,t,e);return Iu(document.getElementById("player"),e),{clips:t,clock:e,player:i,plots:s}}function pf(n,t,e,i){let s=t.map((r,o)=>{let a=R("span",{className:"state-now"}),l=R("b",{},ir(vs(o)),r.name);return Ys(()=>l.replaceChild(ir(vs(o)),l.firstChild)),n[o].append(l,a),a});e.onChange(()=>{for(let[r,o]of t.entries()){let a=e.clipTime(r),c=[e.time+e.span.origins[r]>o.end?"ended":o.stageAt(a).name],[u]=o.readings;u&&c.push(QE(o.valuesAt(u.name,a),u.unit));let h=o.valuesAt(bs,a).reduce((d,f)=>d+f,0);o.tendons&&c.push(`${Ee(i.factor*h)} ${i.unit}`),s[r].textContent=c.join(" · ")}})}function QE(n,t){let e=s=>t==="deg"?`${Dn(s,0)}°`:`${Ee(s)} ${t}`,i=[Math.min(...n),Math.max(...n)].map(e);return i[0]===i[1]?i[0]:i.join(" to ")}var tT=[.1,.2,.5,1,2,5,10,15,30,45,60,90,180],eT=1.35;function Ya(n,t,e=[],i=null,s=null){let r=t.map(o=>nT(o,e[0],i,s));n.replaceChildren(...r.map(o=>o.element)),n.classList.add("plots");for(let o of r)o.start();return r}function nT(n,t,e,i){let[s,r,o]=[n.lines,n.balls,n.marks].map(M=>M.map(iT)),{element:a,key:l,place:c}=uf(n),u=(r.length?r:[s[0]]).map(M=>R("span",{className:"ball"},r.length&&M.name.length<3?M.name:"")),h=r.map(M=>[M.places[0],M.values[0]]),d=Math.round(eT*Ru),f=sT(s),p=f,_=null;function g(){let M=s.map((A,I)=>R("li",{},ir(vs(I)),A.name)),y=r.length?"the run now":"moved by the slider";l.replaceChildren(...M,R("li",{},R("span",{className:"ball still"}),y))}function m(){for(let[M,[y,A]]of h.entries()){let[I,L]=[_.valToPos(y,"x"),_.valToPos(A,"y")];u[M].style.transform=`translate(${I.toFixed(2)}px, ${L.toFixed(2)}px)`}}function x(){let[M,y]=Ki(t.time,e.clipTime(0));for(let[A,{places:I,values:L}]of r.entries())h[A]=[mf(I,M,y),mf(L,M,y)];m()}function w(M){p=M,_.setScale("x",{min:M[0],max:M[1]})}function b(M,y,A){if(p!==f){let{places:P,values:F}=s[0],z=F.filter(($,H)=>P[H]>=p[0]&&P[H]<=p[1]),[U,G]=[Math.min(...z),Math.max(...z)];return[U-.25*(G-U),G+.25*(G-U)]}let I=r.reduce((P,F)=>Math.max(P,F.most),A),L=Math.min(0,y);return[L-.06*(I-L||1),I+.1*(I-L||1)]}function S(){let M=on.join(s.map(y=>[y.sorted.places,y.sorted.values]));_=new on(rT({data:n,lines:s,balls:r,marks:o,energyRange:b},c.clientWidth,d),M,c),_.over.append(...u),new ResizeObserver(()=>_.setSize({width:c.clientWidth,height:d})).observe(c),_.hooks.setSize=[m],_.hooks.setScale=[m],g(),Ys(()=>{g(),_.redraw(!1)}),n.top&&c.after(lT(f,n.top,w)),r.length?(e.onChange(x),cT(_,r,t,e)):uT(n,s[0],c,(y,A)=>{h[0]=[y,A],m()},i),w(f)}return{element:a,start:S,now:h,get chart(){return _}}}function iT({name:n,places:t,values:e}){let i={name:n,places:en(t,Float32Array),values:en(e,Float32Array)},s=Array.from(i.places.keys()).sort((r,o)=>i.places[r]-i.places[o]);return i.most=i.values.reduce((r,o)=>Math.max(r,o),0),i.sorted={places:s.map(r=>i.places[r]),values:s.map(r=>i.values[r])},i}function mf(n,t,e){let i=n[Math.min(t+1,n.length-1)];return n[t]+e*(i-n[t])}function sT(n){let t=n.flatMap(s=>[s.sorted.places[0],s.sorted.places.at(-1)]),[e,i]=[Math.min(...t),Math.max(...t)];return[e-.03*(i-e),i+.03*(i-e)]}function rT({data:n,lines:t,balls:e,marks:i,energyRange:s},r,o){let a=Pu(),l=ff(n);return{width:r,height:o,legend:{show:!1},cursor:{show:!1},pxAlign:0,padding:[10,12,0,0],scales:{x:{time:!1,auto:!1,dir:n.backwards?-1:1},y:{range:s}},series:[{},...hf(t)],axes:[{...a,...df,labelFont:a.font,label:`${n.axis} (deg)`,values:l.values,incrs:tT,space:44},l],hooks:{draw:[c=>oT(c,e),c=>aT(c,i)]}}}function oT(n,t){let{ctx:e,bbox:i}=n,s=1.6*devicePixelRatio;e.save(),e.globalAlpha=.55,e.fillStyle=ke("--accent");for(let{places:r,values:o}of t)for(let a=0;a<r.length;a++){let[l,c]=[n.valToPos(r[a],"x",!0),n.valToPos(o[a],"y",!0)];l>i.left&&l<i.left+i.width&&c>i.top&&c<i.top+i.height&&e.fillRect(l-s/2,c-s/2,s,s)}e.restore()}function aT(n,t){let{ctx:e,bbox:i}=n,s=devicePixelRatio;e.save(),e.beginPath(),e.rect(i.left-6*s,i.top,i.width+12*s,i.height+6*s),e.clip(),e.setLineDash([]),e.font=`${12*s}px system-ui, sans-serif`;for(let{name:r,places:o,values:a}of t){let l=Array.from(o,f=>n.valToPos(f,"x",!0)),c=Array.from(a,f=>n.valToPos(f,"y",!0)),[u,h]=[l[l.length>>1],c[c.length>>1]];if(e.beginPath(),l.length===1)e.arc(u,h,4.5*s,0,2*Math.PI),e.fillStyle=ke("--page"),e.fill(),e.strokeStyle=ke("--ink"),e.lineWidth=1.4*s,e.stroke();else{e.globalAlpha=.35;for(let f of l.keys())e.lineTo(l[f],c[f]);e.strokeStyle=ke("--line-2"),e.lineWidth=7*s,e.stroke(),e.globalAlpha=1}let d=l.length>1?0:u>i.left+i.width/2?-1:1;e.fillStyle=ke("--ink"),e.textAlign=["right","center","left"][d+1],e.fillText(r,u+12*d*s,h-9*s)}e.restore()}function lT(n,t,e){let i=[["whole curve",n],["barrier close up",t]].map(([s,r],o)=>{let a=R("button",{type:"button","aria-pressed":String(o===0)},s);return a.addEventListener("click",()=>{for(let l of i)l.setAttribute("aria-pressed",String(l===a));e(r)}),a});return R("div",{className:"ranges",role:"group","aria-label":"part of the curve"},...i)}function cT(n,t,e,i){let s=r=>{let o=n.over.getBoundingClientRect(),[a,l]=[r.clientX-o.left,r.clientY-o.top],[c,u]=[0,1/0];for(let{places:h,values:d}of t)for(let f=0;f<h.length;f++){let p=Math.hypot(n.valToPos(h[f],"x")-a,n.valToPos(d[f],"y")-l);p<u&&([c,u]=[f,p])}i.pause(),i.seekClip(0,e.time[c])};n.over.addEventListener("pointerdown",r=>{r.button===0&&(n.over.setPointerCapture(r.pointerId),s(r))}),n.over.addEventListener("pointermove",r=>{n.over.hasPointerCapture(r.pointerId)&&s(r)})}function uT(n,t,e,i,s){let r=t.places.length-1,o=R("input",{type:"range",min:"0",max:String(r),value:"0"});o.setAttribute("aria-label",`${n.axis} along the curve`);let a=R("output",{"aria-live":"off"}),l=()=>{let d=Number(o.value);i(t.places[d],t.values[d]);let[f,p]=[Ee(t.places[d]),`${Ee(t.values[d])} ${n.unit}`];a.textContent=`${f}°, ${p}`,o.setAttribute("aria-valuetext",`${n.axis} ${f} degrees, energy ${p}`)},c=n.poses&&s?en(n.poses,Float32Array):null,u=!1;o.addEventListener("input",()=>{l(),u=!0,c&&s.seek(hT(c,t.places[Number(o.value)]))}),c&&s.onChange(()=>{u||(o.value=String(dT(t.places,mf(c,Math.floor(s.time),s.time%1))),l()),u=!1});let h=n.drawn?[R("p",{className:"note"},n.drawn)]:[];e.after(R("div",{className:"slide"},o,a),...h),l()}function hT(n,t){let e=n[n.length-1]>=n[0]?1:-1,i=n.findIndex(r=>e*r>=e*t);if(i<=0)return i===0?0:n.length-1;let s=n[i]-n[i-1];return i-1+(s?(t-n[i-1])/s:0)}function dT(n,t){return n.reduce((e,i,s)=>Math.abs(i-t)<Math.abs(n[e]-t)?s:e,0)}function sx(n){let t=new Set,e={start:n.start,end:n.end,origins:[0]},i=n.start,s=0;function r(){s||=requestAnimationFrame(()=>{s=0;for(let o of t)o()})}return{get time(){return i},span:e,clipTime:(o,a=i)=>Math.min(n.end,Math.max(n.start,a)),timeAt:o=>e.start+o*(e.end-e.start),wayAt:o=>(o-e.start)/(e.end-e.start||1),onChange(o){return t.add(o),r(),()=>t.delete(o)},seek(o){i=Math.min(e.end,Math.max(e.start,o)),r()}}}function rx(n){let t=document.getElementById("curves");if(!n.clips)return{curves:Ya(t,n.curves)};let e=n.clips.map(yi),i=sx(e[0]),s=cu(document.getElementById("player"),e,i,n);return{clips:e,clock:i,player:s,curves:Ya(t,n.curves,[],null,i)}}function Io(n){return n.energy?go:Wm}function ox(n,t){let e=n.at(t).map(s=>Math.round(255*s)),i=.299*e[0]+.587*e[1]+.114*e[2]>118;return{face:`rgb(${e.join(" ")})`,ink:i?"#000":"#fff"}}var fT={"●":"opened","◆":"folded","■":"closed","×":"unfolded","✱":"stuck","↺":"returned","↻":"reclosed","▷":"moving","◁":"opening","≠":"untrusted","✚":"diverged","⊘":"unbuilt","–":"untried","·":"unrun","⊗":"before","◐":"missed","◒":"missed","○":"apart","△":"placed"};function Ui(n){return`what ${fT[n]??"other"}`}var ax="time by torque",pT=["energy",ax];function Lu(n,t){let{factors:e,quantities:i,words:s}=n,r=e.map(h=>h.values.length),o=new Map;for(let h of t)o.set(h.point,[...o.get(h.point)??[],h]);function a(h){if(n.sampled)return e.map(()=>h);let d=[];for(let f=r.length-1;f>=0;f--)d[f]=h%r[f],h=Math.floor(h/r[f]);return d}let l=h=>h.reduce((d,f,p)=>d*r[p]+f,0);function c(h){let f=(pT.includes(h.group)?i.filter(x=>x.group===h.group):[h]).flatMap(x=>x.values??[]).filter(x=>x!==null);if(!f.length)return null;let[p,_]=[f.reduce((x,w)=>Math.min(x,w)),f.reduce((x,w)=>Math.max(x,w))],g=x=>_>p?(x-p)/(_-p):.5,m=mT((h.values??[]).filter(x=>x!==null));return{low:p,high:_,colour:x=>ox(Io(h),g(x)),text:x=>Qi(Number(x.toFixed(m)))}}let u=(h,d)=>`${h.name} ${h.texts[d]}${h.unit?` ${h.unit}`:""}`;return{study:n,sizes:r,numbers:i.filter(h=>h.values&&h.group!==ax),columns:e,shown:()=>!0,nameOf:()=>"",placesOf:a,pointAt:l,scaleOf:c,factorText:u,largestSpan:t.reduce((h,d)=>Math.max(h,d.play.clips[0].span_m),0),runsOf:h=>o.get(h)??[],word:h=>s[h],pointText:h=>a(h).map((d,f)=>u(e[f],d)).join(", "),valueText(h,d){let f=h.values?.[d]??null;return f===null?s[h.reasons[d]].word:`${Qi(f)} ${h.unit}`}}}function mT(n){let t=n.reduce((e,i)=>Math.max(e,Math.abs(i)),0);return Math.min(20,Math.max(0,2-Math.floor(Math.log10(t||1))))}function Qi(n){let t=Number(n.toPrecision(3));return(t!==0&&Math.abs(t)<.001?t.toExponential():String(t)).replaceAll("-","−")}var gT="http://www.w3.org/2000/svg";function Ie(n,t,...e){let i=document.createElementNS(gT,n);for(let[s,r]of Object.entries(t))i.setAttribute(s,r);return i.append(...e),i}function Lo({values:n,log:t},e=[]){let i=[...new Set(n.filter(d=>typeof d=="string"))];if(i.length)return{words:i,share:f=>(i.indexOf(f)+.5)/i.length,ticks:i,value:f=>i[Math.min(i.length-1,Math.max(0,Math.floor(f*i.length)))]};let s=[...n,...e].filter(d=>typeof d=="number"),r=t&&s.every(d=>d>0),[o,a]=r?[Math.log,Math.exp]:[d=>d,d=>d],l=s.reduce((d,f)=>Math.min(d,o(f)),1/0),c=s.reduce((d,f)=>Math.max(d,o(f)),-1/0),u=d=>c>l?(o(d)-l)/(c-l):.5,h=s.length?(r?xT:lx)(a(l),a(c)):[];return{words:i,share:u,ticks:h,value:d=>a(l+d*(c-l))}}function gf(n,t,e,i,s=[]){let r=t.unit?`${t.name} (${t.unit})`:t.name,o=Lo({values:n,log:t.log},s),a=.04*(i-e),l=u=>e+a+o.share(u)*(i-e-2*a),c=o.ticks.map(u=>[l(u),typeof u=="number"?Qi(u):u]);return{label:r,from:e,to:i,ticks:c,at:l,place:u=>n[u]===null?e:l(n[u])}}function lx(n,t){if(!(t>n))return[n];let e=(t-n)/5,i=10**Math.floor(Math.log10(e)),s=i*([1,2,5].find(o=>o*i>=e)??10),r=[];for(let o=Math.ceil(n/s)*s;o<=t+1e-9*s;o+=s)r.push(Number(o.toPrecision(12)));return r}function xT(n,t){if(!(t>n))return[n];let e=t/n>200?[1]:[1,2,5],i=[];for(let s=Math.floor(Math.log10(n));s<=Math.ceil(Math.log10(t));s++)for(let r of e){let o=Number((r*10**s).toPrecision(12));o>=n*(1-1e-9)&&o<=t*(1+1e-9)&&i.push(o)}return i.length>1?i:lx(n,t)}function cx(n,t,e){let i=[Ie("path",{class:"axis",d:`M${n.from} ${t.to}V${t.from}H${n.to}`})],s=(r,o)=>i.push(Ie("text",{class:"label",...o},r));for(let[r,o]of n.ticks)s(o,{x:r,y:t.from+18,"text-anchor":"middle"});for(let[r,o]of t.ticks)s(o,{x:n.from-8,y:r,dy:"0.35em","text-anchor":"end"});return s(n.label,{x:(n.from+n.to)/2,y:e-8,"text-anchor":"middle"}),s(t.label,{transform:`translate(14 ${(t.from+t.to)/2}) rotate(-90)`,"text-anchor":"middle"}),i}var Nu=300,ux=30,_T=92,fx=16,yT=5;function px(n,t,{best:e,best_word:i,front:s},r){let a={axes:[...new Set(t.map(n.indexOf).filter(w=>w>=0))],opened:null,hovered:null,best:e,bestWord:i,front:s},l=R("div",{className:"titles"}),c=R("div",{className:"drawn"}),u=R("div",{className:"board"},l,c),h=R("div",{className:"scroll"},u),d=R("p",{className:"note",role:"status"}),f=R("p",{className:"note under"}," "),p=R("button",{type:"button"},`show all ${n.study.noun}s`);p.addEventListener("click",()=>{n.forget(),c.querySelector("[role=slider]")?.focus()});let _=()=>{ST(n,a,{board:u,titles:l,place:c,width:h.clientWidth}),Du(n,a,c)},m=R("section",{className:"lines"},R("h2",{},`All ${n.study.noun}s at once`),R("p",{className:"note"},"A press on a line opens its run; each axis has two handles, which leave out what lies beyond them."),vT(n,a,_),h,bT(n,a),R("div",{className:"choices"},p,d),f);TT(n,a,c,f,r),n.whenAsked(()=>{Du(n,a,c),mx(n,a,c),hx(n,d,p)}),hx(n,d,p);let x=0;return new ResizeObserver(()=>{h.clientWidth!==x&&(x=h.clientWidth,_())}).observe(h),{element:m,show(w){a.opened=w,Du(n,a,c)}}}function hx(n,t,e){let{points:i,noun:s}=n.study,r=Array.from({length:i},(l,c)=>c).filter(n.shown),o=r.filter(n.good).length,a=n.study.words.find(l=>l.sign==="●")?.word;t.textContent=`${r.length} of ${i} ${s}s lie within what is asked of the axes${a?`; ${a}: ${o}`:""}.`,e.hidden=n.asked.size===0}function vT(n,t,e){let i=n.columns.map((s,r)=>{let o=R("input",{type:"checkbox",checked:t.axes.includes(r)});return o.addEventListener("change",()=>{t.axes=n.columns.map((a,l)=>l).filter(a=>a===r?o.checked:t.axes.includes(a)),o.checked||n.ask(r,0,1),e()}),R("label",{},o,s.name)});return R("details",{},R("summary",{},"Axes"),R("fieldset",{className:"filter"},R("legend",{},"Show an axis of"),...i))}function bT(n,t){let e=(r,o)=>R("li",{},R("span",{className:`line ${r}`,"aria-hidden":"true"}),o),i=n.study.words.find(r=>r.sign==="●"),s=[];return i&&s.push(e("good",i.word)),n.study.words.some(r=>r.sign!=="●")&&s.push(e("behind",i?"the others":`all ${n.study.noun}s`)),t.front.length&&s.push(e("front","none is better in everything")),t.best!==null&&s.push(e("best",t.bestWord)),s.push(e("opened","open")),n.columns.some(r=>r.limits.length)&&s.push(R("li",{},R("span",{className:"bound","aria-hidden":"true"}),"allowed by a limit")),R("ul",{className:"keys-of-lines"},...s)}function ST(n,t,{board:e,titles:i,place:s,width:r}){let o=t.axes.length,a=Math.max(r,o*_T);e.style.width=`${a}px`,i.replaceChildren(...t.axes.map(c=>MT(n.columns[c]))),i.style.gridTemplateColumns=`repeat(${o}, 1fr)`,t.x=c=>(c+.5)*a/o,t.y=c=>Nu-ux-c*(Nu-2*ux);let l=Ie("svg",{width:a,height:Nu,viewBox:`0 0 ${a} ${Nu}`,role:"img","aria-label":`${n.study.points} ${n.study.noun}s as lines over ${o} axes; the table below has them all`});l.append(Ie("g",{class:"layers"}));for(let[c,u]of t.axes.entries())l.append(...wT(n.columns[u],t.x(c),t.y));s.replaceChildren(l),mx(n,t,s)}function MT(n){let t=n.unit?` (${n.unit})`:"",e=n.aim?R("small",{},`${n.aim} is best`):"";return R("div",{},`${n.name}${t}`,e)}function wT({scale:n,limits:t},e,i){let s=[Ie("path",{class:"axis",d:`M${e} ${i(0)}V${i(1)}`})];for(let{kind:r,bound:o}of t){let a=Math.min(1,Math.max(0,n.share(o)));s.push(Ie("path",{class:"bound",d:`M${e} ${i(a)}V${i(r===">="?1:0)}`}))}for(let r of n.ticks){let o=i(n.share(r));s.push(Ie("path",{class:"axis",d:`M${e} ${o}h5`}),Ie("text",{class:"label",x:e+8,y:o,dy:"0.35em"},typeof r=="number"?Qi(r):r))}return s}function mx(n,t,e){let i=e.contains(document.activeElement)?document.activeElement.dataset.handle:null;for(let s of e.querySelectorAll("[role=slider]"))s.remove();for(let[s,r]of t.axes.entries())for(let o of["least","most"]){let a=AT(n,t,e,r,o);a.style.left=`${t.x(s)}px`,e.append(a),a.dataset.handle===i&&a.focus()}}function AT(n,t,e,i,s){let r=n.columns[i],[o,a]=n.asked.get(i)??[0,1],l=s==="least"?o:a,c=r.scale.value(l),u=typeof c=="number"?`${Qi(c)} ${r.unit}`.trim():String(c??""),h=R("div",{role:"slider",className:`handle ${s}`,tabIndex:0,"aria-orientation":"vertical","aria-label":`${s} ${r.name}`,"aria-valuemin":"0","aria-valuemax":"100","aria-valuenow":String(Math.round(100*l)),"aria-valuetext":u,title:`${s} ${r.name}: ${u}`});h.dataset.handle=`${i} ${s}`,h.dataset.keys="own",h.style.top=`${t.y(l)}px`;let d=_=>{let[g,m]=n.asked.get(i)??[0,1];s==="least"?n.ask(i,Math.min(Math.max(_,0),m),m):n.ask(i,g,Math.max(Math.min(_,1),g))},f=r.scale.words.length?1/r.scale.words.length:.02,p={ArrowUp:f,ArrowRight:f,ArrowDown:-f,ArrowLeft:-f,PageUp:5*f,PageDown:-5*f};return h.addEventListener("keydown",_=>{if(!(_.ctrlKey||_.metaKey||_.altKey)){if(_.key in p)d(l+p[_.key]);else if(_.key==="Home")d(0);else if(_.key==="End")d(1);else return;_.preventDefault()}}),h.addEventListener("pointerdown",_=>{_.preventDefault(),h.focus(),gx(_,g=>d(xf(t,e,g)))}),h}function gx(n,t,e=()=>{}){let i=o=>a=>a.pointerId===n.pointerId&&o(a),s=i(t),r=i(o=>{removeEventListener("pointermove",s),removeEventListener("pointerup",r),removeEventListener("pointercancel",r),e(o)});addEventListener("pointermove",s),addEventListener("pointerup",r),addEventListener("pointercancel",r)}function xf(n,t,e){let i=e.clientY-t.getBoundingClientRect().top;return Math.min(1,Math.max(0,(n.y(0)-i)/(n.y(0)-n.y(1))))}function ET(n,t,e){let i="",s=!1;for(let[r,o]of t.axes.entries()){let a=n.columns[o].values[e];a!==null&&(i+=`${s?"L":"M"}${t.x(r).toFixed(1)} ${t.y(n.columns[o].scale.share(a)).toFixed(1)}`),s=a!==null}return i}function Du(n,t,e){let i=e.querySelector(".layers");if(!i)return;let s=Array.from({length:n.study.points},(u,h)=>h),[r,o]=[s.filter(n.shown),s.filter(u=>!n.shown(u))],a=u=>u===null?[]:[u],l={out:o,behind:r.filter(u=>!n.good(u)),good:r.filter(n.good),front:t.front.filter(n.shown),best:a(t.best),opened:a(t.opened),hovered:a(t.hovered)},c=Object.entries(l).filter(([,u])=>u.length);i.replaceChildren(...c.map(([u,h])=>Ie("path",{class:`line ${u}`,d:h.map(d=>ET(n,t,d)).join("")})))}function TT(n,t,e,i,s){let r=o=>{o!==t.hovered&&(t.hovered=o,e.classList.toggle("pressable",o!==null),i.textContent=o===null?" ":`${n.nameOf(o)}${n.pointText(o)}: ${n.study.statuses[o]}`,Du(n,t,e))};e.addEventListener("pointermove",o=>{o.pointerType==="mouse"&&o.buttons===0&&r(dx(n,t,e,o))}),e.addEventListener("pointerleave",()=>r(null)),e.addEventListener("pointerdown",o=>{if(o.button!==0||o.target.closest("[role=slider]"))return;let a=o.pointerType==="touch"?null:CT(t,e,o),l=xf(t,e,o),c=!1;gx(o,h=>{c||=Math.hypot(h.clientX-o.clientX,h.clientY-o.clientY)>yT;let d=xf(t,e,h);c&&a!==null&&n.ask(a,Math.min(l,d),Math.max(l,d))},h=>{let d=c||h.type==="pointercancel"?null:dx(n,t,e,h);d!==null&&s(d)})})}function CT(n,t,e){let i=e.clientX-t.getBoundingClientRect().left,s=n.axes.findIndex((r,o)=>Math.abs(n.x(o)-i)<fx);return s<0?null:n.axes[s]}function dx(n,t,e,i){let s=e.getBoundingClientRect(),[r,o]=[i.clientX-s.left,i.clientY-s.top],a=t.axes.findLastIndex((p,_)=>t.x(_)<=r),[l,c]=[Math.max(0,a),Math.min(t.axes.length-1,a+1)],u=c>l?(r-t.x(l))/(t.x(c)-t.x(l)):0,h=(p,_)=>{let g=n.columns[t.axes[p]],m=g.values[_];return m===null?NaN:t.y(g.scale.share(m))},[d,f]=[null,fx];for(let p=0;p<n.study.points;p++){if(!n.shown(p))continue;let[_,g]=[h(l,p),h(c,p)],m=_+u*(g-_),x=c>l?(g-_)/(t.x(c)-t.x(l)):0,w=Math.abs(o-m)/Math.hypot(1,x)-(n.good(p)?1:0);w<f&&([d,f]=[p,w])}return d}var RT="●";function xx(n,t){let e=Lu(n,t),i=n.factors.map(c=>({...c,limits:[],aim:""})),s=e.numbers.map(c=>({...c,key:c.name,name:c.title,log:!1,own:null})),r=[...i,...s].map(c=>({...c,scale:Lo(c,PT(c))})),o=new Map,a=[],l=([c,[u,h]],d)=>{let f=r[c].values[d];if(f===null)return!1;let p=r[c].scale.share(f);return p>=u-1e-9&&p<=h+1e-9};return{...e,columns:r,asked:o,indexOf:c=>r.findIndex(u=>u.key===c),shown:c=>[...o].every(u=>l(u,c)),good:c=>e.word(n.verdicts[c]).sign===RT,nameOf:c=>`${n.noun} ${c+1}: `,whenAsked:c=>a.push(c),ask(c,u,h){u<=0&&h>=1?o.delete(c):o.set(c,[u,h]);for(let d of a)d()},forget(){o.clear();for(let c of a)c()}}}function PT({limits:n,values:t}){let e=t.filter(r=>typeof r=="number"),[i,s]=[Math.min(...e),Math.max(...e)];return n.map(r=>r.bound).filter(r=>r>=i-(s-i)&&r<=s+(s-i))}var IT=12,[_f,As]=[200,76],Za=130;function yx(n,{marginals:t,pairs:e},i){let s=R("div",{className:"marginals"}),r=R("div",{className:"pairs"}),[o,a]=[t,e].map(h=>h.map(n.indexOf).filter(d=>d>=0)),l=()=>{s.replaceChildren(...o.map(h=>DT(n,h))),r.replaceChildren(...UT(n,a,i))};r.style.setProperty("--columns",Math.max(1,a.length-1)),n.whenAsked(l),l();let u=[R("h2",{},"Unknown by unknown"),R("p",{className:"note"},"Blue: the samples that agree; grey: all that were drawn. Each is scaled by its own number; those first of which what agrees is spread least like all."),s];return a.length>1&&u.push(R("h2",{},"Pair by pair"),R("p",{className:"note"},"A press shows a pair large."),r),{element:R("section",{className:"agreeing"},...u)}}var LT=n=>Array.from({length:n.study.points},(t,e)=>e),vx=n=>LT(n).filter(t=>!["△","⊘"].includes(n.word(n.study.verdicts[t]).sign));function NT(n,t,e){let i=t.words.length||IT,s=new Array(i).fill(0);for(let r of e)s[Math.min(i-1,Math.floor(t.share(n.values[r])*i))]+=1/e.length;return s}function DT(n,t){let e=n.columns[t],i=Lo(e),s=vx(n),r=s.filter(g=>n.good(g)&&n.shown(g)),[o,a]=[s,r].map(g=>NT(e,i,g)),l=Math.max(...o,...r.length?a:[0]),c=_f/o.length,u=(g,m)=>Ie("path",{class:m,d:g.map((x,w)=>`M${w*c+1} ${As}v${-x/l*(As-4)}h${c-2}V${As}z`).join("")}),h=g=>Ie("path",{class:"agree",d:`M0 ${As}${g.map((m,x)=>`V${As-m/l*(As-4)}H${(x+1)*c}`).join("")}V${As}`}),d=`${e.name}: ${_x(e,i,r)}`,f=Ie("svg",{viewBox:`0 0 ${_f} ${As}`,role:"img","aria-label":d,preserveAspectRatio:"none"},u(o,"all"),...r.length?[h(a)]:[],Ie("path",{class:"axis",d:`M0 ${As}H${_f}`})),p=i.words.length?i.words:[0,1].map(g=>Qi(i.value(g))),_=e.unit?` (${e.unit})`:"";return R("figure",{},R("figcaption",{},`${e.name}${_}`),f,R("div",{className:"ends"},...p.map(g=>R("span",{},g))),R("small",{},_x(e,i,r)))}function _x(n,t,e){if(!e.length)return"nothing agrees";if(t.words.length)return t.words.map(r=>`${Math.round(100*e.filter(o=>n.values[o]===r).length/e.length)} % ${r}`).join(", ");let i=e.map(r=>n.values[r]).sort((r,o)=>r-o),s=r=>Qi(i[Math.round(r*(i.length-1))]);return`half of it: ${s(.25)} to ${s(.75)}`}function UT(n,t,e){return t.slice(1).flatMap((i,s)=>t.slice(0,-1).map((r,o)=>o>s?R("span",{}):OT(n,r,i,e)))}function OT(n,t,e,i){let[s,r]=[t,e].map(f=>n.columns[f]),[o,a]=[s,r].map(f=>Lo(f)),l=(f,p)=>Ie("path",{class:p,d:f.map(_=>`M${(4+o.share(s.values[_])*(Za-8)).toFixed(1)} ${(Za-4-a.share(r.values[_])*(Za-8)).toFixed(1)}h0`).join("")}),c=vx(n),u=c.filter(f=>n.good(f)&&n.shown(f)),h=Ie("svg",{viewBox:`0 0 ${Za} ${Za}`,"aria-hidden":"true"},l(c.filter(f=>!u.includes(f)),"all"),l(u,"agree")),d=R("button",{type:"button","aria-label":`${r.name} over ${s.name}, large`},h,R("small",{},`${r.name} ↑, ${s.name} →`));return d.addEventListener("click",()=>i(t,e)),d}var[bx,yf]=[600,420],Uu={left:64,right:14,top:12,bottom:52},Sx=60,Mx={ArrowLeft:-1,ArrowUp:-1,ArrowRight:1,ArrowDown:1};function Ou(n,t,e){let{columns:i,study:s}=n,{quantity:r}=t,o=Array.from({length:s.points},(m,x)=>x),a=n.scaleOf(r),l=gf(i[t.x].values,i[t.x],Uu.left,bx-Uu.right,t.cells?.across),c=t.y===null?r.values??o.map(()=>0):i[t.y].values,u=t.y===null?{name:r.title,unit:r.unit}:i[t.y],h=gf(c,u,yf-Uu.bottom,Uu.top,t.cells?.upwards),d=`${r.title} of ${s.points} ${s.noun}s; arrows move between them, enter opens one`,f=Ie("svg",{viewBox:`0 0 ${bx} ${yf}`,class:["scatter",o.length>Sx&&"many",t.ordered&&"judged"].filter(Boolean).join(" "),role:"listbox","aria-label":d});t.cells&&f.append(...BT(t.cells,l,h)),f.append(...cx(l,h,yf),...Ax(i[t.x],l,h,!0),...t.y===null?[]:Ax(i[t.y],h,l,!1));let p=o.map(m=>[l.place(m),h.place(m)]);t.joined&&f.append(zT(t.front,p,i[t.x].aim));let _=o.length>Sx?6:8,g=o.map(m=>kT(n,t,a,m,p[m],_));return f.append(...(t.ordered?FT(n,t,o):o).map(m=>g[m])),(g[t.current??0]??g[0])?.setAttribute("tabindex","0"),VT(f,g,t.ordered?[...o].sort((m,x)=>p[m][0]-p[x][0]):o,e),{element:R("div",{className:"scroll"},f),points:o}}function FT(n,t,e){let i=s=>(n.shown(s)?0:1e6)+(t.best===s?-1:n.study.verdicts[s]);return[...e].sort((s,r)=>i(r)-i(s))}function kT(n,t,e,i,[s,r],o){let{quantity:a}=t,l=a.values?.[i]??null,c=`${n.nameOf(i)}${n.pointText(i)}: ${n.valueText(a,i)}`,u=Ie("g",{role:"option",tabindex:"-1","aria-label":c,"aria-selected":String(t.opened===i),"data-point":i,transform:`translate(${s.toFixed(1)} ${r.toFixed(1)})`},Ie("title",{},c)),h=l===null?n.word(a.reasons[i]).sign:"";return h&&u.setAttribute("class",Ui(h)),n.shown(i)||u.classList.add("out"),t.front?.includes(i)&&u.append(Ie("circle",{r:o+3,class:"front"})),u.append(Ie("circle",{r:o,class:l===null?"missing":"found",fill:l===null?"transparent":e.colour(l).face})),h&&u.append(Ie("text",{"text-anchor":"middle",dy:"0.36em"},h)),t.best===i&&u.append(Ie("text",{class:"best","text-anchor":"middle",dy:-o-6},t.bestWord)),u}function BT(n,t,e){let[i,s]=[wx(n.across.map(t.at)),wx(n.upwards.map(e.at))];return n.works.flatMap((r,o)=>r.map((a,l)=>Ie("rect",{class:a?"map-works":"map-fails",x:i[o],width:i[o+1]-i[o],y:s[l+1],height:s[l]-s[l+1]})))}function wx(n){let t=n.slice(1).map((s,r)=>(s+n[r])/2),[e,i]=[n[0],n.at(-1)];return[e,...t,i]}function Ax(n,t,e,i){let s=(a,l)=>Ie("path",{class:l,d:i?`M${a} ${e.from}V${e.to}`:`M${e.from} ${a}H${e.to}`}),r=a=>a>=Math.min(t.from,t.to)&&a<=Math.max(t.from,t.to),o=[];typeof n.own=="number"&&r(t.at(n.own))&&o.push(s(t.at(n.own),"own"));for(let{kind:a,bound:l}of n.limits??[]){let c=t.at(l);if(!r(c))continue;let u=a===">="?t.from:t.to,[h,d]=[Math.min(c,u),Math.abs(c-u)],f=i?{x:h,width:d,y:e.to,height:e.from-e.to}:{y:h,height:d,x:e.from,width:e.to-e.from};o.push(Ie("rect",{class:"beyond",...f}),s(c,"limit"))}return o}function zT(n,t,e){let i=n.map(r=>t[r]).sort((r,o)=>r[0]-o[0]),s=([r,o])=>e==="least"?`H${r.toFixed(1)}V${o.toFixed(1)}`:`V${o.toFixed(1)}H${r.toFixed(1)}`;return Ie("path",{class:"front",d:i.map((r,o)=>o?s(r):`M${r.join(" ")}`).join("")})}function VT(n,t,e,i){let s=r=>r.target.closest("[data-point]");n.addEventListener("click",r=>{s(r)&&i(Number(s(r).dataset.point))}),n.addEventListener("focusin",r=>{for(let o of t)o.setAttribute("tabindex",o===r.target?"0":"-1")}),n.addEventListener("keydown",r=>{let o=s(r);if(!o||r.ctrlKey||r.metaKey||r.altKey)return;let a=Number(o.dataset.point);if(r.key==="Enter"||r.key===" ")i(a);else if(r.key in Mx)t[e[e.indexOf(a)+Mx[r.key]]]?.focus();else return;r.preventDefault()})}function Ex(n,{plane:t,front:e,best:i,best_word:s,joined:r},o){let{quantities:a}=n.study,[l,c]=[t.x,t.y].map(n.indexOf),[u,h]=[l,c],d={quantity:a[0],x:l,y:c,current:i??0,opened:null,front:e,best:i,bestWord:s,ordered:!0},f=R("div",{className:"map-place"}),p=R("div",{className:"map-legend"}),_=()=>{let A=d.x===u&&d.y===h;d.cells=A?t.cells:void 0,d.joined=r&&new Set([d.x,d.y,u,h]).size===2;let I=Ou(n,d,g);f.replaceChildren(I.element),p.replaceChildren(...GT(n,d))},g=A=>{m(A),o(A)};function m(A){d.current=d.opened=A;let I=f.contains(document.activeElement);_(),I&&f.querySelector(`[data-point="${A}"]`)?.focus()}let x=n.columns.map((A,I)=>[I,A.name]),w={across:b("across",x,()=>d.x,A=>M("x","y",A)),upwards:b("upwards",x,()=>d.y,A=>M("y","x",A)),show:b("show",a.map((A,I)=>[I,A.title]),()=>a.indexOf(d.quantity),A=>{d.quantity=a[A]})};function b(A,I,L,P){let F=R("select",{},...I.map(([U,G])=>R("option",{value:String(U)},G)));F.value=String(L()),F.addEventListener("change",()=>{P(Number(F.value)),S(),_()});let z=R("label",{},`${A} `,F);return z.dataset.name=A,{element:z,fill:()=>{F.value=String(L())}}}let S=()=>Object.values(w).forEach(A=>A.fill());function M(A,I,L){d[I]===L&&(d[I]=d[A]),d[A]=L}let y=R("section",{className:"map"},R("h2",{},t.title),R("div",{className:"choices"},...Object.values(w).map(A=>A.element)),f,p);return n.whenAsked(_),_(),{element:y,show:m,over(A,I){[d.x,d.y]=[A,I],S(),_()}}}function GT(n,{quantity:t,front:e,cells:i,x:s,y:r}){let o=[],a=n.scaleOf(t);if(a){let h=R("span",{className:"bar","aria-hidden":"true"});h.style.background=Io(t).gradient,o.push(R("p",{className:"scale"},`${t.title} (${t.unit})`,R("span",{},a.text(a.low)),h,R("span",{},a.text(a.high))))}let l=t.values?t.reasons:n.study.verdicts,c=n.study.words.flatMap(({word:h,sign:d},f)=>{let p=l.filter((_,g)=>_===f&&n.shown(g)).length;return p?[R("li",{},R("span",{className:Ui(d),"aria-hidden":"true"},R("span",{},d)),`${h} (${p})`)]:[]});e.length&&c.push(R("li",{},R("span",{className:"ring","aria-hidden":"true"}),"none is better in everything"));let u=[s,r].map(h=>n.columns[h]);if(u.some(h=>typeof h.own=="number")&&c.push(R("li",{},R("span",{className:"dashes","aria-hidden":"true"}),"as designed")),u.some(h=>h.limits.length)&&c.push(R("li",{},R("span",{className:"shade","aria-hidden":"true"}),"beyond a limit")),i)for(let h of["works","fails"])c.push(R("li",{},R("span",{className:`map-${h}`,"aria-hidden":"true"}),`${h} with only these two off`));return c.length&&o.push(R("ul",{},...c)),o}var HT=2e4,WT=16,XT=16,Tx={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]};function Px(n,t){let{quantities:e,sampled:i}=n.study,s=n.study.axes.filter(_=>n.sizes[_]>1),[r,o]=s.length>1?s:[null,s[0]??0],a={quantity:e[0],x:o,y:r,fixed:[...n.study.cuts],current:null,opened:null},l=R("div",{className:"map-place"}),c=R("div",{className:"map-legend"}),u=R("p",{className:"note"}),h=()=>{let _=i?Ou(n,a,d):YT(n,a,d);l.replaceChildren(_.element),c.replaceChildren(...KT(n,a.quantity,_.points)),u.textContent=jT(n,a.quantity,_.points)},d=_=>{a.current=a.opened=_,$T(l,_),t(_,a.quantity)},f=qT(n,a,s,h),p=R("section",{className:"map"},R("h2",{},"Map"),f.element,l,c,u);return h(),{element:p,show(_){a.current=a.opened=_,i||(a.fixed=n.placesOf(_)),f.fill(),h()}}}function $T(n,t){for(let e of n.querySelectorAll("[data-point]")){let i=Number(e.dataset.point)===t;e.setAttribute("aria-selected",String(i)),e.tabIndex=i?0:-1}}function qT(n,t,e,i){let{factors:s,quantities:r,sampled:o}=n.study,a=R("div",{className:"choices"}),l=(h,d,f,p)=>{let _=R("select",{},...d.map(([g,m])=>R("option",{value:String(g)},m)));return _.value=String(f),_.addEventListener("change",()=>{p(Number(_.value)),u(),i(),[...a.querySelectorAll("label")].find(g=>g.dataset.name===h)?.querySelector("select").focus()}),R("label",{},`${h} `,_)},c=(h,d)=>f=>{t[d]===f&&(t[d]=t[h]),t[h]=f};function u(){let h=[l("show",r.map((d,f)=>[f,d.title]),r.indexOf(t.quantity),d=>{t.quantity=r[d]})];if(e.length>2){let d=e.map(f=>[f,s[f].name]);h.push(l("across",d,t.x,c("x","y")),l("upwards",d,t.y,c("y","x")))}for(let d of e.filter(f=>!o&&f!==t.x&&f!==t.y)){let f=s[d].texts.map((p,_)=>[_,s[d].unit?`${p} ${s[d].unit}`:p]);h.push(l(s[d].name,f,t.fixed[d],p=>{t.fixed[d]=p}))}for(let d of h)d.dataset.name=d.firstChild.textContent.trim();a.replaceChildren(...h)}return u(),{element:a,fill:u}}function YT(n,t,e){let{factors:i}=n.study,[s,r]=[n.sizes[t.x],t.y===null?1:n.sizes[t.y]];if(s*r>HT)return{element:R("p",{className:"note"},"This map has too many cells for a page; the study's figures have it."),points:[]};let o=n.scaleOf(t.quantity),a=s<=WT,l=(m,x)=>n.pointAt(t.fixed.map((w,b)=>b===t.x?m:b===t.y?x:w)),c=new Map,u=[],h=[];for(let m=r-1;m>=0;m--){let x=R("tr",{},R("th",{scope:"row"},t.y===null?"":Rx(i[t.y],m)));for(let w=0;w<s;w++){let b=l(w,m),S=R("td",{tabIndex:-1,role:"gridcell"});ZT(S,n,t,o,b,a),c.set(`${w} ${m}`,S),h.push(b),x.append(S)}u.push(x)}let d=i[t.x].texts.map((m,x)=>R("th",{scope:"col"},Rx(i[t.x],x)));u.push(R("tr",{className:"feet"},R("td"),...d));let f=R("table",{role:"grid",className:a?"grid":"grid small","aria-label":tC(n,t)},R("tbody",{},...u));f.style.setProperty("--columns",s);let p=[...c.values()].find(m=>Number(m.dataset.point)===t.current)??c.get("0 0");p.tabIndex=0,JT(f,c,e);let _=R("div",{className:"upwards"},t.y===null?"":Cx(i[t.y])),g=R("div",{className:"across"},Cx(i[t.x]));return{element:R("div",{className:r<6?"axes low":"axes"},_,R("div",{},R("div",{className:"scroll"},f),g)),points:h}}function ZT(n,t,e,i,s,r){let{quantity:o}=e,a=o.values?.[s]??null;n.dataset.point=s,n.setAttribute("aria-selected",String(e.opened===s));let l=`${t.pointText(s)}: ${o.values?`${o.title} `:""}${t.valueText(o,s)}`;if(n.setAttribute("aria-label",l),n.title=l,a===null){let{sign:h}=t.word(o.reasons[s]);n.className=Ui(h),n.append(R("span",{},r?h:""));return}let{face:c,ink:u}=i.colour(a);n.style.background=c,n.style.color=u,n.textContent=r?i.text(a):""}function JT(n,t,e){let i=new Map([...t].map(([s,r])=>[r,s.split(" ").map(Number)]));n.addEventListener("click",s=>{let r=s.target.closest("[data-point]");r&&e(Number(r.dataset.point))}),n.addEventListener("keydown",s=>{let r=s.target.closest("[data-point]");if(!r||s.ctrlKey||s.metaKey||s.altKey)return;let[o,a]=i.get(r),[l,c]=Tx[s.key]??[0,0],u=Math.max(...[...i.values()].map(([d])=>d)),h={Home:`0 ${a}`,End:`${u} ${a}`}[s.key]??`${o+l} ${a+c}`;if(s.key==="Enter"||s.key===" ")e(Number(r.dataset.point));else{if(!(s.key in Tx)&&s.key!=="Home"&&s.key!=="End")return;t.has(h)&&(r.tabIndex=-1,t.get(h).tabIndex=0,t.get(h).focus())}s.preventDefault()})}function KT(n,t,e){let i=[],s=n.scaleOf(t);if(s){let o=R("span",{className:"bar","aria-hidden":"true"});o.style.background=Io(t).gradient,i.push(R("p",{className:"scale"},`${t.title} (${t.unit})`,R("span",{},s.text(s.low)),o,R("span",{},s.text(s.high))))}let r=[...Ix(t,e)].map(([o,a])=>{let{word:l,sign:c}=n.word(o);return R("li",{},R("span",{className:Ui(c),"aria-hidden":"true"},R("span",{},c)),`${l} (${a})`)});return r.length&&i.push(R("ul",{},...r)),i}function Ix(n,t){let e=new Map;for(let i of t){let s=n.reasons[i];s!==null&&e.set(s,(e.get(s)??0)+1)}return new Map([...e].sort(([i],[s])=>i-s))}function jT(n,t,e){let i=e.filter(c=>(t.values?.[c]??null)!==null),s=[...Ix(t,e)].map(([c,u])=>`${u} ${n.word(c).word}`),r=`${t.title[0].toUpperCase()}${t.title.slice(1)}`;if(!i.length)return`${r} of ${e.length} points: ${s.join(", ")||"none"}.`;let o=s.length?` The others: ${s.join(", ")}.`:"",[a,l]=[Math.min,Math.max].map(c=>QT(n,t,i,c));return`${r}, known of ${i.length} of ${e.length} points: from ${a} to ${l}.${o}`}function QT(n,t,e,i){let s=e.map(a=>t.values[a]).reduce((a,l)=>i(a,l)),r=e.filter(a=>t.values[a]===s),o=r.length>1?`${r.length} points`:n.pointText(r[0]);return`${n.valueText(t,r[0])} (${o})`}function tC(n,t){let{factors:e}=n.study,i=t.y===null?e[t.x].name:`${e[t.x].name} across and ${e[t.y].name} upwards`;return`${t.quantity.title} over ${i}; arrows move between cells, enter opens one`}function Cx(n){return n.unit?`${n.name} (${n.unit})`:n.name}function Rx(n,t){let e=Math.ceil(n.texts.length/XT);return t%e?"":n.texts[t]}var Lx=2,eC=20;function Ux(n){let t=document.getElementById("live")?.textContent??null,e=t&&JSON.parse(t),i=R("div",{className:"answer"}),s=R("p",{className:"outcome",role:"status"}),r=R("div"),o=R("div"),a=null,l=!1,c=0,u=0;function h(m,x){if(u+=1,c=m,!e)return[];if(!eu())return x?[]:[R("p",{className:"note"},`Nor can it be simulated here: ${e.refused}.`)];if(a)p(m);else if(!l){let w=R("button",{type:"button",className:"try"},x?"Try it and refine here":"Simulate it here"),b=R("p",{className:"note"});w.addEventListener("click",()=>d(w,b)),o.replaceChildren(R("div",{className:"offer"},w,b))}return[o]}async function d(m,x){l=m.disabled=!0,x.textContent="Starting the simulator …";try{a=await du(yi(e.bench.clips[0]),e.bench,t,nu),o.replaceChildren(i),i.replaceChildren(a.element),a.begin(),p(c)}catch(w){x.textContent=`It cannot be simulated here: ${w.message}.`}}let f=m=>a.engine.ask({act:"answer",values:m,search:e.search});async function p(m){let x=++u,w=R("button",{type:"button"},"Refine here");w.addEventListener("click",()=>g(m)),r.replaceChildren(),i.replaceChildren(s,...Ox(n,e).length?[w]:[],r,a.element),s.textContent="Simulating …",a.sliders.set(e.points[m]);let b=(await f(e.points[m])).answer;x===u&&(s.textContent=`${bn(n.pointText(m))}: ${Dx(e,b)}.`,_(m))}function _(m){a.sliders.set(e.points[m]),a.engine.tell({act:"restart",through:!1})}async function g(m){let x=++u,w=iC(n,e,m),b=new Map,S=R("p",{className:"note",role:"status"}),M=w[1].values.map(P=>w[0].values.map(F=>nC(w,F,P))).reverse(),y=M.map((P,F)=>R("tr",{},R("th",{scope:"row"},Nx(w[1],w[1].values.length-1-F)),...P.map(({cell:z})=>z))),A=R("tr",{className:"feet"},R("td"),...w[0].values.map((P,F)=>R("th",{scope:"col"},Nx(w[0],F)))),I=R("table",{className:"grid"},R("caption",{},rC(w,n.study.sampled)),R("tbody",{},...y,A));r.replaceChildren(R("div",{className:"table",tabIndex:0,role:"group","aria-label":"finer map"},I),S);let L=M.flat();for(let[P,{cell:F,values:z,where:U}]of L.entries()){S.textContent=`${P} of ${L.length} points simulated`;let G=(await f({...e.points[m],...z})).answer;if(x!==u)return;let $=n.study.words.find(({word:H})=>H===G.word)?.sign??"?";F.className=Ui($),F.replaceChildren(R("span",{},$)),F.title=`${U}: ${Dx(e,G)}`,F.setAttribute("aria-label",F.title),b.set(G.word,$)}S.textContent=[...b].map(([P,F])=>`${F} ${P}`).join(" · "),_(m)}return{offer:h,get panel(){return a}}}function nC(n,t,e){let i={[n[0].key]:t};n[1].key&&(i[n[1].key]=e);let s=n.filter(({key:r})=>r).map(r=>`${r.name} ${Ee(r.factor*i[r.key])} ${r.unit}`).join(", ");return{cell:R("td",{"aria-label":`${s}: not simulated yet`}),values:i,where:s}}function Ox(n,t){let e=i=>t.knobs.some(({key:s})=>s===n.study.factors[i].key);return n.study.axes.filter(i=>n.sizes[i]>1&&e(i))}function iC(n,t,e){let i=Ox(n,t),[s,r]=i.length>1?i:[null,i[0]??0],o=a=>{if(a===null)return{key:"",name:"",unit:"",factor:1,values:[0]};let{key:l,name:c}=n.study.factors[a],u=t.knobs.find(g=>g.key===l);if(n.study.sampled)return{key:l,name:c,unit:u.unit,factor:u.factor,values:sC(t.points.map(g=>g[l]),e)};let h=n.placesOf(e),d=g=>t.points[n.pointAt(h.map((m,x)=>x===a?g:m))][l],[f,p]=[Math.max(0,h[a]-1),Math.min(n.sizes[a]-1,h[a]+1)],_=[];for(let g=f;g<p;g++)for(let m=0;m<Lx;m++)_.push(d(g)+m/Lx*(d(g+1)-d(g)));return{key:l,name:c,unit:u.unit,factor:u.factor,values:[..._,d(p)]}};return[o(r),o(s)]}function sC(n,t){let[e,i]=[Math.min(...n),Math.max(...n)],s=[-2,-1,0,1,2].map(r=>n[t]+r*(i-e)/eC);return[...new Set(s.map(r=>Math.min(i,Math.max(e,r))))].sort((r,o)=>r-o)}var Nx=({key:n,factor:t,unit:e,values:i},s)=>n?`${Ee(t*i[s])} ${e}`:"";function rC([n,t],e){return`${t.key?`${bn(n.name)} across, ${t.name} upwards`:bn(n.name)}, ${e?"around it":"at half the steps"}`}function Dx(n,{status:t,least:e}){let s=(n.search?[n.search.first,n.search.second].filter(Boolean):[]).filter(({name:r})=>e[r]!==null&&e[r]!==void 0).map(({key:r,name:o,title:a})=>{let{factor:l,unit:c}=n.knobs.find(u=>u.key===r);return`${a} ${Ee(l*e[o])} ${c}`});return[t,...s].join("; ")}function Fu(n){let t=R("h2"),e=R("p",{className:"outcome",role:"status"}),i=R("table",{className:"numbers"}),s=R("section",{className:"facts",id:"point"},t,e,R("div",{className:"table"},i)),r=R("div",{className:"parts",role:"group","aria-label":`runs of this ${n.study.noun}`}),o=R("div"),a=R("div",{className:"more"}),l=R("section",{className:"run",id:"run","aria-label":"the run that is open"},r,o,a),c=Ux(n),u={facts:s,element:l,point:null,playing:null,answers:c,open:f,show:g},h=null,d=Ua();function f(x,{play:w=!1,transition:b=null}={}){u.point=x;let S=n.runsOf(x);t.textContent=bn(`${n.study.noun} ${x+1}`),e.textContent=`${bn(n.pointText(x))}: ${n.study.statuses[x]}.`,i.replaceChildren(R("caption",{},"In the table"),R("tbody",{},...uC(n,x))),r.replaceChildren(...S.length>1?S.map(p):S.map(M=>R("b",{},bn(M.title)))),S.length?g((b===null?null:S.find(M=>M.transition===b))??S[0],{play:w}):(_(),o.replaceChildren(R("p",{className:"note"},hC(n,x)))),a.replaceChildren(...n.study.built[x]?c.offer(x,S.length>0):[])}function p(x){let w=R("button",{type:"button"},x.title);return w.dataset.part=x.part,w.addEventListener("click",()=>g(x,{play:!0})),w}function _(){u.playing?.dispose(),u.playing=null}function g(x,{play:w=!1}={}){_();for(let L of r.querySelectorAll("button"))L.setAttribute("aria-pressed",String(L.dataset.part===x.part));let b=h&&h!==x?h:null,S=b?[b,x]:[x],M={player:R("div"),plots:R("div"),readouts:S.map(()=>R("div"))},[y,A]=[dC,fC].map(L=>S.map((P,F)=>L(P,Fx(S,n)[F]))),I=x.advice?[R("p",{className:"note"},x.advice)]:[];o.replaceChildren(R("p",{},x.text),m(x),...I,M.player,M.plots,...M.readouts,...y,...A),d.scale=n.largestSpan/x.play.clips[0].span_m,u.playing={run:x,beside:b,...oC(M,x,b,n,d)},yo(o),w&&!matchMedia("(prefers-reduced-motion: reduce)").matches&&u.playing.clock.play()}function m(x){let b=R("button",{type:"button",className:"pin"},h?`unpin ${n.study.noun} ${h.point+1}`:"pin, to compare it with another");return b.addEventListener("click",()=>{h=h?null:x,g(x),o.querySelector(".pin").focus()}),b}return u}function oC(n,t,e,i,s){let r=e?[e,t]:[t],o=r.map((f,p)=>lC(f,Fx(r,i)[p],i)),a=r.map((f,p)=>({...yi(f.play.clips[0]),...e?{name:o[p]}:{}})),l=Ss(a,e?[cC(a)]:t.play.spans),c=r.map(f=>f.play.energy).reduce((f,p)=>p.largest_J>f.largest_J?p:f),u=e?`${bn(a[0].name)} and ${a[1].name}, side by side on one clock.`:t.play.text,h=xo(n.player,a,l,{...t.play,energy:c,text:u},s);e&&h.stage&&pf(h.stage.cells,a,l,c);let d=Po(n.plots,e?aC(r,a):t.play.plots,a,l);n.plots.classList.toggle("paired",e!==null);for(let[f,p]of a.entries())_o(n.readouts[f],p,l,c,f,e!==null);return{clips:a,clock:l,player:h,plots:d,dispose(){h.dispose(),d.dispose()}}}function aC(n,t){let e=n.map(({play:s},r)=>s.plots.map(o=>({...o,owner:t[r].name,sharing:`${o.title} ${o.unit}`,lines:o.lines.map(a=>({...a,clip:r}))})));return[...new Set(e.flat().map(s=>s.title))].flatMap(s=>e.flat().filter(r=>r.title===s))}function Fx(n,{study:t}){if(n.length===1)return[""];let e=new Set(n.map(i=>i.point)).size<n.length;return n.map(i=>`${t.noun} ${i.point+1}${e?`, ${i.title}`:""}`)}function lC(n,t,e){let{factors:i}=e.study,s=e.placesOf(n.point).map((r,o)=>`${i[o].texts[r]} ${i[o].unit}`.trim());return`${t}: ${s.join(", ")}`}function cC(n){let t=n.map(s=>s.stages.find(r=>r.driven)?.start??s.start),[e,i]=[Math.min(...n.map((s,r)=>s.start-t[r])),Math.max(...n.map((s,r)=>s.end-t[r]))];return{name:"whole runs",label:"time since the first drive acts",start:e,end:i,origins:t,whole:!0}}function uC(n,t){return n.numbers.map(e=>R("tr",{},R("th",{scope:"row"},e.title),R("td",{},n.valueText(e,t))))}function hC(n,t){return n.study.built[t]?`This run was not kept, so it cannot be played here. ${n.study.keeps}`:`There is nothing to play: this ${n.study.noun} cannot be built.`}function dC(n,t){let e=R("div");return e.innerHTML=n.numbers,R("details",{},R("summary",{},`States of ${t||"this run"}`),e)}function fC(n,t){let e=[`forficula run ${n.folder}/design.toml`,`forficula film ${n.folder} --out film.mp4`];return R("details",{},R("summary",{},t?`Commands for ${t}`:"Commands"),R("p",{className:"note"},"In the folder of this page, these run it again, and film it:"),R("pre",{},R("code",{},e.join(`
`))))}function ku(n,t,e,i){let s=n?.querySelector("table");if(!s)return()=>{};let r=[...s.tBodies[0].rows],o=R("p",{className:"note",role:"status"}),a=pC(t,()=>{let u=a.shown(),h=0;for(let[d,f]of r.entries())f.hidden=!u.has(t.study.verdicts[d])||!t.shown(d),h+=f.hidden?0:1;o.textContent=`${h} of ${r.length} ${t.study.noun}s shown.`});for(let[u,h]of r.entries()){let d=R("button",{type:"button","aria-label":`open ${t.study.noun} ${u+1}`},h.cells[0].textContent);d.addEventListener("click",()=>i(u)),h.cells[0].replaceChildren(d)}let l=t.study.factors.length+1;for(let u of[s.tHead.rows[0],...r])u.cells[l].classList.add("words");gC(s,r,mC(t));let c=R("div",{className:"choices"},a.element,...e?[_C(e,t.study.file)]:[]);return s.closest(".table").before(c,o),a.changed(),a.changed}function pC(n,t){let e=new Map,i=n.study.words.flatMap(({word:r,sign:o,count:a},l)=>{if(!a)return[];let c=R("input",{type:"checkbox",checked:!0});return c.addEventListener("change",t),e.set(l,c),[R("label",{},c,R("span",{className:Ui(o),"aria-hidden":"true"},R("span",{},o)),`${r} (${a})`)]});return{element:R("fieldset",{className:"filter"},R("legend",{},`Show ${n.study.noun}s that`),...i),changed:t,shown:()=>new Set([...e].filter(([,r])=>r.checked).map(([r])=>r))}}function mC(n){let{study:t}=n,e=t.statuses.map((r,o)=>o),i=t.factors.map((r,o)=>e.map(a=>r.values[n.placesOf(a)[o]])),s=n.numbers.map(r=>r.values);return[e,...i,t.statuses,...s]}function gC(n,t,e){let i=[...n.tHead.rows[0].cells];for(let[s,r]of i.entries()){let o=R("button",{type:"button"},...r.childNodes);r.replaceChildren(o),o.addEventListener("click",()=>{let a=r.getAttribute("aria-sort")==="ascending";for(let c of i)c.removeAttribute("aria-sort");r.setAttribute("aria-sort",a?"descending":"ascending");let l=t.map((c,u)=>u).sort((c,u)=>xC(e[s][c],e[s][u],a?-1:1)||c-u);n.tBodies[0].append(...l.map(c=>t[c]))})}i[0].setAttribute("aria-sort","ascending")}function xC(n,t,e){if(n===null||t===null)return(n===null)-(t===null);let i=typeof n=="number"?n-t:String(n).localeCompare(String(t),"en");return e*i}function _C(n,t){let e=R("button",{type:"button",className:"button"},`Download ${t}`);return e.addEventListener("click",()=>{let i=URL.createObjectURL(new Blob([n],{type:"text/csv;charset=utf-8"}));R("a",{href:i,download:t}).click(),setTimeout(()=>URL.revokeObjectURL(i),1e4)}),e}function kx(n){let t=Lu(n.study,n.runs),e=Fu(t),i=(a,l=null)=>{e.open(a,{play:!0,transition:l}),vf(e)},s=Px(t,(a,l)=>i(a,l.transition)),r=R("div",{},s.element,e.facts);document.getElementById("explorer").replaceChildren(R("div",{className:"explorer"},r,e.element)),ku(document.getElementById("points"),t,n.csv,a=>{s.show(a),i(a)});let o=yC(t,n.runs);return e.open(o),s.show(o),{model:t,map:s,panel:e,open:i}}function yC(n,t){let e=n.study.quantities.filter(o=>o.group==="torque"),i=o=>[n.study.verdicts[o],...e.map(a=>a.values[o]??1/0),o],s=(o,a)=>{let l=o.findIndex((c,u)=>c!==a[u]);return l>=0&&o[l]<a[l]};return t.map(o=>o.point).reduce((o,a)=>o===null||s(i(a),i(o))?a:o,null)??0}function vf({facts:n,element:t}){let{top:e}=t.getBoundingClientRect();if(e>=0&&e<.5*innerHeight)return;let i=n.getBoundingClientRect().left===t.getBoundingClientRect().left,s=matchMedia("(prefers-reduced-motion: reduce)").matches;(i?n:t).scrollIntoView({behavior:s?"auto":"smooth",block:"start"})}function Bx(n){let{views:t}=n,e=xx(n.study,n.runs),i=Fu(e),s=[],r=(g,m)=>{i.open(g,{play:m});for(let x of s)x.show?.(g)},o=g=>{r(g,!0),vf(i)},a=px(e,t.lines,t,o),l=e.columns.filter(g=>g.aim).length===2,c=Ex(e,{...t,joined:l},o),u=t.pairs?.length?yx(e,t,h):null;s.push(a,c);function h(g,m){c.over(g,m),c.element.scrollIntoView({block:"start"})}let d=n.runs.length?[[c.element,i.facts],[i.element]]:[[c.element],[i.facts]],f=R("div",{className:"explorer"},...d.map(g=>R("div",{},...g))),p={lines:a.element,pairs:u?.element,plane:f};document.getElementById("explorer").replaceChildren(...t.order.map(g=>p[g]));let _=ku(document.getElementById("points"),e,n.csv,o);return e.whenAsked(_),n.study.points&&r(vC(e,n),!1),{model:e,panel:i,lines:a,plane:c,open:o}}function vC(n,{runs:t,views:e,study:i}){let{best:s}=e,r=t.map(o=>o.point);return s!==null&&r.includes(s)?s:r.find(o=>n.good(o))??r[0]??s??i.verdicts.findIndex((o,a)=>n.good(a)||a===i.points-1)}async function zx(n){let t=new Blob([en(n,Uint8Array)]).stream(),e=await new Response(t.pipeThrough(new DecompressionStream("deflate"))).arrayBuffer();function i({kind:s,start:r,shape:o,low:a,step:l}){let c=o.reduce((d,f)=>d*f,1);if(s==="f4")return new Float32Array(e,r,c);if(s==="f8")return new Float64Array(e,r,c);let u=new(s==="u2"?Uint16Array:Uint32Array)(e,r,c),h=bC(u,...o);return a?Float32Array.from(h,(d,f)=>a[f%o[1]]+l[f%o[1]]*d):h}return i}function bC(n,t,e){let i=n.constructor,s=new i(1),r=new i(n.length);for(let o=0;o<e;o++){s[0]=0;for(let a=0;a<t;a++)s[0]+=n[o*t+a],r[a*e+o]=s[0]}return r}var SC="M7 4.5v15l12-7.5z",MC="M7 5h3.5v14H7zM13.5 5H17v14h-3.5z",Qs=180/Math.PI,Bu=1,Vx=10,Gx=720;function Xx(n,t,e,i){let[s,r]=[n.lowest,n.highest].map(p=>p*Qs),o=TC(n),a=EC(n,s,r,o),l=R("button",{type:"button",className:"play"}),c=R("input",{type:"range",min:s,max:r,step:"any","aria-label":"hinge angle"});c.dataset.keys="own";let u=R("p",{className:"time"}),h=p=>{t.pause(),t.seek(i(Math.min(r,Math.max(s,p))/Qs))},d=()=>t.playing?t.pause():t.play(),f=a.map(({angle:p,name:_})=>{let g=R("button",{type:"button"},R("b",{},Hx(p)),` ${_}`);return g.addEventListener("click",()=>h(p)),g});return c.addEventListener("input",()=>h(Number(c.value))),AC(c,()=>e(t.time)*Qs,h,d),l.addEventListener("click",d),t.onChange(()=>{let p=e(t.time)*Qs;c.value=p,u.textContent=`${Hx(p,1)}${Wx(n,p)}`,c.setAttribute("aria-valuetext",`${Dn(p,1)} degrees${Wx(n,p)}`);for(let[g,m]of a.entries())f[g].setAttribute("aria-pressed",String(Math.abs(m.angle-p)<.005));let _=t.playing?"pause":"play: fold from stop to stop";l.getAttribute("aria-label")!==_&&l.replaceChildren(tl(t.playing?MC:SC)),l.setAttribute("aria-label",_)}),R("div",{className:"transport"},R("div",{className:"line"},l,wC(c,s,r,o,a)),R("div",{className:"choices"},u,R("div",{className:"states"},...f)))}function wC(n,t,e,i,s){let r=R("div",{className:"bands","aria-hidden":"true"}),o=R("div",{className:"ticks","aria-hidden":"true"}),a=l=>`${100*l/(e-t)}%`;for(let[l,c]of i){let u=R("span",{className:"band"});Object.assign(u.style,{left:a(l-t),width:a(c-l)}),r.append(u)}for(let{angle:l,stop:c}of s){let u=R("span",{className:c?"tick stop":"tick"});u.style.left=a(l-t),o.append(u)}return R("div",{className:"track"},r,n,o)}function AC(n,t,e,i){let s={ArrowLeft:-Bu,ArrowDown:-Bu,ArrowRight:Bu,ArrowUp:Bu},r={PageDown:-Vx,PageUp:Vx,Home:-1/0,End:1/0};n.addEventListener("keydown",o=>{if(!(o.shiftKey||o.ctrlKey||o.metaKey||o.altKey)){if(o.key===" ")i();else if(o.key in s)e(Math.round(t()+s[o.key]));else if(o.key in r)e(t()+r[o.key]);else return;o.preventDefault()}})}var Hx=(n,t=null)=>`${t===null?Dn(n,Number.isInteger(Number(n.toFixed(3)))?0:1):Dn(n,t)}°`;function EC(n,t,e,i){let s=a=>[...new Set(n.joints.map(l=>Number((l[a]*Qs).toFixed(6))))],r=[...s("lower").map(a=>({angle:a,name:"stop of the fold",stop:!0})),...i.flatMap(([a,l])=>[a,l].map(c=>({angle:c,name:"all straps slack"}))),...t<0&&e>0?[{angle:0,name:"flat"}]:[],...s("upper").map(a=>({angle:a,name:e>0?"stop of the overbend":"stop, flat",stop:!0}))],o=a=>Math.abs(a-t)<1e-6||Math.abs(a-e)<1e-6;return r.filter(a=>a.stop||a.name==="flat"||!o(a.angle)).sort((a,l)=>a.angle-l.angle)}function TC(n){let t=a=>$x(n,a).every(({longer:l})=>l<0),[e,i]=[n.lowest*Qs,n.highest*Qs],s=(a,l)=>{let c=t(a);for(let u=0;u<40;u++){let h=(a+l)/2;t(h)===c?a=h:l=h}return l},r=[];if(!n.straps.length)return r;let o=t(e)?null:e;for(let a=1;a<=Gx;a++){let[l,c]=[a-1,a].map(u=>e+(i-e)*u/Gx);t(l)!==t(c)&&(o===null?o=s(l,c):(r.push([o,s(l,c)]),o=null))}return o!==null&&r.push([o,i]),r}function $x(n,t){let e=n.turn(n.anglesTogether(t/Qs));return n.straps.flatMap(i=>n.strapStretches(i,e).map(s=>({longer:s,rest:i.rest})))}function Wx(n,t){let e=$x(n,t);if(!e.length)return"";let i=e.filter(({longer:a})=>a<0).length,s=Math.max(...e.map(({longer:a})=>a));if(i===e.length)return`, straps slack by ${Dn(-1e3*s,1)} mm or more`;let r=Math.max(...e.map(({longer:a,rest:l})=>a/l)),o=`stretched by up to ${Dn(1e3*s,1)} mm (${Dn(100*r,1)} %)`;return i?`, ${i} of ${e.length} straps slack, others ${o}`:`, straps ${o}`}function qx(n){let t=R("input",{type:"range",min:0,max:100,step:1,value:0});return t.dataset.keys="own",t.addEventListener("input",()=>n(Number(t.value)/100)),t.setAttribute("aria-valuetext","together"),t.addEventListener("input",()=>{t.setAttribute("aria-valuetext",t.value==="0"?"together":`${t.value} % apart`)}),R("label",{className:"slide"},"take apart ",t)}function Yx(n,t,e){let i=n.map((s,r)=>{let o=R("input",{type:"checkbox",checked:!0});o.dataset.keys="own",o.addEventListener("change",()=>e(r,o.checked));let a=R("span",{className:"swatch panel","aria-hidden":"true"});return a.style.background=s.colour,R("label",{},o,a,`${s.name}${t[r]>1?`, ${t[r]}`:""}`)});return R("fieldset",{className:"kinds"},R("legend",{},"show"),...i)}function bf(n,t,e){let i=R("select",{},...t.map((s,r)=>R("option",{value:String(r)},s)));return i.addEventListener("change",()=>e(Number(i.value))),R("label",{},`${n} `,i)}var zu=28,Zx=24;function Jx(n,t){return n.ends.map(e=>{let[i,s]=e.map((r,o)=>new W(...r).applyMatrix4(No(t,n.bodies[o])));return i.distanceTo(s)-n.rest})}var CC=new pe,No=(n,t)=>t<0?CC:n[t];function Sf(n,t,e,i,s){let r=new W(...n.axis).transformDirection(No(t,n.bodies[0])),o=new W(...n.up).transformDirection(No(t,n.bodies[0]));return n.ends.map(a=>{let l=a.map((x,w)=>new W(...x).applyMatrix4(No(t,n.bodies[w])).add(i)),c=l[1].clone().sub(l[0]),u=c.dot(r);c.addScaledVector(r,-u);let h=c.length(),d=h>1e-9?c.divideScalar(h):new W().crossVectors(r,o),f=new W().crossVectors(r,d).multiplyScalar(e),_=n.rest>Math.hypot(h,u)?Math.sqrt(n.rest**2-u**2):h,g=RC(s,_>1e-9?h/_:1);return{points:g.map(([x,w],b)=>l[0].clone().addScaledVector(d,x*_).addScaledVector(f,w*_).addScaledVector(r,u*b/(g.length-1))),wide:r,ends:l}})}function RC({values:n,shape:t},e){let[i,s]=t,r=Math.sqrt(Math.max(0,1-e))*(i-1),o=Math.min(i-2,Math.floor(r)),a=Math.min(1,r-o),l=(d,f,p)=>n[(d*s+f)*2+p],c=(d,f)=>l(o,d,f)+a*(l(o+1,d,f)-l(o,d,f)),u=c(s-1,0),h=u>1e-6?e/u:1;return Array.from({length:s},(d,f)=>[h*c(f,0),c(f,1)])}function Kx(n,t,e){let i={triangles:[],edges:[]};for(let{points:s,wide:r,ends:o}of t){let a=r.clone().multiplyScalar(n.width/2),l=s.map((c,u)=>{let d=s[Math.min(u+1,s.length-1)].clone().sub(s[Math.max(u-1,0)]).cross(r).setLength(n.thickness/2);return[[-1,-1],[1,-1],[1,1],[-1,1]].map(([f,p])=>c.clone().addScaledVector(a,f).addScaledVector(d,p))});Qx(i,l,[0,1,2,3]);for(let[c,u]of o.entries()){let h=new W(...n.across[c]).transformDirection(No(e,n.bodies[c]));IC(i,u,h,n.width,n.eye/2,n.peg/2)}}return i}function Mf(n,t,e){let i=n.places.map(_=>new W(..._).add(e)),[s,r,o,a]=i,l=No(t,n.body),[c,u]=[o,a].map(_=>_.clone().sub(e).applyMatrix4(l).add(e)),h=r.clone().sub(s).normalize(),d=u.clone().sub(c).normalize(),f=r.distanceTo(o),p=[s];for(let _=0;_<=Zx;_++)p.push(PC(r,h,c,d,f,_/Zx));return[...p,u]}function PC(n,t,e,i,s,r){let[o,a]=[1-r,r];return n.clone().multiplyScalar(o*o*(1+2*a)).addScaledVector(e,a*a*(1+2*o)).addScaledVector(t,s*o*o*a).addScaledVector(i,-s*a*a*o)}function jx(n,t){let e={triangles:[],edges:[]},i=n[1].clone().sub(n[0]).normalize(),s=new W(Math.abs(i.z)<.9?0:1,0,Math.abs(i.z)<.9?1:0),r=n.map((o,a)=>{let l=n[Math.min(a+1,n.length-1)].clone().sub(n[Math.max(a-1,0)]).normalize();s=s.clone().addScaledVector(l,-s.dot(l)).normalize();let c=new W().crossVectors(l,s);return Array.from({length:zu},(u,h)=>{let d=2*Math.PI*h/zu;return o.clone().addScaledVector(s,Math.cos(d)*t/2).addScaledVector(c,Math.sin(d)*t/2)})});return Qx(e,r,[]),e}function Qx({triangles:n,edges:t},e,i){let s=e[0].length;for(let r=1;r<e.length;r++){let[o,a]=[e[r-1],e[r]];for(let l=0;l<s;l++){let c=(l+1)%s;n.push(o[l],o[c],a[c],o[l],a[c],a[l]),i.includes(l)&&t.push(o[l],a[l])}}for(let r of[e[0],e.at(-1)])for(let o=1;o<s-1;o++)n.push(r[0],r[o],r[o+1])}function IC({triangles:n,edges:t},e,i,s,r,o){let a=new W(Math.abs(i.z)<.9?0:1,0,Math.abs(i.z)<.9?1:0);a.addScaledVector(i,-a.dot(i)).normalize();let l=new W().crossVectors(i,a),c=(u,h,d)=>e.clone().addScaledVector(i,d*s/2).addScaledVector(a,h*Math.cos(u)).addScaledVector(l,h*Math.sin(u));for(let u=0;u<zu;u++){let[h,d]=[u,u+1].map(p=>2*Math.PI*p/zu),f=(p,_,g,m)=>n.push(p,_,g,p,g,m);f(c(h,r,-1),c(d,r,-1),c(d,r,1),c(h,r,1));for(let p of[-1,1])f(c(h,o,p),c(d,o,p),c(d,r,p),c(h,r,p)),t.push(c(h,r,p),c(d,r,p))}}function t_(n,t){let e=t.map(({origin:a,axis:l})=>[new W(...a),new W(...l)]),i=n.map((a,l)=>t.flatMap((c,u)=>c.body===l?[u]:[])),s=n.map(()=>new pe),r=new pe,o=new W;return function(l){for(let[c,u]of n.entries()){let h=s[c];u<0?h.identity():h.copy(s[u]);for(let d of i[c]){let[f,p]=e[d];r.makeRotationAxis(p,l[d]-t[d].built),o.copy(f).applyMatrix4(r),r.setPosition(f.x-o.x,f.y-o.y,f.z-o.z),h.multiply(r)}}return s}}var LC=[-1,0,1].flatMap(n=>[-1,0,1].flatMap(t=>[-1,0,1].map(e=>[n,t,e]))),NC=new pe;function e_(n,t){let e=n.parts.map(f=>({...f,...f.mesh?DC(f.mesh,t):{}})),i={values:t(n.bows),shape:n.bows.shape},s=t_(n.bodies,n.turns),r=Math.min(...n.joints.map(f=>f.lower)),o=Math.max(...n.joints.map(f=>f.upper)),a=new Float64Array(n.turns.length);function l(f){for(let[p,_]of n.turns.entries())a[p]=_.built;for(let p of n.joints)a[p.turn]=Math.min(p.upper,Math.max(p.lower,f));return a}let c=(f,p)=>new W(...f.apart).multiplyScalar(p);function u(f,p,_,g=new pe){let m=c(f,_);return g.copy(f.body===null||f.body<0?NC:p[f.body]).multiply(new pe().makeTranslation(m.x,m.y,m.z))}function h(f,p,{apart:_,side:g}){let m=c(f,_);return f.root?jx(Mf(f.root,p,m),f.root.diameter):Kx(f.strap,Sf(f.strap,p,g,m,i),p)}function d(f,p,{apart:_,side:g}){let m=[];for(let x of f){if(x.outer){let S=u(x,p,_);for(let M of x.outer)m.push(...M.clone().applyMatrix4(S).toArray());continue}let w=c(x,_),b=x.root?[Mf(x.root,p,w)]:Sf(x.strap,p,g,w,i).map(S=>S.points);for(let S of b)for(let M=0;M<S.length;M+=4)m.push(...S[M].toArray())}return Float64Array.from(m)}return{parts:e,looks:n.looks,joints:n.joints,turns:n.turns,lowest:r,highest:o,turn:s,anglesTogether:l,matrixOf:u,bentMesh:h,outline:d,straps:e.filter(f=>f.strap).map(f=>f.strap),strapStretches:Jx}}function DC({points:n,triangles:t,stops:e,edges:i},s){let r=s(n),o=s(t),a=n.shape[0];for(let l=0;l<o.length;l+=3)o[l+1]=(o[l]+o[l+1])%a,o[l+2]=(o[l]+o[l+2])%a;return{places:r,corners:o,stops:e,edges:s(i),outer:UC(r)}}function UC(n){let t=new Set;for(let[e,i,s]of LC){let[r,o]=[0,-1/0];for(let a=0;a<n.length;a+=3){let l=e*n[a]+i*n[a+1]+s*n[a+2];l>o&&([r,o]=[a,l])}t.add(r)}return Array.from(t,e=>new W().fromArray(n,e))}function n_(n,t){let e=t(n.time),i=t(n.angles),[,s]=n.angles.shape,r=new Float64Array(s);function o(a){let[l,c]=Ki(e,a),u=Math.min(l+1,e.length-1);for(let h=0;h<s;h++){let d=i[l*s+h];r[h]=d+c*(i[u*s+h]-d)}return r}return{time:e,anglesAt:o,marks:n.marks,stages:n.stages,spans:n.spans}}var OC="#14171a",FC=.55,kC=Math.cos(Math.PI/9),BC=.42;function i_(n,t,e,i){let s=n.parts.map(f=>zC(f,n.looks[f.look].colour,i)),r=new kn;for(let f of s)r.add(f.mesh,f.lines);let o=new kn,a=n.turn(n.anglesTogether(0));function l(f){a=n.turn(e(f));for(let[p,_]of n.parts.entries()){let{mesh:g,lines:m}=s[p],x=!t.hidden.has(_.look);for(let w of[g,m])w.visible=x;x&&(_.places?n.matrixOf(_,a,t.apart,g.matrix):HC(s[p],n.bentMesh(_,a,t)))}}function c(){let f=new Qt(ke("--accent"));for(let[p,{mesh:_}]of s.entries())for(let g of[_.material].flat())g.emissive.copy(f),g.emissiveIntensity=t.chosen===p?BC:0}function u(f,p){let _=new ya;_.setFromCamera(f,p),r.updateMatrixWorld(!0);for(let{mesh:m}of s)m.geometry.boundingSphere===null&&m.geometry.computeBoundingSphere();let[g]=_.intersectObjects(s.map(m=>m.mesh).filter(m=>m.visible),!1);return g?s.findIndex(m=>m.mesh===g.object):null}function h(f){let p=n.parts.findIndex(x=>x.name===f),{mesh:_}=s[p],g=_.geometry.getAttribute("position"),m=new rn(g.array.slice(),3);return Array.from(m.applyMatrix4(_.matrix).array)}function d(){for(let{mesh:f,lines:p}of s){f.geometry.dispose(),p.geometry.dispose();for(let _ of[f.material,p.material].flat())_.dispose()}}return{group:r,shadow:o,pose:l,paint:c,sort:()=>{},at:u,verticesOf:h,dispose:d,current:()=>a}}function zC(n,t,e){let i=(u,h)=>new gs({color:u,side:Bn,flatShading:h,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}),s=n.places?VC(n):new xn,r=n.places?[i(e,!1),i(t,!1)]:i(t,!0),o=new Nn(s,r),a=new xn;n.places&&a.setAttribute("position",new rn(s_(n.places,n.edges),3));let l=new zs({color:OC,transparent:!0,opacity:FC}),c=new cr(a,l);for(let u of[o,c])Object.assign(u,{frustumCulled:!1,matrixAutoUpdate:!1});return c.matrix=o.matrix,{mesh:o,lines:c}}function VC({places:n,corners:t,stops:e}){let i=new xn;return i.setAttribute("position",new rn(s_(n,t),3)),i.setAttribute("normal",new rn(GC(n,t),3)),i.addGroup(0,3*e,0),i.addGroup(3*e,t.length-3*e,1),i}function s_(n,t){let e=new Float32Array(3*t.length);for(let[i,s]of t.entries())for(let r=0;r<3;r++)e[3*i+r]=n[3*s+r];return e}function GC(n,t){let e=t.length/3,i=new Float64Array(t.length),s=Array.from({length:n.length/3},()=>[]);for(let l=0;l<e;l++){let[c,u,h]=[0,1,2].map(f=>3*t[3*l+f]),d=(f,p,_)=>n[p+_%3]-n[f+_%3];for(let f=0;f<3;f++)i[3*l+f]=d(c,u,f+1)*d(c,h,f+2)-d(c,u,f+2)*d(c,h,f+1);for(let f=0;f<3;f++)s[t[3*l+f]].push(l)}let r=Float64Array.from({length:e},(l,c)=>Math.hypot(...i.subarray(3*c,3*c+3))),o=new Float32Array(3*t.length),a=(l,c)=>i[3*l]*i[3*c]+i[3*l+1]*i[3*c+1]+i[3*l+2]*i[3*c+2];for(let l=0;l<t.length;l++){let c=Math.floor(l/3),u=[0,0,0];for(let d of s[t[l]])if(d===c||a(c,d)>=kC*r[c]*r[d])for(let f=0;f<3;f++)u[f]+=i[3*d+f];let h=Math.hypot(...u)||1;for(let d=0;d<3;d++)o[3*l+d]=u[d]/h}return o}function HC({mesh:n,lines:t},{triangles:e,edges:i}){for(let[s,r]of[[n,e],[t,i]]){let{geometry:o}=s,a=o.getAttribute("position");a?.count!==r.length&&(a=new rn(new Float32Array(3*r.length),3),o.setAttribute("position",a));for(let[l,c]of r.entries())c.toArray(a.array,3*l);a.needsUpdate=!0,o.boundingSphere=null}}var WC=.25,r_=60,XC=4;async function a_(n){let t=await zx(n.arrays),e=e_(n,t),i={apart:0,side:1,hidden:new Set,chosen:null},s=[$C(e,i),...n.motion?[qC(e,i,n_(n.motion,t))]:[]],r=YC(s),o=document.getElementById("player"),a=ZC(o,n,e,i,r),l=eR(e,n,i,a);return a.onPress(l.choose),{model:e,state:i,clock:s[0].clock,run:s[1]?.clock??null,...a,choose:l.choose}}function $C(n,t){let e=c=>n.highest+c*(n.lowest-n.highest),i=c=>(c-n.highest)/(n.lowest-n.highest||1),s=Float64Array.from({length:r_+1},(c,u)=>u/r_),r=c=>n.anglesTogether(e(c)),o=l_(n,t,{time:s,anglesAt:r,marks:[],stages:[]}),a=Ss([c_(n,o,r)],[{name:"",label:"",start:0,end:1,origins:[0],whole:!1}]);a.setSpeed(WC);let l=Xx(n,a,e,i);return{name:"all joints alike",clip:o,clock:a,anglesAt:r,control:l}}function qC(n,t,e){let i=l_(n,t,e),s=Ss([c_(n,i,e.anglesAt)],e.spans);return{name:"as in the simulated run",clip:i,clock:s,anglesAt:e.anglesAt,control:au([i],s)}}function l_(n,t,{time:e,anglesAt:i,marks:s,stages:r}){let o=()=>{let a=n.parts.filter(l=>!t.hidden.has(l.look));return a.length?a:n.parts};return{name:"",time:e,start:e[0],end:e[e.length-1],marks:s,stages:r,readings:[],reach:0,mesh:{tubes:[],joints:[],jointRadius:0},pointsAt:a=>n.outline(o(),n.turn(i(a)),t),stageAt:a=>r.findLast(l=>l.start<=a)??r[0],markAt:a=>s.find(l=>Math.abs(l.time-a)<1e-9)}}function c_(n,t,e){let i=n.parts.filter(s=>s.outer).map(s=>({...s,outer:[s.outer[0],s.outer.at(-1)]}));return{...t,pointsAt:s=>n.outline(i,n.turn(e(s)),{apart:0,side:1})}}function YC(n){let t=n[0],e={of:null},i=new Set;for(let a of n)a.clock.onChange(()=>{if(a===t)for(let l of i)l()});let s=()=>t.clock.redraw(),r={get time(){return t.clock.time},get playing(){return t.clock.playing},get span(){return e.of!==t.clock.span&&(e={...t.clock.span,of:t.clock.span}),e},clipTime:(a,l)=>t.clock.clipTime(a,l),timeAt:a=>t.clock.timeAt(a),wayAt:a=>t.clock.wayAt(a),onChange(a){return i.add(a),s(),()=>i.delete(a)},seek:a=>t.clock.seek(a),seekClip:(a,l)=>t.clock.seekClip(a,l),step:a=>t.clock.step(a),play:()=>t.clock.play(),pause:()=>t.clock.pause()};return{clip:{...n[0].clip,pointsAt:a=>t.clip.pointsAt(a)},clock:r,sources:n,get now(){return t},anglesAt:a=>t.anglesAt(a),take(a){t.clock.pause(),t=n[a],e={of:null},s()},changed(){e={of:null},s()}}}var u_="Press a part, or its name in the table, to see what it is.",o_="parts";function ZC(n,t,e,i,s){let{clip:r,clock:o,sources:a}=s,l=null,u=Ba([r],o,()=>l=i_(e,i,s.anglesAt,t.stopColour),t.text),h=u?R("div",{className:"picture"},u.element,hu(u.eye,null)):R("p",{className:"note"},uu(o_)),d=R("p",{className:"chosen",role:"status"},u_),f=R("div",{},a[0].control);return n.replaceChildren(h,d,f,JC(e,i,s,f),KC(e,i,s),jC(t,e,u),ru([r],u!==null,o_)),n.classList.add("player"),n.setAttribute("role","region"),n.setAttribute("aria-label","the parts moving"),ou(n,[r],o,u?.eye,gr[0]),{stage:u,shape:l,info:d,repaint:()=>{l?.paint(),o.seek(o.time)},onPress:p=>u&&tR(u.canvas,_=>p(l.at(_,u.eye.camera)))}}function JC(n,t,e,i){let s=l=>{Object.assign(t,l),e.changed()},r=e.sources.map(l=>l.name),o=bf("motion",r,l=>{e.take(l),i.replaceChildren(e.now.control)}),a=bf("slack straps bow",["away from the hinge","towards the hinge"],l=>s({side:l?-1:1}));return R("div",{className:"choices"},...r.length>1?[o]:[],qx(l=>s({apart:l})),...n.straps.length?[a]:[])}function KC(n,t,e){let i=n.looks.map((s,r)=>n.parts.reduce((o,a)=>o+(a.look===r?a.count:0),0));return Yx(n.looks,i,(s,r)=>{r?t.hidden.delete(s):t.hidden.add(s),e.changed()})}function jC(n,t,e){let i=R("span",{className:"swatch taut","aria-hidden":"true"});return R("ul",{className:"legend"},...t.parts.some(s=>s.stops)?[QC(n.stopColour,"face of a stop")]:[],...t.straps.length?[R("li",{},i,"on the slider: where straps are taut")]:[],...e?[R("li",{},`squares of the grid: ${Ee(1e3*ka(e.eye.size))} mm`)]:[])}function QC(n,t){let e=R("span",{className:"swatch panel","aria-hidden":"true"});return e.style.background=n,R("li",{},e,t)}function tR(n,t){let e=null;n.addEventListener("pointerdown",i=>{e=i.isPrimary?[i.clientX,i.clientY]:null}),n.addEventListener("pointerup",i=>{if(e===null||Math.hypot(i.clientX-e[0],i.clientY-e[1])>XC)return;let s=n.getBoundingClientRect(),[r,o]=[(i.clientX-s.left)/s.width,(i.clientY-s.top)/s.height];t(new Yt(2*r-1,1-2*o))})}function eR(n,t,e,i){let r=Array.from(document.querySelectorAll("#bill tbody tr")).map((l,c)=>{let[u]=l.querySelector("th").childNodes,h=R("button",{type:"button",className:"name","aria-pressed":"false"},u.textContent);return u.replaceWith(h),h.addEventListener("click",()=>o(e.chosen===c?null:c)),h});function o(l){e.chosen=l;for(let[c,u]of r.entries())u.setAttribute("aria-pressed",String(c===l));i.info.textContent=l===null?u_:a(l),i.repaint()}function a(l){let c=n.parts[l],[u,h,d]=c.facts,f=c.count>1?`${c.count} alike, each `:"";return`${c.name}: ${n.looks[c.look].name} of ${u}, ${f}${h}, ${d}`}return{choose:o}}function h_(n){let t=n.clips.map(yi),e=Ss(t,n.spans),i=xo(document.getElementById("player"),t,e,n),s=n.curves?Ya(document.getElementById("curves"),n.curves,t,e):[],r=Po(document.getElementById("plots"),n.plots,t,e);_o(document.getElementById("readout"),t[0],e,n.energy),Iu(document.getElementById("player"),e);let o=fu(document.getElementById("try"),t[0],n,()=>e.pause());return{clips:t,clock:e,player:i,curves:s,plots:r,trial:o}}var nR={run:h_,compare:ix,curves:rx,study:kx,goals:Bx,parts:a_,bench:Cg},d_=JSON.parse(document.getElementById("data").textContent);function f_(n){let t=`What moves cannot be shown in this browser (${n.message}); the numbers below are all there.`;throw document.querySelector("main").prepend(R("p",{className:"note",role:"alert"},t)),n}function p_(n){window.forficula=n}try{let n=nR[d_.kind](d_);n instanceof Promise?n.then(p_,f_):p_(n)}catch(n){f_(n)}yo();})();
