/* forficula, MIT; with three.js and uPlot, MIT: see LICENSES.txt; sources af343ed3515438bce733cc90a5739d5d0eba03219010d16839cde49a20a16f0f */
(()=>{function b(n,e={},...t){let i=document.createElement(n);for(let[s,r]of Object.entries(e))s.includes("-")||s==="role"?i.setAttribute(s,r):i[s]=r;return i.append(...t),i}var il=n=>ih(n,24);function ih(n,e){let t="http://www.w3.org/2000/svg",i=document.createElementNS(t,"svg");i.setAttribute("viewBox",`0 0 ${e} ${e}`),e!==24&&i.setAttribute("preserveAspectRatio","none"),i.setAttribute("aria-hidden","true");let s=document.createElementNS(t,"path");return s.setAttribute("d",n),i.append(s),i}function ar({colour:n,dash:e}){let t="http://www.w3.org/2000/svg",i=document.createElementNS(t,"svg");i.setAttribute("viewBox","0 0 24 8"),i.setAttribute("aria-hidden","true"),i.classList.add("sample");let s=document.createElementNS(t,"path");return s.setAttribute("d","M0 4H24"),s.setAttribute("stroke",n),s.setAttribute("stroke-dasharray",e.join(" ")),i.append(s),i}function kt(n){return`${n[0]?.toUpperCase()??""}${n.slice(1)}`}function Ln(n,e){let t=n.toFixed(e);return(Number(t)===0?0 .toFixed(e):t).replace("-","−")}function sh(n,e){return n.replace(/\{(\w+)\}/g,(t,i)=>e[i])}function vt(n){let e=Number(n.toPrecision(4)),t=Math.abs(e);return(t!==0&&(t>=1e5||t<.001)?n.toExponential(2):String(e)).replaceAll("-","−")}var rh={};function cp(n){rh=n}function up(n,e){let t=rh[n],[i,s]=t.find(([,,r])=>e>=r||e===0)??t.at(-1);return{unit:i,factor:s}}function hp(n){return Object.values(rh).flat().find(([e])=>e===n)[1]}function zr(n,e){let{unit:t,factor:i}=up(e,Math.abs(n));return`${vt(i*n)} ${t}`}function qo(n){return n.unit?{unit:n.unit,factor:1}:up("s",Math.max(Math.abs(n.start),Math.abs(n.end)))}function lr(n,e){let{unit:t,factor:i}=qo(e),s=Math.ceil(2.7-Math.log10(i*(e.end-e.start)));return`${Ln(i*n,Math.min(6,Math.max(0,s)))} ${t}`}var Ws={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},$s={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Wp=0,Uh=1,$p=2;var Ea=1,Xp=2,po=3,Xs=0,Yn=1,Bn=2,gr=0,mo=1,Oh=2,Fh=3,kh=4,qp=5;var xr=100,Yp=101,Zp=102,Kp=103,Jp=104,jp=200,Qp=201,em=202,tm=203,Bh=204,zh=205,nm=206,im=207,sm=208,rm=209,om=210,am=211,lm=212,cm=213,um=214,Rl=0,Pl=1,Il=2,no=3,Ll=4,Nl=5,Dl=6,Ul=7,ac=0,hm=1,dm=2,Yi=0,Vh=1,Gh=2,Hh=3,Wh=4,$h=5,Xh=6,qh=7;var Yh=300,_r=301,go=302,lc=303,cc=304,Ol=1e3,Wi=1001,Fl=1002,Pn=1003,fm=1004;var Ta=1005;var qn=1006,uc=1007;var gs=1008;var jn=1009,Zh=1010,Kh=1011,xo=1012,hc=1013,Ri=1014,yi=1015,Pi=1016,dc=1017,fc=1018,yr=1020,Jh=35902,jh=35899,Qh=1021,ed=1022,Ii=1023,us=1026,xs=1027,pc=1028,mc=1029,qs=1030,gc=1031;var xc=1033,Ca=33776,Ra=33777,Pa=33778,Ia=33779,_c=35840,yc=35841,vc=35842,bc=35843,Sc=36196,Mc=37492,wc=37496,Ac=37488,Ec=37489,La=37490,Tc=37491,Cc=37808,Rc=37809,Pc=37810,Ic=37811,Lc=37812,Nc=37813,Dc=37814,Uc=37815,Oc=37816,Fc=37817,kc=37818,Bc=37819,zc=37820,Vc=37821,Gc=36492,Hc=36494,Wc=36495,$c=36283,Xc=36284,Na=36285,qc=36286;var sa=2300,kl=2301,Tl=2302,Th=2303,Ch=2400,Rh=2401,Ph=2402;var pm=3200;var Yc=0,mm=1,_s="",oi="srgb",ra="srgb-linear",oa="linear",Et="srgb";var Cl=7680,td=7681;var nd=517;var gm=519,xm=512,_m=513,ym=514,id=515,vm=516,bm=517,sd=518,rd=519,Sm=35044,Da=35048;var od="300 es",_i=2e3,io=2001;function by(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function Sy(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function aa(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Mm(){let n=aa("canvas");return n.style.display="block",n}var dp={},so=null;function ad(...n){let e="THREE."+n.shift();so?so("log",e,...n):console.log(e,...n)}function wm(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Xe(...n){n=wm(n);let e="THREE."+n.shift();if(so)so("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function je(...n){n=wm(n);let e="THREE."+n.shift();if(so)so("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function ta(...n){let e=n.join(" ");e in dp||(dp[e]=!0,Xe(...n))}function Am(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var Em={[Rl]:Rl,[Il]:Dl,[Ll]:Ll,[no]:Nl,[Pl]:Pl,[Dl]:Il,[Ul]:Ul,[Nl]:no},Ci=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},On=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],fp=1234567,na=Math.PI/180,ro=180/Math.PI;function _o(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(On[n&255]+On[n>>8&255]+On[n>>16&255]+On[n>>24&255]+"-"+On[e&255]+On[e>>8&255]+"-"+On[e>>16&15|64]+On[e>>24&255]+"-"+On[t&63|128]+On[t>>8&255]+"-"+On[t>>16&255]+On[t>>24&255]+On[i&255]+On[i>>8&255]+On[i>>16&255]+On[i>>24&255]).toLowerCase()}function ft(n,e,t){return Math.max(e,Math.min(t,n))}function ld(n,e){return(n%e+e)%e}function My(n,e,t,i,s){return i+(n-e)*(s-i)/(t-e)}function wy(n,e,t){return n!==e?(t-n)/(e-n):0}function ia(n,e,t){return(1-t)*n+t*e}function Ay(n,e,t,i){return ia(n,e,1-Math.exp(-t*i))}function Ey(n,e=1){return e-Math.abs(ld(n,e*2)-e)}function Ty(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function Cy(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function Ry(n,e){return n+Math.floor(Math.random()*(e-n+1))}function Py(n,e){return n+Math.random()*(e-n)}function Iy(n){return n*(.5-Math.random())}function Ly(n){n!==void 0&&(fp=n);let e=fp+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function Ny(n){return n*na}function Dy(n){return n*ro}function Uy(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function Oy(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function cd(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function Fy(n,e,t,i,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+i)/2),u=o((e+i)/2),h=r((e-i)/2),d=o((e-i)/2),f=r((i-e)/2),p=o((i-e)/2);switch(s){case"XYX":n.set(a*u,l*h,l*d,a*c);break;case"YZY":n.set(l*d,a*u,l*h,a*c);break;case"ZXZ":n.set(l*h,l*d,a*u,a*c);break;case"XZX":n.set(a*u,l*p,l*f,a*c);break;case"YXY":n.set(l*f,a*u,l*p,a*c);break;case"ZYZ":n.set(l*p,l*f,a*u,a*c);break;default:Xe("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function ud(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Tm(n,e){if(e.constructor===Float32Array)return n;let t=ud(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function Cm(n,e){if(e.constructor===Float32Array)return n;let t=ud(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var hd={DEG2RAD:na,RAD2DEG:ro,generateUUID:_o,clamp:ft,euclideanModulo:ld,mapLinear:My,inverseLerp:wy,lerp:ia,damp:Ay,pingpong:Ey,smoothstep:Ty,smootherstep:Cy,randInt:Ry,randFloat:Py,randFloatSpread:Iy,seededRandom:Ly,degToRad:Ny,radToDeg:Dy,isPowerOfTwo:Uy,ceilPowerOfTwo:Oy,floorPowerOfTwo:cd,setQuaternionFromProperEuler:Fy,normalize:Cm,denormalize:Tm},qe=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=ft(this.x,e.x,t.x),this.y=ft(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=ft(this.x,e,t),this.y=ft(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ft(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(ft(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},li=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],d=r[o+0],f=r[o+1],p=r[o+2],m=r[o+3];if(h!==m||l!==d||c!==f||u!==p){let g=l*d+c*f+u*p+h*m;g<0&&(d=-d,f=-f,p=-p,m=-m,g=-g);let x=1-a;if(g<.9995){let _=Math.acos(g),M=Math.sin(_);x=Math.sin(x*_)/M,a=Math.sin(a*_)/M,l=l*x+d*a,c=c*x+f*a,u=u*x+p*a,h=h*x+m*a}else{l=l*x+d*a,c=c*x+f*a,u=u*x+p*a,h=h*x+m*a;let _=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=_,c*=_,u*=_,h*=_}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return e[t]=a*p+u*h+l*f-c*d,e[t+1]=l*p+u*d+c*h-a*f,e[t+2]=c*p+u*f+a*d-l*h,e[t+3]=u*p-a*h-l*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),d=l(i/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=d*u*h+c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h-d*f*p;break;case"YXZ":this._x=d*u*h+c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h+d*f*p;break;case"ZXY":this._x=d*u*h-c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h-d*f*p;break;case"ZYX":this._x=d*u*h-c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h+d*f*p;break;case"YZX":this._x=d*u*h+c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h-d*f*p;break;case"XZY":this._x=d*u*h-c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h+d*f*p;break;default:Xe("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],d=i+a+h;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>h){let f=2*Math.sqrt(1+i-a-h);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>h){let f=2*Math.sqrt(1+a-i-h);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+h-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(ft(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},H=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(pp.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(pp.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),h=2*(r*i-o*t);return this.x=t+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=ft(this.x,e.x,t.x),this.y=ft(this.y,e.y,t.y),this.z=ft(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=ft(this.x,e,t),this.y=ft(this.y,e,t),this.z=ft(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ft(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return oh.copy(this).projectOnVector(e),this.sub(oh)}reflect(e){return this.sub(oh.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(ft(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},oh=new H,pp=new li,tt=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],d=i[2],f=i[5],p=i[8],m=s[0],g=s[3],x=s[6],_=s[1],M=s[4],v=s[7],E=s[2],A=s[5],y=s[8];return r[0]=o*m+a*_+l*E,r[3]=o*g+a*M+l*A,r[6]=o*x+a*v+l*y,r[1]=c*m+u*_+h*E,r[4]=c*g+u*M+h*A,r[7]=c*x+u*v+h*y,r[2]=d*m+f*_+p*E,r[5]=d*g+f*M+p*A,r[8]=d*x+f*v+p*y,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,d=a*l-u*r,f=c*r-o*l,p=t*h+i*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let m=1/p;return e[0]=h*m,e[1]=(s*c-u*i)*m,e[2]=(a*i-s*o)*m,e[3]=d*m,e[4]=(u*t-s*l)*m,e[5]=(s*r-a*t)*m,e[6]=f*m,e[7]=(i*l-c*t)*m,e[8]=(o*t-i*r)*m,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return ta("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(ah.makeScale(e,t)),this}rotate(e){return ta("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(ah.makeRotation(-e)),this}translate(e,t){return ta("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(ah.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},ah=new tt,mp=new tt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),gp=new tt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function ky(){let n={enabled:!0,workingColorSpace:ra,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Et&&(s.r=cs(s.r),s.g=cs(s.g),s.b=cs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Et&&(s.r=to(s.r),s.g=to(s.g),s.b=to(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===_s?oa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[ra]:{primaries:e,whitePoint:i,transfer:oa,toXYZ:mp,fromXYZ:gp,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:oi},outputColorSpaceConfig:{drawingBufferColorSpace:oi}},[oi]:{primaries:e,whitePoint:i,transfer:Et,toXYZ:mp,fromXYZ:gp,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:oi}}}),n}var xt=ky();function cs(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function to(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Vr,Bl=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{Vr===void 0&&(Vr=aa("canvas")),Vr.width=e.width,Vr.height=e.height;let s=Vr.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=Vr}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=aa("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=cs(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(cs(t[i]/255)*255):t[i]=cs(t[i]);return{data:t,width:e.width,height:e.height}}else return Xe("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},By=0,oo=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:By++}),this.uuid=_o(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(lh(s[o].image)):r.push(lh(s[o]))}else r=lh(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function lh(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Bl.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Xe("Texture: Unable to serialize Texture."),{})}var zy=0,ch=new H,Jn=class n extends Ci{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=Wi,s=Wi,r=qn,o=gs,a=Ii,l=jn,c=n.DEFAULT_ANISOTROPY,u=_s){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:zy++}),this.uuid=_o(),this.name="",this.source=new oo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new qe(0,0),this.repeat=new qe(1,1),this.center=new qe(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new tt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(ch).x}get height(){return this.source.getSize(ch).y}get depth(){return this.source.getSize(ch).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Xe(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Xe(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Yh)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Ol:e.x=e.x-Math.floor(e.x);break;case Wi:e.x=e.x<0?0:1;break;case Fl:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Ol:e.y=e.y-Math.floor(e.y);break;case Wi:e.y=e.y<0?0:1;break;case Fl:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Jn.DEFAULT_IMAGE=null;Jn.DEFAULT_MAPPING=Yh;Jn.DEFAULT_ANISOTROPY=1;var Zt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],h=l[8],d=l[1],f=l[5],p=l[9],m=l[2],g=l[6],x=l[10];if(Math.abs(u-d)<.01&&Math.abs(h-m)<.01&&Math.abs(p-g)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+m)<.1&&Math.abs(p+g)<.1&&Math.abs(c+f+x-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let M=(c+1)/2,v=(f+1)/2,E=(x+1)/2,A=(u+d)/4,y=(h+m)/4,S=(p+g)/4;return M>v&&M>E?M<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(M),s=A/i,r=y/i):v>E?v<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(v),i=A/s,r=S/s):E<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(E),i=y/r,s=S/r),this.set(i,s,r,t),this}let _=Math.sqrt((g-p)*(g-p)+(h-m)*(h-m)+(d-u)*(d-u));return Math.abs(_)<.001&&(_=1),this.x=(g-p)/_,this.y=(h-m)/_,this.z=(d-u)/_,this.w=Math.acos((c+f+x-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=ft(this.x,e.x,t.x),this.y=ft(this.y,e.y,t.y),this.z=ft(this.z,e.z,t.z),this.w=ft(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=ft(this.x,e,t),this.y=ft(this.y,e,t),this.z=ft(this.z,e,t),this.w=ft(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ft(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},zl=class extends Ci{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:qn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new Zt(0,0,e,t),this.scissorTest=!1,this.viewport=new Zt(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Jn({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:qn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new oo(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},ci=class extends zl{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},la=class extends Jn{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Pn,this.minFilter=Pn,this.wrapR=Wi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Vl=class extends Jn{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Pn,this.minFilter=Pn,this.wrapR=Wi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var pt=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,h,d,f,p,m,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,h,d,f,p,m,g)}set(e,t,i,s,r,o,a,l,c,u,h,d,f,p,m,g){let x=this.elements;return x[0]=e,x[4]=t,x[8]=i,x[12]=s,x[1]=r,x[5]=o,x[9]=a,x[13]=l,x[2]=c,x[6]=u,x[10]=h,x[14]=d,x[3]=f,x[7]=p,x[11]=m,x[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/Gr.setFromMatrixColumn(e,0).length(),r=1/Gr.setFromMatrixColumn(e,1).length(),o=1/Gr.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){let d=o*u,f=o*h,p=a*u,m=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=f+p*c,t[5]=d-m*c,t[9]=-a*l,t[2]=m-d*c,t[6]=p+f*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*u,f=l*h,p=c*u,m=c*h;t[0]=d+m*a,t[4]=p*a-f,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=f*a-p,t[6]=m+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*u,f=l*h,p=c*u,m=c*h;t[0]=d-m*a,t[4]=-o*h,t[8]=p+f*a,t[1]=f+p*a,t[5]=o*u,t[9]=m-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*u,f=o*h,p=a*u,m=a*h;t[0]=l*u,t[4]=p*c-f,t[8]=d*c+m,t[1]=l*h,t[5]=m*c+d,t[9]=f*c-p,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,f=o*c,p=a*l,m=a*c;t[0]=l*u,t[4]=m-d*h,t[8]=p*h+f,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=f*h+p,t[10]=d-m*h}else if(e.order==="XZY"){let d=o*l,f=o*c,p=a*l,m=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=d*h+m,t[5]=o*u,t[9]=f*h-p,t[2]=p*h-f,t[6]=a*u,t[10]=m*h+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Vy,e,Gy)}lookAt(e,t,i){let s=this.elements;return si.subVectors(e,t),si.lengthSq()===0&&(si.z=1),si.normalize(),Ls.crossVectors(i,si),Ls.lengthSq()===0&&(Math.abs(i.z)===1?si.x+=1e-4:si.z+=1e-4,si.normalize(),Ls.crossVectors(i,si)),Ls.normalize(),sl.crossVectors(si,Ls),s[0]=Ls.x,s[4]=sl.x,s[8]=si.x,s[1]=Ls.y,s[5]=sl.y,s[9]=si.y,s[2]=Ls.z,s[6]=sl.z,s[10]=si.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],d=i[9],f=i[13],p=i[2],m=i[6],g=i[10],x=i[14],_=i[3],M=i[7],v=i[11],E=i[15],A=s[0],y=s[4],S=s[8],P=s[12],L=s[1],I=s[5],O=s[9],k=s[13],N=s[2],V=s[6],X=s[10],G=s[14],oe=s[3],Z=s[7],Q=s[11],ie=s[15];return r[0]=o*A+a*L+l*N+c*oe,r[4]=o*y+a*I+l*V+c*Z,r[8]=o*S+a*O+l*X+c*Q,r[12]=o*P+a*k+l*G+c*ie,r[1]=u*A+h*L+d*N+f*oe,r[5]=u*y+h*I+d*V+f*Z,r[9]=u*S+h*O+d*X+f*Q,r[13]=u*P+h*k+d*G+f*ie,r[2]=p*A+m*L+g*N+x*oe,r[6]=p*y+m*I+g*V+x*Z,r[10]=p*S+m*O+g*X+x*Q,r[14]=p*P+m*k+g*G+x*ie,r[3]=_*A+M*L+v*N+E*oe,r[7]=_*y+M*I+v*V+E*Z,r[11]=_*S+M*O+v*X+E*Q,r[15]=_*P+M*k+v*G+E*ie,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],d=e[10],f=e[14],p=e[3],m=e[7],g=e[11],x=e[15],_=l*f-c*d,M=a*f-c*h,v=a*d-l*h,E=o*f-c*u,A=o*d-l*u,y=o*h-a*u;return t*(m*_-g*M+x*v)-i*(p*_-g*E+x*A)+s*(p*M-m*E+x*y)-r*(p*v-m*A+g*y)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],d=e[10],f=e[11],p=e[12],m=e[13],g=e[14],x=e[15],_=t*a-i*o,M=t*l-s*o,v=t*c-r*o,E=i*l-s*a,A=i*c-r*a,y=s*c-r*l,S=u*m-h*p,P=u*g-d*p,L=u*x-f*p,I=h*g-d*m,O=h*x-f*m,k=d*x-f*g,N=_*k-M*O+v*I+E*L-A*P+y*S;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/N;return e[0]=(a*k-l*O+c*I)*V,e[1]=(s*O-i*k-r*I)*V,e[2]=(m*y-g*A+x*E)*V,e[3]=(d*A-h*y-f*E)*V,e[4]=(l*L-o*k-c*P)*V,e[5]=(t*k-s*L+r*P)*V,e[6]=(g*v-p*y-x*M)*V,e[7]=(u*y-d*v+f*M)*V,e[8]=(o*O-a*L+c*S)*V,e[9]=(i*L-t*O-r*S)*V,e[10]=(p*A-m*v+x*_)*V,e[11]=(h*v-u*A-f*_)*V,e[12]=(a*P-o*I-l*S)*V,e[13]=(t*I-i*P+s*S)*V,e[14]=(m*M-p*E-g*_)*V,e[15]=(u*E-h*M+d*_)*V,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,h=a+a,d=r*c,f=r*u,p=r*h,m=o*u,g=o*h,x=a*h,_=l*c,M=l*u,v=l*h,E=i.x,A=i.y,y=i.z;return s[0]=(1-(m+x))*E,s[1]=(f+v)*E,s[2]=(p-M)*E,s[3]=0,s[4]=(f-v)*A,s[5]=(1-(d+x))*A,s[6]=(g+_)*A,s[7]=0,s[8]=(p+M)*y,s[9]=(g-_)*y,s[10]=(1-(d+m))*y,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=Gr.set(s[0],s[1],s[2]).length(),a=Gr.set(s[4],s[5],s[6]).length(),l=Gr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Ai.copy(this);let c=1/o,u=1/a,h=1/l;return Ai.elements[0]*=c,Ai.elements[1]*=c,Ai.elements[2]*=c,Ai.elements[4]*=u,Ai.elements[5]*=u,Ai.elements[6]*=u,Ai.elements[8]*=h,Ai.elements[9]*=h,Ai.elements[10]*=h,t.setFromRotationMatrix(Ai),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=_i,l=!1){let c=this.elements,u=2*r/(t-e),h=2*r/(i-s),d=(t+e)/(t-e),f=(i+s)/(i-s),p,m;if(l)p=r/(o-r),m=o*r/(o-r);else if(a===_i)p=-(o+r)/(o-r),m=-2*o*r/(o-r);else if(a===io)p=-o/(o-r),m=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=h,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=m,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=_i,l=!1){let c=this.elements,u=2/(t-e),h=2/(i-s),d=-(t+e)/(t-e),f=-(i+s)/(i-s),p,m;if(l)p=1/(o-r),m=o/(o-r);else if(a===_i)p=-2/(o-r),m=-(o+r)/(o-r);else if(a===io)p=-1/(o-r),m=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=h,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=m,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},Gr=new H,Ai=new pt,Vy=new H(0,0,0),Gy=new H(1,1,1),Ls=new H,sl=new H,si=new H,xp=new pt,_p=new li,hs=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(ft(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ft(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(ft(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ft(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ft(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-ft(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:Xe("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return xp.makeRotationFromQuaternion(e),this.setFromRotationMatrix(xp,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return _p.setFromEuler(this),this.setFromQuaternion(_p,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};hs.DEFAULT_ORDER="XYZ";var ao=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},Hy=0,yp=new H,Hr=new li,ss=new pt,rl=new H,Yo=new H,Wy=new H,$y=new li,vp=new H(1,0,0),bp=new H(0,1,0),Sp=new H(0,0,1),Mp={type:"added"},Xy={type:"removed"},Wr={type:"childadded",child:null},uh={type:"childremoved",child:null},Nn=class n extends Ci{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Hy++}),this.uuid=_o(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new H,t=new hs,i=new li,s=new H(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new pt},normalMatrix:{value:new tt}}),this.matrix=new pt,this.matrixWorld=new pt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ao,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Hr.setFromAxisAngle(e,t),this.quaternion.multiply(Hr),this}rotateOnWorldAxis(e,t){return Hr.setFromAxisAngle(e,t),this.quaternion.premultiply(Hr),this}rotateX(e){return this.rotateOnAxis(vp,e)}rotateY(e){return this.rotateOnAxis(bp,e)}rotateZ(e){return this.rotateOnAxis(Sp,e)}translateOnAxis(e,t){return yp.copy(e).applyQuaternion(this.quaternion),this.position.add(yp.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(vp,e)}translateY(e){return this.translateOnAxis(bp,e)}translateZ(e){return this.translateOnAxis(Sp,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(ss.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?rl.copy(e):rl.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Yo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ss.lookAt(Yo,rl,this.up):ss.lookAt(rl,Yo,this.up),this.quaternion.setFromRotationMatrix(ss),s&&(ss.extractRotation(s.matrixWorld),Hr.setFromRotationMatrix(ss),this.quaternion.premultiply(Hr.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(je("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Mp),Wr.child=e,this.dispatchEvent(Wr),Wr.child=null):je("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Xy),uh.child=e,this.dispatchEvent(uh),uh.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),ss.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),ss.multiply(e.parent.matrixWorld)),e.applyMatrix4(ss),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Mp),Wr.child=e,this.dispatchEvent(Wr),Wr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Yo,e,Wy),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Yo,$y,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),d=o(e.skeletons),f=o(e.animations),p=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Nn.DEFAULT_UP=new H(0,1,0);Nn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Nn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var kn=class extends Nn{constructor(){super(),this.isGroup=!0,this.type="Group"}},qy={type:"move"},lo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new kn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new kn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new H,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new H),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new kn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new H,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new H,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let m of e.hand.values()){let g=t.getJointPose(m,i),x=this._getHandJoint(c,m);g!==null&&(x.matrix.fromArray(g.transform.matrix),x.matrix.decompose(x.position,x.quaternion,x.scale),x.matrixWorldNeedsUpdate=!0,x.jointRadius=g.radius),x.visible=g!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,p=.005;c.inputState.pinching&&d>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(qy)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new kn;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},Rm={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ns={h:0,s:0,l:0},ol={h:0,s:0,l:0};function hh(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var Qe=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=oi){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,xt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=xt.workingColorSpace){return this.r=e,this.g=t,this.b=i,xt.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=xt.workingColorSpace){if(e=ld(e,1),t=ft(t,0,1),i=ft(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=hh(o,r,e+1/3),this.g=hh(o,r,e),this.b=hh(o,r,e-1/3)}return xt.colorSpaceToWorking(this,s),this}setStyle(e,t=oi){function i(r){r!==void 0&&parseFloat(r)<1&&Xe("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Xe("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Xe("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=oi){let i=Rm[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Xe("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=cs(e.r),this.g=cs(e.g),this.b=cs(e.b),this}copyLinearToSRGB(e){return this.r=to(e.r),this.g=to(e.g),this.b=to(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=oi){return xt.workingToColorSpace(Fn.copy(this),e),Math.round(ft(Fn.r*255,0,255))*65536+Math.round(ft(Fn.g*255,0,255))*256+Math.round(ft(Fn.b*255,0,255))}getHexString(e=oi){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=xt.workingColorSpace){xt.workingToColorSpace(Fn.copy(this),t);let i=Fn.r,s=Fn.g,r=Fn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=xt.workingColorSpace){return xt.workingToColorSpace(Fn.copy(this),t),e.r=Fn.r,e.g=Fn.g,e.b=Fn.b,e}getStyle(e=oi){xt.workingToColorSpace(Fn.copy(this),e);let t=Fn.r,i=Fn.g,s=Fn.b;return e!==oi?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(Ns),this.setHSL(Ns.h+e,Ns.s+t,Ns.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Ns),e.getHSL(ol);let i=ia(Ns.h,ol.h,t),s=ia(Ns.s,ol.s,t),r=ia(Ns.l,ol.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Fn=new Qe;Qe.NAMES=Rm;var ca=class extends Nn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new hs,this.environmentIntensity=1,this.environmentRotation=new hs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Ei=new H,rs=new H,dh=new H,os=new H,$r=new H,Xr=new H,wp=new H,fh=new H,ph=new H,mh=new H,gh=new Zt,xh=new Zt,_h=new Zt,Fs=class n{constructor(e=new H,t=new H,i=new H){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Ei.subVectors(e,t),s.cross(Ei);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Ei.subVectors(s,t),rs.subVectors(i,t),dh.subVectors(e,t);let o=Ei.dot(Ei),a=Ei.dot(rs),l=Ei.dot(dh),c=rs.dot(rs),u=rs.dot(dh),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let d=1/h,f=(c*l-a*u)*d,p=(o*u-a*l)*d;return r.set(1-f-p,p,f)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,os)===null?!1:os.x>=0&&os.y>=0&&os.x+os.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,os)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,os.x),l.addScaledVector(o,os.y),l.addScaledVector(a,os.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return gh.setScalar(0),xh.setScalar(0),_h.setScalar(0),gh.fromBufferAttribute(e,t),xh.fromBufferAttribute(e,i),_h.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(gh,r.x),o.addScaledVector(xh,r.y),o.addScaledVector(_h,r.z),o}static isFrontFacing(e,t,i,s){return Ei.subVectors(i,t),rs.subVectors(e,t),Ei.cross(rs).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Ei.subVectors(this.c,this.b),rs.subVectors(this.a,this.b),Ei.cross(rs).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;$r.subVectors(s,i),Xr.subVectors(r,i),fh.subVectors(e,i);let l=$r.dot(fh),c=Xr.dot(fh);if(l<=0&&c<=0)return t.copy(i);ph.subVectors(e,s);let u=$r.dot(ph),h=Xr.dot(ph);if(u>=0&&h<=u)return t.copy(s);let d=l*h-u*c;if(d<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector($r,o);mh.subVectors(e,r);let f=$r.dot(mh),p=Xr.dot(mh);if(p>=0&&f<=p)return t.copy(r);let m=f*c-l*p;if(m<=0&&c>=0&&p<=0)return a=c/(c-p),t.copy(i).addScaledVector(Xr,a);let g=u*p-f*h;if(g<=0&&h-u>=0&&f-p>=0)return wp.subVectors(r,s),a=(h-u)/(h-u+(f-p)),t.copy(s).addScaledVector(wp,a);let x=1/(g+m+d);return o=m*x,a=d*x,t.copy(i).addScaledVector($r,o).addScaledVector(Xr,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},$i=class{constructor(e=new H(1/0,1/0,1/0),t=new H(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Ti.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Ti.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Ti.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Ti):Ti.fromBufferAttribute(r,o),Ti.applyMatrix4(e.matrixWorld),this.expandByPoint(Ti);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),al.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),al.copy(i.boundingBox)),al.applyMatrix4(e.matrixWorld),this.union(al)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Ti),Ti.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Zo),ll.subVectors(this.max,Zo),qr.subVectors(e.a,Zo),Yr.subVectors(e.b,Zo),Zr.subVectors(e.c,Zo),Ds.subVectors(Yr,qr),Us.subVectors(Zr,Yr),cr.subVectors(qr,Zr);let t=[0,-Ds.z,Ds.y,0,-Us.z,Us.y,0,-cr.z,cr.y,Ds.z,0,-Ds.x,Us.z,0,-Us.x,cr.z,0,-cr.x,-Ds.y,Ds.x,0,-Us.y,Us.x,0,-cr.y,cr.x,0];return!yh(t,qr,Yr,Zr,ll)||(t=[1,0,0,0,1,0,0,0,1],!yh(t,qr,Yr,Zr,ll))?!1:(cl.crossVectors(Ds,Us),t=[cl.x,cl.y,cl.z],yh(t,qr,Yr,Zr,ll))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Ti).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Ti).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(as[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),as[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),as[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),as[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),as[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),as[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),as[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),as[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(as),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},as=[new H,new H,new H,new H,new H,new H,new H,new H],Ti=new H,al=new $i,qr=new H,Yr=new H,Zr=new H,Ds=new H,Us=new H,cr=new H,Zo=new H,ll=new H,cl=new H,ur=new H;function yh(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){ur.fromArray(n,r);let a=s.x*Math.abs(ur.x)+s.y*Math.abs(ur.y)+s.z*Math.abs(ur.z),l=e.dot(ur),c=t.dot(ur),u=i.dot(ur);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var pn=new H,ul=new qe,Yy=0,on=class extends Ci{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Yy++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=Sm,this.updateRanges=[],this.gpuType=yi,this.version=0,this._normalizationScale=e!==void 0?ud(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)ul.fromBufferAttribute(this,t),ul.applyMatrix3(e),this.setXY(t,ul.x,ul.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)pn.fromBufferAttribute(this,t),pn.applyMatrix3(e),this.setXYZ(t,pn.x,pn.y,pn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)pn.fromBufferAttribute(this,t),pn.applyMatrix4(e),this.setXYZ(t,pn.x,pn.y,pn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)pn.fromBufferAttribute(this,t),pn.applyNormalMatrix(e),this.setXYZ(t,pn.x,pn.y,pn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)pn.fromBufferAttribute(this,t),pn.transformDirection(e),this.setXYZ(t,pn.x,pn.y,pn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Tm(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Cm(e,this.array)}};var ua=class extends on{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var ha=class extends on{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var nn=class extends on{constructor(e,t,i){super(new Float32Array(e),t,i)}},Zy=new $i,Ko=new H,vh=new H,ds=class{constructor(e=new H,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):Zy.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Ko.subVectors(e,this.center);let t=Ko.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(Ko,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(vh.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Ko.copy(e.center).add(vh)),this.expandByPoint(Ko.copy(e.center).sub(vh))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},Ky=0,xi=new pt,bh=new Nn,Kr=new H,ri=new $i,Jo=new $i,Rn=new H,_n=class n extends Ci{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Ky++}),this.uuid=_o(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(by(e)?ha:ua)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new tt().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return xi.makeRotationFromQuaternion(e),this.applyMatrix4(xi),this}rotateX(e){return xi.makeRotationX(e),this.applyMatrix4(xi),this}rotateY(e){return xi.makeRotationY(e),this.applyMatrix4(xi),this}rotateZ(e){return xi.makeRotationZ(e),this.applyMatrix4(xi),this}translate(e,t,i){return xi.makeTranslation(e,t,i),this.applyMatrix4(xi),this}scale(e,t,i){return xi.makeScale(e,t,i),this.applyMatrix4(xi),this}lookAt(e){return bh.lookAt(e),bh.updateMatrix(),this.applyMatrix4(bh.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Kr).negate(),this.translate(Kr.x,Kr.y,Kr.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new nn(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Xe("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new $i);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){je("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new H(-1/0,-1/0,-1/0),new H(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];ri.setFromBufferAttribute(r),this.morphTargetsRelative?(Rn.addVectors(this.boundingBox.min,ri.min),this.boundingBox.expandByPoint(Rn),Rn.addVectors(this.boundingBox.max,ri.max),this.boundingBox.expandByPoint(Rn)):(this.boundingBox.expandByPoint(ri.min),this.boundingBox.expandByPoint(ri.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&je('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ds);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){je("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new H,1/0);return}if(e){let i=this.boundingSphere.center;if(ri.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Jo.setFromBufferAttribute(a),this.morphTargetsRelative?(Rn.addVectors(ri.min,Jo.min),ri.expandByPoint(Rn),Rn.addVectors(ri.max,Jo.max),ri.expandByPoint(Rn)):(ri.expandByPoint(Jo.min),ri.expandByPoint(Jo.max))}ri.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Rn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Rn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Rn.fromBufferAttribute(a,c),l&&(Kr.fromBufferAttribute(e,c),Rn.add(Kr)),s=Math.max(s,i.distanceToSquared(Rn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&je('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){je("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new on(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let P=0;P<i.count;P++)a[P]=new H,l[P]=new H;let u=new H,h=new H,d=new H,f=new qe,p=new qe,m=new qe,g=new H,x=new H;function _(P,L,I){c[P]=c[L]=c[I]=1,u.fromBufferAttribute(i,P),h.fromBufferAttribute(i,L),d.fromBufferAttribute(i,I),f.fromBufferAttribute(r,P),p.fromBufferAttribute(r,L),m.fromBufferAttribute(r,I),h.sub(u),d.sub(u),p.sub(f),m.sub(f);let O=1/(p.x*m.y-m.x*p.y);isFinite(O)&&(g.copy(h).multiplyScalar(m.y).addScaledVector(d,-p.y).multiplyScalar(O),x.copy(d).multiplyScalar(p.x).addScaledVector(h,-m.x).multiplyScalar(O),a[P].add(g),a[L].add(g),a[I].add(g),l[P].add(x),l[L].add(x),l[I].add(x))}let M=this.groups;M.length===0&&(M=[{start:0,count:e.count}]);for(let P=0,L=M.length;P<L;++P){let I=M[P],O=I.start,k=I.count;for(let N=O,V=O+k;N<V;N+=3)_(e.getX(N+0),e.getX(N+1),e.getX(N+2))}let v=new H,E=new H,A=new H,y=new H;function S(P){A.fromBufferAttribute(s,P),y.copy(A);let L=a[P];v.copy(L),v.sub(A.multiplyScalar(A.dot(L))).normalize(),E.crossVectors(y,L);let O=E.dot(l[P])<0?-1:1;o.setXYZW(P,v.x,v.y,v.z,O)}for(let P=0,L=i.count;P<L;++P)c[P]&&S(P);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new on(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let s=new H,r=new H,o=new H,a=new H,l=new H,c=new H,u=new H,h=new H;if(e)for(let d=0,f=e.count;d<f;d+=3){let p=e.getX(d+0),m=e.getX(d+1),g=e.getX(d+2);s.fromBufferAttribute(t,p),r.fromBufferAttribute(t,m),o.fromBufferAttribute(t,g),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,p),l.fromBufferAttribute(i,m),c.fromBufferAttribute(i,g),a.add(u),l.add(u),c.add(u),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(m,l.x,l.y,l.z),i.setXYZ(g,c.x,c.y,c.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(d+0,u.x,u.y,u.z),i.setXYZ(d+1,u.x,u.y,u.z),i.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Rn.fromBufferAttribute(e,t),Rn.normalize(),e.setXYZ(t,Rn.x,Rn.y,Rn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,d=new c.constructor(l.length*u),f=0,p=0;for(let m=0,g=l.length;m<g;m++){a.isInterleavedBufferAttribute?f=l[m]*a.data.stride+a.offset:f=l[m]*u;for(let x=0;x<u;x++)d[p++]=c[f++]}return new on(d,u,h)}if(this.index===null)return Xe("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let d=c[u],f=e(d,i);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,d=c.length;h<d;h++){let f=c[h];u.push(f.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],h=r[c];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Sh=new H,Jy=new H,jy=new tt,ai=class{constructor(e=new H(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=Sh.subVectors(i,t).cross(Jy.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(Sh),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||jy.getNormalMatrix(e),s=this.coplanarPoint(Sh).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},Qy=0,fs=class extends Ci{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Qy++}),this.uuid=_o(),this.name="",this.type="Material",this.blending=mo,this.side=Xs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Bh,this.blendDst=zh,this.blendEquation=xr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Qe(0,0,0),this.blendAlpha=0,this.depthFunc=no,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=gm,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Cl,this.stencilZFail=Cl,this.stencilZPass=Cl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Xe(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Xe(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Qe().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new ai().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new qe().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new qe().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var ls=new H,Mh=new H,hl=new H,dl=new H,ks=class{constructor(e=new H,t=new H(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,ls)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=ls.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(ls.copy(this.origin).addScaledVector(this.direction,t),ls.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){Mh.copy(e).add(t).multiplyScalar(.5),hl.copy(t).sub(e).normalize(),dl.copy(this.origin).sub(Mh);let r=e.distanceTo(t)*.5,o=-this.direction.dot(hl),a=dl.dot(this.direction),l=-dl.dot(hl),c=dl.lengthSq(),u=Math.abs(1-o*o),h,d,f,p;if(u>0)if(h=o*l-a,d=o*a-l,p=r*u,h>=0)if(d>=-p)if(d<=p){let m=1/u;h*=m,d*=m,f=h*(h+o*d+2*a)+d*(o*h+d+2*l)+c}else d=r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d=-r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d<=-p?(h=Math.max(0,-(-o*r+a)),d=h>0?-r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c):d<=p?(h=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(h=Math.max(0,-(o*r+a)),d=h>0?r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c);else d=o>0?-r:r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Mh).addScaledVector(hl,d),f}intersectSphere(e,t){if(e.radius<0)return null;ls.subVectors(e.center,this.origin);let i=ls.dot(this.direction),s=ls.dot(ls)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return c>=0?(i=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(i=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),u>=0?(r=(e.min.y-d.y)*u,o=(e.max.y-d.y)*u):(r=(e.max.y-d.y)*u,o=(e.min.y-d.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-d.z)*h,l=(e.max.z-d.z)*h):(a=(e.max.z-d.z)*h,l=(e.min.z-d.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,ls)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=e.x-o.x,d=e.y-o.y,f=e.z-o.z,p=t.x-o.x,m=t.y-o.y,g=t.z-o.z,x=i.x-o.x,_=i.y-o.y,M=i.z-o.z,v=Math.abs(l),E=Math.abs(c),A=Math.abs(u),y,S,P,L,I,O,k,N,V,X,G,oe;if(v>=E&&v>=A?(P=l,O=h,V=p,oe=x,l>=0?(y=c,S=u,L=d,I=f,k=m,N=g,X=_,G=M):(y=u,S=c,L=f,I=d,k=g,N=m,X=M,G=_)):E>=A?(P=c,O=d,V=m,oe=_,c>=0?(y=u,S=l,L=f,I=h,k=g,N=p,X=M,G=x):(y=l,S=u,L=h,I=f,k=p,N=g,X=x,G=M)):(P=u,O=f,V=g,oe=M,u>=0?(y=l,S=c,L=h,I=d,k=p,N=m,X=x,G=_):(y=c,S=l,L=d,I=h,k=m,N=p,X=_,G=x)),P===0)return null;let Z=y/P,Q=S/P,ie=1/P,fe=L-Z*O,de=I-Q*O,ee=k-Z*V,he=N-Q*V,ge=X-Z*oe,Se=G-Q*oe,Me=ge*he-Se*ee,He=fe*Se-de*ge,st=ee*de-he*fe;if(s){if(Me<0||He<0||st<0)return null}else if((Me<0||He<0||st<0)&&(Me>0||He>0||st>0))return null;let Ve=Me+He+st;if(Ve===0)return null;let ut=ie*(Me*O+He*V+st*oe);return(Ve>0?ut<0:ut>0)?null:this.at(ut/Ve,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},fr=class extends fs{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Qe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new hs,this.combine=ac,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},Ap=new pt,hr=new ks,fl=new ds,Ep=new H,pl=new H,ml=new H,gl=new H,wh=new H,xl=new H,Tp=new H,_l=new H,Dn=class extends Nn{constructor(e=new _n,t=new fr){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){xl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(wh.fromBufferAttribute(h,e),o?xl.addScaledVector(wh,u):xl.addScaledVector(wh.sub(t),u))}t.add(xl)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),fl.copy(i.boundingSphere),fl.applyMatrix4(r),hr.copy(e.ray).recast(e.near),!(fl.containsPoint(hr.origin)===!1&&(hr.intersectSphere(fl,Ep)===null||hr.origin.distanceToSquared(Ep)>(e.far-e.near)**2))&&(Ap.copy(r).invert(),hr.copy(e.ray).applyMatrix4(Ap),!(i.boundingBox!==null&&hr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,hr)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,m=d.length;p<m;p++){let g=d[p],x=o[g.materialIndex],_=Math.max(g.start,f.start),M=Math.min(a.count,Math.min(g.start+g.count,f.start+f.count));for(let v=_,E=M;v<E;v+=3){let A=a.getX(v),y=a.getX(v+1),S=a.getX(v+2);s=yl(this,x,e,i,c,u,h,A,y,S),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),m=Math.min(a.count,f.start+f.count);for(let g=p,x=m;g<x;g+=3){let _=a.getX(g),M=a.getX(g+1),v=a.getX(g+2);s=yl(this,o,e,i,c,u,h,_,M,v),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,m=d.length;p<m;p++){let g=d[p],x=o[g.materialIndex],_=Math.max(g.start,f.start),M=Math.min(l.count,Math.min(g.start+g.count,f.start+f.count));for(let v=_,E=M;v<E;v+=3){let A=v,y=v+1,S=v+2;s=yl(this,x,e,i,c,u,h,A,y,S),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),m=Math.min(l.count,f.start+f.count);for(let g=p,x=m;g<x;g+=3){let _=g,M=g+1,v=g+2;s=yl(this,o,e,i,c,u,h,_,M,v),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}}};function ev(n,e,t,i,s,r,o,a){let l;if(e.side===Yn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===Xs,a),l===null)return null;_l.copy(a),_l.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(_l);return c<t.near||c>t.far?null:{distance:c,point:_l.clone(),object:n}}function yl(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,pl),n.getVertexPosition(l,ml),n.getVertexPosition(c,gl);let u=ev(n,e,t,i,pl,ml,gl,Tp);if(u){let h=new H;Fs.getBarycoord(Tp,pl,ml,gl,h),s&&(u.uv=Fs.getInterpolatedAttribute(s,a,l,c,h,new qe)),r&&(u.uv1=Fs.getInterpolatedAttribute(r,a,l,c,h,new qe)),o&&(u.normal=Fs.getInterpolatedAttribute(o,a,l,c,h,new H),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new H,materialIndex:0};Fs.getNormal(pl,ml,gl,d.normal),u.face=d,u.barycoord=h}return u}var da=class extends Jn{constructor(e=null,t=1,i=1,s,r,o,a,l,c=Pn,u=Pn,h,d){super(null,o,a,l,c,u,s,r,h,d),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var fa=class extends on{constructor(e,t,i,s=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},Jr=new pt,Cp=new pt,vl=[],Rp=new $i,tv=new pt,jo=new Dn,Qo=new ds,ui=class extends Dn{constructor(e,t,i){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new fa(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,tv)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new $i),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,Jr),Rp.copy(e.boundingBox).applyMatrix4(Jr),this.boundingBox.union(Rp)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new ds),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,Jr),Qo.copy(e.boundingSphere).applyMatrix4(Jr),this.boundingSphere.union(Qo)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let i=t.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=e*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(e,t){let i=this.matrixWorld,s=this.count;if(jo.geometry=this.geometry,jo.material=this.material,jo.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Qo.copy(this.boundingSphere),Qo.applyMatrix4(i),e.ray.intersectsSphere(Qo)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Jr),Cp.multiplyMatrices(i,Jr),jo.matrixWorld=Cp,jo.raycast(e,vl);for(let o=0,a=vl.length;o<a;o++){let l=vl[o];l.instanceId=r,l.object=this,t.push(l)}vl.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new fa(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let i=t.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new da(new Float32Array(s*this.count),s,this.count,pc,yi));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*e;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},dr=new ds,nv=new qe(.5,.5),bl=new H,Bs=class{constructor(e=new ai,t=new ai,i=new ai,s=new ai,r=new ai,o=new ai){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=_i,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],d=r[6],f=r[7],p=r[8],m=r[9],g=r[10],x=r[11],_=r[12],M=r[13],v=r[14],E=r[15];if(s[0].setComponents(c-o,f-u,x-p,E-_).normalize(),s[1].setComponents(c+o,f+u,x+p,E+_).normalize(),s[2].setComponents(c+a,f+h,x+m,E+M).normalize(),s[3].setComponents(c-a,f-h,x-m,E-M).normalize(),i)s[4].setComponents(l,d,g,v).normalize(),s[5].setComponents(c-l,f-d,x-g,E-v).normalize();else if(s[4].setComponents(c-l,f-d,x-g,E-v).normalize(),t===_i)s[5].setComponents(c+l,f+d,x+g,E+v).normalize();else if(t===io)s[5].setComponents(l,d,g,v).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),dr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),dr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(dr)}intersectsSprite(e){dr.center.set(0,0,0);let t=nv.distanceTo(e.center);return dr.radius=.7071067811865476+t,dr.applyMatrix4(e.matrixWorld),this.intersectsSphere(dr)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(bl.x=s.normal.x>0?e.max.x:e.min.x,bl.y=s.normal.y>0?e.max.y:e.min.y,bl.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(bl)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Pp=new pt,Gl=class n{constructor(){this.coordinateSystem=_i,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];Pp.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Bs),i[s].setFromProjectionMatrix(Pp,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Bs),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var zs=class extends fs{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Qe(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Hl=new H,Wl=new H,Ip=new pt,ea=new ks,Sl=new ds,Ah=new H,Lp=new H,$l=class extends Nn{constructor(e=new _n,t=new zs){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)Hl.fromBufferAttribute(t,s-1),Wl.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=Hl.distanceTo(Wl);e.setAttribute("lineDistance",new nn(i,1))}else Xe("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Sl.copy(i.boundingSphere),Sl.applyMatrix4(s),Sl.radius+=r,e.ray.intersectsSphere(Sl)===!1)return;Ip.copy(s).invert(),ea.copy(e.ray).applyMatrix4(Ip);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,d=i.attributes.position;if(u!==null){let f=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let m=f,g=p-1;m<g;m+=c){let x=u.getX(m),_=u.getX(m+1),M=Ml(this,e,ea,l,x,_,m);M&&t.push(M)}if(this.isLineLoop){let m=u.getX(p-1),g=u.getX(f),x=Ml(this,e,ea,l,m,g,p-1);x&&t.push(x)}}else{let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let m=f,g=p-1;m<g;m+=c){let x=Ml(this,e,ea,l,m,m+1,m);x&&t.push(x)}if(this.isLineLoop){let m=Ml(this,e,ea,l,p-1,f,p-1);m&&t.push(m)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Ml(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(Hl.fromBufferAttribute(a,s),Wl.fromBufferAttribute(a,r),t.distanceSqToSegment(Hl,Wl,Ah,Lp)>i)return;Ah.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Ah);if(!(c<e.near||c>e.far))return{distance:c,point:Lp.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var Np=new H,Dp=new H,pr=class extends $l{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)Np.fromBufferAttribute(t,s),Dp.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+Np.distanceTo(Dp);e.setAttribute("lineDistance",new nn(i,1))}else Xe("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var pa=class extends Jn{constructor(e=[],t=_r,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var ps=class extends Jn{constructor(e,t,i=Ri,s,r,o,a=Pn,l=Pn,c,u=us,h=1){if(u!==us&&u!==xs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:h};super(d,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new oo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},ma=class extends ps{constructor(e,t=Ri,i=_r,s,r,o=Pn,a=Pn,l,c=us){let u={width:e,height:e,depth:1},h=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},ga=class extends Jn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},co=class n extends _n{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],d=0,f=0;p("z","y","x",-1,-1,i,t,e,o,r,0),p("z","y","x",1,-1,i,t,-e,o,r,1),p("x","z","y",1,1,e,i,t,s,o,2),p("x","z","y",1,-1,e,i,-t,s,o,3),p("x","y","z",1,-1,e,t,i,s,r,4),p("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new nn(c,3)),this.setAttribute("normal",new nn(u,3)),this.setAttribute("uv",new nn(h,2));function p(m,g,x,_,M,v,E,A,y,S,P){let L=v/y,I=E/S,O=v/2,k=E/2,N=A/2,V=y+1,X=S+1,G=0,oe=0,Z=new H;for(let Q=0;Q<X;Q++){let ie=Q*I-k;for(let fe=0;fe<V;fe++){let de=fe*L-O;Z[m]=de*_,Z[g]=ie*M,Z[x]=N,c.push(Z.x,Z.y,Z.z),Z[m]=0,Z[g]=0,Z[x]=A>0?1:-1,u.push(Z.x,Z.y,Z.z),h.push(fe/y),h.push(1-Q/S),G+=1}}for(let Q=0;Q<S;Q++)for(let ie=0;ie<y;ie++){let fe=d+ie+V*Q,de=d+ie+V*(Q+1),ee=d+(ie+1)+V*(Q+1),he=d+(ie+1)+V*Q;l.push(fe,de,he),l.push(de,ee,he),oe+=6}a.addGroup(f,oe,P),f+=oe,d+=G}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Xi=class n extends _n{constructor(e=1,t=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],d=[],f=[],p=0,m=[],g=i/2,x=0;_(),o===!1&&(e>0&&M(!0),t>0&&M(!1)),this.setIndex(u),this.setAttribute("position",new nn(h,3)),this.setAttribute("normal",new nn(d,3)),this.setAttribute("uv",new nn(f,2));function _(){let v=new H,E=new H,A=0,y=(t-e)/i;for(let S=0;S<=r;S++){let P=[],L=S/r,I=L*(t-e)+e;for(let O=0;O<=s;O++){let k=O/s,N=k*l+a,V=Math.sin(N),X=Math.cos(N);E.x=I*V,E.y=-L*i+g,E.z=I*X,h.push(E.x,E.y,E.z),v.set(V,y,X).normalize(),d.push(v.x,v.y,v.z),f.push(k,1-L),P.push(p++)}m.push(P)}for(let S=0;S<s;S++)for(let P=0;P<r;P++){let L=m[P][S],I=m[P+1][S],O=m[P+1][S+1],k=m[P][S+1];(e>0||P!==0)&&(u.push(L,I,k),A+=3),(t>0||P!==r-1)&&(u.push(I,O,k),A+=3)}c.addGroup(x,A,0),x+=A}function M(v){let E=p,A=new qe,y=new H,S=0,P=v===!0?e:t,L=v===!0?1:-1;for(let O=1;O<=s;O++)h.push(0,g*L,0),d.push(0,L,0),f.push(.5,.5),p++;let I=p;for(let O=0;O<=s;O++){let N=O/s*l+a,V=Math.cos(N),X=Math.sin(N);y.x=P*X,y.y=g*L,y.z=P*V,h.push(y.x,y.y,y.z),d.push(0,L,0),A.x=V*.5+.5,A.y=X*.5*L+.5,f.push(A.x,A.y),p++}for(let O=0;O<s;O++){let k=E+O,N=I+O;v===!0?u.push(N,N+1,k):u.push(N+1,N,k),S+=3}c.addGroup(x,S,v===!0?1:2),x+=S}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},xa=class n extends Xi{constructor(e=1,t=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new n(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var _a=class n extends _n{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=e/a,d=t/l,f=[],p=[],m=[],g=[];for(let x=0;x<u;x++){let _=x*d-o;for(let M=0;M<c;M++){let v=M*h-r;p.push(v,-_,0),m.push(0,0,1),g.push(M/a),g.push(1-x/l)}}for(let x=0;x<l;x++)for(let _=0;_<a;_++){let M=_+c*x,v=_+c*(x+1),E=_+1+c*(x+1),A=_+1+c*x;f.push(M,v,A),f.push(v,E,A)}this.setIndex(f),this.setAttribute("position",new nn(p,3)),this.setAttribute("normal",new nn(m,3)),this.setAttribute("uv",new nn(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var uo=class n extends _n{constructor(e=1,t=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new H,d=new H,f=[],p=[],m=[],g=[];for(let x=0;x<=i;x++){let _=[],M=x/i,v=o+M*a,E=e*Math.cos(v),A=Math.sqrt(e*e-E*E),y=0;x===0&&o===0?y=.5/t:x===i&&l===Math.PI&&(y=-.5/t);for(let S=0;S<=t;S++){let P=S/t,L=s+P*r;h.x=-A*Math.cos(L),h.y=E,h.z=A*Math.sin(L),p.push(h.x,h.y,h.z),d.copy(h).normalize(),m.push(d.x,d.y,d.z),g.push(P+y,1-M),_.push(c++)}u.push(_)}for(let x=0;x<i;x++)for(let _=0;_<t;_++){let M=u[x][_+1],v=u[x][_],E=u[x+1][_],A=u[x+1][_+1];(x!==0||o>0)&&f.push(M,v,A),(x!==i-1||l<Math.PI)&&f.push(v,E,A)}this.setIndex(f),this.setAttribute("position",new nn(p,3)),this.setAttribute("normal",new nn(m,3)),this.setAttribute("uv",new nn(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};function vr(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(Up(s))s.isRenderTargetTexture?(Xe("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(Up(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function zn(n){let e={};for(let t=0;t<n.length;t++){let i=vr(n[t]);for(let s in i)e[s]=i[s]}return e}function Up(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function iv(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function dd(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:xt.workingColorSpace}var Pm={clone:vr,merge:zn},sv=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,rv=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,qi=class extends fs{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=sv,this.fragmentShader=rv,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=vr(e.uniforms),this.uniformsGroups=iv(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new Qe().setHex(s.value);break;case"v2":this.uniforms[i].value=new qe().fromArray(s.value);break;case"v3":this.uniforms[i].value=new H().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Zt().fromArray(s.value);break;case"m3":this.uniforms[i].value=new tt().fromArray(s.value);break;case"m4":this.uniforms[i].value=new pt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Xl=class extends qi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var ms=class extends fs{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Qe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Qe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Yc,this.normalScale=new qe(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new hs,this.combine=ac,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},ql=class extends fs{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=pm,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Yl=class extends fs{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function jr(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function wl(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Vs=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break e}o=i,i=0;break t}break n}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Zl=class extends Vs{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Ch,endingEnd:Ch}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Rh:r=e,a=2*t-i;break;case Ph:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Rh:o=e,l=2*i-t;break;case Ph:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(i-t)/(s-t),m=p*p,g=m*p,x=-d*g+2*d*m-d*p,_=(1+d)*g+(-1.5-2*d)*m+(-.5+d)*p+1,M=(-1-f)*g+(1.5+f)*m+.5*p,v=f*g-f*m;for(let E=0;E!==a;++E)r[E]=x*o[u+E]+_*o[c+E]+M*o[l+E]+v*o[h+E];return r}},Kl=class extends Vs{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),h=1-u;for(let d=0;d!==a;++d)r[d]=o[c+d]*h+o[l+d]*u;return r}},Jl=class extends Vs{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},jl=class extends Vs{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let p=(i-t)/(s-t),m=1-p;for(let g=0;g!==a;++g)r[g]=o[c+g]*m+o[l+g]*p;return r}let d=a*2,f=e-1;for(let p=0;p!==a;++p){let m=o[c+p],g=o[l+p],x=f*d+p*2,_=h[x],M=h[x+1],v=e*d+p*2,E=u[v],A=u[v+1],y=av(i,t,_,E,s);r[p]=Im(y,m,M,A,g)}return r}};function Im(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function ov(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function av(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=Im(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=ov(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var hi=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=jr(t,this.TimeBufferType),this.values=jr(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:jr(e.times,Array),values:jr(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),wl(e.settings)&&(i.settings={inTangents:jr(e.settings.inTangents,Array),outTangents:jr(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new Jl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Kl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Zl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new jl(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case sa:t=this.InterpolantFactoryMethodDiscrete;break;case kl:t=this.InterpolantFactoryMethodLinear;break;case Tl:t=this.InterpolantFactoryMethodSmooth;break;case Th:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Xe("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return sa;case this.InterpolantFactoryMethodLinear:return kl;case this.InterpolantFactoryMethodSmooth:return Tl;case this.InterpolantFactoryMethodBezier:return Th}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;wl(this.settings)&&(Op(this.settings.inTangents,e),Op(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;wl(this.settings)&&(Fp(this.settings.inTangents,e),Fp(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(je("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(je("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){je("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){je("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&Sy(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){je("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Tl,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let h=a*i,d=h-i,f=h+i;for(let p=0;p!==i;++p){let m=t[h+p];if(m!==t[d+p]||m!==t[f+p]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*i,d=o*i;for(let f=0;f!==i;++f)t[d+f]=t[h+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,wl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Op(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function Fp(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}hi.prototype.ValueTypeName="";hi.prototype.TimeBufferType=Float32Array;hi.prototype.ValueBufferType=Float32Array;hi.prototype.DefaultInterpolation=kl;var Gs=class extends hi{constructor(e,t,i){super(e,t,i)}};Gs.prototype.ValueTypeName="bool";Gs.prototype.ValueBufferType=Array;Gs.prototype.DefaultInterpolation=sa;Gs.prototype.InterpolantFactoryMethodLinear=void 0;Gs.prototype.InterpolantFactoryMethodSmooth=void 0;var Ql=class extends hi{constructor(e,t,i,s){super(e,t,i,s)}};Ql.prototype.ValueTypeName="color";var ec=class extends hi{constructor(e,t,i,s){super(e,t,i,s)}};ec.prototype.ValueTypeName="number";var tc=class extends Vs{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)li.slerpFlat(r,0,o,c-a,o,c,l);return r}},ya=class extends hi{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new tc(this.times,this.values,this.getValueSize(),e)}};ya.prototype.ValueTypeName="quaternion";ya.prototype.InterpolantFactoryMethodSmooth=void 0;var Hs=class extends hi{constructor(e,t,i){super(e,t,i)}};Hs.prototype.ValueTypeName="string";Hs.prototype.ValueBufferType=Array;Hs.prototype.DefaultInterpolation=sa;Hs.prototype.InterpolantFactoryMethodLinear=void 0;Hs.prototype.InterpolantFactoryMethodSmooth=void 0;var nc=class extends hi{constructor(e,t,i,s){super(e,t,i,s)}};nc.prototype.ValueTypeName="vector";var ic=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,d=c.length;h<d;h+=2){let f=c[h],p=c[h+1];if(f.global&&(f.lastIndex=0),f.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Lm=new ic,sc=class{constructor(e){this.manager=e!==void 0?e:Lm,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};sc.DEFAULT_MATERIAL_NAME="__DEFAULT";var va=class extends Nn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new Qe(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},ba=class extends va{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Nn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Qe(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},Eh=new pt,kp=new H,Bp=new H,rc=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new qe(512,512),this.mapType=jn,this.map=null,this.mapPass=null,this.matrix=new pt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Bs,this._frameExtents=new qe(1,1),this._viewportCount=1,this._viewports=[new Zt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;kp.setFromMatrixPosition(e.matrixWorld),t.position.copy(kp),Bp.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(Bp),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,s){Eh.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(Eh,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===io||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(Eh)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},Al=new H,El=new li,Hi=new H,Sa=class extends Nn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new pt,this.projectionMatrix=new pt,this.projectionMatrixInverse=new pt,this.coordinateSystem=_i,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Al,El,Hi),Hi.x===1&&Hi.y===1&&Hi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Al,El,Hi.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(Al,El,Hi),Hi.x===1&&Hi.y===1&&Hi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Al,El,Hi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Os=new H,zp=new qe,Vp=new qe,Xn=class extends Sa{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=ro*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(na*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return ro*2*Math.atan(Math.tan(na*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){Os.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Os.x,Os.y).multiplyScalar(-e/Os.z),Os.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Os.x,Os.y).multiplyScalar(-e/Os.z)}getViewSize(e,t){return this.getViewBounds(e,zp,Vp),t.subVectors(Vp,zp)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(na*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Ma=class extends Sa{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},Ih=class extends rc{constructor(){super(new Ma(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},wa=class extends va{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Nn.DEFAULT_UP),this.updateMatrix(),this.target=new Nn,this.shadow=new Ih}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var Qr=-90,eo=1,ho=class extends Nn{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Xn(Qr,eo,e,t);s.layers=this.layers,this.add(s);let r=new Xn(Qr,eo,e,t);r.layers=this.layers,this.add(r);let o=new Xn(Qr,eo,e,t);o.layers=this.layers,this.add(o);let a=new Xn(Qr,eo,e,t);a.layers=this.layers,this.add(a);let l=new Xn(Qr,eo,e,t);l.layers=this.layers,this.add(l);let c=new Xn(Qr,eo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===_i)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===io)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let m=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let g=!1;e.isWebGLRenderer===!0?g=e.state.buffers.depth.getReversed():g=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=m,e.setRenderTarget(i,5,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(h,d,f),e.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},oc=class extends Xn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var fd="\\[\\]\\.:\\/",lv=new RegExp("["+fd+"]","g"),pd="[^"+fd+"]",cv="[^"+fd.replace("\\.","")+"]",uv=/((?:WC+[\/:])*)/.source.replace("WC",pd),hv=/(WCOD+)?/.source.replace("WCOD",cv),dv=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",pd),fv=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",pd),pv=new RegExp("^"+uv+hv+dv+fv+"$"),mv=["material","materials","bones","map"],Lh=class{constructor(e,t,i){let s=i||Wt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},Wt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(lv,"")}static parseTrackName(e){let t=pv.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);mv.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Xe("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){je("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){je("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){je("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){je("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){je("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){je("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){je("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;je("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){je("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){je("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Wt.Composite=Lh;Wt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Wt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Wt.prototype.GetterByBindingType=[Wt.prototype._getValue_direct,Wt.prototype._getValue_array,Wt.prototype._getValue_arrayElement,Wt.prototype._getValue_toArray];Wt.prototype.SetterByBindingTypeAndVersioning=[[Wt.prototype._setValue_direct,Wt.prototype._setValue_direct_setNeedsUpdate,Wt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Wt.prototype._setValue_array,Wt.prototype._setValue_array_setNeedsUpdate,Wt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Wt.prototype._setValue_arrayElement,Wt.prototype._setValue_arrayElement_setNeedsUpdate,Wt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Wt.prototype._setValue_fromArray,Wt.prototype._setValue_fromArray_setNeedsUpdate,Wt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var AP=new Float32Array(1);var Gp=new pt,mr=class{constructor(e,t,i=0,s=1/0){this.ray=new ks(e,t),this.near=i,this.far=s,this.camera=null,this.layers=new ao,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):je("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return Gp.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Gp),this}intersectObject(e,t=!0,i=[]){return Nh(e,this,i,t),i.sort(Hp),i}intersectObjects(e,t=!0,i=[]){for(let s=0,r=e.length;s<r;s++)Nh(e[s],this,i,t);return i.sort(Hp),i}};function Hp(n,e){return n.distance-e.distance}function Nh(n,e,t,i){let s=!0;if(n.layers.test(e.layers)&&n.raycast(e,t)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)Nh(r[o],e,t,!0)}}var fo=class{constructor(e=1,t=0,i=0){this.radius=e,this.phi=t,this.theta=i}set(e,t,i){return this.radius=e,this.phi=t,this.theta=i,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=ft(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,i){return this.radius=Math.sqrt(e*e+t*t+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,i),this.phi=Math.acos(ft(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Dh=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};var Aa=class extends Ci{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function md(n,e,t,i){let s=gv(i);switch(t){case Qh:return n*e;case pc:return n*e/s.components*s.byteLength;case mc:return n*e/s.components*s.byteLength;case qs:return n*e*2/s.components*s.byteLength;case gc:return n*e*2/s.components*s.byteLength;case ed:return n*e*3/s.components*s.byteLength;case Ii:return n*e*4/s.components*s.byteLength;case xc:return n*e*4/s.components*s.byteLength;case Ca:case Ra:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Pa:case Ia:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case yc:case bc:return Math.max(n,16)*Math.max(e,8)/4;case _c:case vc:return Math.max(n,8)*Math.max(e,8)/2;case Sc:case Mc:case Ac:case Ec:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case wc:case La:case Tc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Cc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Rc:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Pc:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case Ic:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case Lc:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Nc:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case Dc:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Uc:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Oc:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case Fc:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case kc:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Bc:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case zc:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Vc:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Gc:case Hc:case Wc:return Math.ceil(n/4)*Math.ceil(e/4)*16;case $c:case Xc:return Math.ceil(n/4)*Math.ceil(e/4)*8;case Na:case qc:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function gv(n){switch(n){case jn:case Zh:return{byteLength:1,components:1};case xo:case Kh:case Pi:return{byteLength:2,components:1};case dc:case fc:return{byteLength:2,components:4};case Ri:case hc:case yi:return{byteLength:4,components:1};case Jh:case jh:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Xe("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function eg(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function _v(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<h.length;f++){let p=h[d],m=h[f];m.start<=p.start+p.count+1?p.count=Math.max(p.count,m.start+m.count-p.start):(++d,h[d]=m)}h.length=d+1;for(let f=0,p=h.length;f<p;f++){let m=h[f];n.bufferSubData(c,m.start*u.BYTES_PER_ELEMENT,u,m.start,m.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var yv=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,vv=`#ifdef USE_ALPHAHASH
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
#endif`,bv=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Sv=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Mv=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,wv=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Av=`#ifdef USE_AOMAP
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
#endif`,Ev=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Tv=`#ifdef USE_BATCHING
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
#endif`,Cv=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Rv=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Pv=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Iv=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,Lv=`#ifdef USE_IRIDESCENCE
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
#endif`,Nv=`#ifdef USE_BUMPMAP
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
#endif`,Dv=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,Uv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Ov=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Fv=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,kv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Bv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,zv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Vv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,Gv=`#define PI 3.141592653589793
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
} // validated`,Hv=`vec3 transformedNormal = objectNormal;
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
#endif`,Wv=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,$v=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Xv=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,qv=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Yv="gl_FragColor = linearToOutputTexel( gl_FragColor );",Zv=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Kv=`#ifdef USE_ENVMAP
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
#endif`,Jv=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,jv=`#ifdef USE_ENVMAP
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
#endif`,Qv=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,eb=`#ifdef USE_ENVMAP
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
#endif`,tb=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,nb=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,ib=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,sb=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,rb=`#ifdef USE_GRADIENTMAP
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
}`,ob=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,ab=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,lb=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,cb=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,ub=`#ifdef USE_ENVMAP
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
#endif`,hb=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,db=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,fb=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,pb=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,mb=`PhysicalMaterial material;
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
#endif`,gb=`uniform sampler2D dfgLUT;
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
}`,xb=`
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
#endif`,_b=`#if defined( RE_IndirectDiffuse )
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
#endif`,yb=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,vb=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,bb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Sb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Mb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,wb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Ab=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Eb=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Tb=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,Cb=`#if defined( USE_POINTS_UV )
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
#endif`,Rb=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Pb=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Ib=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Lb=`#if defined( USE_MORPHCOLORS )
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
#endif`,Nb=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Db=`#ifdef USE_MORPHTARGETS
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
#endif`,Ub=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Ob=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,Fb=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,kb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Bb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,zb=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Vb=`#ifdef USE_NORMALMAP
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
#endif`,Gb=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Hb=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Wb=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,$b=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Xb=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,qb=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,Yb=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Zb=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Kb=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Jb=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,jb=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Qb=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,eS=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,tS=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,nS=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,iS=`float getShadowMask() {
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
}`,sS=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,rS=`#ifdef USE_SKINNING
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
#endif`,oS=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,aS=`#ifdef USE_SKINNING
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
#endif`,lS=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,cS=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,uS=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,hS=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,dS=`#ifdef USE_TRANSMISSION
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
#endif`,fS=`#ifdef USE_TRANSMISSION
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
#endif`,pS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,mS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,gS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,xS=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,_S=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,yS=`uniform sampler2D t2D;
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
}`,vS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,bS=`uniform float backgroundBlurriness;
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
}`,SS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,MS=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,wS=`#include <common>
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
}`,AS=`#if DEPTH_PACKING == 3200
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
}`,ES=`#define DISTANCE
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
}`,TS=`#define DISTANCE
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
}`,CS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,RS=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,PS=`uniform float scale;
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
}`,IS=`uniform vec3 diffuse;
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
}`,LS=`#include <common>
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
}`,NS=`uniform vec3 diffuse;
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
}`,DS=`#define LAMBERT
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
}`,US=`#define LAMBERT
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
}`,OS=`#define MATCAP
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
}`,FS=`#define MATCAP
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
}`,kS=`#define NORMAL
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
}`,BS=`#define NORMAL
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
}`,zS=`#define PHONG
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
}`,VS=`#define PHONG
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
}`,GS=`#define STANDARD
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
}`,HS=`#define STANDARD
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
}`,WS=`#define TOON
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
}`,$S=`#define TOON
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
}`,XS=`uniform float size;
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
}`,qS=`uniform vec3 diffuse;
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
}`,YS=`#include <common>
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
}`,ZS=`uniform vec3 color;
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
}`,KS=`uniform float rotation;
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
}`,JS=`uniform vec3 diffuse;
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
}`,ct={alphahash_fragment:yv,alphahash_pars_fragment:vv,alphamap_fragment:bv,alphamap_pars_fragment:Sv,alphatest_fragment:Mv,alphatest_pars_fragment:wv,aomap_fragment:Av,aomap_pars_fragment:Ev,batching_pars_vertex:Tv,batching_vertex:Cv,begin_vertex:Rv,beginnormal_vertex:Pv,bsdfs:Iv,iridescence_fragment:Lv,bumpmap_pars_fragment:Nv,clipping_planes_fragment:Dv,clipping_planes_pars_fragment:Uv,clipping_planes_pars_vertex:Ov,clipping_planes_vertex:Fv,color_fragment:kv,color_pars_fragment:Bv,color_pars_vertex:zv,color_vertex:Vv,common:Gv,defaultnormal_vertex:Hv,displacementmap_pars_vertex:Wv,displacementmap_vertex:$v,emissivemap_fragment:Xv,emissivemap_pars_fragment:qv,colorspace_fragment:Yv,colorspace_pars_fragment:Zv,envmap_fragment:Kv,envmap_common_pars_fragment:Jv,envmap_pars_fragment:jv,envmap_pars_vertex:Qv,envmap_physical_pars_fragment:ub,envmap_vertex:eb,fog_vertex:tb,fog_pars_vertex:nb,fog_fragment:ib,fog_pars_fragment:sb,gradientmap_pars_fragment:rb,lightmap_pars_fragment:ob,lights_lambert_fragment:ab,lights_lambert_pars_fragment:lb,lights_pars_begin:cb,lights_toon_fragment:hb,lights_toon_pars_fragment:db,lights_phong_fragment:fb,lights_phong_pars_fragment:pb,lights_physical_fragment:mb,lights_physical_pars_fragment:gb,lights_fragment_begin:xb,lights_fragment_maps:_b,lights_fragment_end:yb,lightprobes_pars_fragment:vb,logdepthbuf_fragment:bb,logdepthbuf_pars_fragment:Sb,logdepthbuf_pars_vertex:Mb,logdepthbuf_vertex:wb,map_fragment:Ab,map_pars_fragment:Eb,map_particle_fragment:Tb,map_particle_pars_fragment:Cb,metalnessmap_fragment:Rb,metalnessmap_pars_fragment:Pb,morphinstance_vertex:Ib,morphcolor_vertex:Lb,morphnormal_vertex:Nb,morphtarget_pars_vertex:Db,morphtarget_vertex:Ub,normal_fragment_begin:Ob,normal_fragment_maps:Fb,normal_pars_fragment:kb,normal_pars_vertex:Bb,normal_vertex:zb,normalmap_pars_fragment:Vb,clearcoat_normal_fragment_begin:Gb,clearcoat_normal_fragment_maps:Hb,clearcoat_pars_fragment:Wb,iridescence_pars_fragment:$b,opaque_fragment:Xb,packing:qb,premultiplied_alpha_fragment:Yb,project_vertex:Zb,dithering_fragment:Kb,dithering_pars_fragment:Jb,roughnessmap_fragment:jb,roughnessmap_pars_fragment:Qb,shadowmap_pars_fragment:eS,shadowmap_pars_vertex:tS,shadowmap_vertex:nS,shadowmask_pars_fragment:iS,skinbase_vertex:sS,skinning_pars_vertex:rS,skinning_vertex:oS,skinnormal_vertex:aS,specularmap_fragment:lS,specularmap_pars_fragment:cS,tonemapping_fragment:uS,tonemapping_pars_fragment:hS,transmission_fragment:dS,transmission_pars_fragment:fS,uv_pars_fragment:pS,uv_pars_vertex:mS,uv_vertex:gS,worldpos_vertex:xS,background_vert:_S,background_frag:yS,backgroundCube_vert:vS,backgroundCube_frag:bS,cube_vert:SS,cube_frag:MS,depth_vert:wS,depth_frag:AS,distance_vert:ES,distance_frag:TS,equirect_vert:CS,equirect_frag:RS,linedashed_vert:PS,linedashed_frag:IS,meshbasic_vert:LS,meshbasic_frag:NS,meshlambert_vert:DS,meshlambert_frag:US,meshmatcap_vert:OS,meshmatcap_frag:FS,meshnormal_vert:kS,meshnormal_frag:BS,meshphong_vert:zS,meshphong_frag:VS,meshphysical_vert:GS,meshphysical_frag:HS,meshtoon_vert:WS,meshtoon_frag:$S,points_vert:XS,points_frag:qS,shadow_vert:YS,shadow_frag:ZS,sprite_vert:KS,sprite_frag:JS},Le={common:{diffuse:{value:new Qe(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new tt},alphaMap:{value:null},alphaMapTransform:{value:new tt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new tt}},envmap:{envMap:{value:null},envMapRotation:{value:new tt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new tt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new tt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new tt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new tt},normalScale:{value:new qe(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new tt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new tt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new tt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new tt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Qe(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Qe(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new tt},alphaTest:{value:0},uvTransform:{value:new tt}},sprite:{diffuse:{value:new Qe(16777215)},opacity:{value:1},center:{value:new qe(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new tt},alphaMap:{value:null},alphaMapTransform:{value:new tt},alphaTest:{value:0}}},Ki={basic:{uniforms:zn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.fog]),vertexShader:ct.meshbasic_vert,fragmentShader:ct.meshbasic_frag},lambert:{uniforms:zn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new Qe(0)},envMapIntensity:{value:1}}]),vertexShader:ct.meshlambert_vert,fragmentShader:ct.meshlambert_frag},phong:{uniforms:zn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new Qe(0)},specular:{value:new Qe(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ct.meshphong_vert,fragmentShader:ct.meshphong_frag},standard:{uniforms:zn([Le.common,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.roughnessmap,Le.metalnessmap,Le.fog,Le.lights,{emissive:{value:new Qe(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ct.meshphysical_vert,fragmentShader:ct.meshphysical_frag},toon:{uniforms:zn([Le.common,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.gradientmap,Le.fog,Le.lights,{emissive:{value:new Qe(0)}}]),vertexShader:ct.meshtoon_vert,fragmentShader:ct.meshtoon_frag},matcap:{uniforms:zn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,{matcap:{value:null}}]),vertexShader:ct.meshmatcap_vert,fragmentShader:ct.meshmatcap_frag},points:{uniforms:zn([Le.points,Le.fog]),vertexShader:ct.points_vert,fragmentShader:ct.points_frag},dashed:{uniforms:zn([Le.common,Le.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ct.linedashed_vert,fragmentShader:ct.linedashed_frag},depth:{uniforms:zn([Le.common,Le.displacementmap]),vertexShader:ct.depth_vert,fragmentShader:ct.depth_frag},normal:{uniforms:zn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,{opacity:{value:1}}]),vertexShader:ct.meshnormal_vert,fragmentShader:ct.meshnormal_frag},sprite:{uniforms:zn([Le.sprite,Le.fog]),vertexShader:ct.sprite_vert,fragmentShader:ct.sprite_frag},background:{uniforms:{uvTransform:{value:new tt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ct.background_vert,fragmentShader:ct.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new tt}},vertexShader:ct.backgroundCube_vert,fragmentShader:ct.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ct.cube_vert,fragmentShader:ct.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ct.equirect_vert,fragmentShader:ct.equirect_frag},distance:{uniforms:zn([Le.common,Le.displacementmap,{referencePosition:{value:new H},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ct.distance_vert,fragmentShader:ct.distance_frag},shadow:{uniforms:zn([Le.lights,Le.fog,{color:{value:new Qe(0)},opacity:{value:1}}]),vertexShader:ct.shadow_vert,fragmentShader:ct.shadow_frag}};Ki.physical={uniforms:zn([Ki.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new tt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new tt},clearcoatNormalScale:{value:new qe(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new tt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new tt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new tt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new tt},sheen:{value:0},sheenColor:{value:new Qe(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new tt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new tt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new tt},transmissionSamplerSize:{value:new qe},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new tt},attenuationDistance:{value:0},attenuationColor:{value:new Qe(0)},specularColor:{value:new Qe(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new tt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new tt},anisotropyVector:{value:new qe},anisotropyMap:{value:null},anisotropyMapTransform:{value:new tt}}]),vertexShader:ct.meshphysical_vert,fragmentShader:ct.meshphysical_frag};var Zc={r:0,b:0,g:0},jS=new pt,tg=new tt;tg.set(-1,0,0,0,1,0,0,0,1);function QS(n,e,t,i,s,r){let o=new Qe(0),a=s===!0?0:1,l,c,u=null,h=0,d=null;function f(_){let M=_.isScene===!0?_.background:null;if(M&&M.isTexture){let v=_.backgroundBlurriness>0;M=e.get(M,v)}return M}function p(_){let M=!1,v=f(_);v===null?g(o,a):v&&v.isColor&&(g(v,1),M=!0);let E=n.xr.getEnvironmentBlendMode();E==="additive"?t.buffers.color.setClear(0,0,0,1,r):E==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||M)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function m(_,M){let v=f(M);v&&v.isCubeTexture?(c===void 0&&(c=new Dn(new co(1,1,1),new qi({name:"BackgroundCubeMaterial",uniforms:vr(Ki.backgroundCube.uniforms),vertexShader:Ki.backgroundCube.vertexShader,fragmentShader:Ki.backgroundCube.fragmentShader,side:Yn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(E,A,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=v,c.material.uniforms.backgroundBlurriness.value=M.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(jS.makeRotationFromEuler(M.backgroundRotation)).transpose(),v.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(tg),c.material.toneMapped=xt.getTransfer(v.colorSpace)!==Et,(u!==v||h!==v.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,u=v,h=v.version,d=n.toneMapping),c.layers.enableAll(),_.unshift(c,c.geometry,c.material,0,0,null)):v&&v.isTexture&&(l===void 0&&(l=new Dn(new _a(2,2),new qi({name:"BackgroundMaterial",uniforms:vr(Ki.background.uniforms),vertexShader:Ki.background.vertexShader,fragmentShader:Ki.background.fragmentShader,side:Xs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=v,l.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,l.material.toneMapped=xt.getTransfer(v.colorSpace)!==Et,v.matrixAutoUpdate===!0&&v.updateMatrix(),l.material.uniforms.uvTransform.value.copy(v.matrix),(u!==v||h!==v.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,u=v,h=v.version,d=n.toneMapping),l.layers.enableAll(),_.unshift(l,l.geometry,l.material,0,0,null))}function g(_,M){_.getRGB(Zc,dd(n)),t.buffers.color.setClear(Zc.r,Zc.g,Zc.b,M,r)}function x(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(_,M=1){o.set(_),a=M,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(_){a=_,g(o,a)},render:p,addToRenderList:m,dispose:x}}function eM(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(I,O,k,N,V){let X=!1,G=h(I,N,k,O);r!==G&&(r=G,c(r.object)),X=f(I,N,k,V),X&&p(I,N,k,V),V!==null&&e.update(V,n.ELEMENT_ARRAY_BUFFER),(X||o)&&(o=!1,v(I,O,k,N),V!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(V).buffer))}function l(){return n.createVertexArray()}function c(I){return n.bindVertexArray(I)}function u(I){return n.deleteVertexArray(I)}function h(I,O,k,N){let V=N.wireframe===!0,X=i[O.id];X===void 0&&(X={},i[O.id]=X);let G=I.isInstancedMesh===!0?I.id:0,oe=X[G];oe===void 0&&(oe={},X[G]=oe);let Z=oe[k.id];Z===void 0&&(Z={},oe[k.id]=Z);let Q=Z[V];return Q===void 0&&(Q=d(l()),Z[V]=Q),Q}function d(I){let O=[],k=[],N=[];for(let V=0;V<t;V++)O[V]=0,k[V]=0,N[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:O,enabledAttributes:k,attributeDivisors:N,object:I,attributes:{},index:null}}function f(I,O,k,N){let V=r.attributes,X=O.attributes,G=0,oe=k.getAttributes();for(let Z in oe)if(oe[Z].location>=0){let ie=V[Z],fe=X[Z];if(fe===void 0&&(Z==="instanceMatrix"&&I.instanceMatrix&&(fe=I.instanceMatrix),Z==="instanceColor"&&I.instanceColor&&(fe=I.instanceColor)),ie===void 0||ie.attribute!==fe||fe&&ie.data!==fe.data)return!0;G++}return r.attributesNum!==G||r.index!==N}function p(I,O,k,N){let V={},X=O.attributes,G=0,oe=k.getAttributes();for(let Z in oe)if(oe[Z].location>=0){let ie=X[Z];ie===void 0&&(Z==="instanceMatrix"&&I.instanceMatrix&&(ie=I.instanceMatrix),Z==="instanceColor"&&I.instanceColor&&(ie=I.instanceColor));let fe={};fe.attribute=ie,ie&&ie.data&&(fe.data=ie.data),V[Z]=fe,G++}r.attributes=V,r.attributesNum=G,r.index=N}function m(){let I=r.newAttributes;for(let O=0,k=I.length;O<k;O++)I[O]=0}function g(I){x(I,0)}function x(I,O){let k=r.newAttributes,N=r.enabledAttributes,V=r.attributeDivisors;k[I]=1,N[I]===0&&(n.enableVertexAttribArray(I),N[I]=1),V[I]!==O&&(n.vertexAttribDivisor(I,O),V[I]=O)}function _(){let I=r.newAttributes,O=r.enabledAttributes;for(let k=0,N=O.length;k<N;k++)O[k]!==I[k]&&(n.disableVertexAttribArray(k),O[k]=0)}function M(I,O,k,N,V,X,G){G===!0?n.vertexAttribIPointer(I,O,k,V,X):n.vertexAttribPointer(I,O,k,N,V,X)}function v(I,O,k,N){m();let V=N.attributes,X=k.getAttributes(),G=O.defaultAttributeValues;for(let oe in X){let Z=X[oe];if(Z.location>=0){let Q=V[oe];if(Q===void 0&&(oe==="instanceMatrix"&&I.instanceMatrix&&(Q=I.instanceMatrix),oe==="instanceColor"&&I.instanceColor&&(Q=I.instanceColor)),Q!==void 0){let ie=Q.normalized,fe=Q.itemSize,de=e.get(Q);if(de===void 0)continue;let ee=de.buffer,he=de.type,ge=de.bytesPerElement,Se=he===n.INT||he===n.UNSIGNED_INT||Q.gpuType===hc;if(Q.isInterleavedBufferAttribute){let Me=Q.data,He=Me.isInterleavedBuffer===!0?Me.stride:Me.itemSize,st=Q.offset;if(Me.isInstancedInterleavedBuffer||Me.isInstancedBufferAttribute){for(let Ve=0;Ve<Z.locationSize;Ve++)x(Z.location+Ve,Me.meshPerAttribute);I.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Me.meshPerAttribute*Me.count)}else for(let Ve=0;Ve<Z.locationSize;Ve++)g(Z.location+Ve);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let Ve=0;Ve<Z.locationSize;Ve++)M(Z.location+Ve,fe/Z.locationSize,he,ie,He*ge,(st+fe/Z.locationSize*Ve)*ge,Se)}else{if(Q.isInstancedBufferAttribute){for(let Me=0;Me<Z.locationSize;Me++)x(Z.location+Me,Q.meshPerAttribute);I.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let Me=0;Me<Z.locationSize;Me++)g(Z.location+Me);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let Me=0;Me<Z.locationSize;Me++)M(Z.location+Me,fe/Z.locationSize,he,ie,fe*ge,fe/Z.locationSize*Me*ge,Se)}}else if(G!==void 0){let ie=G[oe];if(ie!==void 0)switch(ie.length){case 2:n.vertexAttrib2fv(Z.location,ie);break;case 3:n.vertexAttrib3fv(Z.location,ie);break;case 4:n.vertexAttrib4fv(Z.location,ie);break;default:n.vertexAttrib1fv(Z.location,ie)}}}}_()}function E(){P();for(let I in i){let O=i[I];for(let k in O){let N=O[k];for(let V in N){let X=N[V];for(let G in X)u(X[G].object),delete X[G];delete N[V]}}delete i[I]}}function A(I){if(i[I.id]===void 0)return;let O=i[I.id];for(let k in O){let N=O[k];for(let V in N){let X=N[V];for(let G in X)u(X[G].object),delete X[G];delete N[V]}}delete i[I.id]}function y(I){for(let O in i){let k=i[O];for(let N in k){let V=k[N];if(V[I.id]===void 0)continue;let X=V[I.id];for(let G in X)u(X[G].object),delete X[G];delete V[I.id]}}}function S(I){for(let O in i){let k=i[O],N=I.isInstancedMesh===!0?I.id:0,V=k[N];if(V!==void 0){for(let X in V){let G=V[X];for(let oe in G)u(G[oe].object),delete G[oe];delete V[X]}delete k[N],Object.keys(k).length===0&&delete i[O]}}}function P(){L(),o=!0,r!==s&&(r=s,c(r.object))}function L(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:P,resetDefaultState:L,dispose:E,releaseStatesOfGeometry:A,releaseStatesOfObject:S,releaseStatesOfProgram:y,initAttributes:m,enableAttribute:g,disableUnusedAttributes:_}}function tM(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let d=0;for(let f=0;f<u;f++)d+=c[f];t.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function nM(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let y=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==Ii&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let S=y===Pi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(y!==jn&&y!==yi&&!S&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Xe("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&h===!1;t.reversedDepthBuffer===!0&&h===!1&&Xe("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&h===!0&&Xe("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),m=n.getParameter(n.MAX_TEXTURE_SIZE),g=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),x=n.getParameter(n.MAX_VERTEX_ATTRIBS),_=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),M=n.getParameter(n.MAX_VARYING_VECTORS),v=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),E=n.getParameter(n.MAX_SAMPLES),A=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:p,maxTextureSize:m,maxCubemapSize:g,maxAttributes:x,maxVertexUniforms:_,maxVaryings:M,maxFragmentUniforms:v,maxSamples:E,samples:A}}function iM(n){let e=this,t=null,i=0,s=!1,r=!1,o=new ai,a=new tt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){let f=h.length!==0||d||i!==0||s;return s=d,i=h.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,d){t=u(h,d,0)},this.setState=function(h,d,f){let p=h.clippingPlanes,m=h.clipIntersection,g=h.clipShadows,x=n.get(h);if(!s||p===null||p.length===0||r&&!g)r?u(null):c();else{let _=r?0:i,M=_*4,v=x.clippingState||null;l.value=v,v=u(p,d,M,f);for(let E=0;E!==M;++E)v[E]=t[E];x.clippingState=v,this.numIntersection=m?this.numPlanes:0,this.numPlanes+=_}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(h,d,f,p){let m=h!==null?h.length:0,g=null;if(m!==0){if(g=l.value,p!==!0||g===null){let x=f+m*4,_=d.matrixWorldInverse;a.getNormalMatrix(_),(g===null||g.length<x)&&(g=new Float32Array(x));for(let M=0,v=f;M!==m;++M,v+=4)o.copy(h[M]).applyMatrix4(_,a),o.normal.toArray(g,v),g[v+3]=o.constant}l.value=g,l.needsUpdate=!0}return e.numPlanes=m,e.numIntersection=0,g}}var Fa=class extends ci{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new pa(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new co(5,5,5),r=new qi({name:"CubemapFromEquirect",uniforms:vr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Yn,blending:gr});r.uniforms.tEquirect.value=t;let o=new Dn(s,r),a=t.minFilter;return t.minFilter===gs&&(t.minFilter=qn),new ho(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},Nm=256,sM=3,rM=20,ng=256,ig=16,oM=3,aM=new H,lM=new Qe,Jc=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new ho(1,10,null),this._boxMesh=new Dn(new co(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=aM}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,m=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,m===null&&(e.background=l.getClearColor(lM));let g=new ho(i,s,u);return g.position.copy(a),g.update(l,e),l.autoClear=h,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=p,e.background=m,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Om(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Um(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(Nm,cd(e))}_fromTexture(e,t){e.mapping===_r||e.mapping===go?this._setSize(e.image.length===0?Nm:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=Dm(e,!1,!1),i=Math.log2(e)-sM;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Dm(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===_r||e.mapping===go?(this._cubemapMaterial===null&&(this._cubemapMaterial=Om()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Um()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=cM(),this._integrationMaterial=uM());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/ig);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-oM)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(ng*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=hM());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function Dm(n,e,t){return new Fa(n,{minFilter:gs,generateMipmaps:e,type:Pi,colorSpace:ra,depthBuffer:t})}function ka(n,e,t){return new qi({name:n,uniforms:e,vertexShader:ct.cube_vert,fragmentShader:t,side:Yn,blending:gr,depthTest:!1,depthWrite:!1})}function cM(){return ka("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${ng}u

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
	`)}function uM(){return ka("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:ig}},`

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
	`)}function hM(){return ka("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${rM}
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
	`)}function Um(){return ka("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function Om(){return ka("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function dM(n){let e=new WeakMap,t=new WeakMap,i=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===lc||f===cc)if(e.has(d)){let p=e.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let m=new Fa(p.height);return m.fromEquirectangularTexture(n,d),e.set(d,m),d.addEventListener("dispose",c),a(m.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===lc||f===cc,m=f===_r||f===go;if(p||m){let g=t.get(d),x=g!==void 0?g.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==x)return i===null&&(i=new Jc(n)),g=p?i.fromEquirectangular(d,g):i.fromCubemap(d,g),g.texture.pmremVersion=d.pmremVersion,t.set(d,g),g.texture;if(g!==void 0)return g.texture;{let _=d.image;return p&&_&&_.height>0||m&&_&&l(_)?(i===null&&(i=new Jc(n)),g=p?i.fromEquirectangular(d):i.fromCubemap(d),g.texture.pmremVersion=d.pmremVersion,t.set(d,g),d.addEventListener("dispose",u),g.texture):null}}}return d}function a(d,f){return f===lc?d.mapping=_r:f===cc&&(d.mapping=go),d}function l(d){let f=0,p=6;for(let m=0;m<p;m++)d[m]!==void 0&&f++;return f===p}function c(d){let f=d.target;f.removeEventListener("dispose",c);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function u(d){let f=d.target;f.removeEventListener("dispose",u);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function h(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function fM(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&ta("WebGLRenderer: "+i+" extension not supported."),s}}}function pM(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&e.remove(p.index);for(let g in p.attributes)e.remove(p.attributes[g]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let m=r.get(p);m&&(e.remove(m),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,t.memory.geometries--}function c(p,m){return s[m.id]!==void 0||(m.addEventListener("dispose",a),s[m.id]=new WeakRef(m),o.register(m,m.id,m),t.memory.geometries++),m}function u(p){let m=p.attributes;for(let g in m)e.update(m[g],n.ARRAY_BUFFER)}function h(p){let m=p.index,g=p.attributes.position,x=0;if(g===void 0)return;let _=m!==null?m.array.length:g.array.length/3-1,M=g.count>=65535?ha:ua,v=new M(Math.ceil(_/3)*6,1),E=v.array;if(m!==null){let y=m.array;x=m.version;for(let S=0,P=0;S<_;S+=3){let L=y[S+0],I=y[S+1],O=y[S+2];E[P++]=L,E[P++]=I,E[P++]=I,E[P++]=O,E[P++]=O,E[P++]=L}}else{x=g.version;for(let y=0,S=0;y<_;y+=3){let P=y+0,L=y+1,I=y+2;E[S++]=P,E[S++]=L,E[S++]=L,E[S++]=I,E[S++]=I,E[S++]=P}}v.version=x;let A=r.get(p);A&&e.remove(A),r.set(p,v)}function d(p){let m=r.get(p);if(m){let g=p.index;g!==null&&m.version<g.version&&h(p)}else h(p);return r.get(p)}function f(){for(let p in s){let m=s[p].deref();m!==void 0&&l(m)}}return{get:c,update:u,getWireframeAttribute:d,dispose:f}}function mM(n,e,t){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,d){n.drawElements(i,d,r,h*o),t.update(d,i,1)}function c(h,d,f){f!==0&&(n.drawElementsInstanced(i,d,r,h*o,f),t.update(d,i,f))}function u(h,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,h,0,f);let m=0;for(let g=0;g<f;g++)m+=d[g];t.update(m,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function gM(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:je("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function xM(n,e,t){let i=new WeakMap,s=new Zt;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,d=i.get(a);if(d===void 0||d.count!==h){let P=function(){y.dispose(),i.delete(a),a.removeEventListener("dispose",P)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,m=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],x=a.morphAttributes.normal||[],_=a.morphAttributes.color||[],M=0;f===!0&&(M=1),p===!0&&(M=2),m===!0&&(M=3);let v=a.attributes.position.count*M,E=1;v>e.maxTextureSize&&(E=Math.ceil(v/e.maxTextureSize),v=e.maxTextureSize);let A=new Float32Array(v*E*4*h),y=new la(A,v,E,h);y.type=yi,y.needsUpdate=!0;let S=M*4;for(let L=0;L<h;L++){let I=g[L],O=x[L],k=_[L],N=v*E*4*L;for(let V=0;V<I.count;V++){let X=V*S;f===!0&&(s.fromBufferAttribute(I,V),A[N+X+0]=s.x,A[N+X+1]=s.y,A[N+X+2]=s.z,A[N+X+3]=0),p===!0&&(s.fromBufferAttribute(O,V),A[N+X+4]=s.x,A[N+X+5]=s.y,A[N+X+6]=s.z,A[N+X+7]=0),m===!0&&(s.fromBufferAttribute(k,V),A[N+X+8]=s.x,A[N+X+9]=s.y,A[N+X+10]=s.z,A[N+X+11]=k.itemSize===4?s.w:1)}}d={count:h,texture:y,size:new qe(v,E)},i.set(a,d),a.addEventListener("dispose",P)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let f=0;for(let m=0;m<c.length;m++)f+=c[m];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function _M(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,d=e.get(c,h);if(r.get(d)!==u&&(e.update(d),r.set(d,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return d}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var yM={[Vh]:"LINEAR_TONE_MAPPING",[Gh]:"REINHARD_TONE_MAPPING",[Hh]:"CINEON_TONE_MAPPING",[Wh]:"ACES_FILMIC_TONE_MAPPING",[Xh]:"AGX_TONE_MAPPING",[qh]:"NEUTRAL_TONE_MAPPING",[$h]:"CUSTOM_TONE_MAPPING"};function vM(n,e,t,i,s,r){let o=new ci(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new _n;u.setAttribute("position",new nn([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new nn([0,2,0,0,2,0],2));let h=new Xl({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new Dn(u,h),f=new Ma(-1,1,1,-1,0,1),p=null,m=null,g=!1,x,_=null,M=[],v=!1;this.setSize=function(E,A){o.setSize(E,A),a!==null&&a.setSize(E,A),l!==null&&l.setSize(E,A);for(let y=0;y<M.length;y++){let S=M[y];S.setSize&&S.setSize(E,A)}},this.setEffects=function(E){M=E,v=M.length>0&&M[0].isRenderPass===!0;let A=o.width,y=o.height;M.length>0&&a===null&&(a=new ci(A,y,{type:Pi,depthBuffer:!1,stencilBuffer:!1}),l=new ci(A,y,{type:Pi,depthBuffer:!1,stencilBuffer:!1}));let S=s===!0&&M.some(P=>P.needsDepthTexture===!0);S!==(o.depthTexture!==null)&&(S===!0&&c===null&&(c=new ps(A,y),r===!0&&(c.format=xs,c.type=yr)),o.dispose(),o.depthTexture=S?c:null,o.resolveDepthBuffer=S,o.storeMultisampledDepthBuffer=S);for(let P=0;P<M.length;P++){let L=M[P];L.setSize&&L.setSize(A,y),S&&L.needsDepthTexture===!0&&L.setDepthTexture&&L.setDepthTexture(c)}},this.begin=function(E,A){if(g||E.toneMapping===Yi&&M.length===0)return!1;if(_=A,A!==null){let y=A.width,S=A.height;(o.width!==y||o.height!==S)&&this.setSize(y,S)}return v===!1&&E.setRenderTarget(o),x=E.toneMapping,E.toneMapping=Yi,!0},this.hasRenderPass=function(){return v},this.end=function(E,A){E.toneMapping=x,g=!0;let y=o,S=a;for(let P=0;P<M.length;P++){let L=M[P];L.enabled!==!1&&(L.render(E,S,y,A),L.needsSwap!==!1&&(y=S,S=S===a?l:a))}if(p!==E.outputColorSpace||m!==E.toneMapping){p=E.outputColorSpace,m=E.toneMapping,h.defines={},xt.getTransfer(p)===Et&&(h.defines.SRGB_TRANSFER="");let P=yM[m];P&&(h.defines[P]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=y.texture,E.setRenderTarget(_),E.render(d,f),_=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var sg=new Jn,rg=new ps(1,1),og=new ma(1),ag=new la,lg=new Vl,cg=new pa,Fm=[],km=[],Bm=new Float32Array(16),zm=new Float32Array(9),Vm=new Float32Array(4);function vo(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=Fm[s];if(r===void 0&&(r=new Float32Array(s),Fm[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function yn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function vn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Qc(n,e){let t=km[e];t===void 0&&(t=new Int32Array(e),km[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function bM(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function SM(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(yn(t,e))return;n.uniform2fv(this.addr,e),vn(t,e)}}function MM(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(yn(t,e))return;n.uniform3fv(this.addr,e),vn(t,e)}}function wM(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(yn(t,e))return;n.uniform4fv(this.addr,e),vn(t,e)}}function AM(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(yn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),vn(t,e)}else{if(yn(t,i))return;Vm.set(i),n.uniformMatrix2fv(this.addr,!1,Vm),vn(t,i)}}function EM(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(yn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),vn(t,e)}else{if(yn(t,i))return;zm.set(i),n.uniformMatrix3fv(this.addr,!1,zm),vn(t,i)}}function TM(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(yn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),vn(t,e)}else{if(yn(t,i))return;Bm.set(i),n.uniformMatrix4fv(this.addr,!1,Bm),vn(t,i)}}function CM(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function RM(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(yn(t,e))return;n.uniform2iv(this.addr,e),vn(t,e)}}function PM(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(yn(t,e))return;n.uniform3iv(this.addr,e),vn(t,e)}}function IM(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(yn(t,e))return;n.uniform4iv(this.addr,e),vn(t,e)}}function LM(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function NM(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(yn(t,e))return;n.uniform2uiv(this.addr,e),vn(t,e)}}function DM(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(yn(t,e))return;n.uniform3uiv(this.addr,e),vn(t,e)}}function UM(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(yn(t,e))return;n.uniform4uiv(this.addr,e),vn(t,e)}}function eu(n){return n.version===0&&(n.compareFunction=rd,n.needsUpdate=!0),n}function OM(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=eu(rg):r=sg,t.setTexture2D(e||r,s)}function FM(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||lg,s)}function kM(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=eu(og):r=cg,t.setTextureCube(e||r,s)}function BM(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||ag,s)}function zM(n){switch(n){case 5126:return bM;case 35664:return SM;case 35665:return MM;case 35666:return wM;case 35674:return AM;case 35675:return EM;case 35676:return TM;case 5124:case 35670:return CM;case 35667:case 35671:return RM;case 35668:case 35672:return PM;case 35669:case 35673:return IM;case 5125:return LM;case 36294:return NM;case 36295:return DM;case 36296:return UM;case 35678:case 36198:case 36298:case 36306:case 35682:return OM;case 35679:case 36299:case 36307:return FM;case 35680:case 36300:case 36308:case 36293:return kM;case 36289:case 36303:case 36311:case 36292:return BM}}function VM(n,e){n.uniform1fv(this.addr,e)}function GM(n,e){let t=vo(e,this.size,2);n.uniform2fv(this.addr,t)}function HM(n,e){let t=vo(e,this.size,3);n.uniform3fv(this.addr,t)}function WM(n,e){let t=vo(e,this.size,4);n.uniform4fv(this.addr,t)}function $M(n,e){let t=vo(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function XM(n,e){let t=vo(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function qM(n,e){let t=vo(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function YM(n,e){n.uniform1iv(this.addr,e)}function ZM(n,e){n.uniform2iv(this.addr,e)}function KM(n,e){n.uniform3iv(this.addr,e)}function JM(n,e){n.uniform4iv(this.addr,e)}function jM(n,e){n.uniform1uiv(this.addr,e)}function QM(n,e){n.uniform2uiv(this.addr,e)}function ew(n,e){n.uniform3uiv(this.addr,e)}function tw(n,e){n.uniform4uiv(this.addr,e)}function nw(n,e,t){let i=this.cache,s=e.length,r=Qc(t,s);yn(i,r)||(n.uniform1iv(this.addr,r),vn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=eu(rg):o=sg;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function iw(n,e,t){let i=this.cache,s=e.length,r=Qc(t,s);yn(i,r)||(n.uniform1iv(this.addr,r),vn(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||lg,r[o])}function sw(n,e,t){let i=this.cache,s=e.length,r=Qc(t,s);yn(i,r)||(n.uniform1iv(this.addr,r),vn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=eu(og):o=cg;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function rw(n,e,t){let i=this.cache,s=e.length,r=Qc(t,s);yn(i,r)||(n.uniform1iv(this.addr,r),vn(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||ag,r[o])}function ow(n){switch(n){case 5126:return VM;case 35664:return GM;case 35665:return HM;case 35666:return WM;case 35674:return $M;case 35675:return XM;case 35676:return qM;case 5124:case 35670:return YM;case 35667:case 35671:return ZM;case 35668:case 35672:return KM;case 35669:case 35673:return JM;case 5125:return jM;case 36294:return QM;case 36295:return ew;case 36296:return tw;case 35678:case 36198:case 36298:case 36306:case 35682:return nw;case 35679:case 36299:case 36307:return iw;case 35680:case 36300:case 36308:case 36293:return sw;case 36289:case 36303:case 36311:case 36292:return rw}}var _d=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=zM(t.type)}},yd=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=ow(t.type)}},vd=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},gd=/(\w+)(\])?(\[|\.)?/g;function Gm(n,e){n.seq.push(e),n.map[e.id]=e}function aw(n,e,t){let i=n.name,s=i.length;for(gd.lastIndex=0;;){let r=gd.exec(i),o=gd.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Gm(t,c===void 0?new _d(a,n,e):new yd(a,n,e));break}else{let h=t.map[a];h===void 0&&(h=new vd(a),Gm(t,h)),t=h}}}var yo=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);aw(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function Hm(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var lw=37297,cw=0;function uw(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var Wm=new tt;function hw(n){xt._getMatrix(Wm,xt.workingColorSpace,n);let e=`mat3( ${Wm.elements.map(t=>t.toFixed(4))} )`;switch(xt.getTransfer(n)){case oa:return[e,"LinearTransferOETF"];case Et:return[e,"sRGBTransferOETF"];default:return Xe("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function $m(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+uw(n.getShaderSource(e),a)}else return r}function dw(n,e){let t=hw(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var fw={[Vh]:"Linear",[Gh]:"Reinhard",[Hh]:"Cineon",[Wh]:"ACESFilmic",[Xh]:"AgX",[qh]:"Neutral",[$h]:"Custom"};function pw(n,e){let t=fw[e];return t===void 0?(Xe("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Kc=new H;function mw(){xt.getLuminanceCoefficients(Kc);let n=Kc.x.toFixed(4),e=Kc.y.toFixed(4),t=Kc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function gw(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Oa).join(`
`)}function xw(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function _w(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function Oa(n){return n!==""}function Xm(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function qm(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var yw=/^[ \t]*#include +<([\w\d./]+)>/gm;function bd(n){return n.replace(yw,vw)}function vw(n,e){let t=ct[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return bd(t)}var bw=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Ym(n){return n.replace(bw,Sw)}function Sw(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Zm(n){let e=`precision ${n.precision} float;
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
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var Mw={[Ea]:"SHADOWMAP_TYPE_PCF",[po]:"SHADOWMAP_TYPE_VSM"};function ww(n){return Mw[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var Aw={[go]:"ENVMAP_MODE_REFRACTION"};function Ew(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":Aw[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var Tw={[ac]:"ENVMAP_BLENDING_MULTIPLY",[hm]:"ENVMAP_BLENDING_MIX",[dm]:"ENVMAP_BLENDING_ADD"};function Cw(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":Tw[n.combine]||"ENVMAP_BLENDING_NONE"}function Rw(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=ww(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=Ew(t),h=Cw(t),d=gw(t),f=xw(r),p=s.createProgram(),m,g,x=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Oa).join(`
`),m.length>0&&(m+=`
`),g=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Oa).join(`
`),g.length>0&&(g+=`
`)):(m=[Zm(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Oa).join(`
`),g=[Zm(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Yi?"#define TONE_MAPPING":"",t.toneMapping!==Yi?ct.tonemapping_pars_fragment:"",t.toneMapping!==Yi?pw("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ct.colorspace_pars_fragment,dw("linearToOutputTexel",t.outputColorSpace),mw(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Oa).join(`
`)),o=bd(o),o=Xm(o,t),o=qm(o,t),a=bd(a),a=Xm(a,t),a=qm(a,t),o=Ym(o),a=Ym(a),t.isRawShaderMaterial!==!0&&(x=`#version 300 es
`,m=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+m,g=["#define varying in",t.glslVersion===od?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===od?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let _=x+m+o,M=x+g+a,v=Hm(s,s.VERTEX_SHADER,_),E=Hm(s,s.FRAGMENT_SHADER,M);s.attachShader(p,v),s.attachShader(p,E),t.index0AttributeName!==void 0?s.bindAttribLocation(p,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function A(L){if(n.debug.checkShaderErrors){let I=s.getProgramInfoLog(p)||"",O=s.getShaderInfoLog(v)||"",k=s.getShaderInfoLog(E)||"",N=I.trim(),V=O.trim(),X=k.trim(),G=!0,oe=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(G=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,v,E);else{let Z=$m(s,v,"vertex"),Q=$m(s,E,"fragment");je("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+L.name+`
Material Type: `+L.type+`

Program Info Log: `+N+`
`+Z+`
`+Q)}else N!==""?Xe("WebGLProgram: Program Info Log:",N):(V===""||X==="")&&(oe=!1);oe&&(L.diagnostics={runnable:G,programLog:N,vertexShader:{log:V,prefix:m},fragmentShader:{log:X,prefix:g}})}s.deleteShader(v),s.deleteShader(E),y=new yo(s,p),S=_w(s,p)}let y;this.getUniforms=function(){return y===void 0&&A(this),y};let S;this.getAttributes=function(){return S===void 0&&A(this),S};let P=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return P===!1&&(P=s.getProgramParameter(p,lw)),P},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=cw++,this.cacheKey=e,this.usedTimes=1,this.program=p,this.vertexShader=v,this.fragmentShader=E,this}var Pw=0,Sd=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new Md(e),t.set(e,i)),i}},Md=class{constructor(e){this.id=Pw++,this.code=e,this.usedTimes=0}};function Iw(n){return n===qs||n===La||n===Na}function Lw(n,e,t,i,s,r){let o=new ao,a=new Sd,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(y){return l.add(y),y===0?"uv":`uv${y}`}function p(y,S,P,L,I,O){let k=L.fog,N=I.geometry,V=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?L.environment:null,X=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,G=e.get(y.envMap||V,X),oe=d[y.type],Z=i.precision;y.precision!==null&&(Z=i.getMaxPrecision(y.precision),Z!==y.precision&&Xe("WebGLProgram.getParameters:",y.precision,"not supported, using",Z,"instead."));let Q=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,ie=Q!==void 0?Q.length:0,fe=0;N.morphAttributes.position!==void 0&&(fe=1),N.morphAttributes.normal!==void 0&&(fe=2),N.morphAttributes.color!==void 0&&(fe=3);let de,ee,he,ge;if(oe){let Ce=Ki[oe];de=Ce.vertexShader,ee=Ce.fragmentShader}else{de=y.vertexShader,ee=y.fragmentShader;let Ce=a.getVertexShaderStage(y),ot=a.getFragmentShaderStage(y);a.update(y,Ce,ot),he=Ce.id,ge=ot.id}let Se=n.getRenderTarget(),Me=n.state.buffers.depth.getReversed(),He=I.isInstancedMesh===!0,st=I.isBatchedMesh===!0,Ve=!!y.map,ut=!!y.matcap,at=!!G,nt=at&&G.isPMREMTexture===!0,qt=!!y.aoMap,Ft=!!y.lightMap,ln=!!y.bumpMap&&y.wireframe===!1,Lt=!!y.normalMap,wn=!!y.displacementMap,yt=!!y.emissiveMap,gn=!!y.metalnessMap,Jt=!!y.roughnessMap,cn=y.anisotropy>0,z=y.clearcoat>0,Re=y.diffuseRoughness>0,Ye=y.dispersion>0,rt=y.retroreflectivity>0,we=y.iridescence>0,Dt=y.sheen>0,ze=y.transmission>0,$e=cn&&!!y.anisotropyMap,D=z&&!!y.clearcoatMap,T=z&&!!y.clearcoatNormalMap,q=z&&!!y.clearcoatRoughnessMap,ue=Re&&!!y.diffuseRoughnessMap,ae=we&&!!y.iridescenceMap,_e=we&&!!y.iridescenceThicknessMap,ye=Dt&&!!y.sheenColorMap,te=Dt&&!!y.sheenRoughnessMap,se=!!y.specularMap,me=!!y.specularColorMap,B=!!y.specularIntensityMap,re=ze&&!!y.transmissionMap,ne=ze&&!!y.thicknessMap,Ae=!!y.gradientMap,xe=!!y.alphaMap,be=y.alphaTest>0,Ge=!!y.alphaHash,Ke=!!y.extensions,ce=Yi;y.toneMapped&&(Se===null||Se.isXRRenderTarget===!0)&&(ce=n.toneMapping);let Fe=nt?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,Je={shaderID:oe,shaderType:y.type,shaderName:y.name,vertexShader:de,fragmentShader:ee,defines:y.defines,customVertexShaderID:he,customFragmentShaderID:ge,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:Z,batching:st,batchingColor:st&&I._colorsTexture!==null,instancing:He,instancingColor:He&&I.instanceColor!==null,instancingMorph:He&&I.morphTexture!==null,outputColorSpace:Se===null?n.outputColorSpace:Se.isXRRenderTarget===!0?Se.texture.colorSpace:xt.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:Ve,matcap:ut,envMap:at,envMapMode:at&&G.mapping,envMapPMREM:nt,envMapMaxLod:nt?Fe.length-1:null,envMapSize:nt?Fe[0].width:null,aoMap:qt,lightMap:Ft,bumpMap:ln,normalMap:Lt,displacementMap:wn,emissiveMap:yt,normalMapObjectSpace:Lt&&y.normalMapType===mm,normalMapTangentSpace:Lt&&y.normalMapType===Yc,packedNormalMap:Lt&&y.normalMapType===Yc&&Iw(y.normalMap.format),metalnessMap:gn,roughnessMap:Jt,anisotropy:cn,anisotropyMap:$e,clearcoat:z,clearcoatMap:D,clearcoatNormalMap:T,clearcoatRoughnessMap:q,diffuseRoughness:Re,diffuseRoughnessMap:ue,dispersion:Ye,retroreflection:rt,iridescence:we,iridescenceMap:ae,iridescenceThicknessMap:_e,sheen:Dt,sheenColorMap:ye,sheenRoughnessMap:te,specularMap:se,specularColorMap:me,specularIntensityMap:B,transmission:ze,transmissionMap:re,thicknessMap:ne,gradientMap:Ae,opaque:y.transparent===!1&&y.blending===mo&&y.alphaToCoverage===!1,alphaMap:xe,alphaTest:be,alphaHash:Ge,combine:y.combine,mapUv:Ve&&f(y.map.channel),aoMapUv:qt&&f(y.aoMap.channel),lightMapUv:Ft&&f(y.lightMap.channel),bumpMapUv:ln&&f(y.bumpMap.channel),normalMapUv:Lt&&f(y.normalMap.channel),displacementMapUv:wn&&f(y.displacementMap.channel),emissiveMapUv:yt&&f(y.emissiveMap.channel),metalnessMapUv:gn&&f(y.metalnessMap.channel),roughnessMapUv:Jt&&f(y.roughnessMap.channel),anisotropyMapUv:$e&&f(y.anisotropyMap.channel),clearcoatMapUv:D&&f(y.clearcoatMap.channel),clearcoatNormalMapUv:T&&f(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&f(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ue&&f(y.diffuseRoughnessMap.channel),iridescenceMapUv:ae&&f(y.iridescenceMap.channel),iridescenceThicknessMapUv:_e&&f(y.iridescenceThicknessMap.channel),sheenColorMapUv:ye&&f(y.sheenColorMap.channel),sheenRoughnessMapUv:te&&f(y.sheenRoughnessMap.channel),specularMapUv:se&&f(y.specularMap.channel),specularColorMapUv:me&&f(y.specularColorMap.channel),specularIntensityMapUv:B&&f(y.specularIntensityMap.channel),transmissionMapUv:re&&f(y.transmissionMap.channel),thicknessMapUv:ne&&f(y.thicknessMap.channel),alphaMapUv:xe&&f(y.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(Lt||cn),vertexNormals:!!N.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:I.isPoints===!0&&!!N.attributes.uv&&(Ve||xe),fog:!!k,useFog:y.fog===!0,fogExp2:!!k&&k.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||N.attributes.normal===void 0&&Lt===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:Me,skinning:I.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:ie,morphTextureStride:fe,numSunLights:S.sun.length,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numSunLightShadows:S.sunShadowMap.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numLightProbeGrids:O.filter(Ce=>Ce.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:n.shadowMap.enabled&&P.length>0,shadowMapType:n.shadowMap.type,toneMapping:ce,decodeVideoTexture:Ve&&y.map.isVideoTexture===!0&&xt.getTransfer(y.map.colorSpace)===Et,decodeVideoTextureEmissive:yt&&y.emissiveMap.isVideoTexture===!0&&xt.getTransfer(y.emissiveMap.colorSpace)===Et,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===Bn,flipSided:y.side===Yn,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:Ke&&y.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ke&&y.extensions.multiDraw===!0||st)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return Je.vertexUv1s=l.has(1),Je.vertexUv2s=l.has(2),Je.vertexUv3s=l.has(3),l.clear(),Je}function m(y){let S=[];if(y.shaderID?S.push(y.shaderID):(S.push(y.customVertexShaderID),S.push(y.customFragmentShaderID)),y.defines!==void 0)for(let P in y.defines)S.push(P),S.push(y.defines[P]);return y.isRawShaderMaterial===!1&&(g(S,y),x(S,y),S.push(n.outputColorSpace)),S.push(y.customProgramCacheKey),S.join()}function g(y,S){y.push(S.precision),y.push(S.outputColorSpace),y.push(S.envMapMode),y.push(S.envMapPMREM),y.push(S.envMapMaxLod),y.push(S.envMapSize),y.push(S.mapUv),y.push(S.alphaMapUv),y.push(S.lightMapUv),y.push(S.aoMapUv),y.push(S.bumpMapUv),y.push(S.normalMapUv),y.push(S.displacementMapUv),y.push(S.emissiveMapUv),y.push(S.metalnessMapUv),y.push(S.roughnessMapUv),y.push(S.anisotropyMapUv),y.push(S.clearcoatMapUv),y.push(S.clearcoatNormalMapUv),y.push(S.clearcoatRoughnessMapUv),y.push(S.diffuseRoughnessMapUv),y.push(S.iridescenceMapUv),y.push(S.iridescenceThicknessMapUv),y.push(S.sheenColorMapUv),y.push(S.sheenRoughnessMapUv),y.push(S.specularMapUv),y.push(S.specularColorMapUv),y.push(S.specularIntensityMapUv),y.push(S.transmissionMapUv),y.push(S.thicknessMapUv),y.push(S.combine),y.push(S.fogExp2),y.push(S.sizeAttenuation),y.push(S.morphTargetsCount),y.push(S.numSunLights),y.push(S.numDirLights),y.push(S.numPointLights),y.push(S.numSpotLights),y.push(S.numSpotLightMaps),y.push(S.numHemiLights),y.push(S.numRectAreaLights),y.push(S.numSunLightShadows),y.push(S.numDirLightShadows),y.push(S.numPointLightShadows),y.push(S.numSpotLightShadows),y.push(S.numSpotLightShadowsWithMaps),y.push(S.numLightProbes),y.push(S.numLightProbeGrids),y.push(S.shadowMapType),y.push(S.toneMapping),y.push(S.numClippingPlanes),y.push(S.numClipIntersection),y.push(S.depthPacking)}function x(y,S){o.disableAll(),S.instancing&&o.enable(0),S.instancingColor&&o.enable(1),S.instancingMorph&&o.enable(2),S.matcap&&o.enable(3),S.envMap&&o.enable(4),S.normalMapObjectSpace&&o.enable(5),S.normalMapTangentSpace&&o.enable(6),S.clearcoat&&o.enable(7),S.iridescence&&o.enable(8),S.alphaTest&&o.enable(9),S.vertexColors&&o.enable(10),S.vertexAlphas&&o.enable(11),S.vertexUv1s&&o.enable(12),S.vertexUv2s&&o.enable(13),S.vertexUv3s&&o.enable(14),S.vertexTangents&&o.enable(15),S.anisotropy&&o.enable(16),S.alphaHash&&o.enable(17),S.batching&&o.enable(18),S.dispersion&&o.enable(19),S.retroreflection&&o.enable(24),S.diffuseRoughness&&o.enable(25),S.batchingColor&&o.enable(20),S.gradientMap&&o.enable(21),S.packedNormalMap&&o.enable(22),S.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),S.fog&&o.enable(0),S.useFog&&o.enable(1),S.flatShading&&o.enable(2),S.logarithmicDepthBuffer&&o.enable(3),S.reversedDepthBuffer&&o.enable(4),S.skinning&&o.enable(5),S.morphTargets&&o.enable(6),S.morphNormals&&o.enable(7),S.morphColors&&o.enable(8),S.premultipliedAlpha&&o.enable(9),S.shadowMapEnabled&&o.enable(10),S.doubleSided&&o.enable(11),S.flipSided&&o.enable(12),S.useDepthPacking&&o.enable(13),S.dithering&&o.enable(14),S.transmission&&o.enable(15),S.sheen&&o.enable(16),S.opaque&&o.enable(17),S.pointsUvs&&o.enable(18),S.decodeVideoTexture&&o.enable(19),S.decodeVideoTextureEmissive&&o.enable(20),S.alphaToCoverage&&o.enable(21),S.numLightProbeGrids>0&&o.enable(22),S.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function _(y){let S=d[y.type],P;if(S){let L=Ki[S];P=Pm.clone(L.uniforms)}else P=y.uniforms;return P}function M(y,S){let P=u.get(S);return P!==void 0?++P.usedTimes:(P=new Rw(n,S,y,s),c.push(P),u.set(S,P)),P}function v(y){if(--y.usedTimes===0){let S=c.indexOf(y);c[S]=c[c.length-1],c.pop(),u.delete(y.cacheKey),y.destroy()}}function E(y){a.remove(y)}function A(){a.dispose()}return{getParameters:p,getProgramCacheKey:m,getUniforms:_,acquireProgram:M,releaseProgram:v,releaseShaderCache:E,programs:c,dispose:A}}function Nw(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function Dw(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function Km(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function Jm(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,m,g,x){let _=n[e];return _===void 0?(_={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:m,renderOrder:d.renderOrder,z:g,group:x},n[e]=_):(_.id=d.id,_.object=d,_.geometry=f,_.material=p,_.materialVariant=o(d),_.groupOrder=m,_.renderOrder=d.renderOrder,_.z=g,_.group=x),e++,_}function l(d,f,p,m,g,x,_){_.reversedDepth===!0&&(g=-g);let M=a(d,f,p,m,g,x);p.transmission>0?i.push(M):p.transparent===!0?s.push(M):t.push(M)}function c(d,f,p,m,g,x){let _=a(d,f,p,m,g,x);p.transmission>0?i.unshift(_):p.transparent===!0?s.unshift(_):t.unshift(_)}function u(d,f){t.length>1&&t.sort(d||Dw),i.length>1&&i.sort(f||Km),s.length>1&&s.sort(f||Km)}function h(){for(let d=e,f=n.length;d<f;d++){let p=n[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function Uw(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new Jm,n.set(i,[o])):s>=r.length?(o=new Jm,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function Ow(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new H,color:new Qe};break;case"SpotLight":t={position:new H,direction:new H,color:new Qe,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new H,color:new Qe,distance:0,decay:0};break;case"HemisphereLight":t={direction:new H,skyColor:new Qe,groundColor:new Qe};break;case"RectAreaLight":t={color:new Qe,position:new H,halfWidth:new H,halfHeight:new H};break}return n[e.id]=t,t}}}function Fw(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new qe};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new qe};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new qe,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var kw=0;function Bw(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function zw(n){let e=new Ow,t=Fw(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new H);let s=new H,r=new pt,o=new pt;function a(c){let u=0,h=0,d=0;for(let O=0;O<9;O++)i.probe[O].set(0,0,0);let f=0,p=0,m=0,g=0,x=0,_=0,M=0,v=0,E=0,A=0,y=0,S=0,P=0,L=0;c.sort(Bw);for(let O=0,k=c.length;O<k;O++){let N=c[O],V=N.color,X=N.intensity,G=N.distance,oe=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===qs?oe=N.shadow.map.texture:oe=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)u+=V.r*X,h+=V.g*X,d+=V.b*X;else if(N.isLightProbe){for(let Z=0;Z<9;Z++)i.probe[Z].addScaledVector(N.sh.coefficients[Z],X);L++}else if(N.isSunLight){let Z=e.get(N);if(Z.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[p]=ie,i.sunShadowMap[p]=oe;let fe=Q.getViewportCount();for(let de=0;de<fe;de++)i.sunShadowMatrix[m+de]=Q.getMatrix(de),i.sunShadowCascade[m+de]=Q._cascadeData[de];m+=fe,p++}i.sun[f]=Z,f++}else if(N.isDirectionalLight){let Z=e.get(N);if(Z.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,i.directionalShadow[g]=ie,i.directionalShadowMap[g]=oe,i.directionalShadowMatrix[g]=N.shadow.matrix,E++}i.directional[g]=Z,g++}else if(N.isSpotLight){let Z=e.get(N);Z.position.setFromMatrixPosition(N.matrixWorld),Z.color.copy(V).multiplyScalar(X),Z.distance=G,Z.coneCos=Math.cos(N.angle),Z.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),Z.decay=N.decay,i.spot[_]=Z;let Q=N.shadow;if(N.map&&(i.spotLightMap[S]=N.map,S++,Q.updateMatrices(N),N.castShadow&&P++),i.spotLightMatrix[_]=Q.matrix,N.castShadow){let ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,i.spotShadow[_]=ie,i.spotShadowMap[_]=oe,y++}_++}else if(N.isRectAreaLight){let Z=e.get(N);Z.color.copy(V).multiplyScalar(X),Z.halfWidth.set(N.width*.5,0,0),Z.halfHeight.set(0,N.height*.5,0),i.rectArea[M]=Z,M++}else if(N.isPointLight){let Z=e.get(N);if(Z.color.copy(N.color).multiplyScalar(N.intensity),Z.distance=N.distance,Z.decay=N.decay,N.castShadow){let Q=N.shadow,ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,ie.shadowCameraNear=Q.camera.near,ie.shadowCameraFar=Q.camera.far,i.pointShadow[x]=ie,i.pointShadowMap[x]=oe,i.pointShadowMatrix[x]=N.shadow.matrix,A++}i.point[x]=Z,x++}else if(N.isHemisphereLight){let Z=e.get(N);Z.skyColor.copy(N.color).multiplyScalar(X),Z.groundColor.copy(N.groundColor).multiplyScalar(X),i.hemi[v]=Z,v++}}M>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Le.LTC_FLOAT_1,i.rectAreaLTC2=Le.LTC_FLOAT_2):(i.rectAreaLTC1=Le.LTC_HALF_1,i.rectAreaLTC2=Le.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=d;let I=i.hash;(I.sunLength!==f||I.directionalLength!==g||I.pointLength!==x||I.spotLength!==_||I.rectAreaLength!==M||I.hemiLength!==v||I.numSunShadows!==p||I.numDirectionalShadows!==E||I.numPointShadows!==A||I.numSpotShadows!==y||I.numSpotMaps!==S||I.numLightProbes!==L)&&(i.sun.length=f,i.directional.length=g,i.spot.length=_,i.rectArea.length=M,i.point.length=x,i.hemi.length=v,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=m,i.sunShadowCascade.length=m,i.directionalShadow.length=E,i.directionalShadowMap.length=E,i.directionalShadowMatrix.length=E,i.pointShadow.length=A,i.pointShadowMap.length=A,i.pointShadowMatrix.length=A,i.spotShadow.length=y,i.spotShadowMap.length=y,i.spotLightMatrix.length=y+S-P,i.spotLightMap.length=S,i.numSpotLightShadowsWithMaps=P,i.numLightProbes=L,I.sunLength=f,I.directionalLength=g,I.pointLength=x,I.spotLength=_,I.rectAreaLength=M,I.hemiLength=v,I.numSunShadows=p,I.numDirectionalShadows=E,I.numPointShadows=A,I.numSpotShadows=y,I.numSpotMaps=S,I.numLightProbes=L,i.version=kw++)}function l(c,u){let h=0,d=0,f=0,p=0,m=0,g=0,x=u.matrixWorldInverse;for(let _=0,M=c.length;_<M;_++){let v=c[_];if(v.isSunLight){let E=i.sun[h];E.direction.setFromMatrixPosition(v.matrixWorld),E.direction.transformDirection(x),h++}else if(v.isDirectionalLight){let E=i.directional[d];E.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),E.direction.sub(s),E.direction.transformDirection(x),d++}else if(v.isSpotLight){let E=i.spot[p];E.position.setFromMatrixPosition(v.matrixWorld),E.position.applyMatrix4(x),E.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),E.direction.sub(s),E.direction.transformDirection(x),p++}else if(v.isRectAreaLight){let E=i.rectArea[m];E.position.setFromMatrixPosition(v.matrixWorld),E.position.applyMatrix4(x),o.identity(),r.copy(v.matrixWorld),r.premultiply(x),o.extractRotation(r),E.halfWidth.set(v.width*.5,0,0),E.halfHeight.set(0,v.height*.5,0),E.halfWidth.applyMatrix4(o),E.halfHeight.applyMatrix4(o),m++}else if(v.isPointLight){let E=i.point[f];E.position.setFromMatrixPosition(v.matrixWorld),E.position.applyMatrix4(x),f++}else if(v.isHemisphereLight){let E=i.hemi[g];E.direction.setFromMatrixPosition(v.matrixWorld),E.direction.transformDirection(x),g++}}}return{setup:a,setupView:l,state:i}}function jm(n){let e=new zw(n),t=[],i=[],s=[];function r(h){u.camera=h,t.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):t.push(h)}function a(h){i.push(h)}function l(){e.setup(t),s.sort((h,d)=>h.priority-d.priority||h.id-d.id)}function c(h){e.setupView(t,h)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function Vw(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new jm(n),e.set(s,[a])):r>=o.length?(a=new jm(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var Gw=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,Hw=`uniform sampler2D shadow_pass;
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
}`,Ww=[new H(1,0,0),new H(-1,0,0),new H(0,1,0),new H(0,-1,0),new H(0,0,1),new H(0,0,-1)],$w=[new H(0,-1,0),new H(0,-1,0),new H(0,0,1),new H(0,0,-1),new H(0,-1,0),new H(0,-1,0)],Qm=new pt,Ua=new H,xd=new H;function Xw(n,e,t){let i=new Bs,s=new qe,r=new qe,o=new Zt,a=new ql,l=new Yl,c={},u=t.maxTextureSize,h={[Xs]:Yn,[Yn]:Xs,[Bn]:Bn},d=new qi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new qe},radius:{value:4}},vertexShader:Gw,fragmentShader:Hw}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new _n;p.setAttribute("position",new on(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let m=new Dn(p,d),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Ea;let x=this.type;this.render=function(A,y,S){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||A.length===0)return;this.type===Xp&&(Xe("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Ea);let P=n.getRenderTarget(),L=n.getActiveCubeFace(),I=n.getActiveMipmapLevel(),O=n.state;O.setBlending(gr),O.buffers.depth.getReversed()===!0?O.buffers.color.setClear(0,0,0,0):O.buffers.color.setClear(1,1,1,1),O.buffers.depth.setTest(!0),O.setScissorTest(!1);let k=x!==this.type;k&&y.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(V=>V.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,V=A.length;N<V;N++){let X=A[N],G=X.shadow;if(G===void 0){Xe("WebGLShadowMap:",X,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;s.copy(G.mapSize);let oe=G.getFrameExtents();s.multiply(oe),r.copy(G.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/oe.x),s.x=r.x*oe.x,G.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/oe.y),s.y=r.y*oe.y,G.mapSize.y=r.y));let Z=n.state.buffers.depth.getReversed();if(G.camera._reversedDepth=Z,G.map===null||k===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===po){if(X.isPointLight){Xe("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new ci(s.x,s.y,{format:qs,type:Pi,minFilter:qn,magFilter:qn,generateMipmaps:!1}),G.map.texture.name=X.name+".shadowMap",G.map.depthTexture=new ps(s.x,s.y,yi),G.map.depthTexture.name=X.name+".shadowMapDepth",G.map.depthTexture.format=us,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Pn,G.map.depthTexture.magFilter=Pn}else X.isPointLight?(G.map=new Fa(s.x),G.map.depthTexture=new ma(s.x,Ri)):(G.map=new ci(s.x,s.y),G.map.depthTexture=new ps(s.x,s.y,Ri)),G.map.depthTexture.name=X.name+".shadowMap",G.map.depthTexture.format=us,this.type===Ea?(G.map.depthTexture.compareFunction=Z?sd:id,G.map.depthTexture.minFilter=qn,G.map.depthTexture.magFilter=qn):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Pn,G.map.depthTexture.magFilter=Pn);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==s.x||G.map.height!==s.y)&&G.map.setSize(s.x,s.y);let Q=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();X.isPointLight!==!0&&G.updateMatrices(X,S);let ie=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:S.layers;for(let fe=0;fe<Q;fe++){let de=G.getCamera(fe);if(X.isPointLight){let ee=G.camera,he=G.matrix,ge=X.distance||ee.far;ge!==ee.far&&(ee.far=ge,ee.updateProjectionMatrix()),Ua.setFromMatrixPosition(X.matrixWorld),ee.position.copy(Ua),xd.copy(ee.position),xd.add(Ww[fe]),ee.up.copy($w[fe]),ee.lookAt(xd),ee.updateMatrixWorld(),he.makeTranslation(-Ua.x,-Ua.y,-Ua.z),Qm.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),G._frustum.setFromProjectionMatrix(Qm,ee.coordinateSystem,ee.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)n.setRenderTarget(G.map,fe),n.clear();else{fe===0&&(n.setRenderTarget(G.map),n.clear());let ee=G.getViewport(fe);o.set(r.x*ee.x,r.y*ee.y,r.x*ee.z,r.y*ee.w),O.viewport(o)}i=G.getFrustum(fe),v(y,S,de,X,ie,this.type)}G.isPointLightShadow!==!0&&this.type===po&&_(G,S),G.needsUpdate=!1}x=this.type,g.needsUpdate=!1,n.setRenderTarget(P,L,I)};function _(A,y){let S=e.update(m);d.defines.VSM_SAMPLES!==A.blurSamples&&(d.defines.VSM_SAMPLES=A.blurSamples,f.defines.VSM_SAMPLES=A.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),A.mapPass===null?A.mapPass=new ci(s.x,s.y,{format:qs,type:Pi}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),d.uniforms.shadow_pass.value=A.map.depthTexture,d.uniforms.resolution.value.set(A.map.width,A.map.height),d.uniforms.radius.value=A.radius,n.setRenderTarget(A.mapPass),n.clear(),n.renderBufferDirect(y,null,S,d,m,null),f.uniforms.shadow_pass.value=A.mapPass.texture,f.uniforms.resolution.value.set(A.map.width,A.map.height),f.uniforms.radius.value=A.radius,n.setRenderTarget(A.map),n.clear(),n.renderBufferDirect(y,null,S,f,m,null)}function M(A,y,S,P){let L=null,I=S.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(I!==void 0)L=I;else if(L=S.isPointLight===!0?l:a,n.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let O=L.uuid,k=y.uuid,N=c[O];N===void 0&&(N={},c[O]=N);let V=N[k];V===void 0&&(V=L.clone(),N[k]=V,y.addEventListener("dispose",E)),L=V}if(L.visible=y.visible,L.wireframe=y.wireframe,P===po?L.side=y.shadowSide!==null?y.shadowSide:y.side:L.side=y.shadowSide!==null?y.shadowSide:h[y.side],L.alphaMap=y.alphaMap,L.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,L.map=y.map,L.clipShadows=y.clipShadows,L.clippingPlanes=y.clippingPlanes,L.clipIntersection=y.clipIntersection,L.displacementMap=y.displacementMap,L.displacementScale=y.displacementScale,L.displacementBias=y.displacementBias,L.wireframeLinewidth=y.wireframeLinewidth,L.linewidth=y.linewidth,S.isPointLight===!0&&L.isMeshDistanceMaterial===!0){let O=n.properties.get(L);O.light=S}return L}function v(A,y,S,P,L,I){if(A.visible===!1)return;if(A.layers.test(L)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&I===po)&&(!A.frustumCulled||A.intersectsFrustum(i))){A.modelViewMatrix.multiplyMatrices(S.matrixWorldInverse,A.matrixWorld);let N=e.update(A),V=A.material;if(Array.isArray(V)){let X=N.groups;for(let G=0,oe=X.length;G<oe;G++){let Z=X[G],Q=V[Z.materialIndex];if(Q&&Q.visible){let ie=M(A,Q,P,I);A.onBeforeShadow(n,A,y,S,N,ie,Z),n.renderBufferDirect(S,null,N,ie,A,Z),A.onAfterShadow(n,A,y,S,N,ie,Z)}}}else if(V.visible){let X=M(A,V,P,I);A.onBeforeShadow(n,A,y,S,N,X,null),n.renderBufferDirect(S,null,N,X,A,null),A.onAfterShadow(n,A,y,S,N,X,null)}}let k=A.children;for(let N=0,V=k.length;N<V;N++)v(k[N],y,S,P,L,I)}function E(A){A.target.removeEventListener("dispose",E);for(let S in c){let P=c[S],L=A.target.uuid;L in P&&(P[L].dispose(),delete P[L])}}}function qw(n,e){function t(){let B=!1,re=new Zt,ne=null,Ae=new Zt(0,0,0,0);return{setMask:function(xe){ne!==xe&&!B&&(n.colorMask(xe,xe,xe,xe),ne=xe)},setLocked:function(xe){B=xe},setClear:function(xe,be,Ge,Ke,ce){ce===!0&&(xe*=Ke,be*=Ke,Ge*=Ke),re.set(xe,be,Ge,Ke),Ae.equals(re)===!1&&(n.clearColor(xe,be,Ge,Ke),Ae.copy(re))},reset:function(){B=!1,ne=null,Ae.set(-1,0,0,0)}}}function i(){let B=!1,re=!1,ne=null,Ae=null,xe=null;return{setReversed:function(be){if(re!==be){let Ge=e.get("EXT_clip_control");be?Ge.clipControlEXT(Ge.LOWER_LEFT_EXT,Ge.ZERO_TO_ONE_EXT):Ge.clipControlEXT(Ge.LOWER_LEFT_EXT,Ge.NEGATIVE_ONE_TO_ONE_EXT),re=be;let Ke=xe;xe=null,this.setClear(Ke)}},getReversed:function(){return re},setTest:function(be){be?Me(n.DEPTH_TEST):He(n.DEPTH_TEST)},setMask:function(be){ne!==be&&!B&&(n.depthMask(be),ne=be)},setFunc:function(be){if(re&&(be=Em[be]),Ae!==be){switch(be){case Rl:n.depthFunc(n.NEVER);break;case Pl:n.depthFunc(n.ALWAYS);break;case Il:n.depthFunc(n.LESS);break;case no:n.depthFunc(n.LEQUAL);break;case Ll:n.depthFunc(n.EQUAL);break;case Nl:n.depthFunc(n.GEQUAL);break;case Dl:n.depthFunc(n.GREATER);break;case Ul:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Ae=be}},setLocked:function(be){B=be},setClear:function(be){xe!==be&&(xe=be,re&&(be=1-be),n.clearDepth(be))},reset:function(){B=!1,ne=null,Ae=null,xe=null,re=!1}}}function s(){let B=!1,re=null,ne=null,Ae=null,xe=null,be=null,Ge=null,Ke=null,ce=null;return{setTest:function(Fe){B||(Fe?Me(n.STENCIL_TEST):He(n.STENCIL_TEST))},setMask:function(Fe){re!==Fe&&!B&&(n.stencilMask(Fe),re=Fe)},setFunc:function(Fe,Je,Ce){(ne!==Fe||Ae!==Je||xe!==Ce)&&(n.stencilFunc(Fe,Je,Ce),ne=Fe,Ae=Je,xe=Ce)},setOp:function(Fe,Je,Ce){(be!==Fe||Ge!==Je||Ke!==Ce)&&(n.stencilOp(Fe,Je,Ce),be=Fe,Ge=Je,Ke=Ce)},setLocked:function(Fe){B=Fe},setClear:function(Fe){ce!==Fe&&(n.clearStencil(Fe),ce=Fe)},reset:function(){B=!1,re=null,ne=null,Ae=null,xe=null,be=null,Ge=null,Ke=null,ce=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},h={},d={},f=new WeakMap,p=[],m=null,g=!1,x=null,_=null,M=null,v=null,E=null,A=null,y=null,S=new Qe(0,0,0),P=0,L=!1,I=null,O=null,k=null,N=null,V=null,X=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),G=!1,oe=0,Z=n.getParameter(n.VERSION);Z.indexOf("WebGL")!==-1?(oe=parseFloat(/^WebGL (\d)/.exec(Z)[1]),G=oe>=1):Z.indexOf("OpenGL ES")!==-1&&(oe=parseFloat(/^OpenGL ES (\d)/.exec(Z)[1]),G=oe>=2);let Q=null,ie={},fe=n.getParameter(n.SCISSOR_BOX),de=n.getParameter(n.VIEWPORT),ee=new Zt().fromArray(fe),he=new Zt().fromArray(de);function ge(B,re,ne,Ae){let xe=new Uint8Array(4),be=n.createTexture();n.bindTexture(B,be),n.texParameteri(B,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(B,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Ge=0;Ge<ne;Ge++)B===n.TEXTURE_3D||B===n.TEXTURE_2D_ARRAY?n.texImage3D(re,0,n.RGBA,1,1,Ae,0,n.RGBA,n.UNSIGNED_BYTE,xe):n.texImage2D(re+Ge,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,xe);return be}let Se={};Se[n.TEXTURE_2D]=ge(n.TEXTURE_2D,n.TEXTURE_2D,1),Se[n.TEXTURE_CUBE_MAP]=ge(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Se[n.TEXTURE_2D_ARRAY]=ge(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Se[n.TEXTURE_3D]=ge(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Me(n.DEPTH_TEST),o.setFunc(no),ln(!1),Lt(Uh),Me(n.CULL_FACE),qt(gr);function Me(B){u[B]!==!0&&(n.enable(B),u[B]=!0)}function He(B){u[B]!==!1&&(n.disable(B),u[B]=!1)}function st(B,re){return d[B]!==re?(n.bindFramebuffer(B,re),d[B]=re,B===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=re),B===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=re),!0):!1}function Ve(B,re){let ne=p,Ae=!1;if(B){ne=f.get(re),ne===void 0&&(ne=[],f.set(re,ne));let xe=B.textures;if(ne.length!==xe.length||ne[0]!==n.COLOR_ATTACHMENT0){for(let be=0,Ge=xe.length;be<Ge;be++)ne[be]=n.COLOR_ATTACHMENT0+be;ne.length=xe.length,Ae=!0}}else ne[0]!==n.BACK&&(ne[0]=n.BACK,Ae=!0);Ae&&n.drawBuffers(ne)}function ut(B){return m!==B?(n.useProgram(B),m=B,!0):!1}let at={[xr]:n.FUNC_ADD,[Yp]:n.FUNC_SUBTRACT,[Zp]:n.FUNC_REVERSE_SUBTRACT};at[Kp]=n.MIN,at[Jp]=n.MAX;let nt={[jp]:n.ZERO,[Qp]:n.ONE,[em]:n.SRC_COLOR,[Bh]:n.SRC_ALPHA,[om]:n.SRC_ALPHA_SATURATE,[sm]:n.DST_COLOR,[nm]:n.DST_ALPHA,[tm]:n.ONE_MINUS_SRC_COLOR,[zh]:n.ONE_MINUS_SRC_ALPHA,[rm]:n.ONE_MINUS_DST_COLOR,[im]:n.ONE_MINUS_DST_ALPHA,[am]:n.CONSTANT_COLOR,[lm]:n.ONE_MINUS_CONSTANT_COLOR,[cm]:n.CONSTANT_ALPHA,[um]:n.ONE_MINUS_CONSTANT_ALPHA};function qt(B,re,ne,Ae,xe,be,Ge,Ke,ce,Fe){if(B===gr){g===!0&&(He(n.BLEND),g=!1);return}if(g===!1&&(Me(n.BLEND),g=!0),B!==qp){if(B!==x||Fe!==L){if((_!==xr||E!==xr)&&(n.blendEquation(n.FUNC_ADD),_=xr,E=xr),Fe)switch(B){case mo:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Oh:n.blendFunc(n.ONE,n.ONE);break;case Fh:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case kh:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:je("WebGLState: Invalid blending: ",B);break}else switch(B){case mo:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Oh:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Fh:je("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case kh:je("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:je("WebGLState: Invalid blending: ",B);break}M=null,v=null,A=null,y=null,S.set(0,0,0),P=0,x=B,L=Fe}return}xe=xe||re,be=be||ne,Ge=Ge||Ae,(re!==_||xe!==E)&&(n.blendEquationSeparate(at[re],at[xe]),_=re,E=xe),(ne!==M||Ae!==v||be!==A||Ge!==y)&&(n.blendFuncSeparate(nt[ne],nt[Ae],nt[be],nt[Ge]),M=ne,v=Ae,A=be,y=Ge),(Ke.equals(S)===!1||ce!==P)&&(n.blendColor(Ke.r,Ke.g,Ke.b,ce),S.copy(Ke),P=ce),x=B,L=!1}function Ft(B,re){B.side===Bn?He(n.CULL_FACE):Me(n.CULL_FACE);let ne=B.side===Yn;re&&(ne=!ne),ln(ne),B.blending===mo&&B.transparent===!1?qt(gr):qt(B.blending,B.blendEquation,B.blendSrc,B.blendDst,B.blendEquationAlpha,B.blendSrcAlpha,B.blendDstAlpha,B.blendColor,B.blendAlpha,B.premultipliedAlpha),o.setFunc(B.depthFunc),o.setTest(B.depthTest),o.setMask(B.depthWrite),r.setMask(B.colorWrite);let Ae=B.stencilWrite;a.setTest(Ae),Ae&&(a.setMask(B.stencilWriteMask),a.setFunc(B.stencilFunc,B.stencilRef,B.stencilFuncMask),a.setOp(B.stencilFail,B.stencilZFail,B.stencilZPass)),yt(B.polygonOffset,B.polygonOffsetFactor,B.polygonOffsetUnits),B.alphaToCoverage===!0?Me(n.SAMPLE_ALPHA_TO_COVERAGE):He(n.SAMPLE_ALPHA_TO_COVERAGE)}function ln(B){I!==B&&(B?n.frontFace(n.CW):n.frontFace(n.CCW),I=B)}function Lt(B){B!==Wp?(Me(n.CULL_FACE),B!==O&&(B===Uh?n.cullFace(n.BACK):B===$p?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):He(n.CULL_FACE),O=B}function wn(B){B!==k&&(G&&n.lineWidth(B),k=B)}function yt(B,re,ne){B?(Me(n.POLYGON_OFFSET_FILL),(N!==re||V!==ne)&&(N=re,V=ne,o.getReversed()&&(re=-re,ne=-ne),n.polygonOffset(re,ne))):He(n.POLYGON_OFFSET_FILL)}function gn(B){B?Me(n.SCISSOR_TEST):He(n.SCISSOR_TEST)}function Jt(B){B===void 0&&(B=n.TEXTURE0+X-1),Q!==B&&(n.activeTexture(B),Q=B)}function cn(B,re,ne){ne===void 0&&(Q===null?ne=n.TEXTURE0+X-1:ne=Q);let Ae=ie[ne];Ae===void 0&&(Ae={type:void 0,texture:void 0},ie[ne]=Ae),(Ae.type!==B||Ae.texture!==re)&&(Q!==ne&&(n.activeTexture(ne),Q=ne),n.bindTexture(B,re||Se[B]),Ae.type=B,Ae.texture=re)}function z(){let B=ie[Q];B!==void 0&&B.type!==void 0&&(n.bindTexture(B.type,null),B.type=void 0,B.texture=void 0)}function Re(){try{n.compressedTexImage2D(...arguments)}catch(B){je("WebGLState:",B)}}function Ye(){try{n.compressedTexImage3D(...arguments)}catch(B){je("WebGLState:",B)}}function rt(){try{n.texSubImage2D(...arguments)}catch(B){je("WebGLState:",B)}}function we(){try{n.texSubImage3D(...arguments)}catch(B){je("WebGLState:",B)}}function Dt(){try{n.compressedTexSubImage2D(...arguments)}catch(B){je("WebGLState:",B)}}function ze(){try{n.compressedTexSubImage3D(...arguments)}catch(B){je("WebGLState:",B)}}function $e(){try{n.texStorage2D(...arguments)}catch(B){je("WebGLState:",B)}}function D(){try{n.texStorage3D(...arguments)}catch(B){je("WebGLState:",B)}}function T(){try{n.texImage2D(...arguments)}catch(B){je("WebGLState:",B)}}function q(){try{n.texImage3D(...arguments)}catch(B){je("WebGLState:",B)}}function ue(B){return h[B]!==void 0?h[B]:n.getParameter(B)}function ae(B,re){h[B]!==re&&(n.pixelStorei(B,re),h[B]=re)}function _e(B){ee.equals(B)===!1&&(n.scissor(B.x,B.y,B.z,B.w),ee.copy(B))}function ye(B){he.equals(B)===!1&&(n.viewport(B.x,B.y,B.z,B.w),he.copy(B))}function te(B,re){let ne=c.get(re);ne===void 0&&(ne=new WeakMap,c.set(re,ne));let Ae=ne.get(B);Ae===void 0&&(Ae=n.getUniformBlockIndex(re,B.name),n.uniformBlockBinding(re,Ae,Ae),ne.set(B,Ae))}function se(B,re,ne){let xe=c.get(re).get(B);l[xe]!==ne&&(n.bindBufferBase(n.UNIFORM_BUFFER,xe,ne),l[xe]=ne)}function me(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},Q=null,ie={},d={},l={},f=new WeakMap,p=[],m=null,g=!1,x=null,_=null,M=null,v=null,E=null,A=null,y=null,S=new Qe(0,0,0),P=0,L=!1,I=null,O=null,k=null,N=null,V=null,ee.set(0,0,n.canvas.width,n.canvas.height),he.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Me,disable:He,bindFramebuffer:st,drawBuffers:Ve,useProgram:ut,setBlending:qt,setMaterial:Ft,setFlipSided:ln,setCullFace:Lt,setLineWidth:wn,setPolygonOffset:yt,setScissorTest:gn,activeTexture:Jt,bindTexture:cn,unbindTexture:z,compressedTexImage2D:Re,compressedTexImage3D:Ye,texImage2D:T,texImage3D:q,pixelStorei:ae,getParameter:ue,updateUBOMapping:te,uniformBlockBinding:se,texStorage2D:$e,texStorage3D:D,texSubImage2D:rt,texSubImage3D:we,compressedTexSubImage2D:Dt,compressedTexSubImage3D:ze,scissor:_e,viewport:ye,reset:me}}function Yw(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new qe,u=new WeakMap,h=new Set,d,f=new WeakMap,p=new Set,m=new FinalizationRegistry(D=>p.delete(D)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function x(D,T){return g?new OffscreenCanvas(D,T):aa("canvas")}function _(D,T,q){let ue=1,ae=$e(D);if((ae.width>q||ae.height>q)&&(ue=q/Math.max(ae.width,ae.height)),ue<1)if(typeof HTMLImageElement<"u"&&D instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&D instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&D instanceof ImageBitmap||typeof VideoFrame<"u"&&D instanceof VideoFrame){let _e=Math.floor(ue*ae.width),ye=Math.floor(ue*ae.height);d===void 0&&(d=x(_e,ye));let te=T?x(_e,ye):d;return te.width=_e,te.height=ye,te.getContext("2d").drawImage(D,0,0,_e,ye),Xe("WebGLRenderer: Texture has been resized from ("+ae.width+"x"+ae.height+") to ("+_e+"x"+ye+")."),te}else return"data"in D&&Xe("WebGLRenderer: Image in DataTexture is too big ("+ae.width+"x"+ae.height+")."),D;return D}function M(D){return D.generateMipmaps}function v(D){n.generateMipmap(D)}function E(D){return D.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:D.isWebGL3DRenderTarget?n.TEXTURE_3D:D.isWebGLArrayRenderTarget||D.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function A(D,T,q,ue,ae,_e=!1){if(D!==null){if(n[D]!==void 0)return n[D];Xe("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+D+"'")}let ye;ue&&(ye=e.get("EXT_texture_norm16"),ye||Xe("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=T;if(T===n.RED&&(q===n.FLOAT&&(te=n.R32F),q===n.HALF_FLOAT&&(te=n.R16F),q===n.UNSIGNED_BYTE&&(te=n.R8),q===n.UNSIGNED_SHORT&&ye&&(te=ye.R16_EXT),q===n.SHORT&&ye&&(te=ye.R16_SNORM_EXT)),T===n.RED_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.R8UI),q===n.UNSIGNED_SHORT&&(te=n.R16UI),q===n.UNSIGNED_INT&&(te=n.R32UI),q===n.BYTE&&(te=n.R8I),q===n.SHORT&&(te=n.R16I),q===n.INT&&(te=n.R32I)),T===n.RG&&(q===n.FLOAT&&(te=n.RG32F),q===n.HALF_FLOAT&&(te=n.RG16F),q===n.UNSIGNED_BYTE&&(te=n.RG8),q===n.UNSIGNED_SHORT&&ye&&(te=ye.RG16_EXT),q===n.SHORT&&ye&&(te=ye.RG16_SNORM_EXT)),T===n.RG_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RG8UI),q===n.UNSIGNED_SHORT&&(te=n.RG16UI),q===n.UNSIGNED_INT&&(te=n.RG32UI),q===n.BYTE&&(te=n.RG8I),q===n.SHORT&&(te=n.RG16I),q===n.INT&&(te=n.RG32I)),T===n.RGB_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGB8UI),q===n.UNSIGNED_SHORT&&(te=n.RGB16UI),q===n.UNSIGNED_INT&&(te=n.RGB32UI),q===n.BYTE&&(te=n.RGB8I),q===n.SHORT&&(te=n.RGB16I),q===n.INT&&(te=n.RGB32I)),T===n.RGBA_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGBA8UI),q===n.UNSIGNED_SHORT&&(te=n.RGBA16UI),q===n.UNSIGNED_INT&&(te=n.RGBA32UI),q===n.BYTE&&(te=n.RGBA8I),q===n.SHORT&&(te=n.RGBA16I),q===n.INT&&(te=n.RGBA32I)),T===n.RGB&&(q===n.UNSIGNED_SHORT&&ye&&(te=ye.RGB16_EXT),q===n.SHORT&&ye&&(te=ye.RGB16_SNORM_EXT),q===n.UNSIGNED_INT_5_9_9_9_REV&&(te=n.RGB9_E5),q===n.UNSIGNED_INT_10F_11F_11F_REV&&(te=n.R11F_G11F_B10F)),T===n.RGBA){let se=_e?oa:xt.getTransfer(ae);q===n.FLOAT&&(te=n.RGBA32F),q===n.HALF_FLOAT&&(te=n.RGBA16F),q===n.UNSIGNED_BYTE&&(te=se===Et?n.SRGB8_ALPHA8:n.RGBA8),q===n.UNSIGNED_SHORT&&ye&&(te=ye.RGBA16_EXT),q===n.SHORT&&ye&&(te=ye.RGBA16_SNORM_EXT),q===n.UNSIGNED_SHORT_4_4_4_4&&(te=n.RGBA4),q===n.UNSIGNED_SHORT_5_5_5_1&&(te=n.RGB5_A1)}return(te===n.R16F||te===n.R32F||te===n.RG16F||te===n.RG32F||te===n.RGBA16F||te===n.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function y(D,T){let q;return D?T===null||T===Ri||T===yr?q=n.DEPTH24_STENCIL8:T===yi?q=n.DEPTH32F_STENCIL8:T===xo&&(q=n.DEPTH24_STENCIL8,Xe("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):T===null||T===Ri||T===yr?q=n.DEPTH_COMPONENT24:T===yi?q=n.DEPTH_COMPONENT32F:T===xo&&(q=n.DEPTH_COMPONENT16),q}function S(D,T){return M(D)===!0||D.isFramebufferTexture&&D.minFilter!==Pn&&D.minFilter!==qn?Math.log2(Math.max(T.width,T.height))+1:D.mipmaps.length>0?D.mipmaps.length:D.isCompressedTexture&&Array.isArray(D.image)?T.mipmaps.length:1}function P(D){let T=new WeakRef(D);i.get(D).__ref=T,p.add(T),m.register(D,T,T)}function L(D){let T=i.get(D).__ref;T!==void 0&&(p.delete(T),m.unregister(T))}function I(D){k(D.target)}function O(D){N(D.target)}function k(D){D.removeEventListener("dispose",I),L(D),X(D),D.isVideoTexture&&u.delete(D),D.isHTMLTexture&&h.delete(D)}function N(D){D.removeEventListener("dispose",O),L(D),oe(D)}function V(){for(let D of p){let T=D.deref();T!==void 0&&(T.isRenderTarget===!0?N(T):k(T))}p.clear(),h.clear()}function X(D){let T=i.get(D);if(T.__webglInit===void 0)return;let q=D.source,ue=f.get(q);if(ue){let ae=ue[T.__cacheKey];ae.usedTimes--,ae.usedTimes===0&&G(D),Object.keys(ue).length===0&&f.delete(q)}i.remove(D)}function G(D){let T=i.get(D);n.deleteTexture(T.__webglTexture);let q=D.source,ue=f.get(q);delete ue[T.__cacheKey],o.memory.textures--}function oe(D){let T=i.get(D);T.__depthDisposeCallback&&T.__depthDisposeCallback();let q=D.depthTexture;if(q&&q.renderTarget===D&&k(q),D.isWebGLCubeRenderTarget)for(let ae=0;ae<6;ae++){if(Array.isArray(T.__webglFramebuffer[ae]))for(let _e=0;_e<T.__webglFramebuffer[ae].length;_e++)n.deleteFramebuffer(T.__webglFramebuffer[ae][_e]);else n.deleteFramebuffer(T.__webglFramebuffer[ae]);T.__webglDepthbuffer&&n.deleteRenderbuffer(T.__webglDepthbuffer[ae])}else{if(Array.isArray(T.__webglFramebuffer))for(let ae=0;ae<T.__webglFramebuffer.length;ae++)n.deleteFramebuffer(T.__webglFramebuffer[ae]);else n.deleteFramebuffer(T.__webglFramebuffer);if(T.__webglDepthbuffer&&n.deleteRenderbuffer(T.__webglDepthbuffer),T.__webglMultisampledFramebuffer&&n.deleteFramebuffer(T.__webglMultisampledFramebuffer),T.__webglColorRenderbuffer)for(let ae=0;ae<T.__webglColorRenderbuffer.length;ae++)T.__webglColorRenderbuffer[ae]&&n.deleteRenderbuffer(T.__webglColorRenderbuffer[ae]);T.__webglDepthRenderbuffer&&n.deleteRenderbuffer(T.__webglDepthRenderbuffer)}let ue=D.textures;for(let ae=0,_e=ue.length;ae<_e;ae++){let ye=i.get(ue[ae]);ye.__webglTexture&&(n.deleteTexture(ye.__webglTexture),o.memory.textures--),i.remove(ue[ae])}i.remove(D)}let Z=0;function Q(){Z=0}function ie(){return Z}function fe(D){Z=D}function de(){let D=Z;return D>=s.maxTextures&&Xe("WebGLTextures: Trying to use "+(D+1)+" texture units while this GPU supports only "+s.maxTextures),Z+=1,D}function ee(D){let T=[];return T.push(D.wrapS),T.push(D.wrapT),T.push(D.wrapR||0),T.push(D.magFilter),T.push(D.minFilter),T.push(D.anisotropy),T.push(D.internalFormat),T.push(D.format),T.push(D.type),T.push(D.generateMipmaps),T.push(D.mipmapsAutoUpdate),T.push(D.premultiplyAlpha),T.push(D.flipY),T.push(D.unpackAlignment),T.push(D.colorSpace),T.join()}function he(D,T){let q=i.get(D);if(D.isVideoTexture&&Dt(D),D.isRenderTargetTexture===!1&&D.isExternalTexture!==!0&&D.version>0&&q.__version!==D.version){let ue=D.image;if(ue===null)Xe("WebGLRenderer: Texture marked for update but no image data found.");else if(ue.complete===!1)Xe("WebGLRenderer: Texture marked for update but image is incomplete");else{Ft(q,D,T);return}}else D.isExternalTexture&&(q.__webglTexture=D.sourceTexture?D.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,q.__webglTexture,n.TEXTURE0+T)}function ge(D,T){let q=i.get(D);if(D.isRenderTargetTexture===!1&&D.version>0&&q.__version!==D.version){Ft(q,D,T);return}else D.isExternalTexture&&(q.__webglTexture=D.sourceTexture?D.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,q.__webglTexture,n.TEXTURE0+T)}function Se(D,T){let q=i.get(D);if(D.isRenderTargetTexture===!1&&D.version>0&&q.__version!==D.version){Ft(q,D,T);return}t.bindTexture(n.TEXTURE_3D,q.__webglTexture,n.TEXTURE0+T)}function Me(D,T){let q=i.get(D);if(D.version>0&&q.__version!==D.version){ln(q,D,T);return}t.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture,n.TEXTURE0+T)}let He={[Ol]:n.REPEAT,[Wi]:n.CLAMP_TO_EDGE,[Fl]:n.MIRRORED_REPEAT},st={[Pn]:n.NEAREST,[fm]:n.NEAREST_MIPMAP_NEAREST,[Ta]:n.NEAREST_MIPMAP_LINEAR,[qn]:n.LINEAR,[uc]:n.LINEAR_MIPMAP_NEAREST,[gs]:n.LINEAR_MIPMAP_LINEAR},Ve={[xm]:n.NEVER,[rd]:n.ALWAYS,[_m]:n.LESS,[id]:n.LEQUAL,[ym]:n.EQUAL,[sd]:n.GEQUAL,[vm]:n.GREATER,[bm]:n.NOTEQUAL};function ut(D,T){if(T.type===yi&&e.has("OES_texture_float_linear")===!1&&(T.magFilter===qn||T.magFilter===uc||T.magFilter===Ta||T.magFilter===gs||T.minFilter===qn||T.minFilter===uc||T.minFilter===Ta||T.minFilter===gs)&&Xe("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(D,n.TEXTURE_WRAP_S,He[T.wrapS]),n.texParameteri(D,n.TEXTURE_WRAP_T,He[T.wrapT]),(D===n.TEXTURE_3D||D===n.TEXTURE_2D_ARRAY)&&n.texParameteri(D,n.TEXTURE_WRAP_R,He[T.wrapR]),n.texParameteri(D,n.TEXTURE_MAG_FILTER,st[T.magFilter]),n.texParameteri(D,n.TEXTURE_MIN_FILTER,st[T.minFilter]),T.compareFunction&&(n.texParameteri(D,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(D,n.TEXTURE_COMPARE_FUNC,Ve[T.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(T.magFilter===Pn||T.minFilter!==Ta&&T.minFilter!==gs||T.type===yi&&e.has("OES_texture_float_linear")===!1)return;if(T.anisotropy>1||i.get(T).__currentAnisotropy){let q=e.get("EXT_texture_filter_anisotropic");n.texParameterf(D,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(T.anisotropy,s.getMaxAnisotropy())),i.get(T).__currentAnisotropy=T.anisotropy}}}function at(D,T){let q=!1;D.__webglInit===void 0&&(D.__webglInit=!0,T.addEventListener("dispose",I),P(T));let ue=T.source,ae=f.get(ue);ae===void 0&&(ae={},f.set(ue,ae));let _e=ee(T);if(_e!==D.__cacheKey){ae[_e]===void 0&&(ae[_e]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,q=!0),ae[_e].usedTimes++;let ye=ae[D.__cacheKey];ye!==void 0&&(ae[D.__cacheKey].usedTimes--,ye.usedTimes===0&&G(T)),D.__cacheKey=_e,D.__webglTexture=ae[_e].texture}return q}function nt(D,T,q){return Math.floor(Math.floor(D/q)/T)}function qt(D,T,q,ue){let _e=D.updateRanges;if(_e.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,T.width,T.height,q,ue,T.data);else{_e.sort((B,re)=>B.start-re.start);let ye=0;for(let B=1;B<_e.length;B++){let re=_e[ye],ne=_e[B],Ae=re.start+re.count,xe=nt(ne.start,T.width,4),be=nt(re.start,T.width,4);ne.start<=Ae+1&&xe===be&&nt(ne.start+ne.count-1,T.width,4)===xe?re.count=Math.max(re.count,ne.start+ne.count-re.start):(++ye,_e[ye]=ne)}_e.length=ye+1;let te=t.getParameter(n.UNPACK_ROW_LENGTH),se=t.getParameter(n.UNPACK_SKIP_PIXELS),me=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,T.width);for(let B=0,re=_e.length;B<re;B++){let ne=_e[B],Ae=Math.floor(ne.start/4),xe=Math.ceil(ne.count/4),be=Ae%T.width,Ge=Math.floor(Ae/T.width),Ke=xe,ce=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,be),t.pixelStorei(n.UNPACK_SKIP_ROWS,Ge),t.texSubImage2D(n.TEXTURE_2D,0,be,Ge,Ke,ce,q,ue,T.data)}D.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,te),t.pixelStorei(n.UNPACK_SKIP_PIXELS,se),t.pixelStorei(n.UNPACK_SKIP_ROWS,me)}}function Ft(D,T,q){let ue=n.TEXTURE_2D;(T.isDataArrayTexture||T.isCompressedArrayTexture)&&(ue=n.TEXTURE_2D_ARRAY),T.isData3DTexture&&(ue=n.TEXTURE_3D);let ae=at(D,T),_e=T.source;t.bindTexture(ue,D.__webglTexture,n.TEXTURE0+q);let ye=i.get(_e);if(_e.version!==ye.__version||ae===!0){if(t.activeTexture(n.TEXTURE0+q),(typeof ImageBitmap<"u"&&T.image instanceof ImageBitmap)===!1){let ce=xt.getPrimaries(xt.workingColorSpace),Fe=T.colorSpace===_s?null:xt.getPrimaries(T.colorSpace),Je=T.colorSpace===_s||ce===Fe?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,T.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Je)}t.pixelStorei(n.UNPACK_ALIGNMENT,T.unpackAlignment);let se=_(T.image,!1,s.maxTextureSize);se=ze(T,se);let me=r.convert(T.format,T.colorSpace),B=r.convert(T.type),re=A(T.internalFormat,me,B,T.normalized,T.colorSpace,T.isVideoTexture);ut(ue,T);let ne,Ae=T.mipmaps,xe=T.isVideoTexture!==!0,be=ye.__version===void 0||ae===!0,Ge=_e.dataReady,Ke=S(T,se);if(T.isDepthTexture)re=y(T.format===xs,T.type),be&&(xe?t.texStorage2D(n.TEXTURE_2D,1,re,se.width,se.height):t.texImage2D(n.TEXTURE_2D,0,re,se.width,se.height,0,me,B,null));else if(T.isDataTexture)if(Ae.length>0){xe&&be&&t.texStorage2D(n.TEXTURE_2D,Ke,re,Ae[0].width,Ae[0].height);for(let ce=0,Fe=Ae.length;ce<Fe;ce++)ne=Ae[ce],xe?Ge&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,me,B,ne.data):t.texImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,me,B,ne.data);T.generateMipmaps=!1}else xe?(be&&t.texStorage2D(n.TEXTURE_2D,Ke,re,se.width,se.height),Ge&&qt(T,se,me,B)):t.texImage2D(n.TEXTURE_2D,0,re,se.width,se.height,0,me,B,se.data);else if(T.isCompressedTexture)if(T.isCompressedArrayTexture){xe&&be&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Ke,re,Ae[0].width,Ae[0].height,se.depth);for(let ce=0,Fe=Ae.length;ce<Fe;ce++)if(ne=Ae[ce],T.format!==Ii)if(me!==null)if(xe){if(Ge)if(T.layerUpdates.size>0){let Je=md(ne.width,ne.height,T.format,T.type);for(let Ce of T.layerUpdates){let ot=ne.data.subarray(Ce*Je/ne.data.BYTES_PER_ELEMENT,(Ce+1)*Je/ne.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,Ce,ne.width,ne.height,1,me,ot)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,se.depth,me,ne.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,se.depth,0,ne.data,0,0);else Xe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else xe?Ge&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,se.depth,me,B,ne.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,se.depth,0,me,B,ne.data);T.layerUpdates.size>0&&T.clearLayerUpdates()}else{xe&&be&&t.texStorage2D(n.TEXTURE_2D,Ke,re,Ae[0].width,Ae[0].height);for(let ce=0,Fe=Ae.length;ce<Fe;ce++)ne=Ae[ce],T.format!==Ii?me!==null?xe?Ge&&t.compressedTexSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,me,ne.data):t.compressedTexImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,ne.data):Xe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):xe?Ge&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,me,B,ne.data):t.texImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,me,B,ne.data)}else if(T.isDataArrayTexture)if(xe){if(be&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Ke,re,se.width,se.height,se.depth),Ge)if(T.layerUpdates.size>0){let ce=md(se.width,se.height,T.format,T.type);for(let Fe of T.layerUpdates){let Je=se.data.subarray(Fe*ce/se.data.BYTES_PER_ELEMENT,(Fe+1)*ce/se.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Fe,se.width,se.height,1,me,B,Je)}T.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,se.width,se.height,se.depth,me,B,se.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,re,se.width,se.height,se.depth,0,me,B,se.data);else if(T.isData3DTexture)xe?(be&&t.texStorage3D(n.TEXTURE_3D,Ke,re,se.width,se.height,se.depth),Ge&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,se.width,se.height,se.depth,me,B,se.data)):t.texImage3D(n.TEXTURE_3D,0,re,se.width,se.height,se.depth,0,me,B,se.data);else if(T.isFramebufferTexture){if(be)if(xe)t.texStorage2D(n.TEXTURE_2D,Ke,re,se.width,se.height);else{let ce=se.width,Fe=se.height;for(let Je=0;Je<Ke;Je++)t.texImage2D(n.TEXTURE_2D,Je,re,ce,Fe,0,me,B,null),ce>>=1,Fe>>=1}}else if(T.isHTMLTexture){if("texElementImage2D"in n){let ce=n.canvas;if(ce.hasAttribute("layoutsubtree")||ce.setAttribute("layoutsubtree","true"),se.parentNode!==ce){ce.appendChild(se),h.add(T),ce.onpaint=Fe=>{let Je=Fe.changedElements;for(let Ce of h)Je.includes(Ce.image)&&(Ce.needsUpdate=!0)},ce.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,se);else{let Je=n.RGBA,Ce=n.RGBA,ot=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,Je,Ce,ot,se)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Ae.length>0){if(xe&&be){let ce=$e(Ae[0]);t.texStorage2D(n.TEXTURE_2D,Ke,re,ce.width,ce.height)}for(let ce=0,Fe=Ae.length;ce<Fe;ce++)ne=Ae[ce],xe?Ge&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,me,B,ne):t.texImage2D(n.TEXTURE_2D,ce,re,me,B,ne);T.generateMipmaps=!1}else if(xe){if(be){let ce=$e(se);t.texStorage2D(n.TEXTURE_2D,Ke,re,ce.width,ce.height)}Ge&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,me,B,se)}else t.texImage2D(n.TEXTURE_2D,0,re,me,B,se);M(T)&&T.mipmapsAutoUpdate===!0&&v(ue),ye.__version=_e.version,T.onUpdate&&T.onUpdate(T)}D.__version=T.version}function ln(D,T,q){if(T.image.length!==6)return;let ue=at(D,T),ae=T.source;t.bindTexture(n.TEXTURE_CUBE_MAP,D.__webglTexture,n.TEXTURE0+q);let _e=i.get(ae);if(ae.version!==_e.__version||ue===!0){t.activeTexture(n.TEXTURE0+q);let ye=xt.getPrimaries(xt.workingColorSpace),te=T.colorSpace===_s?null:xt.getPrimaries(T.colorSpace),se=T.colorSpace===_s||ye===te?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,T.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,T.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,se);let me=T.isCompressedTexture||T.image[0].isCompressedTexture,B=T.image[0]&&T.image[0].isDataTexture,re=[];for(let Ce=0;Ce<6;Ce++)!me&&!B?re[Ce]=_(T.image[Ce],!0,s.maxCubemapSize):re[Ce]=B?T.image[Ce].image:T.image[Ce],re[Ce]=ze(T,re[Ce]);let ne=re[0],Ae=r.convert(T.format,T.colorSpace),xe=r.convert(T.type),be=A(T.internalFormat,Ae,xe,T.normalized,T.colorSpace),Ge=T.isVideoTexture!==!0,Ke=_e.__version===void 0||ue===!0,ce=ae.dataReady,Fe=S(T,ne);ut(n.TEXTURE_CUBE_MAP,T);let Je;if(T.isDepthTexture){if(be=y(T.format===xs,T.type),Ke)if(Ge)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,be,ne.width,ne.height);else for(let Ce=0;Ce<6;Ce++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,be,ne.width,ne.height,0,Ae,xe,null)}else if(me){Ge&&Ke&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Fe,be,ne.width,ne.height);for(let Ce=0;Ce<6;Ce++){Je=re[Ce].mipmaps;for(let ot=0;ot<Je.length;ot++){let zt=Je[ot];T.format!==Ii?Ae!==null?Ge?ce&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ot,0,0,zt.width,zt.height,Ae,zt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ot,be,zt.width,zt.height,0,zt.data):Xe("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ot,0,0,zt.width,zt.height,Ae,xe,zt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ot,be,zt.width,zt.height,0,Ae,xe,zt.data)}}}else{if(Je=T.mipmaps,Ge&&Ke){Je.length>0&&Fe++;let Ce=$e(re[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Fe,be,Ce.width,Ce.height)}for(let Ce=0;Ce<6;Ce++)if(B){Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,re[Ce].width,re[Ce].height,Ae,xe,re[Ce].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,be,re[Ce].width,re[Ce].height,0,Ae,xe,re[Ce].data);for(let ot=0;ot<Je.length;ot++){let Vn=Je[ot].image[Ce].image;Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ot+1,0,0,Vn.width,Vn.height,Ae,xe,Vn.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ot+1,be,Vn.width,Vn.height,0,Ae,xe,Vn.data)}}else{Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,Ae,xe,re[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,be,Ae,xe,re[Ce]);for(let ot=0;ot<Je.length;ot++){let zt=Je[ot];Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ot+1,0,0,Ae,xe,zt.image[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ot+1,be,Ae,xe,zt.image[Ce])}}}M(T)&&T.mipmapsAutoUpdate===!0&&v(n.TEXTURE_CUBE_MAP),_e.__version=ae.version,T.onUpdate&&T.onUpdate(T)}D.__version=T.version}function Lt(D,T,q,ue,ae,_e){let ye=r.convert(q.format,q.colorSpace),te=r.convert(q.type),se=A(q.internalFormat,ye,te,q.normalized,q.colorSpace),me=i.get(T),B=i.get(q);if(B.__renderTarget=T,!me.__hasExternalTextures){let re=Math.max(1,T.width>>_e),ne=Math.max(1,T.height>>_e);ae===n.TEXTURE_3D||ae===n.TEXTURE_2D_ARRAY?t.texImage3D(ae,_e,se,re,ne,T.depth,0,ye,te,null):t.texImage2D(ae,_e,se,re,ne,0,ye,te,null)}t.bindFramebuffer(n.FRAMEBUFFER,D),we(T)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ue,ae,B.__webglTexture,0,rt(T)):(ae===n.TEXTURE_2D||ae>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ae<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ue,ae,B.__webglTexture,_e),t.bindFramebuffer(n.FRAMEBUFFER,null)}function wn(D,T,q){if(n.bindRenderbuffer(n.RENDERBUFFER,D),T.depthBuffer){let ue=T.depthTexture,ae=ue&&ue.isDepthTexture?ue.type:null,_e=y(T.stencilBuffer,ae),ye=T.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;we(T)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,rt(T),_e,T.width,T.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,rt(T),_e,T.width,T.height):n.renderbufferStorage(n.RENDERBUFFER,_e,T.width,T.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ye,n.RENDERBUFFER,D)}else{let ue=T.textures;for(let ae=0;ae<ue.length;ae++){let _e=ue[ae],ye=r.convert(_e.format,_e.colorSpace),te=r.convert(_e.type),se=A(_e.internalFormat,ye,te,_e.normalized,_e.colorSpace);we(T)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,rt(T),se,T.width,T.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,rt(T),se,T.width,T.height):n.renderbufferStorage(n.RENDERBUFFER,se,T.width,T.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function yt(D,T,q){let ue=T.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,D),!(T.depthTexture&&T.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ae=i.get(T.depthTexture);ae.__renderTarget=T;let _e=ue?T.depthTexture.image[0]:T.depthTexture.image;(!ae.__webglTexture||_e.width!==T.width||_e.height!==T.height)&&(_e.width=T.width,_e.height=T.height,T.depthTexture.needsUpdate=!0),ue?Me(T.depthTexture,0):he(T.depthTexture,0);let ye=ae.__webglTexture,te=rt(T),se=ue?n.TEXTURE_CUBE_MAP_POSITIVE_X+q:n.TEXTURE_2D,me=T.depthTexture.format===xs?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(T.depthTexture.format===us)we(T)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,me,se,ye,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,me,se,ye,0);else if(T.depthTexture.format===xs)we(T)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,me,se,ye,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,me,se,ye,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function gn(D){let T=i.get(D),q=D.isWebGLCubeRenderTarget===!0;if(T.__boundDepthTexture!==D.depthTexture){let ue=D.depthTexture;if(T.__depthDisposeCallback&&T.__depthDisposeCallback(),ue){let ae=()=>{delete T.__boundDepthTexture,delete T.__depthDisposeCallback,ue.removeEventListener("dispose",ae)};ue.addEventListener("dispose",ae),T.__depthDisposeCallback=ae}T.__boundDepthTexture=ue}if(D.depthTexture&&!T.__autoAllocateDepthBuffer)if(q)for(let ue=0;ue<6;ue++)yt(T.__webglFramebuffer[ue],D,ue);else D.texture.mipmaps.length>0?yt(T.__webglFramebuffer[0],D,0):yt(T.__webglFramebuffer,D,0);else if(q){T.__webglDepthbuffer=[];for(let ue=0;ue<6;ue++)if(t.bindFramebuffer(n.FRAMEBUFFER,T.__webglFramebuffer[ue]),T.__webglDepthbuffer[ue]===void 0)T.__webglDepthbuffer[ue]=n.createRenderbuffer(),wn(T.__webglDepthbuffer[ue],D,!1);else{let ae=D.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_e=T.__webglDepthbuffer[ue];n.bindRenderbuffer(n.RENDERBUFFER,_e),n.framebufferRenderbuffer(n.FRAMEBUFFER,ae,n.RENDERBUFFER,_e)}}else if(D.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,T.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,T.__webglFramebuffer),T.__webglDepthbuffer===void 0)T.__webglDepthbuffer=n.createRenderbuffer(),wn(T.__webglDepthbuffer,D,!1);else{let ae=D.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_e=T.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,_e),n.framebufferRenderbuffer(n.FRAMEBUFFER,ae,n.RENDERBUFFER,_e)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function Jt(D,T,q){let ue=i.get(D);T!==void 0&&Lt(ue.__webglFramebuffer,D,D.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),q!==void 0&&gn(D)}function cn(D){let T=D.texture,q=i.get(D),ue=i.get(T);D.addEventListener("dispose",O),P(D);let ae=D.textures,_e=D.isWebGLCubeRenderTarget===!0,ye=ae.length>1;if(ye||(ue.__webglTexture===void 0&&(ue.__webglTexture=n.createTexture()),ue.__version=T.version,o.memory.textures++),_e){q.__webglFramebuffer=[];for(let te=0;te<6;te++)if(T.mipmaps.length>0){q.__webglFramebuffer[te]=[];for(let se=0;se<T.mipmaps.length;se++)q.__webglFramebuffer[te][se]=n.createFramebuffer()}else q.__webglFramebuffer[te]=n.createFramebuffer()}else{if(T.mipmaps.length>0){q.__webglFramebuffer=[];for(let te=0;te<T.mipmaps.length;te++)q.__webglFramebuffer[te]=n.createFramebuffer()}else q.__webglFramebuffer=n.createFramebuffer();if(ye)for(let te=0,se=ae.length;te<se;te++){let me=i.get(ae[te]);me.__webglTexture===void 0&&(me.__webglTexture=n.createTexture(),o.memory.textures++)}if(D.samples>0&&we(D)===!1){q.__webglMultisampledFramebuffer=n.createFramebuffer(),q.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let te=0;te<ae.length;te++){let se=ae[te];q.__webglColorRenderbuffer[te]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,q.__webglColorRenderbuffer[te]);let me=r.convert(se.format,se.colorSpace),B=r.convert(se.type),re=A(se.internalFormat,me,B,se.normalized,se.colorSpace,D.isXRRenderTarget===!0),ne=rt(D);n.renderbufferStorageMultisample(n.RENDERBUFFER,ne,re,D.width,D.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+te,n.RENDERBUFFER,q.__webglColorRenderbuffer[te])}n.bindRenderbuffer(n.RENDERBUFFER,null),D.depthBuffer&&(q.__webglDepthRenderbuffer=n.createRenderbuffer(),wn(q.__webglDepthRenderbuffer,D,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(_e){t.bindTexture(n.TEXTURE_CUBE_MAP,ue.__webglTexture),ut(n.TEXTURE_CUBE_MAP,T);for(let te=0;te<6;te++)if(T.mipmaps.length>0)for(let se=0;se<T.mipmaps.length;se++)Lt(q.__webglFramebuffer[te][se],D,T,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,se);else Lt(q.__webglFramebuffer[te],D,T,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);M(T)?v(n.TEXTURE_CUBE_MAP):T.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),t.unbindTexture()}else if(ye){for(let te=0,se=ae.length;te<se;te++){let me=ae[te],B=i.get(me),re=n.TEXTURE_2D;(D.isWebGL3DRenderTarget||D.isWebGLArrayRenderTarget)&&(re=D.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(re,B.__webglTexture),ut(re,me),Lt(q.__webglFramebuffer,D,me,n.COLOR_ATTACHMENT0+te,re,0),M(me)&&v(re)}t.unbindTexture()}else{let te=n.TEXTURE_2D;if((D.isWebGL3DRenderTarget||D.isWebGLArrayRenderTarget)&&(te=D.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(te,ue.__webglTexture),ut(te,T),T.mipmaps.length>0)for(let se=0;se<T.mipmaps.length;se++)Lt(q.__webglFramebuffer[se],D,T,n.COLOR_ATTACHMENT0,te,se);else Lt(q.__webglFramebuffer,D,T,n.COLOR_ATTACHMENT0,te,0);M(T)?v(te):T.mipmaps.length>0&&n.texParameteri(te,n.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),t.unbindTexture()}D.depthBuffer&&gn(D)}function z(D){let T=D.textures;for(let q=0,ue=T.length;q<ue;q++){let ae=T[q];if(M(ae)&&ae.mipmapsAutoUpdate===!0){let _e=E(D),ye=i.get(ae).__webglTexture;t.bindTexture(_e,ye),v(_e),t.unbindTexture()}}}let Re=[];function Ye(D){if(D.samples>0){if(we(D)===!1){let T=D.textures,q=D.width,ue=D.height,ae=n.COLOR_BUFFER_BIT,_e=D.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ye=i.get(D),te=T.length>1;if(te)for(let me=0;me<T.length;me++)t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ye.__webglMultisampledFramebuffer),D.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglFramebuffer);for(let me=0;me<T.length;me++){if(D.resolveDepthBuffer&&(D.depthBuffer&&(ae|=n.DEPTH_BUFFER_BIT),D.stencilBuffer&&D.resolveStencilBuffer&&(ae|=n.STENCIL_BUFFER_BIT)),te){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ye.__webglColorRenderbuffer[me]);let B=i.get(T[me]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,B,0)}n.blitFramebuffer(0,0,q,ue,0,0,q,ue,ae,n.NEAREST),l===!0&&(Re.length=0,Re.push(n.COLOR_ATTACHMENT0+me),D.depthBuffer&&D.storeMultisampledDepthBuffer===!1&&Re.push(_e),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Re))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),te)for(let me=0;me<T.length;me++){t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.RENDERBUFFER,ye.__webglColorRenderbuffer[me]);let B=i.get(T[me]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.TEXTURE_2D,B,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglMultisampledFramebuffer)}else if(D.depthBuffer&&D.storeMultisampledDepthBuffer===!1&&l){let T=D.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[T])}}}function rt(D){return Math.min(s.maxSamples,D.samples)}function we(D){let T=i.get(D);return D.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&T.__useRenderToTexture!==!1}function Dt(D){let T=o.render.frame;u.get(D)!==T&&(u.set(D,T),D.update())}function ze(D,T){let q=D.colorSpace,ue=D.format,ae=D.type;return D.isCompressedTexture===!0||D.isVideoTexture===!0||q!==ra&&q!==_s&&(xt.getTransfer(q)===Et?(ue!==Ii||ae!==jn)&&Xe("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):je("WebGLTextures: Unsupported texture color space:",q)),T}function $e(D){return typeof HTMLImageElement<"u"&&D instanceof HTMLImageElement?(c.width=D.naturalWidth||D.width,c.height=D.naturalHeight||D.height):typeof VideoFrame<"u"&&D instanceof VideoFrame?(c.width=D.displayWidth,c.height=D.displayHeight):(c.width=D.width,c.height=D.height),c}this.allocateTextureUnit=de,this.resetTextureUnits=Q,this.getTextureUnits=ie,this.setTextureUnits=fe,this.setTexture2D=he,this.setTexture2DArray=ge,this.setTexture3D=Se,this.setTextureCube=Me,this.rebindTextures=Jt,this.setupRenderTarget=cn,this.updateRenderTargetMipmap=z,this.updateMultisampleRenderTarget=Ye,this.setupDepthRenderbuffer=gn,this.setupFrameBufferTexture=Lt,this.useMultisampledRTT=we,this.dispose=V}function Zw(n,e){function t(i,s=_s){let r,o=xt.getTransfer(s);if(i===jn)return n.UNSIGNED_BYTE;if(i===dc)return n.UNSIGNED_SHORT_4_4_4_4;if(i===fc)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Jh)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===jh)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Zh)return n.BYTE;if(i===Kh)return n.SHORT;if(i===xo)return n.UNSIGNED_SHORT;if(i===hc)return n.INT;if(i===Ri)return n.UNSIGNED_INT;if(i===yi)return n.FLOAT;if(i===Pi)return n.HALF_FLOAT;if(i===Qh)return n.ALPHA;if(i===ed)return n.RGB;if(i===Ii)return n.RGBA;if(i===us)return n.DEPTH_COMPONENT;if(i===xs)return n.DEPTH_STENCIL;if(i===pc)return n.RED;if(i===mc)return n.RED_INTEGER;if(i===qs)return n.RG;if(i===gc)return n.RG_INTEGER;if(i===xc)return n.RGBA_INTEGER;if(i===Ca||i===Ra||i===Pa||i===Ia)if(o===Et)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Ca)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Ra)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Pa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Ia)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Ca)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Ra)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Pa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Ia)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===_c||i===yc||i===vc||i===bc)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===_c)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===yc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===vc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===bc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Sc||i===Mc||i===wc||i===Ac||i===Ec||i===La||i===Tc)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Sc||i===Mc)return o===Et?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===wc)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Ac)return r.COMPRESSED_R11_EAC;if(i===Ec)return r.COMPRESSED_SIGNED_R11_EAC;if(i===La)return r.COMPRESSED_RG11_EAC;if(i===Tc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Cc||i===Rc||i===Pc||i===Ic||i===Lc||i===Nc||i===Dc||i===Uc||i===Oc||i===Fc||i===kc||i===Bc||i===zc||i===Vc)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Cc)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Rc)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Pc)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Ic)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Lc)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Nc)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Dc)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Uc)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Oc)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Fc)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===kc)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Bc)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===zc)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Vc)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Gc||i===Hc||i===Wc)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===Gc)return o===Et?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Hc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Wc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===$c||i===Xc||i===Na||i===qc)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===$c)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Xc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Na)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===qc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===yr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var Kw=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,Jw=`
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

}`,wd=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new ga(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new qi({vertexShader:Kw,fragmentShader:Jw,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Dn(new _a(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Ad=class extends Ci{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,d=null,f=null,p=null,m=typeof XRWebGLBinding<"u",g=new wd,x={},_=t.getContextAttributes(),M=null,v=null,E=[],A=[],y=new qe,S=null,P=null,L=new Xn;L.viewport=new Zt;let I=new Xn;I.viewport=new Zt;let O=[L,I],k=new oc,N=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let he=E[ee];return he===void 0&&(he=new lo,E[ee]=he),he.getTargetRaySpace()},this.getControllerGrip=function(ee){let he=E[ee];return he===void 0&&(he=new lo,E[ee]=he),he.getGripSpace()},this.getHand=function(ee){let he=E[ee];return he===void 0&&(he=new lo,E[ee]=he),he.getHandSpace()};function X(ee){let he=A.indexOf(ee.inputSource);if(he===-1)return;let ge=E[he];ge!==void 0&&(ge.update(ee.inputSource,ee.frame,c||o),ge.dispatchEvent({type:ee.type,data:ee.inputSource}))}function G(){s.removeEventListener("select",X),s.removeEventListener("selectstart",X),s.removeEventListener("selectend",X),s.removeEventListener("squeeze",X),s.removeEventListener("squeezestart",X),s.removeEventListener("squeezeend",X),s.removeEventListener("end",G),s.removeEventListener("inputsourceschange",oe);for(let ee=0;ee<E.length;ee++){let he=A[ee];he!==null&&(A[ee]=null,E[ee].disconnect(he))}N=null,V=null,g.reset();for(let ee in x)delete x[ee];if(e.setRenderTarget(M),f=null,d=null,h=null,s=null,v=null,de.stop(),i.isPresenting=!1,e.setPixelRatio(S),e.setSize(y.width,y.height,!1),P!==null){let ee=P.camera;ee.fov=P.fov,ee.zoom=P.zoom,ee.updateProjectionMatrix(),P=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,i.isPresenting===!0&&Xe("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,i.isPresenting===!0&&Xe("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h===null&&m&&(h=new XRWebGLBinding(s,t)),h},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(M=e.getRenderTarget(),s.addEventListener("select",X),s.addEventListener("selectstart",X),s.addEventListener("selectend",X),s.addEventListener("squeeze",X),s.addEventListener("squeezestart",X),s.addEventListener("squeezeend",X),s.addEventListener("end",G),s.addEventListener("inputsourceschange",oe),_.xrCompatible!==!0&&await t.makeXRCompatible(),S=e.getPixelRatio(),e.getSize(y),m&&"createProjectionLayer"in XRWebGLBinding.prototype){let ge=null,Se=null,Me=null;_.depth&&(Me=_.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ge=_.stencil?xs:us,Se=_.stencil?yr:Ri);let He={colorFormat:t.RGBA8,depthFormat:Me,scaleFactor:r};h=this.getBinding(),d=h.createProjectionLayer(He),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),v=new ci(d.textureWidth,d.textureHeight,{format:Ii,type:jn,depthTexture:new ps(d.textureWidth,d.textureHeight,Se,void 0,void 0,void 0,void 0,void 0,void 0,ge),stencilBuffer:_.stencil,colorSpace:e.outputColorSpace,samples:_.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let ge={antialias:_.antialias,alpha:!0,depth:_.depth,stencil:_.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,ge),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),v=new ci(f.framebufferWidth,f.framebufferHeight,{format:Ii,type:jn,colorSpace:e.outputColorSpace,stencilBuffer:_.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}v.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),de.setContext(s),de.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function oe(ee){for(let he=0;he<ee.removed.length;he++){let ge=ee.removed[he],Se=A.indexOf(ge);Se>=0&&(A[Se]=null,E[Se].disconnect(ge))}for(let he=0;he<ee.added.length;he++){let ge=ee.added[he],Se=A.indexOf(ge);if(Se===-1){for(let He=0;He<E.length;He++)if(He>=A.length){A.push(ge),Se=He;break}else if(A[He]===null){A[He]=ge,Se=He;break}if(Se===-1)break}let Me=E[Se];Me&&Me.connect(ge)}}function Z(ee,he){he===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(he.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let he=ee.near,ge=ee.far;g.texture!==null&&(g.depthNear>0&&(he=g.depthNear),g.depthFar>0&&(ge=g.depthFar)),k.near=I.near=L.near=he,k.far=I.far=L.far=ge,(N!==k.near||V!==k.far)&&(s.updateRenderState({depthNear:k.near,depthFar:k.far}),N=k.near,V=k.far),k.layers.mask=ee.layers.mask|6,L.layers.mask=k.layers.mask&-5,I.layers.mask=k.layers.mask&-3;let Se=ee.parent,Me=k.cameras;Z(k,Se);for(let He=0;He<Me.length;He++)Z(Me[He],Se);k.projectionMatrix.copy(L.projectionMatrix),k.projectionMatrixInverse.copy(L.projectionMatrixInverse),P===null&&ee.isPerspectiveCamera&&(P={camera:ee,fov:ee.fov,zoom:ee.zoom}),Q(ee,k,Se)};function Q(ee,he,ge){ge===null?ee.matrix.copy(he.matrixWorld):(ee.matrix.copy(ge.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(he.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(he.projectionMatrix),ee.projectionMatrixInverse.copy(he.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=ro*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return k},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(ee){l=ee,d!==null&&(d.fixedFoveation=ee),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=ee)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(k)},this.getCameraTexture=function(ee){return x[ee]};let ie=null;function fe(ee,he){if(u=he.getViewerPose(c||o),p=he,u!==null){let ge=u.views;f!==null&&(e.setRenderTargetFramebuffer(v,f.framebuffer),e.setRenderTarget(v));let Se=!1;ge.length!==k.cameras.length&&(k.cameras.length=0,Se=!0);for(let Ve=0;Ve<ge.length;Ve++){let ut=ge[Ve],at=null;if(f!==null)at=f.getViewport(ut);else{let qt=h.getViewSubImage(d,ut);at=qt.viewport,Ve===0&&(e.setRenderTargetTextures(v,qt.colorTexture,qt.depthStencilTexture),e.setRenderTarget(v))}let nt=O[Ve];nt===void 0&&(nt=new Xn,nt.layers.enable(Ve),nt.viewport=new Zt,O[Ve]=nt),nt.matrix.fromArray(ut.transform.matrix),nt.matrix.decompose(nt.position,nt.quaternion,nt.scale),nt.projectionMatrix.fromArray(ut.projectionMatrix),nt.projectionMatrixInverse.copy(nt.projectionMatrix).invert(),nt.viewport.set(at.x,at.y,at.width,at.height),Ve===0&&(k.matrix.copy(nt.matrix),k.matrix.decompose(k.position,k.quaternion,k.scale)),Se===!0&&k.cameras.push(nt)}let Me=s.enabledFeatures;if(Me&&Me.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&m){h=i.getBinding();let Ve=h.getDepthInformation(ge[0]);Ve&&Ve.isValid&&Ve.texture&&g.init(Ve,s.renderState)}if(Me&&Me.includes("camera-access")&&m){e.state.unbindTexture(),h=i.getBinding();for(let Ve=0;Ve<ge.length;Ve++){let ut=ge[Ve].camera;if(ut){let at=x[ut];at||(at=new ga,x[ut]=at);let nt=h.getCameraImage(ut);at.sourceTexture=nt}}}}for(let ge=0;ge<E.length;ge++){let Se=A[ge],Me=E[ge];Se!==null&&Me!==void 0&&Me.update(Se,he,c||o)}ie&&ie(ee,he),he.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:he}),p=null}let de=new eg;de.setAnimationLoop(fe),this.setAnimationLoop=function(ee){ie=ee},this.dispose=function(){}}},jw=new pt,ug=new tt;ug.set(-1,0,0,0,1,0,0,0,1);function Qw(n,e){function t(g,x){g.matrixAutoUpdate===!0&&g.updateMatrix(),x.value.copy(g.matrix)}function i(g,x){x.color.getRGB(g.fogColor.value,dd(n)),x.isFog?(g.fogNear.value=x.near,g.fogFar.value=x.far):x.isFogExp2&&(g.fogDensity.value=x.density)}function s(g,x,_,M,v){x.isNodeMaterial?x.uniformsNeedUpdate=!1:x.isMeshBasicMaterial?r(g,x):x.isMeshLambertMaterial?(r(g,x),x.envMap&&(g.envMapIntensity.value=x.envMapIntensity)):x.isMeshToonMaterial?(r(g,x),h(g,x)):x.isMeshPhongMaterial?(r(g,x),u(g,x),x.envMap&&(g.envMapIntensity.value=x.envMapIntensity)):x.isMeshStandardMaterial?(r(g,x),d(g,x),x.isMeshPhysicalMaterial&&f(g,x,v)):x.isMeshMatcapMaterial?(r(g,x),p(g,x)):x.isMeshDepthMaterial?r(g,x):x.isMeshDistanceMaterial?(r(g,x),m(g,x)):x.isMeshNormalMaterial?r(g,x):x.isLineBasicMaterial?(o(g,x),x.isLineDashedMaterial&&a(g,x)):x.isPointsMaterial?l(g,x,_,M):x.isSpriteMaterial?c(g,x):x.isShadowMaterial?(g.color.value.copy(x.color),g.opacity.value=x.opacity):x.isShaderMaterial&&(x.uniformsNeedUpdate=!1)}function r(g,x){g.opacity.value=x.opacity,x.color&&g.diffuse.value.copy(x.color),x.emissive&&g.emissive.value.copy(x.emissive).multiplyScalar(x.emissiveIntensity),x.map&&(g.map.value=x.map,t(x.map,g.mapTransform)),x.alphaMap&&(g.alphaMap.value=x.alphaMap,t(x.alphaMap,g.alphaMapTransform)),x.bumpMap&&(g.bumpMap.value=x.bumpMap,t(x.bumpMap,g.bumpMapTransform),g.bumpScale.value=x.bumpScale,x.side===Yn&&(g.bumpScale.value*=-1)),x.normalMap&&(g.normalMap.value=x.normalMap,t(x.normalMap,g.normalMapTransform),g.normalScale.value.copy(x.normalScale),x.side===Yn&&g.normalScale.value.negate()),x.displacementMap&&(g.displacementMap.value=x.displacementMap,t(x.displacementMap,g.displacementMapTransform),g.displacementScale.value=x.displacementScale,g.displacementBias.value=x.displacementBias),x.emissiveMap&&(g.emissiveMap.value=x.emissiveMap,t(x.emissiveMap,g.emissiveMapTransform)),x.specularMap&&(g.specularMap.value=x.specularMap,t(x.specularMap,g.specularMapTransform)),x.alphaTest>0&&(g.alphaTest.value=x.alphaTest);let _=e.get(x),M=_.envMap,v=_.envMapRotation;M&&(g.envMap.value=M,g.envMapRotation.value.setFromMatrix4(jw.makeRotationFromEuler(v)).transpose(),M.isCubeTexture&&M.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(ug),g.reflectivity.value=x.reflectivity,g.ior.value=x.ior,g.refractionRatio.value=x.refractionRatio),x.lightMap&&(g.lightMap.value=x.lightMap,g.lightMapIntensity.value=x.lightMapIntensity,t(x.lightMap,g.lightMapTransform)),x.aoMap&&(g.aoMap.value=x.aoMap,g.aoMapIntensity.value=x.aoMapIntensity,t(x.aoMap,g.aoMapTransform))}function o(g,x){g.diffuse.value.copy(x.color),g.opacity.value=x.opacity,x.map&&(g.map.value=x.map,t(x.map,g.mapTransform))}function a(g,x){g.dashSize.value=x.dashSize,g.totalSize.value=x.dashSize+x.gapSize,g.scale.value=x.scale}function l(g,x,_,M){g.diffuse.value.copy(x.color),g.opacity.value=x.opacity,g.size.value=x.size*_,g.scale.value=M*.5,x.map&&(g.map.value=x.map,t(x.map,g.uvTransform)),x.alphaMap&&(g.alphaMap.value=x.alphaMap,t(x.alphaMap,g.alphaMapTransform)),x.alphaTest>0&&(g.alphaTest.value=x.alphaTest)}function c(g,x){g.diffuse.value.copy(x.color),g.opacity.value=x.opacity,g.rotation.value=x.rotation,x.map&&(g.map.value=x.map,t(x.map,g.mapTransform)),x.alphaMap&&(g.alphaMap.value=x.alphaMap,t(x.alphaMap,g.alphaMapTransform)),x.alphaTest>0&&(g.alphaTest.value=x.alphaTest)}function u(g,x){g.specular.value.copy(x.specular),g.shininess.value=Math.max(x.shininess,1e-4)}function h(g,x){x.gradientMap&&(g.gradientMap.value=x.gradientMap)}function d(g,x){g.metalness.value=x.metalness,x.metalnessMap&&(g.metalnessMap.value=x.metalnessMap,t(x.metalnessMap,g.metalnessMapTransform)),g.roughness.value=x.roughness,x.roughnessMap&&(g.roughnessMap.value=x.roughnessMap,t(x.roughnessMap,g.roughnessMapTransform)),x.envMap&&(g.envMapIntensity.value=x.envMapIntensity)}function f(g,x,_){g.ior.value=x.ior,x.diffuseRoughness>0&&(g.diffuseRoughness.value=x.diffuseRoughness,x.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=x.diffuseRoughnessMap,t(x.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),x.sheen>0&&(g.sheenColor.value.copy(x.sheenColor).multiplyScalar(x.sheen),g.sheenRoughness.value=x.sheenRoughness,x.sheenColorMap&&(g.sheenColorMap.value=x.sheenColorMap,t(x.sheenColorMap,g.sheenColorMapTransform)),x.sheenRoughnessMap&&(g.sheenRoughnessMap.value=x.sheenRoughnessMap,t(x.sheenRoughnessMap,g.sheenRoughnessMapTransform))),x.clearcoat>0&&(g.clearcoat.value=x.clearcoat,g.clearcoatRoughness.value=x.clearcoatRoughness,x.clearcoatMap&&(g.clearcoatMap.value=x.clearcoatMap,t(x.clearcoatMap,g.clearcoatMapTransform)),x.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=x.clearcoatRoughnessMap,t(x.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),x.clearcoatNormalMap&&(g.clearcoatNormalMap.value=x.clearcoatNormalMap,t(x.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(x.clearcoatNormalScale),x.side===Yn&&g.clearcoatNormalScale.value.negate())),x.dispersion>0&&(g.dispersion.value=x.dispersion),x.retroreflectivity>0&&(g.retroreflectivity.value=x.retroreflectivity),x.iridescence>0&&(g.iridescence.value=x.iridescence,g.iridescenceIOR.value=x.iridescenceIOR,g.iridescenceThicknessMinimum.value=x.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=x.iridescenceThicknessMaximum,x.iridescenceMap&&(g.iridescenceMap.value=x.iridescenceMap,t(x.iridescenceMap,g.iridescenceMapTransform)),x.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=x.iridescenceThicknessMap,t(x.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),x.transmission>0&&(g.transmission.value=x.transmission,g.transmissionSamplerMap.value=_.texture,g.transmissionSamplerSize.value.set(_.width,_.height),x.transmissionMap&&(g.transmissionMap.value=x.transmissionMap,t(x.transmissionMap,g.transmissionMapTransform)),g.thickness.value=x.thickness,x.thicknessMap&&(g.thicknessMap.value=x.thicknessMap,t(x.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=x.attenuationDistance,g.attenuationColor.value.copy(x.attenuationColor)),x.anisotropy>0&&(g.anisotropyVector.value.set(x.anisotropy*Math.cos(x.anisotropyRotation),x.anisotropy*Math.sin(x.anisotropyRotation)),x.anisotropyMap&&(g.anisotropyMap.value=x.anisotropyMap,t(x.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=x.specularIntensity,g.specularColor.value.copy(x.specularColor),x.specularColorMap&&(g.specularColorMap.value=x.specularColorMap,t(x.specularColorMap,g.specularColorMapTransform)),x.specularIntensityMap&&(g.specularIntensityMap.value=x.specularIntensityMap,t(x.specularIntensityMap,g.specularIntensityMapTransform))}function p(g,x){x.matcap&&(g.matcap.value=x.matcap)}function m(g,x){let _=e.get(x).light;g.referencePosition.value.setFromMatrixPosition(_.matrixWorld),g.nearDistance.value=_.shadow.camera.near,g.farDistance.value=_.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function e1(n,e,t,i){let s={},r={};function o(_,M){let v=M.program;i.uniformBlockBinding(_,v,s[_.id])}function a(_,M){let v=s[_.id];v===void 0&&(p(_),v=l(_),s[_.id]=v,_.addEventListener("dispose",g));let E=M.program;i.updateUBOMapping(_,E);let A=e.render.frame;r[_.id]!==A&&(c(_),r[_.id]=A)}function l(_){let M=n.createBuffer(),v=_.__size,E=_.usage;return n.bindBuffer(n.UNIFORM_BUFFER,M),n.bufferData(n.UNIFORM_BUFFER,v,E),n.bindBuffer(n.UNIFORM_BUFFER,null),M}function c(_){let M=s[_.id],v=_.uniforms,E=_.__cache;n.bindBuffer(n.UNIFORM_BUFFER,M);for(let A=0,y=v.length;A<y;A++){let S=v[A];if(Array.isArray(S))for(let P=0,L=S.length;P<L;P++)u(S[P],A,P,E);else u(S,A,0,E)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(_,M,v,E){if(d(_,M,v,E)===!0){let A=_.__offset,y=_.value;if(Array.isArray(y)){let S=0;for(let P=0;P<y.length;P++){let L=y[P],I=m(L,!0);h(L,_.__data,S),S+=I.storage/Float32Array.BYTES_PER_ELEMENT}}else h(y,_.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,A,_.__data)}}function h(_,M,v){typeof _=="number"||typeof _=="boolean"?M[v]=_:_.isMatrix3?(M[v]=_.elements[0],M[v+1]=_.elements[1],M[v+2]=_.elements[2],M[v+3]=0,M[v+4]=_.elements[3],M[v+5]=_.elements[4],M[v+6]=_.elements[5],M[v+7]=0,M[v+8]=_.elements[6],M[v+9]=_.elements[7],M[v+10]=_.elements[8],M[v+11]=0):ArrayBuffer.isView(_)?M.set(_.subarray(0,M.length-v),v):_.toArray(M,v)}function d(_,M,v,E){let A=_.value,y=M+"_"+v;if(Array.isArray(A)){E[y]===void 0&&(E[y]=[]);let S=E[y],P=!1;for(let L=0;L<A.length;L++)f(A[L],S,L)===!0&&(P=!0);return P}return f(A,E,y)}function f(_,M,v){if(M[v]===void 0)return typeof _=="number"||typeof _=="boolean"?M[v]=_:ArrayBuffer.isView(_)?M[v]=_.slice():M[v]=_.clone(),!0;{let E=M[v];if(typeof _=="number"||typeof _=="boolean"){if(E!==_)return M[v]=_,!0}else{if(ArrayBuffer.isView(_))return!0;if(E.equals(_)===!1)return E.copy(_),!0}}return!1}function p(_){let M=_.uniforms,v=0,E=16;for(let y=0,S=M.length;y<S;y++){let P=Array.isArray(M[y])?M[y]:[M[y]];for(let L=0,I=P.length;L<I;L++){let O=P[L],k=Array.isArray(O.value)?O.value:[O.value],N=Array.isArray(M[y])||Array.isArray(O.value),V=v;for(let G=0,oe=k.length;G<oe;G++){let Z=k[G],Q=m(Z,N),ie=v%E,fe=ie%Q.boundary,de=ie+fe;v+=fe,de!==0&&E-de<Q.storage&&(v+=E-de),G===0&&(V=v),v+=Q.storage}let X=O.type==="int"?Int32Array:O.type==="uint"?Uint32Array:Float32Array;O.__data=new X((v-V)/Float32Array.BYTES_PER_ELEMENT),O.__offset=V}}let A=v%E;return A>0&&(v+=E-A),_.__size=v,_.__cache={},this}function m(_,M){let v={boundary:0,storage:0};return typeof _=="number"||typeof _=="boolean"?(v.boundary=4,v.storage=4):_.isVector2?(v.boundary=8,v.storage=8):_.isVector3||_.isColor?(v.boundary=16,v.storage=12):_.isVector4?(v.boundary=16,v.storage=16):_.isMatrix3?(v.boundary=16,v.storage=48):_.isMatrix4?(v.boundary=16,v.storage=64):_.isTexture?Xe("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(_)?(v.boundary=16,v.storage=_.byteLength):Xe("WebGLRenderer: Unsupported uniform value type.",_),M===!0&&(v.boundary=16,v.storage=Math.ceil(v.storage/16)*16),v}function g(_){let M=_.target;M.removeEventListener("dispose",g),n.deleteBuffer(s[M.id]),delete s[M.id],delete r[M.id]}function x(){for(let _ in s)n.deleteBuffer(s[_]);s={},r={}}return{bind:o,update:a,dispose:x}}var t1=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Zi=null;function n1(){return Zi===null&&(Zi=new da(t1,16,16,qs,Pi),Zi.name="DFG_LUT",Zi.minFilter=qn,Zi.magFilter=qn,Zi.wrapS=Wi,Zi.wrapT=Wi,Zi.generateMipmaps=!1,Zi.needsUpdate=!0),Zi}var jc=class{constructor(e={}){let{canvas:t=Mm(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1,outputBufferType:f=jn}=e;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let m=f,g=new Set([xc,gc,mc]),x=new Set([jn,Ri,xo,yr,dc,fc]),_=new Uint32Array(4),M=new Int32Array(4),v={textures:[],min:[],max:[],resolution:[]},E=null,A=null,y=[],S=[],P=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Yi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let L=this,I=!1,O=null,k=null,N=null,V=null;this._outputColorSpace=oi;let X=0,G=0,oe=null,Z=-1,Q=null,ie=new Zt,fe=new Zt,de=null,ee=new Qe(0),he=0,ge=t.width,Se=t.height,Me=1,He=null,st=null,Ve=new Zt(0,0,ge,Se),ut=new Zt(0,0,ge,Se),at=!1,nt=new Bs,qt=new Gl,Ft=!1,ln=!1,Lt=new pt,wn=new H,yt=new Zt,gn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Jt=!1;function cn(){return oe===null?Me:1}let z=i;function Re(R,W){return t.getContext(R,W)}let Ye,rt,we,Dt,ze,$e,D,T,q,ue,ae,_e,ye,te,se,me,B,re,ne,Ae,xe,be,Ge;try{let R={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Fe,!1),t.addEventListener("webglcontextrestored",Je,!1),t.addEventListener("webglcontextcreationerror",Ce,!1),z===null){let W="webgl2";if(z=Re(W,R),z===null)throw Re(W)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Ke()}catch(R){throw t.removeEventListener("webglcontextlost",Fe,!1),t.removeEventListener("webglcontextrestored",Je,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),je("WebGLRenderer: "+R.message),R}function Ke(){Ye=new fM(z),Ye.init(),xe=new Zw(z,Ye),rt=new nM(z,Ye,e,xe),we=new qw(z,Ye),rt.reversedDepthBuffer&&d&&we.buffers.depth.setReversed(!0),k=z.createFramebuffer(),N=z.createFramebuffer(),V=z.createFramebuffer(),Dt=new gM(z),ze=new Nw,$e=new Yw(z,Ye,we,ze,rt,xe,Dt),D=new dM(L),T=new _v(z),be=new eM(z,T),q=new pM(z,T,Dt,be),ue=new _M(z,q,T,be,Dt),re=new xM(z,rt,$e),se=new iM(ze),ae=new Lw(L,D,Ye,rt,be,se),_e=new Qw(L,ze),ye=new Uw,te=new Vw(Ye),B=new QS(L,D,we,ue,p,l),me=new Xw(L,ue,rt),Ge=new e1(z,Dt,rt,we),ne=new tM(z,Ye,Dt),Ae=new mM(z,Ye,Dt),Dt.programs=ae.programs,L.capabilities=rt,L.extensions=Ye,L.properties=ze,L.renderLists=ye,L.shadowMap=me,L.state=we,L.info=Dt}m!==jn&&(P=new vM(m,t.width,t.height,a,s,r));let ce=new Ad(L,z);this.xr=ce,this.getContext=function(){return z},this.getContextAttributes=function(){return z.getContextAttributes()},this.forceContextLoss=function(){let R=Ye.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=Ye.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return Me},this.setPixelRatio=function(R){R!==void 0&&(Me=R,this.setSize(ge,Se,!1))},this.getSize=function(R){return R.set(ge,Se)},this.setSize=function(R,W,j=!0){if(ce.isPresenting){Xe("WebGLRenderer: Can't change size while VR device is presenting.");return}ge=R,Se=W,t.width=Math.floor(R*Me),t.height=Math.floor(W*Me),j===!0&&(t.style.width=R+"px",t.style.height=W+"px"),P!==null&&P.setSize(t.width,t.height),this.setViewport(0,0,R,W)},this.getDrawingBufferSize=function(R){return R.set(ge*Me,Se*Me).floor()},this.setDrawingBufferSize=function(R,W,j){ge=R,Se=W,Me=j,t.width=Math.floor(R*j),t.height=Math.floor(W*j),this.setViewport(0,0,R,W)},this.setEffects=function(R){if(m===jn){je("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(R){for(let W=0;W<R.length;W++)if(R[W].isOutputPass===!0){Xe("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}P.setEffects(R||[])},this.getCurrentViewport=function(R){return R.copy(ie)},this.getViewport=function(R){return R.copy(Ve)},this.setViewport=function(R,W,j,Y){R.isVector4?Ve.set(R.x,R.y,R.z,R.w):Ve.set(R,W,j,Y),we.viewport(ie.copy(Ve).multiplyScalar(cn()).round())},this.getScissor=function(R){return R.copy(ut)},this.setScissor=function(R,W,j,Y){R.isVector4?ut.set(R.x,R.y,R.z,R.w):ut.set(R,W,j,Y),we.scissor(fe.copy(ut).multiplyScalar(cn()).round())},this.getScissorTest=function(){return at},this.setScissorTest=function(R){we.setScissorTest(at=R)},this.setOpaqueSort=function(R){He=R},this.setTransparentSort=function(R){st=R},this.getClearColor=function(R){return R.copy(B.getClearColor())},this.setClearColor=function(){B.setClearColor(...arguments)},this.getClearAlpha=function(){return B.getClearAlpha()},this.setClearAlpha=function(){B.setClearAlpha(...arguments)},this.clear=function(R=!0,W=!0,j=!0){let Y=0;if(R){let K=!1;if(oe!==null){let Ee=oe.texture.format;K=g.has(Ee)}if(K){let Ee=oe.texture.type,Pe=x.has(Ee),Te=B.getClearColor(),Ie=B.getClearAlpha(),Be=Te.r,et=Te.g,ht=Te.b;Pe?(_[0]=Be,_[1]=et,_[2]=ht,_[3]=Ie,z.clearBufferuiv(z.COLOR,0,_)):(M[0]=Be,M[1]=et,M[2]=ht,M[3]=Ie,z.clearBufferiv(z.COLOR,0,M))}else Y|=z.COLOR_BUFFER_BIT}W&&(Y|=z.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(Y|=z.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&z.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(R){R.setRenderer(this),O=R},this.dispose=function(){t.removeEventListener("webglcontextlost",Fe,!1),t.removeEventListener("webglcontextrestored",Je,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),B.dispose(),ye.dispose(),te.dispose(),$e.dispose(),ze.dispose(),D.dispose(),ue.dispose(),q.dispose(),be.dispose(),Ge.dispose(),ae.dispose(),ce.dispose(),ce.removeEventListener("sessionstart",Qa),ce.removeEventListener("sessionend",Oi),Qi.stop()};function Fe(R){R.preventDefault(),ad("WebGLRenderer: Context Lost."),I=!0}function Je(){ad("WebGLRenderer: Context Restored."),I=!1;let R=Dt.autoReset,W=me.enabled,j=me.autoUpdate,Y=me.needsUpdate,K=me.type;Ke(),Dt.autoReset=R,me.enabled=W,me.autoUpdate=j,me.needsUpdate=Y,me.type=K}function Ce(R){je("WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function ot(R){let W=R.target;W.removeEventListener("dispose",ot),zt(W)}function zt(R){Vn(R),ze.remove(R)}function Vn(R){let W=ze.get(R).programs;W!==void 0&&(W.forEach(function(j){ae.releaseProgram(j)}),R.isShaderMaterial&&ae.releaseShaderCache(R))}this.renderBufferDirect=function(R,W,j,Y,K,Ee){W===null&&(W=gn);let Pe=K.isMesh&&K.matrixWorld.determinantAffine()<0,Te=Go(R,W,j,Y,K);we.setMaterial(Y,Pe);let Ie=j.index,Be=1;if(Y.wireframe===!0){if(Ie=q.getWireframeAttribute(j),Ie===void 0)return;Be=2}let et=j.drawRange,ht=j.attributes.position,ke=et.start*Be,dt=(et.start+et.count)*Be;Ee!==null&&(ke=Math.max(ke,Ee.start*Be),dt=Math.min(dt,(Ee.start+Ee.count)*Be)),Ie!==null?(ke=Math.max(ke,0),dt=Math.min(dt,Ie.count)):ht!=null&&(ke=Math.max(ke,0),dt=Math.min(dt,ht.count));let Kt=dt-ke;if(Kt<0||Kt===1/0)return;be.setup(K,Y,Te,j,Ie);let Ct,Rt=ne;if(Ie!==null&&(Ct=T.get(Ie),Rt=Ae,Rt.setIndex(Ct)),K.isMesh)Y.wireframe===!0?(we.setLineWidth(Y.wireframeLinewidth*cn()),Rt.setMode(z.LINES)):Rt.setMode(z.TRIANGLES);else if(K.isLine){let xn=Y.linewidth;xn===void 0&&(xn=1),we.setLineWidth(xn*cn()),K.isLineSegments?Rt.setMode(z.LINES):K.isLineLoop?Rt.setMode(z.LINE_LOOP):Rt.setMode(z.LINE_STRIP)}else K.isPoints?Rt.setMode(z.POINTS):K.isSprite&&Rt.setMode(z.TRIANGLES);if(K.isBatchedMesh)if(Ye.get("WEBGL_multi_draw"))Rt.renderMultiDraw(K._multiDrawStarts,K._multiDrawCounts,K._multiDrawCount);else{let xn=K._multiDrawStarts,Ue=K._multiDrawCounts,un=K._multiDrawCount,gt=Ie?T.get(Ie).bytesPerElement:1,ts=ze.get(Y).currentProgram.getUniforms();for(let hn=0;hn<un;hn++)ts.setValue(z,"_gl_DrawID",hn),Rt.render(xn[hn]/gt,Ue[hn])}else if(K.isInstancedMesh)Rt.renderInstances(ke,Kt,K.count);else if(j.isInstancedBufferGeometry){let xn=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Ue=Math.min(j.instanceCount,xn);Rt.renderInstances(ke,Kt,Ue)}else Rt.render(ke,Kt)};function Bo(R,W,j,Y){O!==null&&R.isNodeMaterial&&O.setObject(Y,R),Ft===!0&&se.setState(R,j,!1),R.transparent===!0&&R.side===Bn&&R.forceSinglePass===!1?(R.side=Yn,R.needsUpdate=!0,Fi(R,W,Y),R.side=Xs,R.needsUpdate=!0,Fi(R,W,Y),R.side=Bn):Fi(R,W,Y)}this.compile=function(R,W,j=null){j===null&&(j=R),O!==null&&O.renderStart(R,W,j),A=te.get(j),A.init(W),S.push(A),j.traverseVisible(function(K){K.isLight&&K.layers.test(W.layers)&&(A.pushLight(K),K.castShadow&&A.pushShadow(K))}),R!==j&&R.traverseVisible(function(K){K.isLight&&K.layers.test(W.layers)&&(A.pushLight(K),K.castShadow&&A.pushShadow(K))}),A.setupLights(),O!==null&&O.updateLights(A.state.lightsArray),ln=this.localClippingEnabled,Ft=se.init(this.clippingPlanes,ln),Ft===!0&&se.setGlobalState(this.clippingPlanes,W),O!==null&&me.render(A.state.shadowsArray,j,W);let Y=new Set;return R.traverse(function(K){if(!(K.isMesh||K.isPoints||K.isLine||K.isSprite))return;let Ee=K.material;if(Ee)if(Array.isArray(Ee))for(let Pe=0;Pe<Ee.length;Pe++){let Te=Ee[Pe];Bo(Te,j,W,K),Y.add(Te)}else Bo(Ee,j,W,K),Y.add(Ee)}),A=S.pop(),O!==null&&O.renderEnd(),Y},this.compileAsync=function(R,W,j=null){let Y=this.compile(R,W,j);return new Promise(K=>{function Ee(){if(Y.forEach(function(Pe){let Ie=ze.get(Pe).currentProgram;(Ie===void 0||Ie.isReady())&&Y.delete(Pe)}),Y.size===0){K(R);return}setTimeout(Ee,10)}Ye.get("KHR_parallel_shader_compile")!==null?Ee():setTimeout(Ee,10)})};let Rr=null;function qu(R){Rr&&Rr(R)}function Qa(){Qi.stop()}function Oi(){Qi.start()}let Qi=new eg;Qi.setAnimationLoop(qu),typeof self<"u"&&Qi.setContext(self),this.setAnimationLoop=function(R){Rr=R,ce.setAnimationLoop(R),R===null?Qi.stop():Qi.start()},ce.addEventListener("sessionstart",Qa),ce.addEventListener("sessionend",Oi),this.render=function(R,W){if(W!==void 0&&W.isCamera!==!0){je("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;O!==null&&O.renderStart(R,W);let j=ce.enabled===!0&&ce.isPresenting===!0,Y=P!==null&&(oe===null||j)&&P.begin(L,oe);if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),W.parent===null&&W.matrixWorldAutoUpdate===!0&&W.updateMatrixWorld(),ce.enabled===!0&&ce.isPresenting===!0&&(P===null||P.isCompositing()===!1)&&(ce.cameraAutoUpdate===!0&&ce.updateCamera(W),W=ce.getCamera()),R.isScene===!0&&R.onBeforeRender(L,R,W,oe),A=te.get(R,S.length),A.init(W),A.state.textureUnits=$e.getTextureUnits(),S.push(A),Lt.multiplyMatrices(W.projectionMatrix,W.matrixWorldInverse),W.isArrayCamera?qt.setFromArrayCamera(W):nt.setFromProjectionMatrix(Lt,_i,W.reversedDepth),ln=this.localClippingEnabled,Ft=se.init(this.clippingPlanes,ln),E=ye.get(R,y.length),E.init(),y.push(E),this.info.render.frame++,ce.enabled===!0&&ce.isPresenting===!0){let Pe=L.xr.getDepthSensingMesh();Pe!==null&&es(Pe,W,-1/0,L.sortObjects)}es(R,W,0,L.sortObjects),E.finish(),O!==null&&O.updateLights(A.state.lightsArray),L.sortObjects===!0&&E.sort(He,st),Jt=ce.enabled===!1||ce.isPresenting===!1||ce.hasDepthSensing()===!1,Jt&&B.addToRenderList(E,R),this.info.autoReset===!0&&this.info.reset(),Ft===!0&&se.beginShadows();let K=A.state.shadowsArray;if(me.render(K,R,W),Ft===!0&&se.endShadows(),(Y&&P.hasRenderPass())===!1){let Pe=E.opaque,Te=E.transmissive;if(A.setupLights(),W.isArrayCamera){let Ie=W.cameras;if(Te.length>0)for(let Be=0,et=Ie.length;Be<et;Be++){let ht=Ie[Be];Si(Pe,Te,R,ht)}Jt&&B.render(R);for(let Be=0,et=Ie.length;Be<et;Be++){let ht=Ie[Be];zo(E,R,ht,ht.viewport)}}else Te.length>0&&Si(Pe,Te,R,W),Jt&&B.render(R),zo(E,R,W)}oe!==null&&G===0&&($e.updateMultisampleRenderTarget(oe),$e.updateRenderTargetMipmap(oe)),Y&&P.end(L),R.isScene===!0&&R.onAfterRender(L,R,W),be.resetDefaultState(),Z=-1,Q=null,S.pop(),S.length>0?(A=S[S.length-1],$e.setTextureUnits(A.state.textureUnits),Ft===!0&&se.setGlobalState(L.clippingPlanes,A.state.camera)):A=null,y.pop(),y.length>0?E=y[y.length-1]:E=null,O!==null&&O.renderEnd()};function es(R,W,j,Y){if(R.visible===!1)return;if(R.layers.test(W.layers)){if(R.isGroup)j=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(W);else if(R.isLight)A.pushLight(R),R.castShadow&&A.pushShadow(R);else if(R.isSprite){let Pe=W.isArrayCamera?qt:nt;if(!R.frustumCulled||R.intersectsFrustum(Pe)){Y&&yt.setFromMatrixPosition(R.matrixWorld).applyMatrix4(Lt);let Te=ue.update(R),Ie=R.material;Ie.visible&&E.push(R,Te,Ie,j,yt.z,null,W)}}else if(R.isMesh||R.isLine||R.isPoints){let Pe=W.isArrayCamera?qt:nt;if(!R.frustumCulled||R.intersectsFrustum(Pe)){let Te=ue.update(R),Ie=R.material;if(Y&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),yt.copy(R.boundingSphere.center)):(Te.boundingSphere===null&&Te.computeBoundingSphere(),yt.copy(Te.boundingSphere.center)),yt.applyMatrix4(R.matrixWorld).applyMatrix4(Lt)),Array.isArray(Ie)){let Be=Te.groups;for(let et=0,ht=Be.length;et<ht;et++){let ke=Be[et],dt=Ie[ke.materialIndex];dt&&dt.visible&&E.push(R,Te,dt,j,yt.z,ke,W)}}else Ie.visible&&E.push(R,Te,Ie,j,yt.z,null,W)}}}let Ee=R.children;for(let Pe=0,Te=Ee.length;Pe<Te;Pe++)es(Ee[Pe],W,j,Y)}function zo(R,W,j,Y){let{opaque:K,transmissive:Ee,transparent:Pe}=R;A.setupLightsView(j),Ft===!0&&se.setGlobalState(L.clippingPlanes,j),Y&&we.viewport(ie.copy(Y)),K.length>0&&jt(K,W,j),Ee.length>0&&jt(Ee,W,j),Pe.length>0&&jt(Pe,W,j),we.buffers.depth.setTest(!0),we.buffers.depth.setMask(!0),we.buffers.color.setMask(!0),we.setPolygonOffset(!1)}function Si(R,W,j,Y){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[Y.id]===void 0){let ke=Ye.has("EXT_color_buffer_half_float")||Ye.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[Y.id]=new ci(1,1,{generateMipmaps:!0,type:ke?Pi:jn,minFilter:gs,samples:Math.max(4,rt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:xt.workingColorSpace})}let Ee=A.state.transmissionRenderTarget[Y.id],Pe=Y.viewport||ie;Ee.setSize(Pe.z*L.transmissionResolutionScale,Pe.w*L.transmissionResolutionScale);let Te=L.getRenderTarget(),Ie=L.getActiveCubeFace(),Be=L.getActiveMipmapLevel();L.setRenderTarget(Ee),L.getClearColor(ee),he=L.getClearAlpha(),he<1&&L.setClearColor(16777215,.5),L.clear(),Jt&&B.render(j);let et=L.toneMapping;L.toneMapping=Yi;let ht=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),A.setupLightsView(Y),Ft===!0&&se.setGlobalState(L.clippingPlanes,Y),jt(R,j,Y),$e.updateMultisampleRenderTarget(Ee),$e.updateRenderTargetMipmap(Ee),Ye.has("WEBGL_multisampled_render_to_texture")===!1){let ke=!1;for(let dt=0,Kt=W.length;dt<Kt;dt++){let Ct=W[dt],{object:Rt,geometry:xn,material:Ue,group:un}=Ct;if(Ue.side===Bn&&Rt.layers.test(Y.layers)){let gt=Ue.side;Ue.side=Yn,Ue.needsUpdate=!0,sn(Rt,j,Y,xn,Ue,un),Ue.side=gt,Ue.needsUpdate=!0,ke=!0}}ke===!0&&($e.updateMultisampleRenderTarget(Ee),$e.updateRenderTargetMipmap(Ee))}L.setRenderTarget(Te,Ie,Be),L.setClearColor(ee,he),ht!==void 0&&(Y.viewport=ht),L.toneMapping=et}function jt(R,W,j){let Y=W.isScene===!0?W.overrideMaterial:null;for(let K=0,Ee=R.length;K<Ee;K++){let Pe=R[K],{object:Te,geometry:Ie,group:Be}=Pe,et=Pe.material;et.allowOverride===!0&&Y!==null&&(et=Y),Te.layers.test(j.layers)&&sn(Te,W,j,Ie,et,Be)}}function sn(R,W,j,Y,K,Ee){O!==null&&K.isNodeMaterial&&O.setObject(R,K),R.onBeforeRender(L,W,j,Y,K,Ee),R.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),K.onBeforeRender(L,W,j,Y,R,Ee),K.transparent===!0&&K.side===Bn&&K.forceSinglePass===!1?(K.side=Yn,K.needsUpdate=!0,L.renderBufferDirect(j,W,Y,K,R,Ee),K.side=Xs,K.needsUpdate=!0,L.renderBufferDirect(j,W,Y,K,R,Ee),K.side=Bn):L.renderBufferDirect(j,W,Y,K,R,Ee),R.onAfterRender(L,W,j,Y,K,Ee)}function rn(R){let W=0;for(let j of R)j.texture!==null&&W++;return W}function Fi(R,W,j){W.isScene!==!0&&(W=gn);let Y=ze.get(R),K=A.state.lights,Ee=A.state.shadowsArray,Pe=K.state.version,Te=ae.getParameters(R,K.state,Ee,W,j,A.state.lightProbeGridArray),Ie=ae.getProgramCacheKey(Te),Be=Y.programs;Y.environment=R.isMeshStandardMaterial||R.isMeshLambertMaterial||R.isMeshPhongMaterial?W.environment:null,Y.fog=W.fog;let et=R.isMeshStandardMaterial||R.isMeshLambertMaterial&&!R.envMap||R.isMeshPhongMaterial&&!R.envMap;Y.envMap=D.get(R.envMap||Y.environment,et),Y.envMapRotation=Y.environment!==null&&R.envMap===null?W.environmentRotation:R.envMapRotation,Be===void 0&&(R.addEventListener("dispose",ot),Be=new Map,Y.programs=Be,Y.programVariants=new Map);let ht=Be.get(Ie);if(ht!==void 0){if(Y.currentProgram===ht&&Y.lightsStateVersion===Pe)return Vo(R,Te),ht}else Te.uniforms=ae.getUniforms(R),O!==null&&R.isNodeMaterial&&O.build(R,j,Te),R.onBeforeCompile(Te,L),ht=ae.acquireProgram(Te,Ie),Be.set(Ie,ht),Y.uniforms=Te.uniforms;let ke=Y.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(ke.clippingPlanes=se.uniform),Vo(R,Te),Y.needsLights=Ts(R),Y.lightsStateVersion=Pe,Y.needsLights&&(ke.ambientLightColor.value=K.state.ambient,ke.lightProbe.value=K.state.probe,ke.sunLights.value=K.state.sun,ke.sunLightShadows.value=K.state.sunShadow,ke.directionalLights.value=K.state.directional,ke.directionalLightShadows.value=K.state.directionalShadow,ke.spotLights.value=K.state.spot,ke.spotLightShadows.value=K.state.spotShadow,ke.rectAreaLights.value=K.state.rectArea,ke.ltc_1.value=K.state.rectAreaLTC1,ke.ltc_2.value=K.state.rectAreaLTC2,ke.pointLights.value=K.state.point,ke.pointLightShadows.value=K.state.pointShadow,ke.hemisphereLights.value=K.state.hemi,ke.sunShadowMatrix.value=K.state.sunShadowMatrix,ke.sunShadowCascade.value=K.state.sunShadowCascade,ke.directionalShadowMatrix.value=K.state.directionalShadowMatrix,ke.spotLightMatrix.value=K.state.spotLightMatrix,ke.spotLightMap.value=K.state.spotLightMap,ke.pointShadowMatrix.value=K.state.pointShadowMatrix),Y.numLightProbeGrids=rn(A.state.lightProbeGridArray),Y.currentProgram=ht,Y.uniformsList=null,ht}function ei(R,W,j,Y,K){let Ee=ze.get(R),Pe=Ee.currentProgram.id+","+Y+","+K,Te=Ee.programVariants.get(Pe);return Te===void 0?(Te=Fi(R,W,j),Ee.programVariants.set(Pe,Te)):(Ee.currentProgram=Te,Ee.uniformsList=null,Ee.outputColorSpace=Y,Ee.toneMapping=K),Te}function Es(R){if(R.uniformsList===null){let W=R.currentProgram.getUniforms();R.uniformsList=yo.seqWithValue(W.seq,R.uniforms)}return R.uniformsList}function Vo(R,W){let j=ze.get(R);j.outputColorSpace=W.outputColorSpace,j.batching=W.batching,j.batchingColor=W.batchingColor,j.instancing=W.instancing,j.instancingColor=W.instancingColor,j.instancingMorph=W.instancingMorph,j.skinning=W.skinning,j.morphTargets=W.morphTargets,j.morphNormals=W.morphNormals,j.morphColors=W.morphColors,j.morphTargetsCount=W.morphTargetsCount,j.numClippingPlanes=W.numClippingPlanes,j.numIntersection=W.numClipIntersection,j.vertexAlphas=W.vertexAlphas,j.vertexTangents=W.vertexTangents,j.toneMapping=W.toneMapping}function Go(R,W,j,Y,K){W.isScene!==!0&&(W=gn),$e.resetTextureUnits();let Ee=W.fog,Pe=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?W.environment:null,Te=oe===null?L.outputColorSpace:oe.isXRRenderTarget===!0?oe.texture.colorSpace:xt.workingColorSpace,Ie=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,Be=D.get(Y.envMap||Pe,Ie),et=Y.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,ht=!!j.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),ke=!!j.morphAttributes.position,dt=!!j.morphAttributes.normal,Kt=!!j.morphAttributes.color,Ct=Yi;Y.toneMapped&&(oe===null||oe.isXRRenderTarget===!0)&&(Ct=L.toneMapping);let Rt=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,xn=Rt!==void 0?Rt.length:0,Ue=ze.get(Y),un=A.state.lights;if(Ft===!0&&(ln===!0||R!==Q)){let Pt=R===Q&&Y.id===Z;se.setState(Y,R,Pt)}let gt=!1,ts=!1;Y.version===Ue.__version?Ue.needsLights&&Ue.lightsStateVersion!==un.state.version||K.isBatchedMesh&&Ue.batching===!1||!K.isBatchedMesh&&Ue.batching===!0||K.isBatchedMesh&&Ue.batchingColor===!0&&K._colorsTexture===null||K.isBatchedMesh&&Ue.batchingColor===!1&&K._colorsTexture!==null||K.isInstancedMesh&&Ue.instancing===!1||!K.isInstancedMesh&&Ue.instancing===!0||K.isSkinnedMesh&&Ue.skinning===!1||!K.isSkinnedMesh&&Ue.skinning===!0||K.isInstancedMesh&&Ue.instancingColor===!0&&K.instanceColor===null||K.isInstancedMesh&&Ue.instancingColor===!1&&K.instanceColor!==null||K.isInstancedMesh&&Ue.instancingMorph===!0&&K.morphTexture===null||K.isInstancedMesh&&Ue.instancingMorph===!1&&K.morphTexture!==null||Ue.envMap!==Be||Y.fog===!0&&Ue.fog!==Ee||Ue.numClippingPlanes!==void 0&&(Ue.numClippingPlanes!==se.numPlanes||Ue.numIntersection!==se.numIntersection)||Ue.vertexAlphas!==et||Ue.vertexTangents!==ht||Ue.morphTargets!==ke||Ue.morphNormals!==dt||Ue.morphColors!==Kt||Ue.morphTargetsCount!==xn||Ue.numLightProbeGrids!==rn(A.state.lightProbeGridArray)?gt=!0:(Ue.outputColorSpace!==Te||Ue.toneMapping!==Ct)&&(ts=!0):(gt=!0,Ue.__version=Y.version);let hn=Ue.currentProgram;(gt===!0||ts===!0)&&(hn=ts===!0?ei(Y,W,K,Te,Ct):Fi(Y,W,K),O&&Y.isNodeMaterial&&O.onUpdateProgram(Y,hn,Ue));let Lr=!1,ki=!1,ns=!1,lt=hn.getUniforms(),Qt=Ue.uniforms;if(we.useProgram(hn.program)&&(Lr=!0,ki=!0,ns=!0),Y.id!==Z&&(Z=Y.id,ki=!0),Lr||Q!==R){we.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),lt.setValue(z,"projectionMatrix",R.projectionMatrix),lt.setValue(z,"viewMatrix",R.matrixWorldInverse);let dn=lt.map.cameraPosition;dn!==void 0&&dn.setValue(z,wn.setFromMatrixPosition(R.matrixWorld)),rt.logarithmicDepthBuffer&&lt.setValue(z,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&lt.setValue(z,"isOrthographic",R.isOrthographicCamera===!0),Q!==R&&(Q=R,ki=!0,ns=!0)}if(Ue.needsLights&&(un.state.sunShadowMap.length>0&&lt.setValue(z,"sunShadowMap",un.state.sunShadowMap,$e),un.state.directionalShadowMap.length>0&&lt.setValue(z,"directionalShadowMap",un.state.directionalShadowMap,$e),un.state.spotShadowMap.length>0&&lt.setValue(z,"spotShadowMap",un.state.spotShadowMap,$e),un.state.pointShadowMap.length>0&&lt.setValue(z,"pointShadowMap",un.state.pointShadowMap,$e)),K.isSkinnedMesh){lt.setOptional(z,K,"bindMatrix"),lt.setOptional(z,K,"bindMatrixInverse");let Pt=K.skeleton;Pt&&(Pt.boneTexture===null&&Pt.computeBoneTexture(),lt.setValue(z,"boneTexture",Pt.boneTexture,$e))}K.isBatchedMesh&&(lt.setOptional(z,K,"batchingTexture"),lt.setValue(z,"batchingTexture",K._matricesTexture,$e),lt.setOptional(z,K,"batchingIdTexture"),lt.setValue(z,"batchingIdTexture",K._indirectTexture,$e),lt.setOptional(z,K,"batchingColorTexture"),K._colorsTexture!==null&&lt.setValue(z,"batchingColorTexture",K._colorsTexture,$e));let Gn=j.morphAttributes;if((Gn.position!==void 0||Gn.normal!==void 0||Gn.color!==void 0)&&re.update(K,j,hn),(ki||Ue.receiveShadow!==K.receiveShadow)&&(Ue.receiveShadow=K.receiveShadow,lt.setValue(z,"receiveShadow",K.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&W.environment!==null&&(Qt.envMapIntensity.value=W.environmentIntensity),Qt.dfgLUT!==void 0&&(Qt.dfgLUT.value=n1()),ki){if(lt.setValue(z,"toneMappingExposure",L.toneMappingExposure),Ue.needsLights&&Pr(Qt,ns),Ee&&Y.fog===!0&&_e.refreshFogUniforms(Qt,Ee),_e.refreshMaterialUniforms(Qt,Y,Me,Se,A.state.transmissionRenderTarget[R.id]),Ue.needsLights&&Ue.numLightProbeGrids>0){let Pt=v,dn=0;for(let Un of A.state.lightProbeGridArray)Un.texture!==null&&(Pt.textures[dn]=Un.texture,Pt.min[dn]=Un.boundingBox.min,Pt.max[dn]=Un.boundingBox.max,Pt.resolution[dn]=Un.resolution,dn++);for(let Un in Pt)Pt[Un].length=dn;Qt.probesSH.value=Pt.textures,Qt.probesMin.value=Pt.min,Qt.probesMax.value=Pt.max,Qt.probesResolution.value=Pt.resolution}yo.upload(z,Es(Ue),Qt,$e)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(yo.upload(z,Es(Ue),Qt,$e),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&lt.setValue(z,"center",K.center),lt.setValue(z,"modelViewMatrix",K.modelViewMatrix),lt.setValue(z,"normalMatrix",K.normalMatrix),lt.setValue(z,"modelMatrix",K.matrixWorld),Y.uniformsGroups!==void 0){let Pt=Y.uniformsGroups;for(let dn=0,Un=Pt.length;dn<Un;dn++){let el=Pt[dn];Ge.update(el,hn),Ge.bind(el,hn)}}return hn}function Pr(R,W){R.ambientLightColor.needsUpdate=W,R.lightProbe.needsUpdate=W,R.sunLights.needsUpdate=W,R.sunLightShadows.needsUpdate=W,R.directionalLights.needsUpdate=W,R.directionalLightShadows.needsUpdate=W,R.pointLights.needsUpdate=W,R.pointLightShadows.needsUpdate=W,R.spotLights.needsUpdate=W,R.spotLightShadows.needsUpdate=W,R.rectAreaLights.needsUpdate=W,R.hemisphereLights.needsUpdate=W}function Ts(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return X},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return oe},this.setRenderTargetTextures=function(R,W,j){let Y=ze.get(R);Y.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),ze.get(R.texture).__webglTexture=W,ze.get(R.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:j,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,W){let j=ze.get(R);j.__webglFramebuffer=W,j.__useDefaultFramebuffer=W===void 0},this.setRenderTarget=function(R,W=0,j=0){oe=R,X=W,G=j;let Y=null,K=!1,Ee=!1;if(R){let Te=ze.get(R);if(Te.__useDefaultFramebuffer!==void 0){we.bindFramebuffer(z.FRAMEBUFFER,Te.__webglFramebuffer),ie.copy(R.viewport),fe.copy(R.scissor),de=R.scissorTest,we.viewport(ie),we.scissor(fe),we.setScissorTest(de),Z=-1;return}else if(Te.__webglFramebuffer===void 0)$e.setupRenderTarget(R);else if(Te.__hasExternalTextures)$e.rebindTextures(R,ze.get(R.texture).__webglTexture,ze.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let et=R.depthTexture;if(Te.__boundDepthTexture!==et){if(et!==null&&ze.has(et)&&(R.width!==et.image.width||R.height!==et.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");$e.setupDepthRenderbuffer(R)}}let Ie=R.texture;(Ie.isData3DTexture||Ie.isDataArrayTexture||Ie.isCompressedArrayTexture)&&(Ee=!0);let Be=ze.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray(Be[W])?Y=Be[W][j]:Y=Be[W],K=!0):R.samples>0&&$e.useMultisampledRTT(R)===!1?Y=ze.get(R).__webglMultisampledFramebuffer:Array.isArray(Be)?Y=Be[j]:Y=Be,ie.copy(R.viewport),fe.copy(R.scissor),de=R.scissorTest}else ie.copy(Ve).multiplyScalar(Me).floor(),fe.copy(ut).multiplyScalar(Me).floor(),de=at;if(j!==0&&(Y=k),we.bindFramebuffer(z.FRAMEBUFFER,Y)&&we.drawBuffers(R,Y),we.viewport(ie),we.scissor(fe),we.setScissorTest(de),K){let Te=ze.get(R.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_CUBE_MAP_POSITIVE_X+W,Te.__webglTexture,j)}else if(Ee){let Te=W;for(let Ie=0;Ie<R.textures.length;Ie++){let Be=ze.get(R.textures[Ie]);z.framebufferTextureLayer(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0+Ie,Be.__webglTexture,j,Te)}}else if(R!==null&&j!==0){let Te=ze.get(R.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,Te.__webglTexture,j)}Z=-1};function Ir(R){let W=ze.get(R);return(W.__readFormat!==R.format||W.__readType!==R.type)&&(W.__readFormat=R.format,W.__readType=R.type,W.__formatReadable=rt.textureFormatReadable(R.format),W.__typeReadable=rt.textureTypeReadable(R.type)),W}this.readRenderTargetPixels=function(R,W,j,Y,K,Ee,Pe,Te=0){if(!(R&&R.isWebGLRenderTarget)){je("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ie=ze.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie){we.bindFramebuffer(z.FRAMEBUFFER,Ie);try{let Be=R.textures[Te],et=Be.format,ht=Be.type;R.textures.length>1&&z.readBuffer(z.COLOR_ATTACHMENT0+Te);let ke=Ir(Be);if(ke.__formatReadable===!1){je("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(ke.__typeReadable===!1){je("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}W>=0&&W<=R.width-Y&&j>=0&&j<=R.height-K&&z.readPixels(W,j,Y,K,xe.convert(et),xe.convert(ht),Ee)}finally{let Be=oe!==null?ze.get(oe).__webglFramebuffer:null;we.bindFramebuffer(z.FRAMEBUFFER,Be)}}},this.readRenderTargetPixelsAsync=async function(R,W,j,Y,K,Ee,Pe,Te=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ie=ze.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie)if(W>=0&&W<=R.width-Y&&j>=0&&j<=R.height-K){we.bindFramebuffer(z.FRAMEBUFFER,Ie);let Be=R.textures[Te],et=Be.format,ht=Be.type;R.textures.length>1&&z.readBuffer(z.COLOR_ATTACHMENT0+Te);let ke=Ir(Be);if(ke.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(ke.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let dt=z.createBuffer();z.bindBuffer(z.PIXEL_PACK_BUFFER,dt),z.bufferData(z.PIXEL_PACK_BUFFER,Ee.byteLength,z.STREAM_READ),z.readPixels(W,j,Y,K,xe.convert(et),xe.convert(ht),0),z.bindBuffer(z.PIXEL_PACK_BUFFER,null);let Kt=oe!==null?ze.get(oe).__webglFramebuffer:null;we.bindFramebuffer(z.FRAMEBUFFER,Kt);let Ct=z.fenceSync(z.SYNC_GPU_COMMANDS_COMPLETE,0);return z.flush(),await Am(z,Ct,4),z.bindBuffer(z.PIXEL_PACK_BUFFER,dt),z.getBufferSubData(z.PIXEL_PACK_BUFFER,0,Ee),z.bindBuffer(z.PIXEL_PACK_BUFFER,null),z.deleteBuffer(dt),z.deleteSync(Ct),Ee}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,W=null,j=0){let Y=Math.pow(2,-j),K=Math.floor(R.image.width*Y),Ee=Math.floor(R.image.height*Y),Pe=W!==null?W.x:0,Te=W!==null?W.y:0;$e.setTexture2D(R,0),z.copyTexSubImage2D(z.TEXTURE_2D,j,0,0,Pe,Te,K,Ee),we.unbindTexture()},this.copyTextureToTexture=function(R,W,j=null,Y=null,K=0,Ee=0){let Pe,Te,Ie,Be,et,ht,ke,dt,Kt,Ct=R.isCompressedTexture?R.mipmaps[Ee]:R.image;if(j!==null)Pe=j.max.x-j.min.x,Te=j.max.y-j.min.y,Ie=j.isBox3?j.max.z-j.min.z:1,Be=j.min.x,et=j.min.y,ht=j.isBox3?j.min.z:0;else{let lt=Math.pow(2,-K);Pe=Math.floor(Ct.width*lt),Te=Math.floor(Ct.height*lt),R.isDataArrayTexture?Ie=Ct.depth:R.isData3DTexture?Ie=Math.floor(Ct.depth*lt):Ie=1,Be=0,et=0,ht=0}Y!==null?(ke=Y.x,dt=Y.y,Kt=Y.z):(ke=0,dt=0,Kt=0);let Rt=xe.convert(W.format),xn=xe.convert(W.type),Ue;W.isData3DTexture?($e.setTexture3D(W,0),Ue=z.TEXTURE_3D):W.isDataArrayTexture||W.isCompressedArrayTexture?($e.setTexture2DArray(W,0),Ue=z.TEXTURE_2D_ARRAY):($e.setTexture2D(W,0),Ue=z.TEXTURE_2D),we.activeTexture(z.TEXTURE0),we.pixelStorei(z.UNPACK_FLIP_Y_WEBGL,W.flipY),we.pixelStorei(z.UNPACK_PREMULTIPLY_ALPHA_WEBGL,W.premultiplyAlpha),we.pixelStorei(z.UNPACK_ALIGNMENT,W.unpackAlignment);let un=we.getParameter(z.UNPACK_ROW_LENGTH),gt=we.getParameter(z.UNPACK_IMAGE_HEIGHT),ts=we.getParameter(z.UNPACK_SKIP_PIXELS),hn=we.getParameter(z.UNPACK_SKIP_ROWS),Lr=we.getParameter(z.UNPACK_SKIP_IMAGES);we.pixelStorei(z.UNPACK_ROW_LENGTH,Ct.width),we.pixelStorei(z.UNPACK_IMAGE_HEIGHT,Ct.height),we.pixelStorei(z.UNPACK_SKIP_PIXELS,Be),we.pixelStorei(z.UNPACK_SKIP_ROWS,et),we.pixelStorei(z.UNPACK_SKIP_IMAGES,ht);let ki=R.isDataArrayTexture||R.isData3DTexture,ns=W.isDataArrayTexture||W.isData3DTexture;if(R.isDepthTexture){let lt=ze.get(R),Qt=ze.get(W),Gn=ze.get(lt.__renderTarget),Pt=ze.get(Qt.__renderTarget);we.bindFramebuffer(z.READ_FRAMEBUFFER,Gn.__webglFramebuffer),we.bindFramebuffer(z.DRAW_FRAMEBUFFER,Pt.__webglFramebuffer);for(let dn=0;dn<Ie;dn++)ki&&(z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,ze.get(R).__webglTexture,K,ht+dn),z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,ze.get(W).__webglTexture,Ee,Kt+dn)),z.blitFramebuffer(Be,et,Be+Pe,et+Te,ke,dt,ke+Pe,dt+Te,z.DEPTH_BUFFER_BIT,z.NEAREST);we.bindFramebuffer(z.READ_FRAMEBUFFER,null),we.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else if(K!==0||R.isRenderTargetTexture||ze.has(R)){let lt=ze.get(R),Qt=ze.get(W);we.bindFramebuffer(z.READ_FRAMEBUFFER,N),we.bindFramebuffer(z.DRAW_FRAMEBUFFER,V);for(let Gn=0;Gn<Ie;Gn++)ki?z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,lt.__webglTexture,K,ht+Gn):z.framebufferTexture2D(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,lt.__webglTexture,K),ns?z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,Qt.__webglTexture,Ee,Kt+Gn):z.framebufferTexture2D(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,Qt.__webglTexture,Ee),K!==0?z.blitFramebuffer(Be,et,Be+Pe,et+Te,ke,dt,ke+Pe,dt+Te,z.COLOR_BUFFER_BIT,z.NEAREST):ns?z.copyTexSubImage3D(Ue,Ee,ke,dt,Kt+Gn,Be,et,Pe,Te):z.copyTexSubImage2D(Ue,Ee,ke,dt,Be,et,Pe,Te);we.bindFramebuffer(z.READ_FRAMEBUFFER,null),we.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else ns?R.isDataTexture||R.isData3DTexture?z.texSubImage3D(Ue,Ee,ke,dt,Kt,Pe,Te,Ie,Rt,xn,Ct.data):W.isCompressedArrayTexture?z.compressedTexSubImage3D(Ue,Ee,ke,dt,Kt,Pe,Te,Ie,Rt,Ct.data):z.texSubImage3D(Ue,Ee,ke,dt,Kt,Pe,Te,Ie,Rt,xn,Ct):R.isDataTexture?z.texSubImage2D(z.TEXTURE_2D,Ee,ke,dt,Pe,Te,Rt,xn,Ct.data):R.isCompressedTexture?z.compressedTexSubImage2D(z.TEXTURE_2D,Ee,ke,dt,Ct.width,Ct.height,Rt,Ct.data):z.texSubImage2D(z.TEXTURE_2D,Ee,ke,dt,Pe,Te,Rt,xn,Ct);we.pixelStorei(z.UNPACK_ROW_LENGTH,un),we.pixelStorei(z.UNPACK_IMAGE_HEIGHT,gt),we.pixelStorei(z.UNPACK_SKIP_PIXELS,ts),we.pixelStorei(z.UNPACK_SKIP_ROWS,hn),we.pixelStorei(z.UNPACK_SKIP_IMAGES,Lr),Ee===0&&W.generateMipmaps===!0&&W.mipmapsAutoUpdate===!0&&z.generateMipmap(Ue),we.unbindTexture()},this.initRenderTarget=function(R){ze.get(R).__webglFramebuffer===void 0&&$e.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?$e.setTextureCube(R,0):R.isData3DTexture?$e.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?$e.setTexture2DArray(R,0):$e.setTexture2D(R,0),we.unbindTexture()},this.resetState=function(){X=0,G=0,oe=null,we.reset(),be.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return _i}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=xt._getDrawingBufferColorSpace(e),t.unpackColorSpace=xt._getUnpackColorSpace()}};function br(n){let e=new ms;return n===0||(e.onBeforeCompile=t=>{t.vertexShader=t.vertexShader.replace("#include <project_vertex>",`#include <project_vertex>
      vec4 pulled = vec4(mvPosition.xyz - normalize(mvPosition.xyz) * ${n.toExponential()}, 1.0);
      vec4 nearPosition = projectionMatrix * pulled;
      gl_Position.z = nearPosition.z / nearPosition.w * gl_Position.w;`)},e.customProgramCacheKey=()=>`nearer ${n}`),e}function bo(n,e,t,i,s,r){let o=n[t]-n[e],a=n[t+1]-n[e+1],l=n[t+2]-n[e+2],c=Math.hypot(o,a,l)||1e-12;o/=c,a/=c,l/=c;let u=Math.abs(l)<.9,[h,d,f]=u?[a,-o,0]:[0,l,-a],p=Math.hypot(h,d,f);h/=p,d/=p,f/=p,s[r]=i*h,s[r+1]=i*d,s[r+2]=i*f,s[r+4]=c*o,s[r+5]=c*a,s[r+6]=c*l,s[r+8]=i*(d*l-f*a),s[r+9]=i*(f*o-h*l),s[r+10]=i*(h*a-d*o);for(let m=0;m<3;m++)s[r+12+m]=(n[e+m]+n[t+m])/2;s[r+15]=1}var tu="#d55e00",nu="#0072b2",hg=["#e2cf9f","#c5bcd9","#b7cfa2","#d6aeb9","#9cc4dd","#cfcfcf"];function Ba(n){return hg[n%hg.length]}var i1=["#453781","#39568c","#2d708e","#20908d","#29af7f","#73d055","#b8de29","#fde725"],s1=["#00224e","#083370","#35456c","#4f576c","#666970","#7d7c78","#948e77","#aea371","#c8b866","#e5cf52","#fee838"],r1=["#ffffcc","#ffeda0","#fed976","#feb24c","#fd8c3c","#fc4d2a","#e2191c","#bb0026","#800026"];function Ed(n){let e=n.map(i=>[1,3,5].map(s=>parseInt(i.slice(s,s+2),16)/255));function t(i,s=[0,0,0]){let r=Math.min(1,Math.max(0,i))*(n.length-1),o=Math.min(n.length-2,Math.floor(r));for(let a=0;a<3;a++){let l=e[o][a];s[a]=l+(r-o)*(e[o+1][a]-l)}return s}return{at:t,gradient:`linear-gradient(to right, ${n.join(", ")})`}}var So=Ed(i1),fg=Ed(s1),iu=Ed(r1);function Bt(n){return getComputedStyle(document.documentElement).getPropertyValue(n).trim()}function Ys(n){let e=matchMedia("(prefers-color-scheme: dark)");return e.addEventListener("change",n),()=>e.removeEventListener("change",n)}var dg=[[],[8,4],[8,3,2,3],[2,3]],o1=7;function ys(n){return{colour:Bt(`--line-${n%o1}`),dash:dg[n%dg.length]}}var a1=32767,Zs=24,l1=5/3*Math.PI,c1=.22,Td=.11,pg=.7,mg=3,gg=1e-6;function xg(n){let e=n.turns.map(l=>({...l,pivot:$t(l.pivot,Float32Array),axis:Float32Array.from($t(l.axis,Int16Array),c=>c/a1),left:l.left&&$t(l.left,Float32Array)})),t=n.pushes.map(l=>({...l,force:l.force&&$t(l.force,Float32Array)})),{drives:i,stages:s}=n;function r(l){let c=s.find(({start:u,end:h})=>l>u&&l<=h);return i.map(({strength:u,rise:h},d)=>c?.drives.includes(d)?u*(h>0?Math.min(1,(l-c.start)/h):1):0)}let o=(l,c)=>l.reduce((u,h,d)=>u+h*c[d],0),a=l=>l.reduce((c,{shares:u})=>{let h=s.map(d=>Math.abs(o(u,i.map(({strength:f},p)=>d.drives.includes(p)?f:0))));return Math.max(c,...h)},0);return{...n,time:$t(n.time,Float64Array),turns:e,pushes:t,strengthsAt:r,summed:o,largestTurn:a(e),largestPush:a(t)}}function _g({drives:n,strengthsAt:e},t,i){let s=e(t);return n.flatMap(({text:r,unit:o,factor:a},l)=>s[l]?[`${r}: ${i(a*s[l])} ${o}`]:[])}function yg(n){let{time:e,turns:t,pushes:i,strengthsAt:s,summed:r,largestTurn:o,largestPush:a}=n.efforts,l=Math.max(0,...t.map(P=>P.radius)),c=.05*n.mesh.span_m,u=br(Math.max(l,c)),h=new ui(new Xi(1,1,1,10),u,t.length*Zs+i.length),d=new ui(new xa(1,1,16),u,t.length+i.length),f=new kn;for(let P of[h,d])P.frustumCulled=!1,f.add(P);let p=new Float32Array(3*(Zs+2)),[m,g]=[0,0],x=(P,L,I,O,k)=>bo(p,3*L,3*I,O,P.instanceMatrix.array,16*k);function _(P,L){for(let I=0;I<3;I++)p[3*P+I]=L[I]}function M(P,L,I,O){let[k,N]=vs(e,I),X=(P.left?Cd(P.left,1,k,N)[0]:1)*r(P.shares,O)/o;if(!(Math.abs(X)>gg))return;let[G,oe]=P.ends?u1(L,P.ends):[P.pivot,P.axis].map(he=>Cd(he,3,k,N)),Z=d1(oe,P),Q=h1(oe,Z),ie=l1*Math.min(1.2,Math.abs(X))*Math.sign(X),fe=he=>G.map((ge,Se)=>ge+P.radius*(Math.cos(he)*Z[Se]+Math.sin(he)*Q[Se]));for(let he=0;he<=Zs;he++)_(he,fe(ie*(he/Zs-.5)));let de=ie/2;_(Zs+1,fe(de+Math.sign(X)*pg));let ee=Td*P.radius;for(let he=0;he<Zs;he++)x(h,he,he+1,ee,m++);x(d,Zs,Zs+1,mg*ee,g++)}function v(P,L,I,O){let[k,N]=vs(e,I),V=P.force?Cd(P.force,1,k,N)[0]:r(P.shares,O)/a;if(!(Math.abs(V)>gg))return;let X=c1*n.mesh.span_m*V,G=L.subarray(3*P.point,3*P.point+3),oe=Z=>P.direction.map((Q,ie)=>G[ie]+Z*Q);_(0,G),_(1,oe(X)),_(2,oe(X+Math.sign(V)*pg*c)),x(h,0,1,Td*c,m++),x(d,1,2,mg*Td*c,g++)}function E(P){[m,g]=[0,0];let L=s(P),I=n.pointsAt(P);for(let O of t)M(O,I,P,L);for(let O of i)v(O,I,P,L);[h.count,d.count]=[m,g];for(let O of[h,d])O.instanceMatrix.needsUpdate=!0}let A=()=>u.color.set(new Qe(Bt("--effort")));function y(){for(let P of[h,d])P.dispose(),P.geometry.dispose();u.dispose()}return{group:f,pose:E,paint:A,count:()=>g,dispose:y}}function Cd(n,e,t,i){if(n.length===e)return Array.from(n);let s=Math.min(t+1,n.length/e-1);return Array.from({length:e},(r,o)=>{let a=n[t*e+o];return a+i*(n[s*e+o]-a)})}function u1(n,[e,t]){let[i,s]=[e,t].map(a=>Array.from(n.subarray(3*a,3*a+3))),r=i.map((a,l)=>s[l]-a),o=Math.hypot(...r)||1;return[i.map((a,l)=>(a+s[l])/2),r.map(a=>a/o)]}function h1(n,e){return[0,1,2].map(t=>n[(t+1)%3]*e[(t+2)%3]-n[(t+2)%3]*e[(t+1)%3])}function d1(n,e){e.side??=n.map(Math.abs).reduce((r,o,a,l)=>o<l[r]-.001?a:r,2);let t=n[e.side],i=n.map((r,o)=>(o===e.side?1:0)-t*r),s=Math.hypot(...i)||1;return i.map(r=>r/s)}var bs="tendon energy",Pd=Symbol("readings of single creases");function $t(n,e){let t=atob(n),i=new Uint8Array(t.length);for(let s=0;s<t.length;s++)i[s]=t.charCodeAt(s);return new e(i.buffer)}function vg({low:n,step:e,steps:t}){return Float32Array.from($t(t,Uint16Array),(i,s)=>n[s%n.length]+e[s%n.length]*i)}function Zn(n){let e=$t(n.time,Float64Array),t=typeof n.points=="string"?$t(n.points,Float32Array):vg(n.points),i=3*n.pointCount,s={[bs]:{width:n.tendonParts.length,values:$t(n.tendonEnergy_J,Float32Array)}};for(let _ of n.readings)s[_.name]={width:_.parts.length,values:$t(_.values,Float32Array)};let{creases:r=null}=n,o=(n.along??[]).map(_=>({..._,key:Symbol(_.name)}));for(let{key:_,values:M}of o)s[_]={width:1,values:$t(M,Float32Array)};r&&(s[Pd]={width:r.values.low.length,values:vg(r.values)});let a=Int32Array.from(n.between),l=Float64Array.from(n.share),c=new Float32Array(i);function u(_,M=c){return Rd(e,t,i,_,M),M}function h(_,M=new Float32Array(3*l.length)){return d(u(_),M)}function d(_,M){for(let v=0;v<l.length;v++){let E=3*a[2*v],A=3*a[2*v+1];for(let y=0;y<3;y++){let S=_[E+y];M[3*v+y]=S+l[v]*(_[A+y]-S)}}return M}function f(_,M,v=new Float32Array(s[_].width)){return Rd(e,s[_].values,s[_].width,M,v),v}function p(_,M){let{width:v,values:E}=s[_];return Float32Array.from(e,(A,y)=>E[y*v+M])}let m=$t(n.restLength_m,Float32Array);function g(_,M){m.length===M.length?M.set(m):Rd(e,m,M.length,_,M)}let x=n.efforts&&xg(n.efforts);return{name:n.name,reach:Math.max(n.base.radius,x?.pushes.length?.12*n.span_m:0,...(x?.turns??[]).map(_=>.4*_.radius)),mesh:n,marks:n.marks,stages:n.stages,tendons:n.tendonParts.length,readings:n.readings,along:o,creases:r,time:e,start:e[0],end:e[e.length-1],efforts:x,strained:n.built!==null,builtVertices:()=>d($t(n.built,Float32Array),new Float32Array(3*l.length)),restLengthsAt:g,pointsAt:u,verticesAt:h,verticesOf:d,valuesAt:f,line:p,stageAt:_=>n.stages.findLast(M=>M.start<=_)??n.stages[0],markAt:_=>n.marks.find(M=>Math.abs(M.time-_)<1e-9)}}function Rd(n,e,t,i,s){let[r,o]=vs(n,i),a=r*t,l=Math.min(r+1,n.length-1)*t;for(let c=0;c<t;c++){let u=e[a+c];s[c]=o===0?u:u+o*(e[l+c]-u)}}function vs(n,e){if(!(e>n[0]))return[0,0];let t=n.length-1;if(e>=n[t])return[t,0];let i=0,s=t;for(;s-i>1;){let r=i+s>>1;n[r]<=e?i=r:s=r}return[i,(e-n[i])/(n[i+1]-n[i])]}function za(n,e,t){let[i,s]=vs(n,t);return s===0?e[i]:e[i]+s*(e[i+1]-e[i])}function su(){return document.getElementById("engine-program")!==null}async function Mo(n,e){let t=new Blob([$t(document.getElementById("engine-script").textContent,Uint8Array)]).stream(),i=await new Response(t.pipeThrough(new DecompressionStream("deflate"))).text(),s=URL.createObjectURL(new Blob([i],{type:"text/javascript"})),r=new Worker(s),o=new Map,a=0;r.onmessage=({data:u})=>{let h=o.get(u.to);h?(o.delete(u.to),u.said==="refused"?h.refuse(new Error(u.why)):h.take(u)):e(u)},r.onerror=u=>{u.preventDefault();let h=new Error(u.message||"the engine stopped");for(let{refuse:d}of o.values())d(h);o.clear(),e({said:"refused",why:h.message})};function l(u){let h=++a;return new Promise((d,f)=>{o.set(h,{take:d,refuse:f}),r.postMessage({...u,number:h})})}function c(){r.terminate(),URL.revokeObjectURL(s)}try{let u=document.getElementById("engine-program").textContent,{frame:h,version:d}=await l({act:"load",program:u,text:n}),f={first:h,version:d,ask:l,send:m=>r.postMessage(m),take:p,end:c};return f;async function p(m,g){let{frame:x}=await l({act:"load",text:m});return e=g,{...f,first:x}}}catch(u){throw c(),u}}var bg={type:"change"},Ld={type:"start"},Mg={type:"end"},ru=new ks,Sg=new ai,f1=Math.cos(70*hd.DEG2RAD),bn=new H,Qn=2*Math.PI,wt={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Id=1e-6,ou=class extends Aa{constructor(e,t=null){super(e,t),this.state=wt.NONE,this.target=new H,this.cursor=new H,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Ws.ROTATE,MIDDLE:Ws.DOLLY,RIGHT:Ws.PAN},this.touches={ONE:$s.ROTATE,TWO:$s.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new H,this._lastQuaternion=new li,this._lastTargetPosition=new H,this._quat=new li().setFromUnitVectors(e.up,new H(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new fo,this._sphericalDelta=new fo,this._scale=1,this._panOffset=new H,this._rotateStart=new qe,this._rotateEnd=new qe,this._rotateDelta=new qe,this._panStart=new qe,this._panEnd=new qe,this._panDelta=new qe,this._dollyStart=new qe,this._dollyEnd=new qe,this._dollyDelta=new qe,this._dollyDirection=new H,this._mouse=new qe,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=m1.bind(this),this._onPointerDown=p1.bind(this),this._onPointerUp=g1.bind(this),this._onContextMenu=M1.bind(this),this._onMouseWheel=y1.bind(this),this._onKeyDown=v1.bind(this),this._onTouchStart=b1.bind(this),this._onTouchMove=S1.bind(this),this._onMouseDown=x1.bind(this),this._onMouseMove=_1.bind(this),this._interceptControlDown=w1.bind(this),this._interceptControlUp=A1.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=wt.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(bg),this.update(),this.state=wt.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;bn.copy(t).sub(this.target),bn.applyQuaternion(this._quat),this._spherical.setFromVector3(bn),this.autoRotate&&this.state===wt.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=Qn:i>Math.PI&&(i-=Qn),s<-Math.PI?s+=Qn:s>Math.PI&&(s-=Qn),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(bn.setFromSpherical(this._spherical),bn.applyQuaternion(this._quatInverse),t.copy(this.target).add(bn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=bn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new H(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new H(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=bn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(ru.origin.copy(this.object.position),ru.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(ru.direction))<f1?this.object.lookAt(this.target):(Sg.setFromNormalAndCoplanarPoint(this.object.up,this.target),ru.intersectPlane(Sg,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Id||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Id||this._lastTargetPosition.distanceToSquared(this.target)>Id?(this.dispatchEvent(bg),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?Qn/60*this.autoRotateSpeed*e:Qn/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){bn.setFromMatrixColumn(t,0),bn.multiplyScalar(-e),this._panOffset.add(bn)}_panUp(e,t){this.screenSpacePanning===!0?bn.setFromMatrixColumn(t,1):(bn.setFromMatrixColumn(t,0),bn.crossVectors(this.object.up,bn)),bn.multiplyScalar(e),this._panOffset.add(bn)}_pan(e,t){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;bn.copy(s).sub(this.target);let r=bn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/i.clientHeight,this.object.matrix),this._panUp(2*t*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=e-i.left,r=t-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Qn*this._rotateDelta.x/t.clientHeight),this._rotateUp(Qn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(i,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let i=this._getSecondPointerPosition(e),s=.5*(e.pageX+i.x),r=.5*(e.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Qn*this._rotateDelta.x/t.clientHeight),this._rotateUp(Qn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new qe,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,i={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function p1(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function m1(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function g1(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Mg),this.state=wt.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function x1(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case Ws.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=wt.DOLLY;break;case Ws.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=wt.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=wt.ROTATE}break;case Ws.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=wt.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=wt.PAN}break;default:this.state=wt.NONE}this.state!==wt.NONE&&this.dispatchEvent(Ld)}function _1(n){switch(this.state){case wt.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case wt.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case wt.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function y1(n){this.enabled===!1||this.enableZoom===!1||this.state!==wt.NONE||(n.preventDefault(),this.dispatchEvent(Ld),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(Mg))}function v1(n){this.enabled!==!1&&this._handleKeyDown(n)}function b1(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case $s.ROTATE:if(this.enableRotate===!1){this.state=wt.NONE;break}this._handleTouchStartRotate(n),this.state=wt.TOUCH_ROTATE;break;case $s.PAN:if(this.enablePan===!1){this.state=wt.NONE;break}this._handleTouchStartPan(n),this.state=wt.TOUCH_PAN;break;default:this.state=wt.NONE}break;case 2:switch(this.touches.TWO){case $s.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=wt.TOUCH_DOLLY_PAN;break;case $s.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=wt.TOUCH_DOLLY_ROTATE;break;default:this.state=wt.NONE}break;default:this.state=wt.NONE}this.state!==wt.NONE&&this.dispatchEvent(Ld)}function S1(n){switch(this._trackPointer(n),this.state){case wt.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case wt.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case wt.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case wt.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=wt.NONE}}function M1(n){this.enabled!==!1&&n.preventDefault()}function w1(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function A1(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Nd=120,wg=2,Ag=6;function Dd(n,e,t){let i=new WeakMap,s=e.reduce((l,c)=>n[c].mesh.tubes.reduce((u,h)=>Math.max(u,h.radius),Math.max(l,n[c].reach)),Math.max(...e.map(l=>n[l].mesh.joints.length?n[l].mesh.jointRadius:0))),r=null;function o(){let{span:l}=t;if(!i.has(l)){let c=Array.from({length:Nd+1},(u,h)=>t.timeAt(h/Nd));i.set(l,c.map(u=>e.map(h=>n[h].pointsAt(t.clipTime(h,u)).slice())))}return i.get(l)}function a(l,c){let u=[...l.flatMap(d=>d.toArray()),...c].join();if(r?.key===u&&r.span===t.span)return r;let h=o().map(d=>E1(d,l,c,s));return r={key:u,span:t.span,rows:T1(h),whole:Eg(h)},r}return function(c,u,h,d){let f=new H().crossVectors(u,c).normalize(),p=[f,new H().crossVectors(c,f),c],{rows:m,whole:g}=a(p,h),x=d?C1(m,t.wayAt(t.time)*Nd):g,[_,M,v,E,A,y]=x,S=[(_-M)/2,(v-E)/2,(A-y)/2],P=Math.max((_+M)/(2*h[0]),(v+E)/(2*h[1])),L=new H;for(let[I,O]of p.entries())L.addScaledVector(O,S[I]);return{target:L,distance:P-S[2]||1}}}function E1(n,e,t,i){let s=new Float64Array(Ag).fill(-1/0),r=t.map(h=>i*Math.hypot(1,h)),o=[r[0],r[0],r[1],r[1],0,0],[a,l,c]=e.map(h=>h.toArray()),u=(h,d,f)=>h[0]*d[f]+h[1]*d[f+1]+h[2]*d[f+2];for(let h of n)for(let d=0;d<h.length;d+=3){let[f,p,m]=[u(a,h,d),u(l,h,d),u(c,h,d)],[g,x]=[t[0]*m,t[1]*m],_=[f+g,g-f,p+x,x-p,m,-m];for(let M=0;M<Ag;M++)_[M]>s[M]&&(s[M]=_[M])}return s.map((h,d)=>h+o[d])}function Eg(n){return n.reduce((e,t)=>e.map((i,s)=>Math.max(i,t[s])))}function T1(n){let e=(i,s)=>i.slice(Math.max(0,s-wg),s+wg+1),t=n.map((i,s)=>Eg(e(n,s)));return n.map((i,s)=>{let r=e(t,s);return r[0].map((o,a)=>r.reduce((l,c)=>l+c[a],0)/r.length)})}function C1(n,e){let t=Math.min(n.length-2,Math.max(0,Math.floor(e))),i=Math.min(1,Math.max(0,e-t));return n[t].map((s,r)=>s+i*(n[t+1][r]-s))}var Tg=28,R1=1.05,Cg=Math.PI/24,P1=1.15,Sr=[{name:"3-D",text:"obliquely from above",towards:[.37,-.695,.616]},{name:"top",text:"from above",towards:[0,-5e-4,1]},{name:"side",text:"from the side, along the flat plane",towards:[0,-1,1e-4]},{name:"along",text:"from the far end, along the centre line",towards:[1,0,1e-4]}];function Rg(n,e,t,i,s=Ks()){let{size:r,target:o}=I1(e),a=e.map((E,A)=>A),l=Dd(e,a,t),c=a.map(E=>Dd(e,[E],t)),u=new Xn(Tg,1,.02*r,60*r);u.up.set(0,0,1);let h=new ou(u,n);h.minDistance=.1*r,h.maxDistance=20*r;let d=null;function f(E=0){let A=s.oneScale?l:c[E],y=Math.tan(Tg*Math.PI/360)/R1;d=A(s.towards,u.up,[y*u.aspect,y],s.following),s.oneScale&&(d.distance*=s.scale),h.target.copy(d.target).addScaledVector(s.aside,d.distance),u.position.copy(h.target).addScaledVector(s.towards,s.closer*d.distance),u.lookAt(h.target),u.updateMatrixWorld()}function p(){f(),i()}h.addEventListener("change",()=>{let E=u.position.clone().sub(h.target);s.closer=E.length()/d.distance,s.towards.copy(E).normalize(),s.aside.copy(h.target).sub(d.target).divideScalar(d.distance),p()});let m=E=>{document.activeElement!==n&&!E.ctrlKey&&E.stopImmediatePropagation()};n.parentElement.addEventListener("wheel",m,{capture:!0});function g({towards:E}){s.towards.set(...E).normalize(),s.closer=1,s.aside.set(0,0,0),p()}function x(E,A){let y=s.towards.clone().applyAxisAngle(u.up,E*Cg),S=new H().crossVectors(u.up,y).normalize(),P=y.clone().applyAxisAngle(S,-A*Cg);s.towards.copy(Math.abs(P.z)<.9999?P:y),p()}function _(E){let A=s.closer*d.distance*P1**-E;s.closer=Math.min(h.maxDistance,Math.max(h.minDistance,A))/d.distance,p()}function M(E){Object.assign(s,E),p()}function v(E,A){u.aspect=E,u.updateProjectionMatrix(),h.rotateSpeed=A,h.panSpeed=A,p()}return{camera:u,controls:h,look:s,size:r,target:o,aim:f,show:g,turn:x,zoom:_,choose:M,resize:v,dispose:()=>h.dispose()}}function Ks(){return{towards:new H(...Sr[0].towards).normalize(),closer:1,aside:new H,following:!0,oneScale:!0,scale:1}}function I1(n){let e=new H(1/0,1/0,1/0),t=new H(-1/0,-1/0,-1/0),i=new H;for(let r of n){let o=Math.max(1,Math.floor(r.time.length/60));for(let a=0;a<r.time.length;a+=o){let l=r.pointsAt(r.time[a]);for(let c=0;c<l.length;c+=3)i.fromArray(l,c),e.min(i),t.max(i)}}let s=e.clone().add(t).multiplyScalar(.5);return{target:s,size:t.distanceTo(s)||1}}var Va=1/0,Ud=1e-4;function Pg(n,e,t){let i=new Set,s=n.readings.map(({unit:p})=>(p==="deg"?1:e.units.length)*hp(p)),r={start:n.start,end:Math.max(n.end,n.start+1),origins:[0],whole:!0},o=t,a=t,l=0;function c(){l||=requestAnimationFrame(()=>{l=0;for(let p of i)p()})}let u=(p,m)=>p!==Va?n.pointsAt(p,m):m?(m.set(o.points),m):o.points,h={...n,marks:[],efforts:null,reach:n.mesh.base.radius,pointsAt:u,verticesAt:(p,m)=>p===Va?n.verticesOf(o.points,m):n.verticesAt(p,m),valuesAt(p,m,g){if(m!==Va)return n.valuesAt(p,m,g);let x=n.readings.findIndex(M=>M.name===p),_=p===bs?o.energies_J:o.readings[x].map(M=>s[x]*M);return g?(g.set(_),g):Float32Array.from(_)},restLengthsAt(p,m){p===Va?m.set(o.restLengths_m):n.restLengthsAt(p,m)},markAt:()=>{}},d={get time(){return o.time_s},span:r,clipTime:(p,m=Va)=>m,timeAt:p=>r.start+p*(r.end-r.start),wayAt:()=>0,onChange(p){return i.add(p),c(),()=>i.delete(p)}};function f(p){o=p,!(p!==a&&!L1(p,a,Ud*h.reach))&&(a=p,c())}return{clip:h,clock:d,show:f,get frame(){return o}}}function L1(n,e,t){let i=(s,r,o)=>s.some((a,l)=>Math.abs(a-r[l])>o);return i(n.points,e.points,t)||n.readings.some((s,r)=>i(s,e.readings[r],Ud*Math.max(1,...s.map(Math.abs))))||i(n.energies_J,e.energies_J,Ud*Math.max(...e.energies_J))||i(n.restLengths_m,e.restLengths_m,0)}var N1=16,D1=6;function Ig(n,e,t){let{lines:i}=e.creases,[s,r]=[n.canvas,n.cells[0]],o=b("p",{className:"crease-label","aria-hidden":"true",hidden:!0}),a=b("span",{className:"crease-mark","aria-hidden":"true",hidden:!0});r.append(a,o);let l=b("select",{},b("option",{value:""},"none"),...i.map(({name:y},S)=>b("option",{value:String(S)},y))),c=b("output",{"aria-live":"off"}),u=b("span",{},"or point at one in the picture, or touch it"),h=new H,d=null,f=null,p=null;function m(y){return h.fromArray(n.views[0].shape.vertices,3*y).project(n.eye.camera),[(h.x+1)/2*r.clientWidth,(1-h.y)/2*r.clientHeight]}function g(y){let S=s.getBoundingClientRect(),P=[y.clientX-S.left,y.clientY-S.top],[L,I]=[null,N1];for(let[O,{ends:k}]of i.entries()){let N=U1(P,...k.map(m))+x(k);N<I&&([L,I]=[O,N])}return L}let x=y=>h.fromArray(_(y)).distanceTo(n.eye.camera.position)/(1e3*n.eye.size);function _(y){let{vertices:S}=n.views[0].shape;return[0,1,2].map(P=>(S[3*y[0]+P]+S[3*y[1]+P])/2)}function M(y){let{lines:S,columns:P}=e.creases,L=e.valuesAt(Pd,t.clipTime(0));return S[y].columns.map(I=>{let{name:O,unit:k}=P[I],N=k==="°"?`${Ln(L[I],1)}°`:`${vt(Number(L[I].toPrecision(3)))} ${k}`;return`${O} ${N}`}).join(", ")}function v(){let y=f??d;if(o.hidden=a.hidden=y===null,c.textContent=d===null?"":M(d),u.hidden=d!==null,y===null)return;o.textContent=`${i[y].name}: ${M(y)}`;let[S,P]=i[y].ends.map(m),L=Math.hypot(P[0]-S[0],P[1]-S[1]),I=Math.atan2(P[1]-S[1],P[0]-S[0]);a.style.width=`${L.toFixed(1)}px`,a.style.transform=`translate(${S[0].toFixed(1)}px, ${S[1].toFixed(1)}px) rotate(${I.toFixed(4)}rad)`}let E=y=>{y!==f&&(f=y,v())},A=y=>{d=y,l.value=y===null?"":String(y),v()};return s.addEventListener("pointermove",y=>{y.pointerType==="mouse"&&E(y.buttons?null:g(y))}),s.addEventListener("pointerleave",()=>E(null)),s.addEventListener("pointerdown",y=>{p=y.isPrimary?[y.clientX,y.clientY]:null}),s.addEventListener("pointerup",y=>{if(!p||Math.hypot(y.clientX-p[0],y.clientY-p[1])>D1)return;let S=g(y);A(S===d?null:S)}),l.addEventListener("change",()=>A(l.value===""?null:Number(l.value))),n.onDraw(v),b("div",{className:"crease-choice"},b("label",{},`${e.creases.kind} `,l),c,u)}function U1([n,e],[t,i],[s,r]){let[o,a]=[s-t,r-i],l=Math.min(1,Math.max(0,((n-t)*o+(e-i)*a)/(o*o+a*a||1)));return Math.hypot(n-t-l*o,e-i-l*a)}var O1=[["space","play or pause"],["← →","short step back or forward"],["page down, page up","long step back or forward"],["home, end","start, end"]],F1="shift with ← → ↑ ↓",k1=[["+ −","nearer, further"],["0","reset the view"]];function au(n,e,t){let s=(n.length===1?n[0].marks:[]).map((o,a)=>[String(a+1),o.name]),r=[...O1,...s,...e?[[F1,`turn the ${t}`],...k1]:[]].map(([o,a])=>b("tr",{},b("th",{scope:"row"},o),b("td",{},a)));return b("details",{className:"keys"},b("summary",{},"Keys"),b("table",{},b("tbody",{},...r)),b("p",{},"Space and arrow keys work unless another control has the focus. All other keys work only in the player."))}var Lg={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]};function Ng({key:n,shiftKey:e},t,i,s){if(e&&n in Lg)t?.turn(...Lg[n]);else if(s)if(n==="+"||n==="=")t?.zoom(1);else if(n==="-"||n==="−")t?.zoom(-1);else if(n==="0")t?.show(i);else return!1;else return!1;return!0}function Dg(n,e,t){n.addEventListener("keydown",i=>{!i.ctrlKey&&!i.metaKey&&!i.altKey&&Ng(i,e,t,!0)&&i.preventDefault()})}function lu(n,e,t,i,s){let r={ArrowLeft:-1,ArrowRight:1,PageUp:10,PageDown:-10};function o(c){t.pause(),c()}function a(c,u){let{key:h}=c;if(Ng(c,i,s,u))return!0;if(h in r)o(()=>t.step(r[h]));else if(h===" ")t.playing?t.pause():t.play();else if(h==="Home")o(()=>t.seek(t.span.start));else if(h==="End")o(()=>t.seek(t.span.end));else if(u)if(e.length===1&&e[0].marks[Number(h)-1])o(()=>t.seekClip(0,e[0].marks[Number(h)-1].time));else return!1;else return!1;return!0}function l(c){let u=document.activeElement,h=n.contains(u);!(h||u===document.body||u===null)||c.ctrlKey||c.metaKey||c.altKey||u instanceof HTMLSelectElement||u?.dataset?.keys==="own"||c.key===" "&&/^(BUTTON|SUMMARY|A)$/.test(u?.tagName??"")||u===document.body&&/^(Home|End|PageUp|PageDown)$/.test(c.key)||a(c,h)&&c.preventDefault()}return document.addEventListener("keydown",l),()=>document.removeEventListener("keydown",l)}var Ug=2.4;function Ga(n){let e=10**Math.floor(Math.log10(n/Ug));return e*[5,2,1].find(t=>t*e<=n/Ug)}function Og(n,e){let t=Ga(n),i=t*Math.ceil(1.25*n/t),s=[],[r,o]=[e.x,e.y].map(c=>t*Math.round(c/t));for(let c=-i;c<=i+t/2;c+=t)s.push(r+c,o-i,0,r+c,o+i,0,r-i,o+c,0,r+i,o+c,0);let a=new _n().setAttribute("position",new nn(s,3)),l=new pr(a,new zs({transparent:!0,opacity:.5,depthWrite:!1}));return l.frustumCulled=!1,l}function Od(n,e,t,i){let s=i?["marks on the time line: the states of each run, in its colour"]:[];return b("ul",{className:"legend"},...n.map(({sample:r,text:o})=>r==="tendon"?z1(o,e):B1(r,o)),...n.some(({sample:r})=>r==="tendon")?[b("li",{},"slack tendons sag, drawn with their rest length")]:[],b("li",{},`squares of the grid: ${zr(Ga(t),"m")}`),...s.map(r=>b("li",{},r)))}function B1(n,e){let[t,i]=n.split(" "),s={mountain:{color:tu},valley:{color:nu},region:{background:Ba(i)}};return b("li",{className:t==="region"?"of-region":""},Fg(t==="region"?"panel":t,s[t]??{}),e)}function z1(n,e){let t=b("li",{className:"energy"},`${n}: 0`,Fd(So));return t.append(`${vt(e.factor*e.largest_J)} ${e.unit}${e.orMore?" or more":""}`),t}function Fd(n){return Fg("bar",{background:n.gradient})}function Fg(n,e){let t=b("span",{className:`swatch ${n}`,"aria-hidden":"true"});return Object.assign(t.style,e),t}function kg(n,e){if(!(e>n*(1+1e-6)))return 0;let[t,i]=[0,e/2];for(let s=0;s<40;s++){let r=(t+i)/2;V1(n,r)<e?t=r:i=r}return(t+i)/2}function V1(n,e){return e===0?n:Math.hypot(n,4*e)/2+n*n*Math.asinh(4*e/(n||1e-12))/(8*e)}function zg(n){let{triangles:e,faces:t}=n.mesh,i=n.builtVertices(),s=Array.from({length:t.length},(c,u)=>Bg(i,e,u)),r=new Float32Array(t.reduce((c,u)=>Math.max(c,u),0)+1),o=new Float32Array(t.length);function a(c){r.fill(-1/0);for(let u=0;u<t.length;u++){let[h,d,f]=s[u],p=h*f-d*d;if(p<=1e-9*(h+f)**2)continue;let[m,g,x]=Bg(c,e,u),_=(f*m-2*d*g+h*x)/(2*p),M=(m*x-g*g)/p,v=(_+Math.sqrt(Math.max(_*_-M,0))-1)/2;r[t[u]]=Math.max(r[t[u]],v)}for(let u=0;u<t.length;u++)o[u]=Math.max(0,r[t[u]]);return o}function l(){let c=new Float32Array(i.length),u=0;for(let h of n.time)u=a(n.verticesAt(h,c)).reduce((d,f)=>Math.max(d,f),u);return u}return{at:a,largest:l}}function Bg(n,e,t){let[i,s,r]=[0,1,2].map(c=>3*e[3*t+c]),[o,a,l]=[0,0,0];for(let c=0;c<3;c++){let u=n[s+c]-n[i+c],h=n[r+c]-n[i+c];o+=u*u,a+=u*h,l+=h*h}return[o,a,l]}var G1=.9,Vg=.4,H1=.02,W1=["crease","rim","edge"],Js=12;function kd(n,e){let{mesh:t}=n,i=new Float32Array(3*t.share.length),s=new Float32Array(n.tendons),r=Math.max(0,...t.tubes.map(P=>P.radius)),[o,a]=[!1,!0].map(P=>X1(t,P)),l=Gg(t.tubes.filter(P=>P.kind==="bar"),20,0),c=Gg(t.tubes.filter(P=>W1.includes(P.kind)),8,.4*r),u=q1(n,2.4*r),h=Z1(t.base),d=n.efforts?yg(n):null,f=n.strained?zg(n):null,p=0,m=K1(t),g=new kn;g.add(h.object,a.object,l.object,m.object,c.object,u.object,o.object),d&&g.add(d.group);let x=$1(o.object,a.object,l.object),_=[0,0,0],M=new Qe;function v(P){n.verticesAt(P,i),o.pose(i),a.pose(i);for(let I of[l,c,m])I.pose(i);n.valuesAt(bs,P,s);let L=s.map(I=>e>0?I/e:0);u.pose(i,P,I=>Vg+(1-Vg)*Math.min(1,Math.max(0,L[I])/H1));for(let I=0;I<n.tendons;I++)So.at(L[I],_),u.colour(I,M.setRGB(..._,"srgb"));n.tendons&&(u.object.instanceColor.needsUpdate=!0),d?.pose(P),p&&E()}function E(){let P=f.at(i),L=[0,0,0];for(let I of[o,a])I.colour(O=>M.setRGB(...iu.at(P[O]/p,L),"srgb"))}function A(P){p=f?P:0;for(let L of[o,a])L.flat(p>0),p||L.colour(I=>M.set(Ba(t.regions[I])));p&&E()}function y(){for(let P of[l,c,m,h])P.paint();d?.paint(),x.children[0].material.color.set(Bt("--shadow"))}function S(){for(let P of[l,c,u,m])P.object.dispose();for(let P of[o,a])P.dispose();d?.dispose(),h.dispose();for(let P of[l,c,u,m])P.object.geometry.dispose(),P.object.material.dispose();x.children[0].material.dispose()}return{group:g,shadow:x,pose:v,paint:y,sort:o.sort,vertices:i,tendons:u.object,efforts:d,strains:f,showStrain:A,dispose:S}}function $1(...n){let e=new fr({side:Bn,transparent:!0,opacity:.12,depthWrite:!1,stencilWrite:!0,stencilRef:1,stencilFunc:nd,stencilZPass:td}),t=new kn;for(let i of n){let s=i.isInstancedMesh?new ui(i.geometry,e,i.count):new Dn(i.geometry,e);i.isInstancedMesh&&(s.instanceMatrix=i.instanceMatrix),s.frustumCulled=!1,t.add(s)}return t.scale.z=1e-5,t}function X1(n,e){let t=n.regions.flatMap((v,E)=>n.solid[v]===e?[E]:[]),i=t.flatMap(v=>n.triangles.slice(3*v,3*v+3)),s=t.length,r=new on(new Float32Array(3*i.length),3).setUsage(Da),o=new on(new Float32Array(3*i.length),3).setUsage(Da),a=new on(new Uint32Array(i.length),1).setUsage(Da);for(let v=0;v<i.length;v++)a.array[v]=v;let l=new _n;l.setAttribute("position",r),l.setAttribute("color",o),l.setIndex(a);let c=new ms({vertexColors:!0,side:Bn,flatShading:!0,transparent:!e,opacity:e?1:G1,depthWrite:e,forceSinglePass:!0});c.onBeforeCompile=v=>{v.fragmentShader=v.fragmentShader.replace("#include <color_fragment>",`#include <color_fragment>
if (!gl_FrontFacing) diffuseColor.rgb *= 0.84;`)};let u=new fr({vertexColors:!0,side:Bn}),h=new Dn(l,c);h.frustumCulled=!1,h.renderOrder=e?0:1;let d=new Qe;f(v=>d.set(Ba(n.regions[v])));function f(v){for(let[E,A]of t.entries()){let y=v(A);for(let S=0;S<3;S++)y.toArray(o.array,9*E+3*S)}o.needsUpdate=!0}let p=v=>{h.material=v?u:c};function m(){l.dispose(),c.dispose(),u.dispose()}function g(v){for(let E=0;E<i.length;E++)for(let A=0;A<3;A++)r.array[3*E+A]=v[3*i[E]+A];r.needsUpdate=!0}let x=new Float32Array(s),_=Array.from({length:s},(v,E)=>E);function M(v){let E=r.array;for(let A=0;A<s;A++){let y=0;for(let S=0;S<3;S++){let P=9*A+S;y+=((E[P]+E[P+3]+E[P+6])/3-v.getComponent(S))**2}x[A]=y}_.sort((A,y)=>x[y]-x[A]);for(let A=0;A<s;A++)for(let y=0;y<3;y++)a.array[3*A+y]=3*_[A]+y;a.needsUpdate=!0}return{object:h,pose:g,sort:M,colour:f,flat:p,dispose:m}}function Gg(n,e,t){let i=new ui(new Xi(1,1,1,e),br(t),n.length);i.frustumCulled=!1,o();let s=n.map(a=>[3*a.ends[0],3*a.ends[1],a.radius]);function r(a,l=()=>1){let c=i.instanceMatrix.array;for(let[u,[h,d,f]]of s.entries())bo(a,h,d,l(u)*f,c,16*u);i.instanceMatrix.needsUpdate=!0}function o(){let a={M:new Qe(tu),V:new Qe(nu),B:new Qe(Bt("--bar"))};for(let[l,c]of n.entries())i.setColorAt(l,a[c.crease]);n.length&&(i.instanceColor.needsUpdate=!0)}return{object:i,pose:r,paint:o}}function q1(n,e){let t=n.mesh.tubes.filter(l=>l.kind==="tendon"),i=new ui(new Xi(1,1,1,12),br(e),t.length*Js);i.frustumCulled=!1;let s=new Float32Array(t.length),r=new Float32Array(3*(Js+1));function o(l,c,u){n.restLengthsAt(c,s);let h=i.instanceMatrix.array;for(let[d,{ends:f,radius:p}]of t.entries()){Y1(l,3*f[0],3*f[1],s[d],r);for(let m=0;m<Js;m++)bo(r,3*m,3*m+3,u(d)*p,h,16*(d*Js+m))}i.instanceMatrix.needsUpdate=!0}function a(l,c){for(let u=0;u<Js;u++)i.setColorAt(l*Js+u,c)}return{object:i,pose:o,colour:a}}function Y1(n,e,t,i,s){let r=[0,1,2].map(d=>n[t+d]-n[e+d]),o=Math.hypot(...r),a=kg(o,i),l=Math.abs(r[2])>.999*o?[1,0,0]:[0,0,-1],c=l.reduce((d,f,p)=>d+f*r[p],0)/(o*o||1),u=l.map((d,f)=>d-c*r[f]),h=Math.hypot(...u)||1;for(let d=0;d<=Js;d++){let f=d/Js,p=4*a*f*(1-f)/h;for(let m=0;m<3;m++)s[3*d+m]=n[e+m]+f*r[m]+p*u[m]}}function Z1({rods:n,radius:e}){let t=new Float32Array(n.flat(2)),i=br(0),s=new ui(new Xi(1,1,1,16),i,n.length),r=new ui(new uo(1,16,12),i,2*n.length),o=new kn;for(let l of[s,r])l.frustumCulled=!1,o.add(l);for(let l=0;l<n.length;l++)bo(t,6*l,6*l+3,e,s.instanceMatrix.array,16*l);for(let l=0;l<2*n.length;l++){let c=r.instanceMatrix.array;for(let u=0;u<3;u++)[c[16*l+5*u],c[16*l+12+u]]=[e,t[3*l+u]];c[16*l+15]=1}function a(){for(let l of[s,r])l.dispose(),l.geometry.dispose();i.dispose()}return{object:o,paint:()=>i.color.set(Bt("--base")),dispose:a}}function K1(n){let e=new ui(new uo(1,16,12),br(0),n.joints.length);e.frustumCulled=!1;let t=()=>e.material.color.set(Bt("--joint"));t();function i(s){let r=e.instanceMatrix.array;for(let[o,a]of n.joints.entries()){for(let l=0;l<3;l++)r[16*o+5*l]=n.jointRadius,r[16*o+12+l]=s[3*a+l];r[16*o+15]=1}e.instanceMatrix.needsUpdate=!0}return{object:e,pose:i,paint:t}}var J1=4096,j1=3.2,Q1=new H(-.45,.75,1),eA=.42*Math.PI,tA=.64*Math.PI,nA=.5,iA=.14;function Ha(n,e,t,i,s){let r=b("canvas",{tabIndex:0,role:"img","aria-label":`${i} ${sA}`}),o=r.getContext("webgl2",{antialias:!0,alpha:!0,stencil:!0});if(!o)return null;let a=n.map(()=>b("div",{className:"cell"})),l=n.length>1,c=b("div",{className:l?"stage several":"stage"},r,...a);c.style.setProperty("--columns",String(n.length===4?2:Math.min(n.length,n.length>6?4:3)));let u=()=>l?Math.ceil(j1*parseFloat(getComputedStyle(a[0]).fontSize)):0,h=new jc({canvas:r,context:o,antialias:!0,alpha:!0,stencil:!0});h.setScissorTest(!0);let d=Rg(r,n,e,x,s),f=n.map(I=>rA(I,t(I),d)),p=0,m=!1,g=new Set;function x(){p||(p=requestAnimationFrame(M))}function _(){for(let[I,O]of f.entries())O.shape.pose(e.clipTime(I));m=!0}function M(){cancelAnimationFrame(p),p=0,m||_();let I=r.clientHeight,O=u();h.setScissor(0,0,r.clientWidth,I),h.setViewport(0,0,r.clientWidth,I),h.clear();for(let[k,N]of f.entries()){d.aim(k);let V=a[k],X=[V.offsetLeft,I-V.offsetTop-V.offsetHeight,V.offsetWidth,V.offsetHeight-O];h.setViewport(...X),h.setScissor(...X),N.light.position.copy(Q1).applyQuaternion(d.camera.quaternion);let G=d.camera.position.z>N.floor.position.z;N.floor.material.opacity=G?nA:iA,N.shape.shadow.visible=G,N.shape.sort(d.camera.position),h.render(N.scene,d.camera)}d.aim();for(let k of g)k()}function v(){for(let I of f)I.floor.material.color.set(Bt("--floor")),I.shape.paint();x()}function E(){let[I,O]=[c.clientWidth,c.clientHeight];if(!I||!O)return;h.setPixelRatio(Math.min(devicePixelRatio,2,J1/Math.max(I,O))),h.setSize(I,O,!1);let k=a[0].offsetHeight-u();d.resize(a[0].offsetWidth/k,O/k),M()}let A=new ResizeObserver(E);A.observe(c);let y=e.onChange(()=>{m=!1,M()}),S=Ys(v);r.addEventListener("webglcontextrestored",x),v();function P(){cancelAnimationFrame(p),y(),S(),A.disconnect(),d.dispose();for(let{shape:I,floor:O}of f)I.dispose(),O.geometry.dispose(),O.material.dispose();h.dispose(),h.forceContextLoss(),c.remove()}function L(I){let O=I?f.reduce((k,{shape:N})=>Math.max(k,N.strains?.largest()??0),0):0;for(let{shape:k}of f)k.showStrain(O||(I?Number.MIN_VALUE:0));return x(),O}return{element:c,canvas:r,cells:a,eye:d,pose:_,draw:M,views:f,showStrain:L,onDraw:I=>g.add(I),statistics:()=>h.info.render,dispose:P}}var sA="Drag to turn, pinch to zoom; keys are listed below.";function rA(n,e,t){let i=Og(t.size,t.target);i.position.z=oA(n)-.06*t.size,e.shadow.position.z=i.position.z+.001*t.size;let s=new wa("#ffffff",eA),r=new ca;return r.add(e.group,e.shadow,i,s,new ba("#ffffff","#dde2e8",tA)),{shape:e,floor:i,light:s,scene:r}}function oA(n){let e=1/0,t=Math.max(1,Math.floor(n.time.length/200));for(let i=0;i<n.time.length;i+=t){let s=n.pointsAt(n.time[i]);for(let r=2;r<s.length;r+=3)e=Math.min(e,s[r])}return e}var aA=.3,lA=4,cA=4,Hg=[{name:"even motion",value:"even"},{name:"real time",value:1},{name:"1/2",value:1/2},{name:"1/5",value:1/5},{name:"1/10",value:1/10},{name:"1/20",value:1/20},{name:"1/50",value:1/50},{name:"1/100",value:1/100}];function Wg(n,e){let t=uA(n,e),i=new Float64Array(t.length);for(let[l,c]of n.entries())hA(c,e.origins[l],t,i);for(let l=1;l<i.length;l++)i[l]+=i[l-1];let s=i[i.length-1],r=s>0?aA:1;for(let l=0;l<i.length;l++){let c=(t[l]-t[0])/(t[t.length-1]-t[0]||1);i[l]=r*c+(1-r)*(i[l]/(s||1))}let o=l=>l.drive!=="none"&&l.start-e.origins[0]<e.end&&l.end-e.origins[0]>e.start,a=n[0].stages.filter(o).length;return{seconds:e.seconds??lA+cA*a,wayAt:l=>za(t,i,l),timeAt:l=>za(i,t,l)}}function uA(n,e){let t=new Set([e.start,e.end]);for(let[i,s]of n.entries())for(let r of s.time){let o=r-e.origins[i];o>e.start&&o<e.end&&t.add(o)}return Float64Array.from(t).sort()}function hA(n,e,t,i){let s=n.pointsAt(t[0]+e).slice(),r=s.slice();for(let o=1;o<t.length;o++){n.pointsAt(t[o]+e,r);let a=0;for(let l=0;l<r.length;l+=3){let c=Math.hypot(r[l]-s[l],r[l+1]-s[l+1],r[l+2]-s[l+2]);c>a&&(a=c)}i[o]=Math.max(i[o],a),[s,r]=[r,s]}}var dA="M7 4.5v15l12-7.5z",fA="M7 5h3.5v14H7zM13.5 5H17v14h-3.5z",Bd=1e4,pA=.02;function cu(n,e){let t=b("button",{type:"button",className:"play"}),i=b("input",{type:"range",min:0,max:Bd,step:1,"aria-label":e.span.unit?e.span.name:"time"}),s=b("div",{className:"bands","aria-hidden":"true"}),r=b("div",{className:"ticks","aria-hidden":"true"}),o=b("p",{className:"time"}),a=b("p",{className:"spoken",role:"status"}),l=b("div",{className:"states"}),c=null,u=[];function h(){n.length>1||n[0].marks===c||(c=n[0].marks,u=c.map(g=>gA(g,e)),l.replaceChildren(...u))}h();let d=b("div",{className:"transport"},b("div",{className:"line"},t,b("div",{className:"tracks"},...mA(n[0],e),b("div",{className:"track"},s,i,r))),b("div",{className:"choices"},o,l,...e.span.unit?[]:[xA(e)],..._A(e),a));t.addEventListener("click",()=>e.playing?e.pause():e.play()),i.addEventListener("input",()=>{e.pause(),e.seek(e.momentAt(i.value/Bd))});let f={},p=null,m=0;return e.onChange(()=>{h();let{span:g,stretched:x}=e;(g!==f.span||x!==f.stretched)&&yA(n,e,s,r),f={span:g,stretched:x},i.value=Math.round(Bd*e.shareAt(e.time)),i.setAttribute("aria-valuetext",$g(n,e));let _=n.length===1?uu(n[0],e.clipTime(0)):"",M=n.length===1?_&&` · ${_}`:e.span.label.replace("time",""),v=e.playing&&!e.span.unit?`, ${vA(e.slowness)}`:"";o.textContent=`${lr(e.time,e.span)}${M}${v}${Xg(n[0],e.clipTime(0)," · ")}`;for(let[E,A]of(c??[]).entries())u[E].setAttribute("aria-pressed",String(Math.abs(A.time-e.clipTime(0))<1e-9));e.playing!==p&&(t.replaceChildren(il(e.playing?fA:dA)),t.setAttribute("aria-label",e.playing?"pause":"play"),p=e.playing),clearTimeout(m),e.playing||(m=setTimeout(()=>{a.textContent=$g(n,e)},600))}),d}function mA(n,e){if(!n.along.length)return[];let t=ih("",100),i=b("span",{className:"profile-ball"}),s=b("small"),r=c=>100*e.shareAt(c),o=null,a=null;function l(c){let u=n.line(c.key,0),[h,d]=[Math.min(0,...u),Math.max(...u)];o=p=>100-100*(p-h)/(d-h||1);let f=Array.from(u,(p,m)=>`${r(n.time[m]).toFixed(2)} ${o(p).toFixed(2)}`);t.querySelector("path").setAttribute("d",`M${f.join("L")}`),s.textContent=c.name,s.classList.toggle("at-start",u[0]<u.at(-1)),a=c}return e.onChange(()=>{let[c]=n.along;c!==a&&l(c);let u=e.clipTime(0);i.style.left=`${r(u).toFixed(2)}%`,i.style.top=`${o(n.valuesAt(c.key,u)[0]).toFixed(2)}%`}),[b("div",{className:"profile","aria-hidden":"true"},t,i,s)]}function gA(n,e){let t=b("button",{type:"button",className:"state"},b("b",{},n.letter),` ${n.name}`);return t.addEventListener("click",()=>{e.pause(),e.seekClip(0,n.time)}),t}function xA(n){let e=Hg.map(({name:i,value:s})=>b("option",{value:String(s)},i)),t=b("select",{},...e);return t.addEventListener("change",()=>n.setSpeed(t.value==="even"?"even":Number(t.value))),b("label",{},"speed ",t)}function _A(n){if(n.spans.length<2)return[];let e=n.spans.map((i,s)=>b("option",{value:String(s)},i.name)),t=b("select",{},...e);return t.addEventListener("change",()=>n.setSpan(n.spans[Number(t.value)])),n.onChange(()=>{t.value=String(n.spans.indexOf(n.span))}),[b("label",{},"show ",t)]}function yA(n,e,t,i){let{span:s}=e,r=o=>Math.min(1,Math.max(0,e.shareAt(o)));t.replaceChildren(),i.replaceChildren();for(let[o,a]of n.entries()){let l=s.origins[o];for(let c of a.stages.filter(u=>u.driven&&n.length===1)){let[u,h]=[r(c.start-l),r(c.end-l)],d=b("span",{className:"band"});d.style.left=`${100*u}%`,d.style.width=`${100*(h-u)}%`,h>u&&t.append(d)}for(let c of a.marks){let u=c.time-l;if(u<s.start-1e-9||u>s.end+1e-9)continue;let[h,d]=[r(u),i.lastElementChild];if(d&&n.length===1&&h-d.at<pA){d.append(` ${c.letter}`);continue}let f=b("span",{className:"tick",at:h},n.length===1?c.letter:"");f.style.left=`${100*h}%`,n.length>1&&f.style.setProperty("--tick",`var(--line-${o%7})`),i.append(f)}}}function vA(n){return n<1.05?"real time":`${n<10?Ln(n,1):Math.round(n)} times slower`}function uu(n,e){let t=n.markAt(e);return t?`${t.letter} ${t.name}`:n.stageAt(e).name}function Xg(n,e,t){let i=({name:s,unit:r,key:o})=>`${t}${s} ${vt(Number(n.valuesAt(o,e)[0].toPrecision(3)))} ${r}`;return n.along.map(i).join("")}function $g(n,e){let t=n.map((i,s)=>{let r=e.clipTime(s);return`${n.length>1?`${i.name}: `:""}${uu(i,r)||e.span.name}${Xg(i,r,", ")}${bA(i,r)}`});return`${lr(e.time,e.span)}: ${t.join("; ")}`}function bA(n,e){let[t]=n.readings;if(!t)return"";let i=n.markAt(e)?.readings[t.name]?.mean??n.valuesAt(t.name,e),s=t.unit==="deg"?"degrees":t.unit,r=[Math.min(...i),Math.max(...i)].map(a=>Ln(a,1)),o=i.length>1;return`, ${t.label}${o?"s":""} ${o?r.join(" to "):r[0]} ${s}`}function js(n,e,t,{energy:i,legend:s,text:r,whole:o},a,l=e.length>1||!!a){let c=Ha(e,t,m=>kd(m,i.largest_J),r,a),u=c?b("div",{className:"picture"},c.element,fu(c.eye,l?o:null)):b("p",{className:"note"},du(o));c&&e.length===1&&SA(c.cells[0],e[0],t);let h=c?[Od(s,i,c.eye.size,e.length>1?o:null)]:[];c&&e.some(m=>m.strained)&&h.unshift(Yg(c,h[0])),c&&e.length===1&&e[0].efforts?.drives.length&&MA(h.at(-1),e[0],t),c&&e.length>1&&e.some(m=>m.efforts?.drives.some(g=>g.arrow))&&h.at(-1).append(b("li",{className:"effort"},qg(),"torque or force of a drive, while it acts"));let d=c&&e.length===1&&e[0].creases?[Ig(c,e[0],t)]:[];n.replaceChildren(u,cu(e,t),...d,...h,au(e,c!==null,o)),n.classList.add("player"),n.setAttribute("role","region"),n.setAttribute("aria-label",`the moving ${o}`);let f=lu(n,e,t,c?.eye,Sr[0]);function p(){t.pause(),f(),c?.dispose(),n.replaceChildren()}return{stage:c,dispose:p}}function hu(n,e,t,{energy:i,legend:s,text:r,whole:o},a){let l=Ha(e,t,h=>kd(h,i.largest_J),r,a);if(!l)return n.replaceChildren(b("p",{className:"note"},du(o))),{stage:l};let c=b("div",{className:"picture"},l.element,fu(l.eye,null,!a)),u=[Od(s,{...i,orMore:!0},l.eye.size,null)];return e.some(h=>h.strained)&&u.unshift(Yg(l,u[0])),n.replaceChildren(c,...u),n.classList.add("player"),n.setAttribute("role","region"),n.setAttribute("aria-label",`the ${o} as set by the sliders`),Dg(n,l.eye,Sr[0]),{stage:l}}function SA(n,e,t){let i=b("p",{className:"now","aria-hidden":"true"});n.append(i),t.onChange(()=>{i.textContent=uu(e,t.clipTime(0)),i.hidden=!i.textContent})}function qg(){return b("span",{className:"swatch arrow","aria-hidden":"true"})}function MA(n,e,t){let i=e.efforts.drives.some(r=>r.arrow),s=b("span");n.append(b("li",{className:"effort"},...i?[qg()]:[],s)),t.onChange(()=>{s.textContent=_g(e.efforts,t.clipTime(0),vt).join("; ")||"no drive acts now"})}function Yg(n,e){let t=["panels","membrane strain"],i=b("li",{className:"energy",hidden:!0});e.append(i);let s=t.map((r,o)=>{let a=b("button",{type:"button","aria-pressed":String(!o)},r);return a.addEventListener("click",()=>{let l=n.showStrain(!!o);i.replaceChildren("Green strain of the membrane: 0",Fd(iu),`${vt(100*l)} %`),i.hidden=!o;for(let c of e.querySelectorAll(".of-region"))c.hidden=!!o;for(let c of s)c.setAttribute("aria-pressed",String(c===a))}),a});return b("div",{className:"colours",role:"group","aria-label":"colour of the sheet"},"colour:",b("span",{},...s))}function du(n){return`This browser has no WebGL, so the ${n} cannot be drawn in 3-D. The plots and all numbers are below.`}function fu(n,e,t=!0){let i=(c,u,h)=>{let d=b("button",{type:"button",title:u,"aria-label":u},c);return d.addEventListener("click",h),d},s=Sr.map(c=>i(c.name,`${c.name}: view ${c.text}`,()=>n.show(c))),r=[["←","turn left",[-1,0]],["→","turn right",[1,0]],["↑","turn up",[0,1]],["↓","turn down",[0,-1]]].map(([c,u,h])=>i(c,u,()=>n.turn(...h))),o=(c,u,h)=>{let d=i(c,u,()=>{n.choose({[h]:!n.look[h]}),d.setAttribute("aria-pressed",String(n.look[h]))});return d.setAttribute("aria-pressed",String(n.look[h])),d},a=[...t?[o("follow","follow: keep the picture filled as the structure moves","following")]:[],...e?[o("one scale",`one scale: draw all ${e}s at the same scale`,"oneScale")]:[]],l=[i("+","nearer",()=>n.zoom(1)),i("−","further",()=>n.zoom(-1))];return b("div",{className:"views",role:"group","aria-label":"view"},...a.length?[b("span",{},...a)]:[],b("span",{},...s),b("span",{className:"turns"},...r),b("span",{},...l))}var wA={deg:.05};function Qs(n,e,t,i,s=0,r=!1){let{heading:o,names:a}=e.mesh.parts,l=e.readings.map(m=>({name:m.name,title:m.row,parts:m.parts,text:g=>zd(g,m.unit),ofState:g=>g.readings[m.name]&&AA(g.readings[m.name],m.unit)})),c=m=>vt(i.factor*m);e.tendons&&l.push({name:bs,title:`tendon energy (${i.unit})`,parts:e.mesh.tendonParts,text:c,ofState:m=>m.tendonEnergy_J?.map(c)});let u=l.map(()=>a.map(()=>b("td"))),h=b("caption"),d=b("tr",{},o?b("th",{scope:"col"},o):b("td"),...a.map(m=>b("th",{scope:"col"},m))),f=l.map((m,g)=>b("tr",{},b("th",{scope:"row"},m.title),...u[g])),p=b("table",{className:"numbers"},h,b("thead",{},d),b("tbody",{},...f));return n.replaceChildren(b("div",{className:"table"},p)),n.classList.add("readout"),t.onChange(()=>{let m=t.clipTime(s),g=e.markAt(m),x=g?`, ${g.name}${g.tendonEnergy_J?" (means)":""}`:"",_=r?`${e.name}: `:"",M=o?`every ${o}`:"all values";h.textContent=`${kt(`${_}${M}`)} at ${lr(t.time,t.span)}${x}`;for(let[v,E]of l.entries()){let A=g&&E.ofState(g)||Array.from(e.valuesAt(E.name,m),E.text);for(let[y,S]of E.parts.entries())u[v][S].textContent=A[y]}})}function zd(n,e){return e==="deg"?Ln(n,1):vt(n)}function AA({mean:n,swing:e},t){return n.map((i,s)=>{let r=e[s]>(wA[t]??.005*Math.abs(i));return`${zd(i,t)}${r?` ± ${zd(e[s],t)}`:""}`})}var EA=0;function wo(n=document){let e=new ResizeObserver(t=>{for(let{target:i}of t)if(i.scrollWidth>i.clientWidth||i.scrollHeight>i.clientHeight)TA(i);else for(let s of["tabindex","role","aria-label","aria-labelledby"])i.removeAttribute(s)});for(let t of n.querySelectorAll(".table"))e.observe(t)}function TA(n){let{caption:e}=n.querySelector("table");if(n.tabIndex=0,n.setAttribute("role","group"),!e){let t=[...n.querySelectorAll("thead th")].map(i=>i.textContent);return n.setAttribute("aria-label",t.join(", ")||"table")}return e.id||=`caption-${++EA}`,n.setAttribute("aria-labelledby",e.id)}function CA(n,e){let t=n.design.text.split(`
`);for(let{key:i,unit:s,factor:r,line:o}of n.knobs)i in e&&(t[o.number]=`${o.before}${Kg(e[i],s,r)}${o.after}`);return t.join(`
`)}function Zg({knobs:n},e,t){let{unit:i,factor:s}=n.find(r=>r.key===e);return Kg(t,i,s)}function Kg(n,e,t){return`${Number((t*n).toPrecision(12))} ${e}`}function Jg(n){let e=b("a",{className:"button",download:"design.toml"},"This setting as a design file"),t=b("code"),i=b("p",{className:"note"},"This page does not check the energy balance; a run of the file does."),s=b("div",{className:"setting"},e,b("pre",{},t),i);function r(o){let a=new TextEncoder().encode(CA(n,o));e.href=`data:application/toml;base64,${btoa(String.fromCharCode(...a))}`,t.textContent="forficula run design.toml"}return r({}),{element:s,refresh:r}}var RA=500,jg=[["a little",.1],["half",.5],["as strong as its drives",1]],Qg=[["←","left","ArrowLeft",[-1,0]],["↑","up","ArrowUp",[0,1]],["↓","down","ArrowDown",[0,-1]],["→","right","ArrowRight",[1,0]]];function e0(n,e,t,i,s){let r=t.map((_,M)=>[_,M]).filter(([,_])=>e.movable[_]),o=b("select",{},...r.map(([_,M])=>b("option",{value:M},_))),a=b("select",{},...jg.map(([_,M])=>b("option",{value:M,selected:M===jg[0][1]},_))),l=b("span",{className:"note",role:"status"}),c=Qg.map(([_,M,v])=>b("button",{type:"button",title:`push ${M}`,"aria-label":`push ${M}`,"data-way":v},_)),u=b("span",{className:"pad",role:"group","aria-label":"push in the plane of the picture"},...c),h=b("p",{className:"note"},"On these buttons, arrow keys push while they are held. Pressing a button pushes for half a second."),d=b("details",{className:"push-keys"},b("summary",{},"Push without a pointer"),b("div",{className:"choices"},b("label",{},"point ",o),b("label",{},"force ",a),u,l),h),f=PA(n,e,()=>Number(o.value),d),p=new Set,m=0;function g(){clearTimeout(m);let[_,M]=[0,1].map(A=>Qg.reduce((y,[,,S,P])=>y+(p.has(S)?P[A]:0),0));if(!_&&!M){l.textContent="",s(0,null);return}let{camera:v}=n.eye,E=new H().setFromMatrixColumn(v.matrixWorld,0).multiplyScalar(_);E.addScaledVector(new H().setFromMatrixColumn(v.matrixWorld,1),M).setLength(Number(a.value)*i),l.textContent=`${o.selectedOptions[0].text} pushed with ${vt(E.length())} N`,s(Number(o.value),E.toArray())}function x(){p.size&&(p.clear(),g())}u.addEventListener("keydown",_=>{!_.key.startsWith("Arrow")||_.shiftKey||_.ctrlKey||_.metaKey||_.altKey||(_.preventDefault(),_.stopPropagation(),!p.has(_.key)&&(p.add(_.key),g()))}),u.addEventListener("keyup",({key:_})=>{p.delete(_)&&g()}),u.addEventListener("focusout",x);for(let _ of c)_.addEventListener("click",()=>{p.clear(),p.add(_.dataset.way),g(),m=setTimeout(x,RA)});return o.addEventListener("change",()=>{x(),f()}),d.addEventListener("toggle",f),d}function PA(n,e,t,i){let s="http://www.w3.org/2000/svg",r=document.createElementNS(s,"svg"),o=document.createElementNS(s,"circle");o.setAttribute("r","9"),r.classList.add("push"),r.setAttribute("aria-hidden","true"),r.append(o),n.element.append(r);let a=new H;function l(){if(r.style.display=i.open?"":"none",!i.open)return;let{x:c,y:u}=a.fromArray(e.frame.points,3*t()).project(n.eye.camera);o.setAttribute("cx",(c+1)/2*n.canvas.clientWidth),o.setAttribute("cy",(1-u)/2*n.canvas.clientHeight)}return e.clock.onChange(l),n.eye.controls.addEventListener("change",l),l(),l}var IA=22;function pu(n,{points:e,movable:t,between:i=()=>null,moved:s,left:r}){let{canvas:o,eye:a}=n,l=document.createElementNS("http://www.w3.org/2000/svg","line"),c=document.createElementNS("http://www.w3.org/2000/svg","svg");c.classList.add("push"),c.setAttribute("aria-hidden","true"),c.append(l);let u=b("p",{className:"pushed","aria-hidden":"true"});n.element.append(c,u),c.style.display="none";let[h,d]=[new H,new H],f=null,p=null;function m(y){d.set(0,0,0);for(let[S,P]of y)d.addScaledVector(h.fromArray(e(),3*S),P);return d}function g(y){let S=m(y).project(a.camera);return[(S.x+1)/2*o.clientWidth,(1-S.y)/2*o.clientHeight]}function x(y){let S=o.getBoundingClientRect();return[y.clientX-S.left,y.clientY-S.top]}function _([y,S]){let P={place:null,away:IA};for(let L=0;L<t.length;L++){if(!t[L])continue;let I=[[L,1]],[O,k]=g(I),N=Math.hypot(O-y,k-S);N<P.away&&(P={place:I,away:N})}return P.place}let M=([y,S])=>[2*y/o.clientWidth-1,1-2*S/o.clientHeight],v=y=>_(x(y))??i(...M(x(y)));function E(){if(!f)return;let y=g(f);for(let[S,P]of[["x1",y[0]],["y1",y[1]],["x2",p[0]],["y2",p[1]]])l.setAttribute(S,P);c.style.display=""}o.addEventListener("pointerdown",y=>{f=y.button===0?v(y):null,f&&(a.controls.enabled=!1,o.setPointerCapture(y.pointerId),y.stopImmediatePropagation())},{capture:!0}),o.addEventListener("pointermove",y=>{if(!f){o.classList.toggle("grip",v(y)!==null);return}p=x(y);let S=m(f).clone(),P=S.clone().project(a.camera).z;s(f,S,new H(...M(p),P).unproject(a.camera)),E()});let A=()=>{f&&(f=null,a.controls.enabled=!0,c.style.display="none",u.textContent="",r())};return o.addEventListener("pointerup",A),o.addEventListener("pointercancel",A),n.onDraw(E),{say:y=>u.textContent=y}}var LA=.25;function t0(n,e,t,i,s){let{say:r}=pu(n,{points:()=>e.frame.points,movable:e.movable,moved([[o]],a,l){let c=l.sub(a).multiplyScalar(i/(LA*t)).clampLength(0,i);s(o,c.toArray()),r(`pushed with ${vt(c.length())} N`)},left:()=>s(0,null)})}var Wa=200,NA=20,DA=3;function n0(n,e,t){let i=n.map(o=>UA(o,e,t)),s=b("button",{type:"button",disabled:!0},`Reset all to ${e}`);s.addEventListener("click",()=>i.forEach(o=>o.reset()));let r=b("div",{className:"sliders",role:"group","aria-label":"values to change"});return r.append(...i.map(o=>o.element),s),{element:r,set(o){for(let a of i)a.put(o[a.knob.key]??a.knob.value)},get changes(){let o=i.filter(a=>a.value!==a.knob.value);return Object.fromEntries(o.map(a=>[a.knob.key,a.value]))},refresh(){s.disabled=i.every(o=>o.value===o.knob.value)}}}function UA(n,e,t){let{key:i,title:s,unit:r,factor:o,lowest:a,highest:l}=n,c=a>0&&l/a>=NA,u=E=>c?a*(l/a)**E:a+E*(l-a),h=E=>c?Math.log(E/a)/Math.log(l/a):(E-a)/(l-a),d=Math.round(Wa*h(n.value)),f=kt(i.replace("protocol.","").replace("youngs","Young's").replaceAll(/[._]/g," ")),p=b("input",{type:"range",min:0,max:Wa,step:1,"aria-label":f,"aria-description":s}),m=b("output"),g=b("span",{className:"home",title:`in ${e}`,"aria-hidden":"true"});g.style.left=`${100*d/Wa}%`,p.dataset.keys="own";let x=n.value;function _(){let E=`${vt(o*x)} ${r.replaceAll("^2","²").replaceAll("^3","³")}`;m.textContent=E,p.setAttribute("aria-valuetext",x===n.value?`${E}, as in ${e}`:E),v.classList.toggle("changed",x!==n.value)}function M(E){x=E,p.value=Math.round(Wa*h(x)),_(),t(i,x)}p.addEventListener("input",()=>{let E=Number(p.value);x=E===d?n.value:Number((o*u(E/Wa)).toPrecision(DA))/o,_(),t(i,x)});let v=b("label",{className:"slider",title:`${i}: ${s}`},b("span",{className:"name"},f),m,b("span",{className:"rail"},p,g));return p.value=d,_(),{element:v,knob:n,get value(){return x},put:M,reset:()=>M(n.value)}}var OA=[["real time",1],["1/2",.5],["1/5",.2],["1/20",.05],["1/100",.01]],FA=.2,mu=1.4,kA="Values were changed, or it was pushed, during the motion, which no run of a design file repeats. “Whole protocol” runs these settings from the start.",BA=1e-15;async function Ao(n,e,t,i,{look:s,pace:r=FA,set:o}={}){let a=JSON.parse(t),l={frame:null,engine:null,pace:r},c=await i(t,S=>A(S)),u=Pg(n,a,c.first),h=b("p",{className:"verdict",role:"status"}),d=b("p",{className:"note"}),f=b("p",{className:"time"}),p=b("p",{className:"account"}),m=b("div"),g=b("div"),x=Jg(a),_=n0(a.knobs,e.kind==="bench"?"the design":"this run",(S,P)=>{c.send({act:"set",values:{[S]:P}}),_.refresh(),x.refresh(_.changes),o?.(S,Zg(a,S,P))}),M=VA(a,c,l,()=>{h.textContent="",d.textContent=""}),v=a.motors.every(S=>S.kind==="torque")?"torques":"drives",E=null;function A(S){if(S.said==="refused"){h.textContent=`The simulator stopped: ${S.why}.`;return}S.said==="frame"&&y(S.frame)}function y(S){l.frame=S,u.show(S),f.textContent=`${lr(S.time_s,{start:0,end:Math.max(1,S.time_s)})}${GA(S,a.protocol)}`;let P=S.energies_J.reduce((N,V)=>N+V,0),L=S.works_J.reduce((N,V)=>N+V,0),I=[...n.tendons?[`tendon energy ${Vd(P)}`]:[],`work of the ${v} ${Vd(L)}`];p.textContent=I.join(" · ");let O=S.stageNumber===null?S.ended:null,k=O&&JSON.stringify([O.verdict,...O.stages.map(N=>N.end_s)]);k!==E&&(h.textContent=O?HA(O,e.whole,a.texts.outcome):"",d.textContent=[O?.advice,O&&S.meddled&&kA].filter(Boolean).join(" ")),E=k}return l.element=b("div",{className:"trial"},b("div",{className:"head"},b("div",{className:"choices"},...M),b("div",{className:"live-facts"},f,p),h,d),m,b("div",{className:"hands"},_.element,...o?[]:[x.element]),g),l.begin=()=>{let S=s??{...Ks(),following:!1,closer:e.kind==="bench"?mu:1},{stage:P}=hu(m,[u.clip],u.clock,{...e,text:`${e.shape}, live.`},S);if(l.stage=P,Qs(g,u.clip,u.clock,e.energy),wo(l.element),P){u.movable=a.anchors.bodies.map(O=>O>0);let L=zA(a,n.mesh.span_m),I=(O,k)=>c.send({act:"push",point:O,force:k});t0(P,u,n.mesh.span_m,L,I),m.querySelector(".picture").after(e0(P,u,a.anchors.names,L,I))}y(c.first),c.send({act:"pace",value:l.pace}),c.send({act:"restart",through:!1}),e.kind!=="bench"&&M[0].focus({preventScroll:!0})},l.leave=()=>l.stage?.dispose(),Object.assign(l,{engine:c,live:u,sliders:_,design:x,own:a})}function zA({protocol:n,motors:e},t){let i=n.drives.map(({strength:s,torques:r})=>{let o=e[r.findIndex(a=>a!==0)];return o?.kind==="torque"?Math.abs(s)/t:o?.kind==="force"?Math.abs(s):0});return Math.max(...i)||1}function VA({protocol:n},e,t,i){let s=(a,l,c)=>{let u=b("button",{type:"button",title:c});return u.append(a),u.addEventListener("click",()=>{i(),e.send(l)}),u},r=n.stages.flatMap(({name:a,drives:l},c)=>{if(!l.length)return[];let u=n.stages.findIndex((d,f)=>f>c&&d.drives.length>0),h=(u<0?n.stages.length:u)-1;return[s(kt(a),{act:"stages",from:c,to:h},`the stage "${a}" of the protocol, and what follows without a drive`)]}),o=b("select",{},...OA.map(([a,l])=>b("option",{value:l,selected:l===t.pace},a)));return o.addEventListener("change",()=>{t.pace=Number(o.value),e.send({act:"pace",value:t.pace})}),[s("Start again",{act:"restart",through:!1},"from the start of the run"),...r,s("Release",{act:"release"},"without any drive"),s("Whole protocol",{act:"restart",through:!0},"all stages, as in the run"),b("label",{},"speed ",o)]}function GA({stage:n,stageNumber:e,running:t,ended:i},{stages:s}){let r=n&&!s[e].drives.length&&i?.stages.at(-1),a=r&&r.goal_s!==null&&s.find(({name:l})=>l===r.name).drives.length?`, ${r.name} reached its goal in ${zr(r.goal_s-r.start_s,"s")}`:"";return n?` · ${n}${a}`:t?" · no drive acts":" · at rest"}function HA({status:n,verdict:e,transitions:t},i,s){let r=t.filter(({took:o})=>o?.succeeded&&o.time_s!==null).map(({words:o,took:a})=>sh(s.transition,{did:o.did||o.done,time:zr(a.time_s,"s"),work:Vd(a.work_J)}));return r.length?sh(s[e==="reached"?"reached":"missed"],{whole:i,transitions:r.join(s.then),status:n}):`${kt(n)}.`}var Vd=n=>zr(Math.abs(n)<BA?0:n,"J");function gu(n,e,t,i,s=null){if(!n)return null;let r={panel:null,failed:"",start:null},o=document.getElementById("live").textContent,a=b("button",{type:"button",className:"try"},"Try it"),l=b("p",{className:"note"});l.textContent=`Move this ${t.whole} yourself: change values, switch drives, release it, push it. The simulator runs in this page.`,n.append(b("div",{className:"offer"},a,l));function c(h){r.failed=h,a.disabled=!0;let d="To drag its vertices, open the design in the workbench, with the command forficula open.",f=`A page cannot simulate the motion in time of this ${t.whole}: ${h}.`;if(l.textContent=`${s?`A slider folds this ${t.whole} along its quasi-static path. `:""}${d} ${f}`,!s)return;let p=b("button",{type:"button",className:"try"},"Fold it slowly");p.addEventListener("click",s),a.replaceWith(p)}let u=JSON.parse(o.startsWith('{"refused"')?o:"null");return u!==null?c(u.refused):su()||c("this page was written without the engine"),r.start=async()=>{if(!a.disabled){a.disabled=!0,l.setAttribute("role","status"),l.textContent="Starting the simulator …",i();try{r.panel=await Ao(e,t,o,Mo),n.replaceChildren(b("h2",{},"Try it"),r.panel.element),r.panel.begin()}catch(h){c(h.message)}}},a.addEventListener("click",async()=>{await r.start(),r.failed||n.scrollIntoView({block:"start"})}),r}function i0(n){let e=Zn(n.clips[0]),t=gu(document.getElementById("try"),e,n,()=>{});return t.start(),{clips:[e],trial:t}}var WA=200;function Li(n,e){let t=new Set,i=e[0].start,s=e[0],r="even",o=!1,a=0,l=0,c=new Map;function u(){return c.has(s)||c.set(s,Wg(n,s)),c.get(s)}let h=()=>r==="even"&&s.whole;function d(_){return h()?u().wayAt(_):(_-s.start)/(s.end-s.start||1)}function f(_){return h()?u().timeAt(_):s.start+_*(s.end-s.start)}function p(){l||(l=requestAnimationFrame(m))}function m(_){if(l=0,o){let M=Math.min((_-a)/1e3,.1);a=_,g(M),l=requestAnimationFrame(m)}for(let M of t)M()}function g(_){r==="even"?i=u().timeAt(Math.min(1,u().wayAt(i)+_/u().seconds)):i=Math.min(s.end,i+r*_),i>=s.end&&(o=!1)}function x(_){i=Math.min(s.end,Math.max(s.start,_)),p()}return{get time(){return i},get span(){return s},get speed(){return r},get playing(){return o},spans:e,clipTime:(_,M=i)=>Math.min(n[_].end,Math.max(n[_].start,M+s.origins[_])),get stretched(){return h()},shareAt:d,momentAt:f,wayAt:_=>u().wayAt(_),timeAt:_=>u().timeAt(_),get slowness(){if(r!=="even")return 1/r;let _=u().wayAt(i),[M,v]=[Math.max(0,_-5e-4),Math.min(1,_+5e-4)];return(v-M)*u().seconds/(u().timeAt(v)-u().timeAt(M)||1e-12)},onChange(_){return t.add(_),p(),()=>t.delete(_)},seek:x,seekClip(_,M){(M<s.start+s.origins[_]||M>s.end+s.origins[_])&&(s=e.find(v=>M>=v.start+v.origins[_]&&M<=v.end+v.origins[_])??e[0]),x(M-s.origins[_])},step:_=>x(f(d(i)+_/WA)),play(){i>=s.end&&(i=s.start),o=!0,a=performance.now(),p()},pause(){o=!1,p()},setSpeed(_){r=_,p()},setSpan(_){s=_,x(i<s.start||i>s.end?s.start:i)},redraw:p}}var $A="uplot",XA="u-hz",qA="u-vt",YA="u-title",ZA="u-wrap",KA="u-under",JA="u-over",jA="u-axis",Ar="u-off",QA="u-select",eE="u-cursor-x",tE="u-cursor-y",nE="u-cursor-pt",iE="u-legend",sE="u-live",rE="u-inline",oE="u-series",aE="u-marker",s0="u-label",lE="u-value",Xa="width",qa="height";var r0="bottom",Eo="left",Gd="right",of="#000",o0=of+"0",Hd="mousemove",a0="mousedown",Wd="mouseup",l0="mouseenter",c0="mouseleave",u0="dblclick",cE="resize",uE="scroll",h0="change",bu="dppxchange",af="--",No=typeof window<"u",Zd=No?document:null,Co=No?window:null,hE=No?navigator:null,At,xu;function Kd(){let n=devicePixelRatio;At!=n&&(At=n,xu&&jd(h0,xu,Kd),xu=matchMedia(`(min-resolution: ${At-.001}dppx) and (max-resolution: ${At+.001}dppx)`),Er(h0,xu,Kd),Co.dispatchEvent(new CustomEvent(bu)))}function di(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function Jd(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function Xt(n,e,t){n.style[e]=t+"px"}function Ni(n,e,t,i){let s=Zd.createElement(n);return e!=null&&di(s,e),t?.insertBefore(s,i),s}function vi(n,e){return Ni("div",n,e)}var d0=new WeakMap;function Ji(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=d0.get(n);r!=o&&(n.style.transform=r,d0.set(n,r),e<0||t<0||e>i||t>s?di(n,Ar):Jd(n,Ar))}var f0=new WeakMap;function p0(n,e,t){let i=e+t,s=f0.get(n);i!=s&&(f0.set(n,i),n.style.background=e,n.style.borderColor=t)}var m0=new WeakMap;function g0(n,e,t,i){let s=e+""+t,r=m0.get(n);s!=r&&(m0.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var lf={passive:!0},dE={...lf,capture:!0};function Er(n,e,t,i){e.addEventListener(n,t,i?dE:lf)}function jd(n,e,t,i){e.removeEventListener(n,t,lf)}No&&Kd();function Di(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:fi((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function W0(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var $0=n=>n!=null,X0=n=>n!=null&&n>0,wu=W0($0),fE=W0(X0);function pE(n,e,t,i=0,s=!1){let r=s?fE:wu,o=s?X0:$0;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Ut,l??-Ut]}function Au(n,e,t,i){let s=y0(n),r=y0(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?Ss:q0,a=s==1?fi:bi,l=r==1?bi:fi,c=a(o(Mn(n))),u=l(o(Mn(e))),h=Ro(t,c),d=Ro(t,u);return t==10&&(c<0&&(h=Ot(h,-c)),u<0&&(d=Ot(d,-u))),i||t==2?(n=h*s,e=d*r):(n=J0(n,h),e=Eu(e,d)),[n,e]}function cf(n,e,t,i){let s=Au(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var uf=.1,x0={mode:3,pad:uf},Za={pad:0,soft:null,mode:0},mE={min:Za,max:Za};function Su(n,e,t,i){return Tu(t)?_0(n,e,t):(Za.pad=t,Za.soft=i?0:null,Za.mode=i?3:0,_0(n,e,mE))}function St(n,e){return n??e}function gE(n,e,t){for(e=St(e,0),t=St(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function _0(n,e,t){let i=t.min,s=t.max,r=St(i.pad,0),o=St(s.pad,0),a=St(i.hard,-Ut),l=St(s.hard,Ut),c=St(i.soft,Ut),u=St(s.soft,-Ut),h=St(i.mode,0),d=St(s.mode,0),f=e-n,p=Ss(f),m=Kn(Mn(n),Mn(e)),g=Ss(m),x=Mn(g-p);(f<1e-24||x>10)&&(f=0,(n==0||e==0)&&(f=1e-24,h==2&&c!=Ut&&(r=0),d==2&&u!=-Ut&&(o=0)));let _=f||m||1e3,M=Ss(_),v=Ro(10,fi(M)),E=_*(f==0?n==0?.1:1:r),A=Ot(J0(n-E,v/10),24),y=n>=c&&(h==1||h==3&&A<=c||h==2&&A>=c)?c:Ut,S=Kn(a,A<y&&n>=y?y:Ui(y,A)),P=_*(f==0?e==0?.1:1:o),L=Ot(Eu(e+P,v/10),24),I=e<=u&&(d==1||d==3&&L>=u||d==2&&L<=u)?u:-Ut,O=Ui(l,L>I&&e<=I?I:Kn(I,L));return S==O&&S==0&&(O=100),[S,O]}var xE=new Intl.NumberFormat(No?hE.language:"en-US"),hf=n=>xE.format(n),pi=Math,vu=pi.PI,Mn=pi.abs,fi=pi.floor,Sn=pi.round,bi=pi.ceil,Ui=pi.min,Kn=pi.max,Ro=pi.pow,y0=pi.sign,Ss=pi.log10,q0=pi.log2,_E=(n,e=1)=>pi.sinh(n)*e,$d=(n,e=1)=>pi.asinh(n/e),Ut=1/0;function v0(n){return(Ss((n^n>>31)-(n>>31))|0)+1}function Qd(n,e,t){return Ui(Kn(n,e),t)}function Y0(n){return typeof n=="function"}function _t(n){return Y0(n)?n:()=>n}var yE=()=>{},Z0=n=>n,K0=(n,e)=>e,vE=n=>null,b0=n=>!0,S0=(n,e)=>n==e,bE=/\.\d*?(?=9{6,}|0{6,})/gm,Tr=n=>{if(Q0(n)||tr.has(n))return n;let e=`${n}`,t=e.match(bE);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Tr(s)}e${r}`}return Ot(n,i)};function Mr(n,e){return Tr(Ot(Tr(n/e))*e)}function Eu(n,e){return Tr(bi(Tr(n/e))*e)}function J0(n,e){return Tr(fi(Tr(n/e))*e)}function Ot(n,e=0){if(Q0(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Sn(i)/t}var tr=new Map;function j0(n){return((""+n).split(".")[1]||"").length}function Ja(n,e,t,i){let s=[],r=i.map(j0);for(let o=e;o<t;o++){let a=Mn(o),l=Ot(Ro(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=n==10?u:Ot(u,h);s.push(d),tr.set(d,h)}}return s}var Ka={},df=[],Po=[null,null],er=Array.isArray,Q0=Number.isInteger,SE=n=>n===void 0;function M0(n){return typeof n=="string"}function Tu(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function ME(n){return n!=null&&typeof n=="object"}var wE=Object.getPrototypeOf(Uint8Array),ex="__proto__";function Io(n,e=Tu){let t;if(er(n)){let i=n.find(s=>s!=null);if(er(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=Io(n[s],e)}else t=n.slice()}else if(n instanceof wE)t=n.slice();else if(e(n)){t={};for(let i in n)i!=ex&&(t[i]=Io(n[i],e))}else t=n;return t}function mn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=ex&&(Tu(n[s])?mn(n[s],Io(i[s])):n[s]=Io(i[s]))}return n}var AE=0,EE=1,TE=2;function CE(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function RE(n,e){if(LE(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return NE(o[0])||(o=IE(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),d=e?e[o][c]:EE,f=[];for(let p=0;p<u.length;p++){let m=u[p],g=r.get(l[p]);m===null?d!=AE&&(h[g]=m,d==TE&&f.push(g)):h[g]=m}CE(h,f,s),i.push(h)}}return i}var PE=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function IE(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function LE(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function NE(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Kn(1,fi((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var tx=["January","February","March","April","May","June","July","August","September","October","November","December"],nx=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function ix(n){return n.slice(0,3)}var DE=nx.map(ix),UE=tx.map(ix),OE={MMMM:tx,MMM:UE,WWWW:nx,WWW:DE};function $a(n){return(n<10?"0":"")+n}function FE(n){return(n<10?"00":n<100?"0":"")+n}var kE={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>$a(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>$a(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>$a(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>$a(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>$a(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>FE(n.getMilliseconds())};function ff(n,e){e=e||OE;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?kE[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var BE=new Intl.DateTimeFormat().resolvedOptions().timeZone;function zE(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==BE?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var sx=n=>n%1==0,Mu=[1,2,2.5,5],VE=Ja(10,-32,0,Mu),rx=Ja(10,0,32,Mu),GE=rx.filter(sx),wr=VE.concat(rx),pf=`
`,ox="{YYYY}",w0=pf+ox,ax="{M}/{D}",Ya=pf+ax,_u=Ya+"/{YY}",lx="{aa}",HE="{h}:{mm}",To=HE+lx,A0=pf+To,E0=":{ss}",Tt=null;function cx(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?Ja(10,0,3,Mu).filter(sx):Ja(10,-3,0,Mu)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,ox,Tt,Tt,Tt,Tt,Tt,Tt,1],[s*28,"{MMM}",w0,Tt,Tt,Tt,Tt,Tt,1],[s,ax,w0,Tt,Tt,Tt,Tt,Tt,1],[i,"{h}"+lx,_u,Tt,Ya,Tt,Tt,Tt,1],[t,To,_u,Tt,Ya,Tt,Tt,Tt,1],[e,E0,_u+" "+To,Tt,Ya+" "+To,Tt,A0,Tt,1],[n,E0+".{fff}",_u+" "+To,Tt,Ya+" "+To,Tt,A0,Tt,1]];function u(h){return(d,f,p,m,g,x)=>{let _=[],M=g>=o,v=g>=r&&g<o,E=h(p),A=Ot(E*n,3),y=Xd(E.getFullYear(),M?0:E.getMonth(),v||M?1:E.getDate()),S=Ot(y*n,3);if(v||M){let P=v?g/r:0,L=M?g/o:0,I=A==S?A:Ot(Xd(y.getFullYear()+L,y.getMonth()+P,1)*n,3),O=new Date(Sn(I/n)),k=O.getFullYear(),N=O.getMonth();for(let V=0;I<=m;V++){let X=Xd(k+L*V,N+P*V,1),G=X-h(Ot(X*n,3));I=Ot((+X+G)*n,3),I<=m&&_.push(I)}}else{let P=g>=s?s:g,L=fi(p)-fi(A),I=S+L+Eu(A-S,P);_.push(I);let O=h(I),k=O.getHours()+O.getMinutes()/t+O.getSeconds()/i,N=g/i,V=d.axes[f]._space,X=x/V;for(;I=Ot(I+g,n==1?0:3),!(I>m);)if(N>1){let G=fi(Ot(k+N,6))%24,Q=h(I).getHours()-G;Q>1&&(Q=-1),I-=Q*i,k=(k+N)%24;let ie=_[_.length-1];Ot((I-ie)/g,3)*X>=.7&&_.push(I)}else _.push(I)}return _}}return[l,c,u]}var[WE,$E,XE]=cx(1),[qE,YE,ZE]=cx(.001);Ja(2,-53,53,[1]);function T0(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function C0(n,e){return(t,i,s,r,o)=>{let a=e.find(p=>o>=p[0])||e[e.length-1],l,c,u,h,d,f;return i.map(p=>{let m=n(p),g=m.getFullYear(),x=m.getMonth(),_=m.getDate(),M=m.getHours(),v=m.getMinutes(),E=m.getSeconds(),A=g!=l&&a[2]||x!=c&&a[3]||_!=u&&a[4]||M!=h&&a[5]||v!=d&&a[6]||E!=f&&a[7]||a[1];return l=g,c=x,u=_,h=M,d=v,f=E,A(m)})}}function KE(n,e){let t=ff(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function Xd(n,e,t){return new Date(n,e,t)}function R0(n,e){return e(n)}var JE="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function P0(n,e){return(t,i,s,r)=>r==null?af:e(n(i))}function jE(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function QE(n,e){return n.series[e].fill(n,e)}var eT={show:!0,live:!0,isolate:!1,mount:yE,markers:{show:!0,width:2,stroke:jE,fill:QE,dash:"solid"},idx:null,idxs:null,values:[]};function tT(n,e){let t=n.cursor.points,i=vi(),s=t.size(n,e);Xt(i,Xa,s),Xt(i,qa,s);let r=s/-2;Xt(i,"marginLeft",r),Xt(i,"marginTop",r);let o=t.width(n,e,s);return o&&Xt(i,"borderWidth",o),i}function nT(n,e){let t=n.series[e].points;return t._fill||t._stroke}function iT(n,e){let t=n.series[e].points;return t._stroke||t._fill}function sT(n,e){return n.series[e].points.size}var qd=[0,0];function rT(n,e,t){return qd[0]=e,qd[1]=t,qd}function yu(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function Yd(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var oT={show:!0,x:!0,y:!0,lock:!1,move:rT,points:{one:!1,show:tT,size:sT,width:0,stroke:iT,fill:nT},bind:{mousedown:yu,mouseup:yu,click:yu,dblclick:yu,mousemove:Yd,mouseleave:Yd,mouseenter:Yd},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},ux={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},mf=mn({},ux,{filter:K0}),hx=mn({},mf,{size:10}),dx=mn({},ux,{show:!1}),gf='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',fx="bold "+gf,px=1.5,I0={show:!0,scale:"x",stroke:of,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:fx,side:2,grid:mf,ticks:hx,border:dx,font:gf,lineGap:px,rotate:0},aT="Value",lT="Time",L0={show:!0,scale:"x",auto:!1,sorted:1,min:Ut,max:-Ut,idxs:[]};function cT(n,e,t,i,s){return e.map(r=>r==null?"":hf(r))}function uT(n,e,t,i,s,r,o){let a=[],l=tr.get(s)||0;t=o?t:Ot(Eu(t,s),l);for(let c=t;c<=i;c=Ot(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function ef(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?Ss:q0,u=fi(c(t));s=Ro(l,u),l==10&&(s=wr[Di(s,wr)]);let h=t,d=s*l;l==10&&(d=wr[Di(d,wr)]);do a.push(h),h=h+s,l==10&&!tr.has(h)&&(h=Ot(h,tr.get(s))),h>=d&&(s=h,d=s*l,l==10&&(d=wr[Di(d,wr)]));while(h<=i);return a}function hT(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?ef(n,e,Kn(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?ef(n,e,Kn(l,-i),-t,s):[l]).reverse().map(d=>-d).concat(u,c)}var mx=/./,dT=/[12357]/,fT=/[125]/,N0=/1/,tf=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function pT(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?mx:l(7,o)-u>=c?dT:l(5,o)-u>=c?fT:N0;if(h==N0){let d=Mn(l(1,o)-u);if(d<c)return tf(e.slice().reverse(),a.distr,h,bi(c/d)).reverse()}return tf(e,a.distr,h,1)}function mT(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=Mn(l(1,o)-l(2,o));return c<a?tf(e.slice().reverse(),3,mx,bi(a/c)).reverse():e}function gT(n,e,t,i){return i==null?af:e==null?"":hf(e)}var D0={show:!0,scale:"y",stroke:of,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:fx,side:3,grid:mf,ticks:hx,border:dx,font:gf,lineGap:px,rotate:0};function xT(n,e){let t=3+(n||1)*2;return Ot(t*e,3)}function _T(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=Mn(o-r),l=n.series[e],c=a/(l.points.space*At);return i[1]-i[0]<=c}var U0={scale:null,auto:!0,sorted:0,min:Ut,max:-Ut},gx=(n,e,t,i,s)=>s,O0={show:!0,auto:!0,sorted:0,gaps:gx,alpha:1,facets:[mn({},U0,{scale:"x"}),mn({},U0,{scale:"y"})]},F0={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:gx,alpha:1,points:{show:_T,filter:null},values:null,min:Ut,max:-Ut,idxs:[],path:null,clip:null};function yT(n,e,t,i,s){return t/10}var xx={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},vT=mn({},xx,{time:!1,ori:1}),k0={};function _x(n,e){let t=k0[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(k0[n]=t)),t}var Lo=1,nf=2;function Cr(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,p=a.width,m=a.height,g=n.valToPosH,x=n.valToPosV;return u.ori==0?t(s,l,c,u,h,g,x,d,f,p,m,Ru,Do,Iu,vx,Sx):t(s,l,c,u,h,x,g,f,d,m,p,Pu,Uo,yf,bx,Mx)}function xf(n,e){let t=0,i=0,s=St(n.bands,df);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function bT(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ms(n,e,t,i,s,r){return Cr(n,e,(o,a,l,c,u,h,d,f,p,m,g)=>{let x=o.pxRound,_=c.dir*(c.ori==0?1:-1),M=c.ori==0?Do:Uo,v,E;_==1?(v=t,E=i):(v=i,E=t);let A=x(h(a[v],c,m,f)),y=x(d(l[v],u,g,p)),S=x(h(a[E],c,m,f)),P=x(d(r==1?u.max:u.min,u,g,p)),L=new Path2D(s);return M(L,S,P),M(L,A,P),M(L,A,y),L})}function Cu(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?Iu:yf,l=t;for(let h=0;h<n.length;h++){let d=n[h];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,i,f,i+r),l=d[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function ST(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function _f(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let h=c,d=c;if(s==1)for(;++c<=i&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let f=r(n[h]),p=d==h?f:r(n[d]),m=h-s;f=o<=0&&m>=0&&m<l?r(n[m]):f;let x=d+s;p=o>=0&&x>=0&&x<l?r(n[x]):p,p>=f&&a.push([f,p])}return a}function B0(n){return n==0?Z0:n==1?Sn:e=>Mr(e,n)}function yx(n){let e=n==0?Ru:Pu,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Ui(c,a/2,l/2),u=Ui(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var Ru=(n,e,t)=>{n.moveTo(e,t)},Pu=(n,e,t)=>{n.moveTo(t,e)},Do=(n,e,t)=>{n.lineTo(e,t)},Uo=(n,e,t)=>{n.lineTo(t,e)},Iu=yx(0),yf=yx(1),vx=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},bx=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},Sx=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},Mx=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function wx(n){return(e,t,i,s,r)=>Cr(e,t,(o,a,l,c,u,h,d,f,p,m,g)=>{let{pxRound:x,points:_}=o,M,v;c.ori==0?(M=Ru,v=vx):(M=Pu,v=bx);let E=Ot(_.width*At,3),A=(_.size-_.width)/2*At,y=Ot(A*2,3),S=new Path2D,P=new Path2D,{left:L,top:I,width:O,height:k}=e.bbox;Iu(P,L-y,I-y,O+y*2,k+y*2);let N=V=>{if(l[V]!=null){let X=x(h(a[V],c,m,f)),G=x(d(l[V],u,g,p));M(S,X+A,G),v(S,X,G,A,0,vu*2)}};if(r)r.forEach(N);else for(let V=i;V<=s;V++)N(V);return{stroke:E>0?S:null,fill:S,clip:P,flags:Lo|nf}})}function Ax(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var MT=Ax(Do),wT=Ax(Uo);function Ex(n){let e=St(n?.alignGaps,0);return(t,i,s,r)=>Cr(t,i,(o,a,l,c,u,h,d,f,p,m,g)=>{[s,r]=wu(l,s,r);let x=o.pxRound,_=k=>x(h(k,c,m,f)),M=k=>x(d(k,u,g,p)),v,E;c.ori==0?(v=Do,E=MT):(v=Uo,E=wT);let A=c.dir*(c.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Lo},S=y.stroke,P=!1;if(r-s>=m*4){let k=de=>t.posToVal(de,c.key,!0),N=null,V=null,X,G,oe,Z=_(a[A==1?s:r]),Q=_(a[s]),ie=_(a[r]),fe=k(A==1?Q+1:ie-1);for(let de=A==1?s:r;de>=s&&de<=r;de+=A){let ee=a[de],ge=(A==1?ee<fe:ee>fe)?Z:_(ee),Se=l[de];ge==Z?Se!=null?(G=Se,N==null?(v(S,ge,M(G)),X=N=V=G):G<N?N=G:G>V&&(V=G)):Se===null&&(P=!0):(N!=null&&E(S,Z,M(N),M(V),M(X),M(G)),Se!=null?(G=Se,v(S,ge,M(G)),N=V=X=G):(N=V=null,Se===null&&(P=!0)),Z=ge,fe=k(Z+A))}N!=null&&N!=V&&oe!=Z&&E(S,Z,M(N),M(V),M(X),M(G))}else for(let k=A==1?s:r;k>=s&&k<=r;k+=A){let N=l[k];N===null?P=!0:N!=null&&v(S,_(a[k]),M(N))}let[I,O]=xf(t,i);if(o.fill!=null||I!=0){let k=y.fill=new Path2D(S),N=o.fillTo(t,i,o.min,o.max,I),V=M(N),X=_(a[s]),G=_(a[r]);A==-1&&([G,X]=[X,G]),v(k,G,V),v(k,X,V)}if(!o.spanGaps){let k=[];P&&k.push(..._f(a,l,s,r,A,_,e)),y.gaps=k=o.gaps(t,i,s,r,k),y.clip=Cu(k,c.ori,f,p,m,g)}return O!=0&&(y.band=O==2?[Ms(t,i,s,r,S,-1),Ms(t,i,s,r,S,1)]:Ms(t,i,s,r,S,O)),y})}function AT(n){let e=St(n.align,1),t=St(n.ascDesc,!1),i=St(n.alignGaps,0),s=St(n.extend,!1);return(r,o,a,l)=>Cr(r,o,(c,u,h,d,f,p,m,g,x,_,M)=>{[a,l]=wu(h,a,l);let v=c.pxRound,{left:E,width:A}=r.bbox,y=Q=>v(p(Q,d,_,g)),S=Q=>v(m(Q,f,M,x)),P=d.ori==0?Do:Uo,L={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Lo},I=L.stroke,O=d.dir*(d.ori==0?1:-1),k=S(h[O==1?a:l]),N=y(u[O==1?a:l]),V=N,X=N;s&&e==-1&&(X=E,P(I,X,k)),P(I,N,k);for(let Q=O==1?a:l;Q>=a&&Q<=l;Q+=O){let ie=h[Q];if(ie==null)continue;let fe=y(u[Q]),de=S(ie);e==1?P(I,fe,k):P(I,V,de),P(I,fe,de),k=de,V=fe}let G=V;s&&e==1&&(G=E+A,P(I,G,k));let[oe,Z]=xf(r,o);if(c.fill!=null||oe!=0){let Q=L.fill=new Path2D(I),ie=c.fillTo(r,o,c.min,c.max,oe),fe=S(ie);P(Q,G,fe),P(Q,X,fe)}if(!c.spanGaps){let Q=[];Q.push(..._f(u,h,a,l,O,y,i));let ie=c.width*At/2,fe=t||e==1?ie:-ie,de=t||e==-1?-ie:ie;Q.forEach(ee=>{ee[0]+=fe,ee[1]+=de}),L.gaps=Q=c.gaps(r,o,a,l,Q),L.clip=Cu(Q,d.ori,g,x,_,M)}return Z!=0&&(L.band=Z==2?[Ms(r,o,a,l,I,-1),Ms(r,o,a,l,I,1)]:Ms(r,o,a,l,I,Z)),L})}function z0(n,e,t,i,s,r,o=Ut){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=Mn(n[l]-n[a]);u<c&&(c=u,o=Mn(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function ET(n){n=n||Ka;let e=St(n.size,[.6,Ut,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=_t(s),o=1-e[0],a=St(e[1],Ut),l=St(e[2],1),c=St(n.disp,Ka),u=St(n.each,f=>{}),{fill:h,stroke:d}=c;return(f,p,m,g)=>Cr(f,p,(x,_,M,v,E,A,y,S,P,L,I)=>{let O=x.pxRound,k=t,N=i*At,V=a*At,X=l*At,G,oe;v.ori==0?[G,oe]=r(f,p):[oe,G]=r(f,p);let Z=v.dir*(v.ori==0?1:-1),Q=v.ori==0?Iu:yf,ie=v.ori==0?u:(Re,Ye,rt,we,Dt,ze,$e)=>{u(Re,Ye,rt,Dt,we,$e,ze)},fe=St(f.bands,df).find(Re=>Re.series[0]==p),de=fe!=null?fe.dir:0,ee=x.fillTo(f,p,x.min,x.max,de),he=O(y(ee,E,I,P)),ge,Se,Me,He=L,st=O(x.width*At),Ve=!1,ut=null,at=null,nt=null,qt=null;h!=null&&(st==0||d!=null)&&(Ve=!0,ut=h.values(f,p,m,g),at=new Map,new Set(ut).forEach(Re=>{Re!=null&&at.set(Re,new Path2D)}),st>0&&(nt=d.values(f,p,m,g),qt=new Map,new Set(nt).forEach(Re=>{Re!=null&&qt.set(Re,new Path2D)})));let{x0:Ft,size:ln}=c;if(Ft!=null&&ln!=null){k=1,_=Ft.values(f,p,m,g),Ft.unit==2&&(_=_.map(rt=>f.posToVal(S+rt*L,v.key,!0)));let Re=ln.values(f,p,m,g);ln.unit==2?Se=Re[0]*L:Se=A(Re[0],v,L,S)-A(0,v,L,S),He=z0(_,M,A,v,L,S,He),Me=He-Se+N}else He=z0(_,M,A,v,L,S,He),Me=He*o+N,Se=He-Me;Me<1&&(Me=0),st>=Se/2&&(st=0),Me<5&&(O=Z0);let Lt=Me>0,wn=He-Me-(Lt?st:0);Se=O(Qd(wn,X,V)),ge=(k==0?Se/2:k==Z?0:Se)-k*Z*((k==0?N/2:0)+(Lt?st/2:0));let yt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},gn=Ve?null:new Path2D,Jt=null;if(fe!=null)Jt=f.data[fe.series[1]];else{let{y0:Re,y1:Ye}=c;Re!=null&&Ye!=null&&(M=Ye.values(f,p,m,g),Jt=Re.values(f,p,m,g))}let cn=G*Se,z=oe*Se;for(let Re=Z==1?m:g;Re>=m&&Re<=g;Re+=Z){let Ye=M[Re];if(Ye==null)continue;if(Jt!=null){let q=Jt[Re]??0;if(Ye-q==0)continue;he=y(q,E,I,P)}let rt=v.distr!=2||c!=null?_[Re]:Re,we=A(rt,v,L,S),Dt=y(St(Ye,ee),E,I,P),ze=O(we-ge),$e=O(Kn(Dt,he)),D=O(Ui(Dt,he)),T=$e-D;if(Ye!=null){let q=Ye<0?z:cn,ue=Ye<0?cn:z;Ve?(st>0&&nt[Re]!=null&&Q(qt.get(nt[Re]),ze,D+fi(st/2),Se,Kn(0,T-st),q,ue),ut[Re]!=null&&Q(at.get(ut[Re]),ze,D+fi(st/2),Se,Kn(0,T-st),q,ue)):Q(gn,ze,D+fi(st/2),Se,Kn(0,T-st),q,ue),ie(f,p,Re,ze-st/2,D,Se+st,T)}}return st>0?yt.stroke=Ve?qt:gn:Ve||(yt._fill=x.width==0?x._fill:x._stroke??x._fill,yt.width=0),yt.fill=Ve?at:gn,yt})}function TT(n,e){let t=St(e?.alignGaps,0);return(i,s,r,o)=>Cr(i,s,(a,l,c,u,h,d,f,p,m,g,x)=>{[r,o]=wu(c,r,o);let _=a.pxRound,M=G=>_(d(G,u,g,p)),v=G=>_(f(G,h,x,m)),E,A,y;u.ori==0?(E=Ru,y=Do,A=Sx):(E=Pu,y=Uo,A=Mx);let S=u.dir*(u.ori==0?1:-1),P=M(l[S==1?r:o]),L=P,I=[],O=[];for(let G=S==1?r:o;G>=r&&G<=o;G+=S)if(c[G]!=null){let Z=l[G],Q=M(Z);I.push(L=Q),O.push(v(c[G]))}let k={stroke:n(I,O,E,y,A,_),fill:null,clip:null,band:null,gaps:null,flags:Lo},N=k.stroke,[V,X]=xf(i,s);if(a.fill!=null||V!=0){let G=k.fill=new Path2D(N),oe=a.fillTo(i,s,a.min,a.max,V),Z=v(oe);y(G,L,Z),y(G,P,Z)}if(!a.spanGaps){let G=[];G.push(..._f(l,c,r,o,S,M,t)),k.gaps=G=a.gaps(i,s,r,o,G),k.clip=Cu(G,u.ori,p,m,g,x)}return X!=0&&(k.band=X==2?[Ms(i,s,r,o,N,-1),Ms(i,s,r,o,N,1)]:Ms(i,s,r,o,N,X)),k})}function CT(n){return TT(RT,n)}function RT(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let d=0;d<o-1;d++)u[d]=e[d+1]-e[d],h[d]=n[d+1]-n[d],c[d]=u[d]/h[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(h[d-1]+h[d])/((2*h[d]+h[d-1])/c[d-1]+(h[d]+2*h[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,n[d]+h[d]/3,e[d]+l[d]*h[d]/3,n[d+1]-h[d]/3,e[d+1]-l[d+1]*h[d]/3,n[d+1],e[d+1])}return a}var sf=new Set;function V0(){for(let n of sf)n.syncRect(!0)}No&&(Er(cE,Co,V0),Er(uE,Co,V0,!0),Er(bu,Co,()=>{an.pxRatio=At}));var PT=Ex(),IT=wx();function G0(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>rf(r,o,e,t))}function LT(n,e){return n.map((t,i)=>i==0?{}:mn({},e,t))}function rf(n,e,t,i){return mn({},e==0?t:i,n)}function Tx(n,e,t){return e==null?Po:[e,t]}var NT=Tx;function DT(n,e,t){return e==null?Po:Su(e,t,uf,!0)}function Cx(n,e,t,i){return e==null?Po:Au(e,t,n.scales[i].log,!1)}var UT=Cx;function Rx(n,e,t,i){return e==null?Po:cf(e,t,n.scales[i].log,!1)}var OT=Rx;function FT(n,e,t,i,s){let r=Kn(v0(n),v0(e)),o=e-n,a=Di(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?tr.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function H0(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=Sn((t=+s)*At))+"px"),[n,e,t]}function kT(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Ot(e[2]*At,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function an(n,e,t){let i={mode:St(n.mode,1)},s=i.mode;function r(w,C,U,F){let $=C.valToPct(w);return F+U*(C.dir==-1?1-$:$)}function o(w,C,U,F){let $=C.valToPct(w);return F+U*(C.dir==-1?$:1-$)}function a(w,C,U,F){return C.ori==0?r(w,C,U,F):o(w,C,U,F)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=vi($A);if(n.id!=null&&(c.id=n.id),di(c,n.class),n.title){let w=vi(YA,c);w.textContent=n.title}let u=Ni("canvas"),h=i.ctx=u.getContext("2d"),d=vi(ZA,c);Er("click",d,w=>{w.target===p&&(Vt!=Ur||Yt!=Or)&&In.click(i,w)},!0);let f=i.under=vi(KA,d);d.appendChild(u);let p=i.over=vi(JA,d);n=Io(n);let m=+St(n.pxAlign,1),g=B0(m);(n.plugins||[]).forEach(w=>{w.opts&&(n=w.opts(i,n)||n)});let x=n.ms||.001,_=i.series=s==1?G0(n.series||[],L0,F0,!1):LT(n.series||[null],O0),M=i.axes=G0(n.axes||[],I0,D0,!0),v=i.scales={},E=i.bands=n.bands||[];E.forEach(w=>{w.fill=_t(w.fill||null),w.dir=St(w.dir,-1)});let A=s==2?_[1].facets[0].scale:_[0].scale,y={axes:ns,series:dt},S=(n.drawOrder||["axes","series"]).map(w=>y[w]);function P(w){let C=w.distr==3?U=>Ss(U>0?U:w.clamp(i,U,w.min,w.max,w.key)):w.distr==4?U=>$d(U,w.asinh):w.distr==100?U=>w.fwd(U):U=>U;return U=>{let F=C(U),{_min:$,_max:J}=w,le=J-$;return(F-$)/le}}function L(w){let C=v[w];if(C==null){let U=(n.scales||Ka)[w]||Ka;if(U.from!=null){L(U.from);let F=mn({},v[U.from],U,{key:w});F.valToPct=P(F),v[w]=F}else{C=v[w]=mn({},w==A?xx:vT,U),C.key=w;let F=C.time,$=C.range,J=er($);if((w!=A||s==2&&!F)&&(J&&($[0]==null||$[1]==null)&&($={min:$[0]==null?x0:{mode:1,hard:$[0],soft:$[0]},max:$[1]==null?x0:{mode:1,hard:$[1],soft:$[1]}},J=!1),!J&&Tu($))){let le=$;$=(pe,ve,Ne)=>ve==null?Po:Su(ve,Ne,le)}C.range=_t($||(F?NT:w==A?C.distr==3?UT:C.distr==4?OT:Tx:C.distr==3?Cx:C.distr==4?Rx:DT)),C.auto=_t(J?!1:C.auto),C.clamp=_t(C.clamp||yT),C._min=C._max=null,C.valToPct=P(C)}}}L("x"),L("y"),s==1&&_.forEach(w=>{L(w.scale)}),M.forEach(w=>{L(w.scale)});for(let w in n.scales)L(w);let I=v[A],O=I.distr,k,N;I.ori==0?(di(c,XA),k=r,N=o):(di(c,qA),k=o,N=r);let V={};for(let w in v){let C=v[w];(C.min!=null||C.max!=null)&&(V[w]={min:C.min,max:C.max},C.min=C.max=null)}let X=n.tzDate||(w=>new Date(Sn(w/x))),G=n.fmtDate||ff,oe=x==1?XE(X):ZE(X),Z=C0(X,T0(x==1?$E:YE,G)),Q=P0(X,R0(JE,G)),ie=[],fe=i.legend=mn({},eT,n.legend),de=i.cursor=mn({},oT,{drag:{y:s==2}},n.cursor),ee=fe.show,he=de.show,ge=fe.markers;fe.idxs=ie,ge.width=_t(ge.width),ge.dash=_t(ge.dash),ge.stroke=_t(ge.stroke),ge.fill=_t(ge.fill);let Se,Me,He,st=[],Ve=[],ut,at=!1,nt={};if(fe.live){let w=_[1]?_[1].values:null;at=w!=null,ut=at?w(i,1,0):{_:0};for(let C in ut)nt[C]=af}if(ee)if(Se=Ni("table",iE,c),He=Ni("tbody",null,Se),fe.mount(i,Se),at){Me=Ni("thead",null,Se,He);let w=Ni("tr",null,Me);Ni("th",null,w);for(var qt in ut)Ni("th",s0,w).textContent=qt}else di(Se,rE),fe.live&&di(Se,sE);let Ft={show:!0},ln={show:!1};function Lt(w,C){if(C==0&&(at||!fe.live||s==2))return Po;let U=[],F=Ni("tr",oE,He,He.childNodes[C]);di(F,w.class),w.show||di(F,Ar);let $=Ni("th",null,F);if(ge.show){let pe=vi(aE,$);if(C>0){let ve=ge.width(i,C);ve&&(pe.style.border=ve+"px "+ge.dash(i,C)+" "+ge.stroke(i,C)),pe.style.background=ge.fill(i,C)}}let J=vi(s0,$);w.label instanceof HTMLElement?J.appendChild(w.label):J.textContent=w.label,C>0&&(ge.show||(J.style.color=w.width>0?ge.stroke(i,C):ge.fill(i,C)),yt("click",$,pe=>{if(de._lock)return;Ke(pe);let ve=_.indexOf(w);if((pe.ctrlKey||pe.metaKey)!=fe.isolate){let Ne=_.some((De,Oe)=>Oe>0&&Oe!=ve&&De.show);_.forEach((De,Oe)=>{Oe>0&&Bi(Oe,Ne?Oe==ve?Ft:ln:Ft,!0,fn.setSeries)})}else Bi(ve,{show:!w.show},!0,fn.setSeries)},!1),Je&&yt(l0,$,pe=>{de._lock||(Ke(pe),Bi(_.indexOf(w),kr,!0,fn.setSeries))},!1));for(var le in ut){let pe=Ni("td",lE,F);pe.textContent="--",U.push(pe)}return[F,U]}let wn=new Map;function yt(w,C,U,F=!0){let $=wn.get(C)||{},J=de.bind[w](i,C,U,F);J&&(Er(w,C,$[w]=J),wn.set(C,$))}function gn(w,C,U){let F=wn.get(C)||{};for(let $ in F)(w==null||$==w)&&(jd($,C,F[$]),delete F[$]);w==null&&wn.delete(C)}let Jt=0,cn=0,z=0,Re=0,Ye=0,rt=0,we=Ye,Dt=rt,ze=z,$e=Re,D=0,T=0,q=0,ue=0;i.bbox={};let ae=!1,_e=!1,ye=!1,te=!1,se=!1,me=!1;function B(w,C,U){(U||w!=i.width||C!=i.height)&&re(w,C),lt(!1),ye=!0,_e=!0,Un()}function re(w,C){i.width=Jt=z=w,i.height=cn=Re=C,Ye=rt=0,be(),Ge();let U=i.bbox;D=U.left=Mr(Ye*At,.5),T=U.top=Mr(rt*At,.5),q=U.width=Mr(z*At,.5),ue=U.height=Mr(Re*At,.5)}let ne=3;function Ae(){let w=!1,C=0;for(;!w;){C++;let U=Lr(C),F=ki(C);w=C==ne||U&&F,w||(re(i.width,i.height),_e=!0)}}function xe({width:w,height:C}){B(w,C)}i.setSize=xe;function be(){let w=!1,C=!1,U=!1,F=!1;M.forEach(($,J)=>{if($.show&&$._show){let{side:le,_size:pe}=$,ve=le%2,Ne=$.label!=null?$.labelSize:0,De=pe+Ne;De>0&&(ve?(z-=De,le==3?(Ye+=De,F=!0):U=!0):(Re-=De,le==0?(rt+=De,w=!0):C=!0))}}),Oi[0]=w,Oi[1]=U,Oi[2]=C,Oi[3]=F,z-=Si[1]+Si[3],Ye+=Si[3],Re-=Si[2]+Si[0],rt+=Si[0]}function Ge(){let w=Ye+z,C=rt+Re,U=Ye,F=rt;function $(J,le){switch(J){case 1:return w+=le,w-le;case 2:return C+=le,C-le;case 3:return U-=le,U+le;case 0:return F-=le,F+le}}M.forEach((J,le)=>{if(J.show&&J._show){let pe=J.side;J._pos=$(pe,J._size),J.label!=null&&(J._lpos=$(pe,J.labelSize))}})}if(de.dataIdx==null){let w=de.hover,C=w.skip=new Set(w.skip??[]);C.add(void 0);let U=w.prox=_t(w.prox),F=w.bias??=0;de.dataIdx=($,J,le,pe)=>{if(J==0)return le;let ve=le,Ne=U($,J,le,pe)??Ut,De=Ne>=0&&Ne<Ut,Oe=I.ori==0?z:Re,it=de.left,Mt=e[0],bt=e[J];if(C.has(bt[le])){ve=null;let mt=null,Ze=null,We;if(F==0||F==-1)for(We=le;mt==null&&We-- >0;)C.has(bt[We])||(mt=We);if(F==0||F==1)for(We=le;Ze==null&&We++<bt.length;)C.has(bt[We])||(Ze=We);if(mt!=null||Ze!=null)if(De){let Ht=mt==null?-1/0:k(Mt[mt],I,Oe,0),en=Ze==null?1/0:k(Mt[Ze],I,Oe,0),Cn=it-Ht,Nt=en-it;Cn<=Nt?Cn<=Ne&&(ve=mt):Nt<=Ne&&(ve=Ze)}else ve=Ze==null?mt:mt==null?Ze:le-mt<=Ze-le?mt:Ze}else De&&Mn(it-k(Mt[le],I,Oe,0))>Ne&&(ve=null);return ve}}let Ke=w=>{de.event=w};de.idxs=ie,de._lock=!1;let ce=de.points;ce.show=_t(ce.show),ce.size=_t(ce.size),ce.stroke=_t(ce.stroke),ce.width=_t(ce.width),ce.fill=_t(ce.fill);let Fe=i.focus=mn({},n.focus||{alpha:.3},de.focus),Je=Fe.prox>=0,Ce=Je&&ce.one,ot=[],zt=[],Vn=[];function Bo(w,C){let U=ce.show(i,C);if(U instanceof HTMLElement)return di(U,nE),di(U,w.class),Ji(U,-10,-10,z,Re),p.insertBefore(U,ot[C]),U}function Rr(w,C){if(s==1||C>0){let U=s==1&&v[w.scale].time,F=w.value;w.value=U?M0(F)?P0(X,R0(F,G)):F||Q:F||gT,w.label=w.label||(U?lT:aT)}if(Ce||C>0){w.width=w.width==null?1:w.width,w.paths=w.paths||PT||vE,w.fillTo=_t(w.fillTo||bT),w.pxAlign=+St(w.pxAlign,m),w.pxRound=B0(w.pxAlign),w.stroke=_t(w.stroke||null),w.fill=_t(w.fill||null),w._stroke=w._fill=w._paths=w._focus=null;let U=xT(Kn(1,w.width),1),F=w.points=mn({},{size:U,width:Kn(1,U*.2),stroke:w.stroke,space:U*2,paths:IT,_stroke:null,_fill:null},w.points);F.show=_t(F.show),F.filter=_t(F.filter),F.fill=_t(F.fill),F.stroke=_t(F.stroke),F.paths=_t(F.paths),F.pxAlign=w.pxAlign}if(ee){let U=Lt(w,C);st.splice(C,0,U[0]),Ve.splice(C,0,U[1]),fe.values.push(null)}if(he){ie.splice(C,0,null);let U=null;Ce?C==0&&(U=Bo(w,C)):C>0&&(U=Bo(w,C)),ot.splice(C,0,U),zt.splice(C,0,0),Vn.splice(C,0,0)}Tn("addSeries",C)}function qu(w,C){C=C??_.length,w=s==1?rf(w,C,L0,F0):rf(w,C,{},O0),_.splice(C,0,w),Rr(_[C],C)}i.addSeries=qu;function Qa(w){if(_.splice(w,1),ee){fe.values.splice(w,1),Ve.splice(w,1);let C=st.splice(w,1)[0];gn(null,C.firstChild),C.remove()}he&&(ie.splice(w,1),ot.splice(w,1)[0].remove(),zt.splice(w,1),Vn.splice(w,1)),Tn("delSeries",w)}i.delSeries=Qa;let Oi=[!1,!1,!1,!1];function Qi(w,C){if(w._show=w.show,w.show){let U=w.side%2,F=v[w.scale];F==null&&(w.scale=U?_[1].scale:A,F=v[w.scale]);let $=F.time;w.size=_t(w.size),w.space=_t(w.space),w.rotate=_t(w.rotate),er(w.incrs)&&w.incrs.forEach(le=>{!tr.has(le)&&tr.set(le,j0(le))}),w.incrs=_t(w.incrs||(F.distr==2?GE:$?x==1?WE:qE:wr)),w.splits=_t(w.splits||($&&F.distr==1?oe:F.distr==3?ef:F.distr==4?hT:uT)),w.stroke=_t(w.stroke),w.grid.stroke=_t(w.grid.stroke),w.ticks.stroke=_t(w.ticks.stroke),w.border.stroke=_t(w.border.stroke);let J=w.values;w.values=er(J)&&!er(J[0])?_t(J):$?er(J)?C0(X,T0(J,G)):M0(J)?KE(X,J):J||Z:J||cT,w.filter=_t(w.filter||(F.distr>=3&&F.log==10?pT:F.distr==3&&F.log==2?mT:K0)),w.font=H0(w.font),w.labelFont=H0(w.labelFont),w._size=w.size(i,null,C,0),w._space=w._rotate=w._incrs=w._found=w._splits=w._values=null,w._size>0&&(Oi[C]=!0,w._el=vi(jA,d))}}function es(w,C,U,F){let[$,J,le,pe]=U,ve=C%2,Ne=0;return ve==0&&(pe||J)&&(Ne=C==0&&!$||C==2&&!le?Sn(I0.size/3):0),ve==1&&($||le)&&(Ne=C==1&&!J||C==3&&!pe?Sn(D0.size/2):0),Ne}let zo=i.padding=(n.padding||[es,es,es,es]).map(w=>_t(St(w,es))),Si=i._padding=zo.map((w,C)=>w(i,C,Oi,0)),jt,sn=null,rn=null,Fi=s==1?_[0].idxs:null,ei=null,Es=!1;function Vo(w,C){if(e=w??[],i.data=i._data=e,s==2){jt=0;for(let U=1;U<_.length;U++)jt+=e[U][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),ei=e[0],jt=ei.length;let U=e;if(O==2){U=e.slice();let F=U[0]=Array(jt);for(let $=0;$<jt;$++)F[$]=$}i._data=e=U}if(lt(!0),Tn("setData"),O==2&&(ye=!0),C!==!1){let U=I;U.auto(i,Es)?Go():Rs(A,U.min,U.max),te=te||de.left>=0,me=!0,Un()}}i.setData=Vo;function Go(){Es=!0;let w,C;s==1&&(jt>0?(sn=Fi[0]=0,rn=Fi[1]=jt-1,w=e[0][sn],C=e[0][rn],O==2?(w=sn,C=rn):w==C&&(O==3?[w,C]=Au(w,w,I.log,!1):O==4?[w,C]=cf(w,w,I.log,!1):I.time?C=w+Sn(86400/x):[w,C]=Su(w,C,uf,!0))):(sn=Fi[0]=w=null,rn=Fi[1]=C=null)),Rs(A,w,C)}let Pr,Ts,Ir,R,W,j,Y,K,Ee,Pe;function Te(w,C,U,F,$,J){w??=o0,U??=df,F??="butt",$??=o0,J??="round",w!=Pr&&(h.strokeStyle=Pr=w),$!=Ts&&(h.fillStyle=Ts=$),C!=Ir&&(h.lineWidth=Ir=C),J!=W&&(h.lineJoin=W=J),F!=j&&(h.lineCap=j=F),U!=R&&h.setLineDash(R=U)}function Ie(w,C,U,F){C!=Ts&&(h.fillStyle=Ts=C),w!=Y&&(h.font=Y=w),U!=K&&(h.textAlign=K=U),F!=Ee&&(h.textBaseline=Ee=F)}function Be(w,C,U,F,$=0){if(F.length>0&&w.auto(i,Es)&&(C==null||C.min==null)){let J=St(sn,0),le=St(rn,F.length-1),pe=U.min==null?pE(F,J,le,$,w.distr==3):[U.min,U.max];w.min=Ui(w.min,U.min=pe[0]),w.max=Kn(w.max,U.max=pe[1])}}let et={min:null,max:null};function ht(){for(let F in v){let $=v[F];V[F]==null&&($.min==null||V[A]!=null&&$.auto(i,Es))&&(V[F]=et)}for(let F in v){let $=v[F];V[F]==null&&$.from!=null&&V[$.from]!=null&&(V[F]=et)}V[A]!=null&&lt(!0);let w={};for(let F in V){let $=V[F];if($!=null){let J=w[F]=Io(v[F],ME);if($.min!=null)mn(J,$);else if(F!=A||s==2)if(jt==0&&J.from==null){let le=J.range(i,null,null,F);J.min=le[0],J.max=le[1]}else J.min=Ut,J.max=-Ut}}if(jt>0){_.forEach((F,$)=>{if(s==1){let J=F.scale,le=V[J];if(le==null)return;let pe=w[J];if($==0){let ve=pe.range(i,pe.min,pe.max,J);pe.min=ve[0],pe.max=ve[1],sn=Di(pe.min,e[0]),rn=Di(pe.max,e[0]),rn-sn>1&&(e[0][sn]<pe.min&&sn++,e[0][rn]>pe.max&&rn--),F.min=ei[sn],F.max=ei[rn]}else F.show&&F.auto&&Be(pe,le,F,e[$],F.sorted);F.idxs[0]=sn,F.idxs[1]=rn}else if($>0&&F.show&&F.auto){let[J,le]=F.facets,pe=J.scale,ve=le.scale,[Ne,De]=e[$],Oe=w[pe],it=w[ve];Oe!=null&&Be(Oe,V[pe],J,Ne,J.sorted),it!=null&&Be(it,V[ve],le,De,le.sorted),F.min=le.min,F.max=le.max}});for(let F in w){let $=w[F],J=V[F];if($.from==null&&(J==null||J.min==null)){let le=$.range(i,$.min==Ut?null:$.min,$.max==-Ut?null:$.max,F);$.min=le[0],$.max=le[1]}}}for(let F in w){let $=w[F];if($.from!=null){let J=w[$.from];if(J.min==null)$.min=$.max=null;else{let le=$.range(i,J.min,J.max,F);$.min=le[0],$.max=le[1]}}}let C={},U=!1;for(let F in w){let $=w[F],J=v[F];if(J.min!=$.min||J.max!=$.max){J.min=$.min,J.max=$.max;let le=J.distr;J._min=le==3?Ss(J.min):le==4?$d(J.min,J.asinh):le==100?J.fwd(J.min):J.min,J._max=le==3?Ss(J.max):le==4?$d(J.max,J.asinh):le==100?J.fwd(J.max):J.max,C[F]=U=!0}}if(U){_.forEach((F,$)=>{s==2?$>0&&C.y&&(F._paths=null):C[F.scale]&&(F._paths=null)});for(let F in C)ye=!0,Tn("setScale",F);he&&de.left>=0&&(te=me=!0)}for(let F in V)V[F]=null}function ke(w){let C=Qd(sn-1,0,jt-1),U=Qd(rn+1,0,jt-1);for(;w[C]==null&&C>0;)C--;for(;w[U]==null&&U<jt-1;)U++;return[C,U]}function dt(){if(jt>0){let w=_.some(C=>C._focus)&&Pe!=Fe.alpha;w&&(h.globalAlpha=Pe=Fe.alpha),_.forEach((C,U)=>{if(U>0&&C.show&&(Kt(U,!1),Kt(U,!0),C._paths==null)){let F=Pe;Pe!=C.alpha&&(h.globalAlpha=Pe=C.alpha);let $=s==2?[0,e[U][0].length-1]:ke(e[U]);C._paths=C.paths(i,U,$[0],$[1]),Pe!=F&&(h.globalAlpha=Pe=F)}}),_.forEach((C,U)=>{if(U>0&&C.show){let F=Pe;Pe!=C.alpha&&(h.globalAlpha=Pe=C.alpha),C._paths!=null&&Ct(U,!1);{let $=C._paths!=null?C._paths.gaps:null,J=C.points.show(i,U,sn,rn,$),le=C.points.filter(i,U,J,$);(J||le)&&(C.points._paths=C.points.paths(i,U,sn,rn,le),Ct(U,!0))}Pe!=F&&(h.globalAlpha=Pe=F),Tn("drawSeries",U)}}),w&&(h.globalAlpha=Pe=1)}}function Kt(w,C){let U=C?_[w].points:_[w];U._stroke=U.stroke(i,w),U._fill=U.fill(i,w)}function Ct(w,C){let U=C?_[w].points:_[w],{stroke:F,fill:$,clip:J,flags:le,_stroke:pe=U._stroke,_fill:ve=U._fill,_width:Ne=U.width}=U._paths;Ne=Ot(Ne*At,3);let De=null,Oe=Ne%2/2;C&&ve==null&&(ve=Ne>0?"#fff":pe);let it=U.pxAlign==1&&Oe>0;if(it&&h.translate(Oe,Oe),!C){let Mt=D-Ne/2,bt=T-Ne/2,mt=q+Ne,Ze=ue+Ne;De=new Path2D,De.rect(Mt,bt,mt,Ze)}C?Ue(pe,Ne,U.dash,U.cap,ve,F,$,le,J):Rt(w,pe,Ne,U.dash,U.cap,ve,F,$,le,De,J),it&&h.translate(-Oe,-Oe)}function Rt(w,C,U,F,$,J,le,pe,ve,Ne,De){let Oe=!1;ve!=0&&E.forEach((it,Mt)=>{if(it.series[0]==w){let bt=_[it.series[1]],mt=e[it.series[1]],Ze=(bt._paths||Ka).band;er(Ze)&&(Ze=it.dir==1?Ze[0]:Ze[1]);let We,Ht=null;bt.show&&Ze&&gE(mt,sn,rn)?(Ht=it.fill(i,Mt)||J,We=bt._paths.clip):Ze=null,Ue(C,U,F,$,Ht,le,pe,ve,Ne,De,We,Ze),Oe=!0}}),Oe||Ue(C,U,F,$,J,le,pe,ve,Ne,De)}let xn=Lo|nf;function Ue(w,C,U,F,$,J,le,pe,ve,Ne,De,Oe){Te(w,C,U,F,$),(ve||Ne||Oe)&&(h.save(),ve&&h.clip(ve),Ne&&h.clip(Ne)),Oe?(pe&xn)==xn?(h.clip(Oe),De&&h.clip(De),gt($,le),un(w,J,C)):pe&nf?(gt($,le),h.clip(Oe),un(w,J,C)):pe&Lo&&(h.save(),h.clip(Oe),De&&h.clip(De),gt($,le),h.restore(),un(w,J,C)):(gt($,le),un(w,J,C)),(ve||Ne||Oe)&&h.restore()}function un(w,C,U){U>0&&(C instanceof Map?C.forEach((F,$)=>{h.strokeStyle=Pr=$,h.stroke(F)}):C!=null&&w&&h.stroke(C))}function gt(w,C){C instanceof Map?C.forEach((U,F)=>{h.fillStyle=Ts=F,h.fill(U)}):C!=null&&w&&h.fill(C)}function ts(w,C,U,F){let $=M[w],J;if(F<=0)J=[0,0];else{let le=$._space=$.space(i,w,C,U,F),pe=$._incrs=$.incrs(i,w,C,U,F,le);J=FT(C,U,pe,F,le)}return $._found=J}function hn(w,C,U,F,$,J,le,pe,ve,Ne){let De=le%2/2;m==1&&h.translate(De,De),Te(pe,le,ve,Ne,pe),h.beginPath();let Oe,it,Mt,bt,mt=$+(F==0||F==3?-J:J);U==0?(it=$,bt=mt):(Oe=$,Mt=mt);for(let Ze=0;Ze<w.length;Ze++)C[Ze]!=null&&(U==0?Oe=Mt=w[Ze]:it=bt=w[Ze],h.moveTo(Oe,it),h.lineTo(Mt,bt));h.stroke(),m==1&&h.translate(-De,-De)}function Lr(w){let C=!0;return M.forEach((U,F)=>{if(!U.show)return;let $=v[U.scale];if($.min==null){U._show&&(C=!1,U._show=!1,lt(!1));return}else U._show||(C=!1,U._show=!0,lt(!1));let J=U.side,le=J%2,{min:pe,max:ve}=$,[Ne,De]=ts(F,pe,ve,le==0?z:Re);if(De==0)return;let Oe=$.distr==2,it=U._splits=U.splits(i,F,pe,ve,Ne,De,Oe),Mt=$.distr==2?it.map(We=>ei[We]):it,bt=$.distr==2?ei[it[1]]-ei[it[0]]:Ne,mt=U._values=U.values(i,U.filter(i,Mt,F,De,bt),F,De,bt);U._rotate=J==2?U.rotate(i,mt,F,De):0;let Ze=U._size;U._size=bi(U.size(i,mt,F,w)),Ze!=null&&U._size!=Ze&&(C=!1)}),C}function ki(w){let C=!0;return zo.forEach((U,F)=>{let $=U(i,F,Oi,w);$!=Si[F]&&(C=!1),Si[F]=$}),C}function ns(){for(let w=0;w<M.length;w++){let C=M[w];if(!C.show||!C._show)continue;let U=C.side,F=U%2,$,J,le=C.stroke(i,w),pe=U==0||U==3?-1:1,[ve,Ne]=C._found;if(C.label!=null){let Wn=C.labelGap*pe,ii=Sn((C._lpos+Wn)*At);Ie(C.labelFont[0],le,"center",U==2?"top":r0),h.save(),F==1?($=J=0,h.translate(ii,Sn(T+ue/2)),h.rotate((U==3?-vu:vu)/2)):($=Sn(D+q/2),J=ii);let or=Y0(C.label)?C.label(i,w,ve,Ne):C.label;h.fillText(or,$,J),h.restore()}if(Ne==0)continue;let De=v[C.scale],Oe=F==0?q:ue,it=F==0?D:T,Mt=C._splits,bt=De.distr==2?Mt.map(Wn=>ei[Wn]):Mt,mt=De.distr==2?ei[Mt[1]]-ei[Mt[0]]:ve,Ze=C.ticks,We=C.border,Ht=Ze.show?Ze.size:0,en=Sn(Ht*At),Cn=Sn((C.alignTo==2?C._size-Ht-C.gap:C.gap)*At),Nt=C._rotate*-vu/180,tn=g(C._pos*At),ti=(en+Cn)*pe,Hn=tn+ti;J=F==0?Hn:0,$=F==1?Hn:0;let mi=C.font[0],Mi=C.align==1?Eo:C.align==2?Gd:Nt>0?Eo:Nt<0?Gd:F==0?"center":U==3?Gd:Eo,Vi=Nt||F==1?"middle":U==2?"top":r0;Ie(mi,le,Mi,Vi);let ni=C.font[1]*C.lineGap,gi=Mt.map(Wn=>g(a(Wn,De,Oe,it))),wi=C._values;for(let Wn=0;Wn<wi.length;Wn++){let ii=wi[Wn];if(ii!=null){F==0?$=gi[Wn]:J=gi[Wn],ii=""+ii;let or=ii.indexOf(`
`)==-1?[ii]:ii.split(/\n/gm);for(let $n=0;$n<or.length;$n++){let lp=or[$n];Nt?(h.save(),h.translate($,J+$n*ni),h.rotate(Nt),h.fillText(lp,0,0),h.restore()):h.fillText(lp,$,J+$n*ni)}}}Ze.show&&hn(gi,Ze.filter(i,bt,w,Ne,mt),F,U,tn,en,Ot(Ze.width*At,3),Ze.stroke(i,w),Ze.dash,Ze.cap);let Gi=C.grid;Gi.show&&hn(gi,Gi.filter(i,bt,w,Ne,mt),F,F==0?2:1,F==0?T:D,F==0?ue:q,Ot(Gi.width*At,3),Gi.stroke(i,w),Gi.dash,Gi.cap),We.show&&hn([tn],[1],F==0?1:0,F==0?1:2,F==1?T:D,F==1?ue:q,Ot(We.width*At,3),We.stroke(i,w),We.dash,We.cap)}Tn("drawAxes")}function lt(w){_.forEach((C,U)=>{U>0&&(C._paths=null,w&&(s==1?(C.min=null,C.max=null):C.facets.forEach(F=>{F.min=null,F.max=null})))})}let Qt=!1,Gn=!1,Pt=[];function dn(){Gn=!1;for(let w=0;w<Pt.length;w++)Tn(...Pt[w]);Pt.length=0}function Un(){Qt||(PE(Wf),Qt=!0)}function el(w,C=!1){Qt=!0,Gn=C,w(i),Wf(),C&&Pt.length>0&&queueMicrotask(dn)}i.batch=el;function Wf(){if(ae&&(ht(),ae=!1),ye&&(Ae(),ye=!1),_e){if(Xt(f,Eo,Ye),Xt(f,"top",rt),Xt(f,Xa,z),Xt(f,qa,Re),Xt(p,Eo,Ye),Xt(p,"top",rt),Xt(p,Xa,z),Xt(p,qa,Re),Xt(d,Xa,Jt),Xt(d,qa,cn),u.width=Sn(Jt*At),u.height=Sn(cn*At),M.forEach(({_el:w,_show:C,_size:U,_pos:F,side:$})=>{if(w!=null)if(C){let J=$===3||$===0?U:0,le=$%2==1;Xt(w,le?"left":"top",F-J),Xt(w,le?"width":"height",U),Xt(w,le?"top":"left",le?rt:Ye),Xt(w,le?"height":"width",le?Re:z),Jd(w,Ar)}else di(w,Ar)}),Pr=Ts=Ir=W=j=Y=K=Ee=R=null,Pe=1,$o(!0),Ye!=we||rt!=Dt||z!=ze||Re!=$e){lt(!1);let w=z/ze,C=Re/$e;if(he&&!te&&de.left>=0){de.left*=w,de.top*=C,Nr&&Ji(Nr,Sn(de.left),0,z,Re),Dr&&Ji(Dr,0,Sn(de.top),z,Re);for(let U=0;U<ot.length;U++){let F=ot[U];F!=null&&(zt[U]*=w,Vn[U]*=C,Ji(F,bi(zt[U]),bi(Vn[U]),z,Re))}}if(Gt.show&&!se&&Gt.left>=0&&Gt.width>0){Gt.left*=w,Gt.width*=w,Gt.top*=C,Gt.height*=C;for(let U in Qu)Xt(Fr,U,Gt[U])}we=Ye,Dt=rt,ze=z,$e=Re}Tn("setSize"),_e=!1}Jt>0&&cn>0&&(h.clearRect(0,0,u.width,u.height),Tn("drawClear"),S.forEach(w=>w()),Tn("draw")),Gt.show&&se&&(tl(Gt),se=!1),he&&te&&(rr(null,!0,!1),te=!1),fe.show&&fe.live&&me&&(Ju(),me=!1),l||(l=!0,i.status=1,Tn("ready")),Es=!1,Qt=!1}i.redraw=(w,C)=>{ye=C||!1,w!==!1?Rs(A,I.min,I.max):Un()};function Yu(w,C){let U=v[w];if(U.from==null){if(jt==0){let F=U.range(i,C.min,C.max,w);C.min=F[0],C.max=F[1]}if(C.min>C.max){let F=C.min;C.min=C.max,C.max=F}if(jt>1&&C.min!=null&&C.max!=null&&C.max-C.min<1e-16)return;w==A&&U.distr==2&&jt>0&&(C.min=Di(C.min,e[0]),C.max=Di(C.max,e[0]),C.min==C.max&&C.max++),V[w]=C,ae=!0,Un()}}i.setScale=Yu;let Zu,Ku,Nr,Dr,$f,Xf,Ur,Or,qf,Yf,Vt,Yt,Cs=!1,In=de.drag,An=In.x,En=In.y;he&&(de.x&&(Zu=vi(eE,p)),de.y&&(Ku=vi(tE,p)),I.ori==0?(Nr=Zu,Dr=Ku):(Nr=Ku,Dr=Zu),Vt=de.left,Yt=de.top);let Gt=i.select=mn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Fr=Gt.show?vi(QA,Gt.over?p:f):null;function tl(w,C){if(Gt.show){for(let U in w)Gt[U]=w[U],U in Qu&&Xt(Fr,U,w[U]);C!==!1&&Tn("setSelect")}}i.setSelect=tl;function cy(w){if(_[w].show)ee&&Jd(st[w],Ar);else if(ee&&di(st[w],Ar),he){let U=Ce?ot[0]:ot[w];U!=null&&Ji(U,-10,-10,z,Re)}}function Rs(w,C,U){Yu(w,{min:C,max:U})}function Bi(w,C,U,F){C.focus!=null&&py(w),C.show!=null&&_.forEach(($,J)=>{J>0&&(w==J||w==null)&&($.show=C.show,cy(J),s==2?(Rs($.facets[0].scale,null,null),Rs($.facets[1].scale,null,null)):Rs($.scale,null,null),Un())}),U!==!1&&Tn("setSeries",w,C),F&&Xo("setSeries",i,w,C)}i.setSeries=Bi;function uy(w,C){mn(E[w],C)}function hy(w,C){w.fill=_t(w.fill||null),w.dir=St(w.dir,-1),C=C??E.length,E.splice(C,0,w)}function dy(w){w==null?E.length=0:E.splice(w,1)}i.addBand=hy,i.setBand=uy,i.delBand=dy;function fy(w,C){_[w].alpha=C,he&&ot[w]!=null&&(ot[w].style.opacity=C),ee&&st[w]&&(st[w].style.opacity=C)}let is,Ps,sr,kr={focus:!0};function py(w){if(w!=sr){let C=w==null,U=Fe.alpha!=1;_.forEach((F,$)=>{if(s==1||$>0){let J=C||$==0||$==w;F._focus=C?null:J,U&&fy($,J?1:Fe.alpha)}}),sr=w,U&&Un()}}ee&&Je&&yt(c0,Se,w=>{de._lock||(Ke(w),sr!=null&&Bi(null,kr,!0,fn.setSeries))});function zi(w,C,U){let F=v[C];U&&(w=w/At-(F.ori==1?rt:Ye));let $=z;F.ori==1&&($=Re,w=$-w),F.dir==-1&&(w=$-w);let J=F._min,le=F._max,pe=w/$,ve=J+(le-J)*pe,Ne=F.distr;return Ne==3?Ro(10,ve):Ne==4?_E(ve,F.asinh):Ne==100?F.bwd(ve):ve}function my(w,C){let U=zi(w,A,C);return Di(U,e[0],sn,rn)}i.valToIdx=w=>Di(w,e[0]),i.posToIdx=my,i.posToVal=zi,i.valToPos=(w,C,U)=>v[C].ori==0?r(w,v[C],U?q:z,U?D:0):o(w,v[C],U?ue:Re,U?T:0),i.setCursor=(w,C,U)=>{Vt=w.left,Yt=w.top,rr(null,C,U)};function Zf(w,C){Xt(Fr,Eo,Gt.left=w),Xt(Fr,Xa,Gt.width=C)}function Kf(w,C){Xt(Fr,"top",Gt.top=w),Xt(Fr,qa,Gt.height=C)}let Ho=I.ori==0?Zf:Kf,Wo=I.ori==1?Zf:Kf;function gy(){if(ee&&fe.live)for(let w=s==2?1:0;w<_.length;w++){if(w==0&&at)continue;let C=fe.values[w],U=0;for(let F in C)Ve[w][U++].firstChild.nodeValue=C[F]}}function Ju(w,C){if(w!=null&&(w.idxs?w.idxs.forEach((U,F)=>{ie[F]=U}):SE(w.idx)||ie.fill(w.idx),fe.idx=ie[0]),ee&&fe.live){for(let U=0;U<_.length;U++)(U>0||s==1&&!at)&&xy(U,ie[U]);gy()}me=!1,C!==!1&&Tn("setLegend")}i.setLegend=Ju;function xy(w,C){let U=_[w],F=w==0&&O==2?ei:e[w],$;at?$=U.values(i,w,C)??nt:($=U.value(i,C==null?null:F[C],w,C),$=$==null?nt:{_:$}),fe.values[w]=$}function rr(w,C,U){qf=Vt,Yf=Yt,[Vt,Yt]=de.move(i,Vt,Yt),de.left=Vt,de.top=Yt,he&&(Nr&&Ji(Nr,Sn(Vt),0,z,Re),Dr&&Ji(Dr,0,Sn(Yt),z,Re));let F,$=sn>rn;is=Ut,Ps=null;let J=I.ori==0?z:Re,le=I.ori==1?z:Re;if(Vt<0||jt==0||$){F=de.idx=null;for(let pe=0;pe<_.length;pe++){let ve=ot[pe];ve!=null&&Ji(ve,-10,-10,z,Re)}Je&&Bi(null,kr,!0,w==null&&fn.setSeries),fe.live&&(ie.fill(F),me=!0)}else{let pe,ve,Ne;s==1&&(pe=I.ori==0?Vt:Yt,ve=zi(pe,A),F=de.idx=Di(ve,e[0],sn,rn),Ne=k(e[0][F],I,J,0));let De=-10,Oe=-10,it=0,Mt=0,bt=!0,mt="",Ze="";for(let We=s==2?1:0;We<_.length;We++){let Ht=_[We],en=ie[We],Cn=en==null?null:s==1?e[We][en]:e[We][1][en],Nt=de.dataIdx(i,We,F,ve),tn=Nt==null?null:s==1?e[We][Nt]:e[We][1][Nt];if(me=me||tn!=Cn||Nt!=en,ie[We]=Nt,We>0&&Ht.show){let ti=Nt==null?-10:Nt==F?Ne:k(s==1?e[0][Nt]:e[We][0][Nt],I,J,0),Hn=tn==null?-10:N(tn,s==1?v[Ht.scale]:v[Ht.facets[1].scale],le,0);if(Je&&tn!=null){let mi=I.ori==1?Vt:Yt,Mi=Mn(Fe.dist(i,We,Nt,Hn,mi));if(Mi<is){let Vi=Fe.bias;if(Vi!=0){let ni=zi(mi,Ht.scale),gi=tn>=0?1:-1,wi=ni>=0?1:-1;wi==gi&&(wi==1?Vi==1?tn>=ni:tn<=ni:Vi==1?tn<=ni:tn>=ni)&&(is=Mi,Ps=We)}else is=Mi,Ps=We}}if(me||Ce){let mi,Mi;I.ori==0?(mi=ti,Mi=Hn):(mi=Hn,Mi=ti);let Vi,ni,gi,wi,Gi,Wn,ii=!0,or=ce.bbox;if(or!=null){ii=!1;let $n=or(i,We);gi=$n.left,wi=$n.top,Vi=$n.width,ni=$n.height}else gi=mi,wi=Mi,Vi=ni=ce.size(i,We);if(Wn=ce.fill(i,We),Gi=ce.stroke(i,We),Ce)We==Ps&&is<=Fe.prox&&(De=gi,Oe=wi,it=Vi,Mt=ni,bt=ii,mt=Wn,Ze=Gi);else{let $n=ot[We];$n!=null&&(zt[We]=gi,Vn[We]=wi,g0($n,Vi,ni,ii),p0($n,Wn,Gi),Ji($n,bi(gi),bi(wi),z,Re))}}}}if(Ce){let We=Fe.prox,Ht=sr==null?is<=We:is>We||Ps!=sr;if(me||Ht){let en=ot[0];en!=null&&(zt[0]=De,Vn[0]=Oe,g0(en,it,Mt,bt),p0(en,mt,Ze),Ji(en,bi(De),bi(Oe),z,Re))}}}if(Gt.show&&Cs)if(w!=null){let[pe,ve]=fn.scales,[Ne,De]=fn.match,[Oe,it]=w.cursor.sync.scales,Mt=w.cursor.drag;if(An=Mt._x,En=Mt._y,An||En){let{left:bt,top:mt,width:Ze,height:We}=w.select,Ht=w.scales[Oe].ori,en=w.posToVal,Cn,Nt,tn,ti,Hn,mi=pe!=null&&Ne(pe,Oe),Mi=ve!=null&&De(ve,it);mi&&An?(Ht==0?(Cn=bt,Nt=Ze):(Cn=mt,Nt=We),tn=v[pe],ti=k(en(Cn,Oe),tn,J,0),Hn=k(en(Cn+Nt,Oe),tn,J,0),Ho(Ui(ti,Hn),Mn(Hn-ti))):Ho(0,J),Mi&&En?(Ht==1?(Cn=bt,Nt=Ze):(Cn=mt,Nt=We),tn=v[ve],ti=N(en(Cn,it),tn,le,0),Hn=N(en(Cn+Nt,it),tn,le,0),Wo(Ui(ti,Hn),Mn(Hn-ti))):Wo(0,le)}else eh()}else{let pe=Mn(qf-$f),ve=Mn(Yf-Xf);if(I.ori==1){let it=pe;pe=ve,ve=it}An=In.x&&pe>=In.dist,En=In.y&&ve>=In.dist;let Ne=In.uni;Ne!=null?An&&En&&(An=pe>=Ne,En=ve>=Ne,!An&&!En&&(ve>pe?En=!0:An=!0)):In.x&&In.y&&(An||En)&&(An=En=!0);let De,Oe;An&&(I.ori==0?(De=Ur,Oe=Vt):(De=Or,Oe=Yt),Ho(Ui(De,Oe),Mn(Oe-De)),En||Wo(0,le)),En&&(I.ori==1?(De=Ur,Oe=Vt):(De=Or,Oe=Yt),Wo(Ui(De,Oe),Mn(Oe-De)),An||Ho(0,J)),!An&&!En&&(Ho(0,0),Wo(0,0))}if(In._x=An,In._y=En,w==null){if(U){if(ap!=null){let[pe,ve]=fn.scales;fn.values[0]=pe!=null?zi(I.ori==0?Vt:Yt,pe):null,fn.values[1]=ve!=null?zi(I.ori==1?Vt:Yt,ve):null}Xo(Hd,i,Vt,Yt,z,Re,F)}if(Je){let pe=U&&fn.setSeries,ve=Fe.prox;sr==null?is<=ve&&Bi(Ps,kr,!0,pe):is>ve?Bi(null,kr,!0,pe):Ps!=sr&&Bi(Ps,kr,!0,pe)}}me&&(fe.idx=F,Ju()),C!==!1&&Tn("setCursor")}let Is=null;Object.defineProperty(i,"rect",{get(){return Is==null&&$o(!1),Is}});function $o(w=!1){w?Is=null:(Is=p.getBoundingClientRect(),Tn("syncRect",Is))}function Jf(w,C,U,F,$,J,le){de._lock||Cs&&w!=null&&w.movementX==0&&w.movementY==0||(ju(w,C,U,F,$,J,le,!1,w!=null),w!=null?rr(null,!0,!0):rr(C,!0,!1))}function ju(w,C,U,F,$,J,le,pe,ve){if(Is==null&&$o(!1),Ke(w),w!=null)U=w.clientX-Is.left,F=w.clientY-Is.top;else{if(U<0||F<0){Vt=-10,Yt=-10;return}let[Ne,De]=fn.scales,Oe=C.cursor.sync,[it,Mt]=Oe.values,[bt,mt]=Oe.scales,[Ze,We]=fn.match,Ht=C.axes[0].side%2==1,en=I.ori==0?z:Re,Cn=I.ori==1?z:Re,Nt=Ht?J:$,tn=Ht?$:J,ti=Ht?F:U,Hn=Ht?U:F;if(bt!=null?U=Ze(Ne,bt)?a(it,v[Ne],en,0):-10:U=en*(ti/Nt),mt!=null?F=We(De,mt)?a(Mt,v[De],Cn,0):-10:F=Cn*(Hn/tn),I.ori==1){let mi=U;U=F,F=mi}}ve&&(C==null||C.cursor.event.type==Hd)&&((U<=1||U>=z-1)&&(U=Mr(U,z)),(F<=1||F>=Re-1)&&(F=Mr(F,Re))),pe?($f=U,Xf=F,[Ur,Or]=de.move(i,U,F)):(Vt=U,Yt=F)}let Qu={width:0,height:0,left:0,top:0};function eh(){tl(Qu,!1)}let jf,Qf,ep,tp;function np(w,C,U,F,$,J,le){Cs=!0,An=En=In._x=In._y=!1,ju(w,C,U,F,$,J,le,!0,!1),w!=null&&(yt(Wd,Zd,ip,!1),Xo(a0,i,Ur,Or,z,Re,null));let{left:pe,top:ve,width:Ne,height:De}=Gt;jf=pe,Qf=ve,ep=Ne,tp=De}function ip(w,C,U,F,$,J,le){Cs=In._x=In._y=!1,ju(w,C,U,F,$,J,le,!1,!0);let{left:pe,top:ve,width:Ne,height:De}=Gt,Oe=Ne>0||De>0,it=jf!=pe||Qf!=ve||ep!=Ne||tp!=De;if(Oe&&it&&tl(Gt),In.setScale&&Oe&&it){let Mt=pe,bt=Ne,mt=ve,Ze=De;if(I.ori==1&&(Mt=ve,bt=De,mt=pe,Ze=Ne),An&&Rs(A,zi(Mt,A),zi(Mt+bt,A)),En)for(let We in v){let Ht=v[We];We!=A&&Ht.from==null&&Ht.min!=Ut&&Rs(We,zi(mt+Ze,We),zi(mt,We))}eh()}else de.lock&&(de._lock=!de._lock,rr(C,!0,w!=null));w!=null&&(gn(Wd,Zd),Xo(Wd,i,Vt,Yt,z,Re,null))}function _y(w,C,U,F,$,J,le){if(de._lock)return;Ke(w);let pe=Cs;if(Cs){let ve=!0,Ne=!0,De=10,Oe,it;I.ori==0?(Oe=An,it=En):(Oe=En,it=An),Oe&&it&&(ve=Vt<=De||Vt>=z-De,Ne=Yt<=De||Yt>=Re-De),Oe&&ve&&(Vt=Vt<Ur?0:z),it&&Ne&&(Yt=Yt<Or?0:Re),rr(null,!0,!0),Cs=!1}Vt=-10,Yt=-10,ie.fill(null),rr(null,!0,!0),pe&&(Cs=pe)}function sp(w,C,U,F,$,J,le){de._lock||(Ke(w),Go(),eh(),w!=null&&Xo(u0,i,Vt,Yt,z,Re,null))}function rp(){M.forEach(kT),B(i.width,i.height,!0)}Er(bu,Co,rp);let Br={};Br.mousedown=np,Br.mousemove=Jf,Br.mouseup=ip,Br.dblclick=sp,Br.setSeries=(w,C,U,F)=>{let $=fn.match[2];U=$(i,C,U),U!=-1&&Bi(U,F,!0,!1)},he&&(yt(a0,p,np),yt(Hd,p,Jf),yt(l0,p,w=>{Ke(w),$o(!1)}),yt(c0,p,_y),yt(u0,p,sp),sf.add(i),i.syncRect=$o);let nl=i.hooks=n.hooks||{};function Tn(w,C,U){Gn?Pt.push([w,C,U]):w in nl&&nl[w].forEach(F=>{F.call(null,i,C,U)})}(n.plugins||[]).forEach(w=>{for(let C in w.hooks)nl[C]=(nl[C]||[]).concat(w.hooks[C])});let op=(w,C,U)=>U,fn=mn({key:null,setSeries:!1,filters:{pub:b0,sub:b0},scales:[A,_[1]?_[1].scale:null],match:[S0,S0,op],values:[null,null]},de.sync);fn.match.length==2&&fn.match.push(op),de.sync=fn;let ap=fn.key,th=_x(ap);function Xo(w,C,U,F,$,J,le){fn.filters.pub(w,C,U,F,$,J,le)&&th.pub(w,C,U,F,$,J,le)}th.sub(i);function yy(w,C,U,F,$,J,le){fn.filters.sub(w,C,U,F,$,J,le)&&Br[w](null,C,U,F,$,J,le)}i.pub=yy;function vy(){th.unsub(i),sf.delete(i),wn.clear(),jd(bu,Co,rp),c.remove(),Se?.remove(),Tn("destroy")}i.destroy=vy;function nh(){Tn("init",n,e),Vo(e||n.data,!1),V[A]?Yu(A,V[A]):Go(),se=Gt.show&&(Gt.width>0||Gt.height>0),te=me=!0,B(n.width,n.height)}return _.forEach(Rr),M.forEach(Qi),t?t instanceof HTMLElement?(t.appendChild(c),nh()):t(i,nh):nh(),i}an.assign=mn;an.fmtNum=hf;an.rangeNum=Su;an.rangeLog=Au;an.rangeAsinh=cf;an.orient=Cr;an.pxRatio=At;an.join=RE;an.fmtDate=ff,an.tzDate=zE;an.sync=_x;{an.addGap=ST,an.clipGaps=Cu;let n=an.paths={points:wx};n.linear=Ex,n.stepped=AT,n.bars=ET,n.spline=CT}var Lu=210,BT=64,zT=[.01,.02,.05,.1,.2,.5,1,2,5,10,15,30,45,90,180,360,...JT(3,20)];function nr(n,e,t,i){let s=e.map(o=>VT(o,t)),r=e.map((o,a)=>{let l=o.sharing?s.filter((c,u)=>e[u].sharing===o.sharing).flat():null;return HT(o,s[a].map(c=>c.values),l,t,i)});n.replaceChildren(...r.map(o=>o.element)),n.classList.add("plots");for(let o of r)o.start();return{charts:r.map(o=>o.chart),dispose:()=>r.forEach(o=>o.dispose())}}function VT(n,e){return n.lines.map(t=>({clip:t.clip,values:t.readings?e[t.clip].line(t.readings,t.part):$t(t.values,Float32Array)}))}function GT(n,e,t){let i=[0,0];for(let{clip:s,values:r}of n){let o=e[s].time;for(let a=0;a<o.length;a++){let l=o[a]-t.origins[s];l<t.start||l>t.end||(r[a]<i[0]&&(i[0]=r[a]),r[a]>i[1]&&(i[1]=r[a]))}}return i}function vf(n){let[e,...t]=n.lines.map(i=>i.clip);return t.every(i=>i===e)?e??null:null}function HT(n,e,t,i,s){let{element:r,key:o,place:a}=bf(n,n.owner),l=b("div",{className:"cursor"}),c=n.ball===void 0?null:b("div",{className:"ball"}),u=null,h=null,d=!1,f=[],p=new ResizeObserver(()=>u?.setSize({width:a.clientWidth,height:Lu}));function m(){let{word:v}=n,E=n.lines.map((A,y)=>b("li",{},ar(ys(y)),v?A.name.slice(v.length+1):A.name));o.replaceChildren(...v?[b("li",{},v)]:[],...E)}function g(){(s.span!==h||s.stretched!==d)&&(h=s.span,d=s.stretched,u.setData(Px(n,e,i,h),!1),u.setScale("x",{min:h.start,max:h.end}));let v=u.valToPos(s.time,"x").toFixed(2);l.style.transform=`translateX(${v}px)`,c&&(c.style.transform=`translate(${v}px, ${u.valToPos(x(),"y").toFixed(2)}px)`)}function x(){let{clip:v}=n.lines[n.ball];return za(i[v].time,e[n.ball],s.clipTime(v))}function _(){h=s.span,d=s.stretched,u=new an(WT(n,t,i,s,a.clientWidth),Px(n,e,i,h),a),u.setScale("x",{min:h.start,max:h.end}),u.over.append(l,...c?[c]:[]),KT(u,s),p.observe(a),u.hooks.setSize=[g];let v=()=>{m(),u.redraw(!1)};f=[s.onChange(g),Ys(v)],m()}function M(){for(let v of f)v();p.disconnect(),u.destroy()}return{element:r,start:_,dispose:M,get chart(){return u}}}function bf(n,e=null){let t=e?`${kt(e)}. ${n.text}`:n.text,i=b("div",{className:"chart",role:"img","aria-label":t}),s=b("ul",{className:"key"}),r=b("h2",{},`${kt(n.title)} (${n.unit})`);return e&&r.append(b("small",{},e)),{element:b("figure",{},r,s,i,b("figcaption",{},n.text)),key:s,place:i}}function Px(n,e,t,i){let s=n.lines.map((r,o)=>[Float64Array.from(t[r.clip].time,a=>a-i.origins[r.clip]),e[o]]);return vf(n)!==null?[s[0]?.[0]??[],...s.map(r=>r[1])]:an.join(s)}function WT(n,e,t,i,s){let r=Nu(),o=(a,l,c)=>qT(n,...e?GT(e,t,i.span):[l,c]);return{width:s,height:Lu,legend:{show:!1},cursor:{show:!1},padding:[8,10,0,0],scales:{x:{time:!1,auto:!1,distr:100,fwd:i.shareAt,bwd:i.momentAt},y:{range:o}},series:[{},...Sf(n.lines)],axes:[{...r,...Mf,labelFont:r.font,label:()=>`${i.span.label} (${qo(i.span).unit})${i.stretched?", stretched":""}`,filter:(a,l)=>l,splits:(a,l,c,u,h)=>i.stretched?$T(a,i):XT(c,u,h),values:(a,l)=>l.map(c=>c===null?"":Ix(c*qo(i.span).factor)),space:56},wf(n)],hooks:{drawClear:[a=>YT(a,t,vf(n),i.span)],draw:[a=>ZT(a,t,vf(n),i.span)]}}}function $T(n,e){let t=Math.max(2,Math.floor(n.bbox.width/devicePixelRatio/BT)),{factor:i}=qo(e.span),s=new Set;for(let r=0;r<=t;r++){let o=e.momentAt(r/t),a=[1,2,3,4,5,6].map(c=>Number((i*o).toPrecision(c))/i),l=c=>Math.abs(e.shareAt(c)-r/t)<.2/t;s.add(a.find(l)??a[a.length-1])}return[...s].filter(r=>r>=e.span.start&&r<=e.span.end)}function XT(n,e,t){let i=Math.ceil(n/t-1e-9);return Array.from({length:Math.floor(e/t+1e-9)-i+1},(s,r)=>(i+r)*t)}function Sf(n){return n.map((e,t)=>({stroke:()=>ys(t).colour,dash:ys(t).dash,width:1.6,points:{show:!1},spanGaps:!0}))}var Mf={size:24,gap:3,labelSize:18,labelGap:0};function Nu(){return{stroke:()=>Bt("--muted"),grid:{stroke:()=>Bt("--grid"),width:1},ticks:{stroke:()=>Bt("--grid"),width:1,size:4},font:"12px system-ui, sans-serif"}}function wf(n){return{...Nu(),size:(e,t)=>Math.max(48,16+7*Math.max(0,...(t??[]).map(i=>i.length))),gap:3,values:(e,t)=>t.map(i=>i===null?"":Ix(i)),...n.unit==="deg"?{incrs:zT,space:26}:{space:30}}}function qT(n,e,t){let[i,s]=[Math.min(0,e??0),Math.max(0,t??0)],r=.06*(s-i||1);return[n.unit==="deg"||i<0?i-r:i,s+2*r]}function Ix(n){let e=Math.abs(n)<1e-12?"0":String(Number(n.toPrecision(6)));return e.length>7?vt(n):e.replace("-","−")}function YT(n,e,t,i){if(t===null)return;let{ctx:s,bbox:r}=n;s.save(),s.fillStyle=Bt("--band");for(let o of e[t].stages.filter(a=>a.driven)){let[a,l]=[o.start,o.end].map(u=>n.valToPos(u-i.origins[t],"x",!0)),c=Math.max(a,r.left);s.fillRect(c,r.top,Math.max(0,Math.min(l,r.left+r.width)-c),r.height)}s.restore()}function ZT(n,e,t,i){if(t===null)return;let{ctx:s,bbox:r}=n,o=devicePixelRatio;s.save(),s.strokeStyle=Bt("--muted"),s.font=`bold ${12*o}px system-ui, sans-serif`,s.setLineDash([2*o,3*o]);for(let a of e[t].marks){let l=n.valToPos(a.time-i.origins[t],"x",!0);if(l<r.left-1||l>r.left+r.width+1)continue;s.beginPath(),s.moveTo(l,r.top),s.lineTo(l,r.top+r.height),s.stroke();let c=l>r.left+r.width-16*o?-1:1;s.fillStyle=Bt("--page"),s.fillRect(l+(c>0?2:-14)*o,r.top+1*o,12*o,15*o),s.fillStyle=Bt("--ink"),s.textAlign="center",s.fillText(a.letter,l+c*8*o,r.top+13*o)}s.restore()}function KT(n,e){Af(n,t=>{e.pause(),e.seek(n.posToVal(t.clientX-n.over.getBoundingClientRect().left,"x"))})}function Af(n,e){n.over.addEventListener("pointerdown",t=>{t.button===0&&(n.over.setPointerCapture(t.pointerId),e(t))}),n.over.addEventListener("pointermove",t=>{n.over.hasPointerCapture(t.pointerId)&&e(t)})}function JT(n,e){return Array.from({length:e-n},(t,i)=>[1,2,5].map(s=>s*10**(n+i))).flat()}function Du(n,e){if(matchMedia("(prefers-reduced-motion: reduce)").matches)return;let t=new IntersectionObserver(i=>{i.some(s=>s.isIntersecting)&&(t.disconnect(),e.play())},{threshold:.3});t.observe(n.querySelector(".picture")??n),n.addEventListener("pointerdown",()=>t.disconnect(),{once:!0})}function Lx(n){let e=n.clips.map(Zn),t=Li(e,n.spans),i=js(document.getElementById("player"),e,t,n);i.stage&&Ef(i.stage.cells,e,t,n.energy);let s=nr(document.getElementById("plots"),n.plots,e,t);return Du(document.getElementById("player"),t),{clips:e,clock:t,player:i,plots:s}}function Ef(n,e,t,i){let s=e.map((r,o)=>{let a=b("span",{className:"state-now"}),l=b("b",{},ar(ys(o)),r.name);return Ys(()=>l.replaceChild(ar(ys(o)),l.firstChild)),n[o].append(l,a),a});t.onChange(()=>{for(let[r,o]of e.entries()){let a=t.clipTime(r),c=[t.time+t.span.origins[r]>o.end?"ended":o.stageAt(a).name],[u]=o.readings;u&&c.push(jT(o.valuesAt(u.name,a),u.unit));let h=o.valuesAt(bs,a).reduce((d,f)=>d+f,0);o.tendons&&c.push(`${vt(i.factor*h)} ${i.unit}`),s[r].textContent=c.join(" · ")}})}function jT(n,e){let t=s=>e==="deg"?`${Ln(s,0)}°`:`${vt(s)} ${e}`,i=[Math.min(...n),Math.max(...n)].map(t);return i[0]===i[1]?i[0]:i.join(" to ")}function Tf(n){return n.energy?So:fg}function Nx(n,e){let t=n.at(e).map(s=>Math.round(255*s)),i=.299*t[0]+.587*t[1]+.114*t[2]>118;return{face:`rgb(${t.join(" ")})`,ink:i?"#000":"#fff"}}function Oo({sign:n,pattern:e}){return b("span",{className:`what ${e}`,"aria-hidden":"true"},b("span",{},n))}function Uu(n,e){let t=n.scaleOf(e);if(!t)return[];let i=b("span",{className:"bar","aria-hidden":"true"});return i.style.background=Tf(e).gradient,[b("p",{className:"scale"},`${e.title} (${e.unit})`,b("span",{},t.text(t.low)),i,b("span",{},t.text(t.high)))]}function Ou(n,e){let{factors:t,quantities:i,words:s}=n,r=t.map(h=>h.values.length),o=new Map;for(let h of e)o.set(h.point,[...o.get(h.point)??[],h]);function a(h){if(n.sampled)return t.map(()=>h);let d=[];for(let f=r.length-1;f>=0;f--)d[f]=h%r[f],h=Math.floor(h/r[f]);return d}let l=h=>h.reduce((d,f,p)=>d*r[p]+f,0);function c(h){let f=(h.shares?i.filter(_=>_.group===h.group):[h]).flatMap(_=>_.values??[]).filter(_=>_!==null);if(!f.length)return null;let[p,m]=[f.reduce((_,M)=>Math.min(_,M)),f.reduce((_,M)=>Math.max(_,M))],g=_=>m>p?(_-p)/(m-p):.5,x=QT((h.values??[]).filter(_=>_!==null));return{low:p,high:m,colour:_=>Nx(Tf(h),g(_)),text:_=>ji(Number(_.toFixed(x)))}}let u=(h,d)=>`${h.name} ${h.texts[d]}${h.unit?` ${h.unit}`:""}`;return{study:n,sizes:r,numbers:i.filter(h=>h.values&&!h.tried),columns:t,shown:()=>!0,nameOf:()=>"",placesOf:a,pointAt:l,scaleOf:c,factorText:u,largestSpan:e.reduce((h,d)=>Math.max(h,d.play.clips[0].span_m),0),runsOf:h=>o.get(h)??[],word:h=>s[h],pointText:h=>a(h).map((d,f)=>u(t[f],d)).join(", "),valueText(h,d){let f=h.values?.[d]??null;return f===null?s[h.reasons[d]].word:`${ji(f)} ${h.unit}`}}}function QT(n){let e=n.reduce((t,i)=>Math.max(t,Math.abs(i)),0);return Math.min(20,Math.max(0,2-Math.floor(Math.log10(e||1))))}function ji(n){let e=Number(n.toPrecision(3));return(e!==0&&Math.abs(e)<.001?e.toExponential():String(e)).replaceAll("-","−")}var eC="http://www.w3.org/2000/svg";function It(n,e,...t){let i=document.createElementNS(eC,n);for(let[s,r]of Object.entries(e))i.setAttribute(s,r);return i.append(...t),i}function Fo({values:n,log:e},t=[]){let i=[...new Set(n.filter(d=>typeof d=="string"))];if(i.length)return{words:i,share:f=>(i.indexOf(f)+.5)/i.length,ticks:i,value:f=>i[Math.min(i.length-1,Math.max(0,Math.floor(f*i.length)))]};let s=[...n,...t].filter(d=>typeof d=="number"),r=e&&s.every(d=>d>0),[o,a]=r?[Math.log,Math.exp]:[d=>d,d=>d],l=s.reduce((d,f)=>Math.min(d,o(f)),1/0),c=s.reduce((d,f)=>Math.max(d,o(f)),-1/0),u=d=>c>l?(o(d)-l)/(c-l):.5,h=s.length?(r?tC:Dx)(a(l),a(c)):[];return{words:i,share:u,ticks:h,value:d=>a(l+d*(c-l))}}function Cf(n,e,t,i,s=[]){let r=e.unit?`${e.name} (${e.unit})`:e.name,o=Fo({values:n,log:e.log},s),a=.04*(i-t),l=u=>t+a+o.share(u)*(i-t-2*a),c=o.ticks.map(u=>[l(u),typeof u=="number"?ji(u):u]);return{label:r,from:t,to:i,ticks:c,at:l,place:u=>n[u]===null?t:l(n[u])}}function Dx(n,e){if(!(e>n))return[n];let t=(e-n)/5,i=10**Math.floor(Math.log10(t)),s=i*([1,2,5].find(o=>o*i>=t)??10),r=[];for(let o=Math.ceil(n/s)*s;o<=e+1e-9*s;o+=s)r.push(Number(o.toPrecision(12)));return r}function tC(n,e){if(!(e>n))return[n];let t=e/n>200?[1]:[1,2,5],i=[];for(let s=Math.floor(Math.log10(n));s<=Math.ceil(Math.log10(e));s++)for(let r of t){let o=Number((r*10**s).toPrecision(12));o>=n*(1-1e-9)&&o<=e*(1+1e-9)&&i.push(o)}return i.length>1?i:Dx(n,e)}function Ux(n,e,t){let i=[It("path",{class:"axis",d:`M${n.from} ${e.to}V${e.from}H${n.to}`})],s=(r,o)=>i.push(It("text",{class:"label",...o},r));for(let[r,o]of n.ticks)s(o,{x:r,y:e.from+18,"text-anchor":"middle"});for(let[r,o]of e.ticks)s(o,{x:n.from-8,y:r,dy:"0.35em","text-anchor":"end"});return s(n.label,{x:(n.from+n.to)/2,y:t-8,"text-anchor":"middle"}),s(e.label,{transform:`translate(14 ${(e.from+e.to)/2}) rotate(-90)`,"text-anchor":"middle"}),i}var Fu=300,Ox=30,nC=92,Bx=16,iC=5;function zx(n,e,{best:t,best_word:i,front:s},r){let a={axes:[...new Set(e.map(n.indexOf).filter(M=>M>=0))],opened:null,hovered:null,best:t,bestWord:i,front:s},l=b("div",{className:"titles"}),c=b("div",{className:"drawn"}),u=b("div",{className:"board"},l,c),h=b("div",{className:"scroll"},u),d=b("p",{className:"note",role:"status"}),f=b("p",{className:"note under"}," "),p=b("button",{type:"button"},`show all ${n.study.noun}s`);p.addEventListener("click",()=>{n.forget(),c.querySelector("[role=slider]")?.focus()});let m=()=>{oC(n,a,{board:u,titles:l,place:c,width:h.clientWidth}),ku(n,a,c)},x=b("section",{className:"lines"},b("h2",{},`All ${n.study.noun}s as lines`),b("p",{className:"note"},"Press a line to open its run. Move the two handles of an axis to select a range of values."),sC(n,a,m),h,rC(n,a),b("div",{className:"choices"},p,d),f);hC(n,a,c,f,r),n.whenAsked(()=>{ku(n,a,c),Vx(n,a,c),Fx(n,d,p)}),Fx(n,d,p);let _=0;return new ResizeObserver(()=>{h.clientWidth!==_&&(_=h.clientWidth,m())}).observe(h),{element:x,show(M){a.opened=M,ku(n,a,c)}}}function Fx(n,e,t){let{points:i,noun:s}=n.study,r=Array.from({length:i},(l,c)=>c).filter(n.shown),o=r.filter(n.good).length,a=n.study.words.find(l=>l.good)?.word;e.textContent=`${r.length} of ${i} ${s}s lie within the selected ranges${a?`; ${a}: ${o}`:""}.`,t.hidden=n.asked.size===0}function sC(n,e,t){let i=n.columns.map((s,r)=>{let o=b("input",{type:"checkbox",checked:e.axes.includes(r)});return o.addEventListener("change",()=>{e.axes=n.columns.map((a,l)=>l).filter(a=>a===r?o.checked:e.axes.includes(a)),o.checked||n.ask(r,0,1),t()}),b("label",{},o,s.name)});return b("details",{},b("summary",{},"Axes"),b("fieldset",{className:"filter"},b("legend",{},"Show an axis of"),...i))}function rC(n,e){let t=(r,o)=>b("li",{},b("span",{className:`line ${r}`,"aria-hidden":"true"}),o),i=n.study.words.find(r=>r.good),s=[];return i&&s.push(t("good",i.word)),n.study.words.some(r=>!r.good)&&s.push(t("behind",i?`other ${n.study.noun}s`:`all ${n.study.noun}s`)),e.front.length&&s.push(t("front","Pareto front")),e.best!==null&&s.push(t("best",e.bestWord)),s.push(t("opened","open")),n.columns.some(r=>r.limits.length)&&s.push(b("li",{},b("span",{className:"bound","aria-hidden":"true"}),"range allowed by a limit")),b("ul",{className:"keys-of-lines"},...s)}function oC(n,e,{board:t,titles:i,place:s,width:r}){let o=e.axes.length,a=Math.max(r,o*nC);t.style.width=`${a}px`,i.replaceChildren(...e.axes.map(c=>aC(n.columns[c]))),i.style.gridTemplateColumns=`repeat(${o}, 1fr)`,e.x=c=>(c+.5)*a/o,e.y=c=>Fu-Ox-c*(Fu-2*Ox);let l=It("svg",{width:a,height:Fu,viewBox:`0 0 ${a} ${Fu}`,role:"img","aria-label":`${n.study.points} ${n.study.noun}s as lines over ${o} axes; the table below has them all`});l.append(It("g",{class:"layers"}));for(let[c,u]of e.axes.entries())l.append(...lC(n.columns[u],e.x(c),e.y));s.replaceChildren(l),Vx(n,e,s)}function aC(n){let e=n.unit?` (${n.unit})`:"",t=n.aim?b("small",{},`${n.aim} is best`):"";return b("div",{},`${n.name}${e}`,t)}function lC({scale:n,limits:e},t,i){let s=[It("path",{class:"axis",d:`M${t} ${i(0)}V${i(1)}`})];for(let{kind:r,bound:o}of e){let a=Math.min(1,Math.max(0,n.share(o)));s.push(It("path",{class:"bound",d:`M${t} ${i(a)}V${i(r===">="?1:0)}`}))}for(let r of n.ticks){let o=i(n.share(r));s.push(It("path",{class:"axis",d:`M${t} ${o}h5`}),It("text",{class:"label",x:t+8,y:o,dy:"0.35em"},typeof r=="number"?ji(r):r))}return s}function Vx(n,e,t){let i=t.contains(document.activeElement)?document.activeElement.dataset.handle:null;for(let s of t.querySelectorAll("[role=slider]"))s.remove();for(let[s,r]of e.axes.entries())for(let o of["least","most"]){let a=cC(n,e,t,r,o);a.style.left=`${e.x(s)}px`,t.append(a),a.dataset.handle===i&&a.focus()}}function cC(n,e,t,i,s){let r=n.columns[i],[o,a]=n.asked.get(i)??[0,1],l=s==="least"?o:a,c=r.scale.value(l),u=typeof c=="number"?`${ji(c)} ${r.unit}`.trim():String(c??""),h=b("div",{role:"slider",className:`handle ${s}`,tabIndex:0,"aria-orientation":"vertical","aria-label":`${s} ${r.name}`,"aria-valuemin":"0","aria-valuemax":"100","aria-valuenow":String(Math.round(100*l)),"aria-valuetext":u,title:`${s} ${r.name}: ${u}`});h.dataset.handle=`${i} ${s}`,h.dataset.keys="own",h.style.top=`${e.y(l)}px`;let d=m=>{let[g,x]=n.asked.get(i)??[0,1];s==="least"?n.ask(i,Math.min(Math.max(m,0),x),x):n.ask(i,g,Math.max(Math.min(m,1),g))},f=r.scale.words.length?1/r.scale.words.length:.02,p={ArrowUp:f,ArrowRight:f,ArrowDown:-f,ArrowLeft:-f,PageUp:5*f,PageDown:-5*f};return h.addEventListener("keydown",m=>{if(!(m.ctrlKey||m.metaKey||m.altKey)){if(m.key in p)d(l+p[m.key]);else if(m.key==="Home")d(0);else if(m.key==="End")d(1);else return;m.preventDefault()}}),h.addEventListener("pointerdown",m=>{m.preventDefault(),h.focus(),Gx(m,g=>d(Rf(e,t,g)))}),h}function Gx(n,e,t=()=>{}){let i=o=>a=>a.pointerId===n.pointerId&&o(a),s=i(e),r=i(o=>{removeEventListener("pointermove",s),removeEventListener("pointerup",r),removeEventListener("pointercancel",r),t(o)});addEventListener("pointermove",s),addEventListener("pointerup",r),addEventListener("pointercancel",r)}function Rf(n,e,t){let i=t.clientY-e.getBoundingClientRect().top;return Math.min(1,Math.max(0,(n.y(0)-i)/(n.y(0)-n.y(1))))}function uC(n,e,t){let i="",s=!1;for(let[r,o]of e.axes.entries()){let a=n.columns[o].values[t];a!==null&&(i+=`${s?"L":"M"}${e.x(r).toFixed(1)} ${e.y(n.columns[o].scale.share(a)).toFixed(1)}`),s=a!==null}return i}function ku(n,e,t){let i=t.querySelector(".layers");if(!i)return;let s=Array.from({length:n.study.points},(u,h)=>h),[r,o]=[s.filter(n.shown),s.filter(u=>!n.shown(u))],a=u=>u===null?[]:[u],l={out:o,behind:r.filter(u=>!n.good(u)),good:r.filter(n.good),front:e.front.filter(n.shown),best:a(e.best),opened:a(e.opened),hovered:a(e.hovered)},c=Object.entries(l).filter(([,u])=>u.length);i.replaceChildren(...c.map(([u,h])=>It("path",{class:`line ${u}`,d:h.map(d=>uC(n,e,d)).join("")})))}function hC(n,e,t,i,s){let r=o=>{o!==e.hovered&&(e.hovered=o,t.classList.toggle("pressable",o!==null),i.textContent=o===null?" ":`${n.nameOf(o)}${n.pointText(o)}: ${n.study.statuses[o]}`,ku(n,e,t))};t.addEventListener("pointermove",o=>{o.pointerType==="mouse"&&o.buttons===0&&r(kx(n,e,t,o))}),t.addEventListener("pointerleave",()=>r(null)),t.addEventListener("pointerdown",o=>{if(o.button!==0||o.target.closest("[role=slider]"))return;let a=o.pointerType==="touch"?null:dC(e,t,o),l=Rf(e,t,o),c=!1;Gx(o,h=>{c||=Math.hypot(h.clientX-o.clientX,h.clientY-o.clientY)>iC;let d=Rf(e,t,h);c&&a!==null&&n.ask(a,Math.min(l,d),Math.max(l,d))},h=>{let d=c||h.type==="pointercancel"?null:kx(n,e,t,h);d!==null&&s(d)})})}function dC(n,e,t){let i=t.clientX-e.getBoundingClientRect().left,s=n.axes.findIndex((r,o)=>Math.abs(n.x(o)-i)<Bx);return s<0?null:n.axes[s]}function kx(n,e,t,i){let s=t.getBoundingClientRect(),[r,o]=[i.clientX-s.left,i.clientY-s.top],a=e.axes.findLastIndex((p,m)=>e.x(m)<=r),[l,c]=[Math.max(0,a),Math.min(e.axes.length-1,a+1)],u=c>l?(r-e.x(l))/(e.x(c)-e.x(l)):0,h=(p,m)=>{let g=n.columns[e.axes[p]],x=g.values[m];return x===null?NaN:e.y(g.scale.share(x))},[d,f]=[null,Bx];for(let p=0;p<n.study.points;p++){if(!n.shown(p))continue;let[m,g]=[h(l,p),h(c,p)],x=m+u*(g-m),_=c>l?(g-m)/(e.x(c)-e.x(l)):0,M=Math.abs(o-x)/Math.hypot(1,_)-(n.good(p)?1:0);M<f&&([d,f]=[p,M])}return d}function Hx(n,e){let t=Ou(n,e),i=n.factors.map(c=>({...c,limits:[],aim:""})),s=t.numbers.map(c=>({...c,key:c.name,name:c.title,log:!1,own:null})),r=[...i,...s].map(c=>({...c,scale:Fo(c,fC(c))})),o=new Map,a=[],l=([c,[u,h]],d)=>{let f=r[c].values[d];if(f===null)return!1;let p=r[c].scale.share(f);return p>=u-1e-9&&p<=h+1e-9};return{...t,columns:r,asked:o,indexOf:c=>r.findIndex(u=>u.key===c),shown:c=>[...o].every(u=>l(u,c)),good:c=>t.word(n.verdicts[c]).good,nameOf:c=>`${n.noun} ${c+1}: `,whenAsked:c=>a.push(c),ask(c,u,h){u<=0&&h>=1?o.delete(c):o.set(c,[u,h]);for(let d of a)d()},forget(){o.clear();for(let c of a)c()}}}function fC({limits:n,values:e}){let t=e.filter(r=>typeof r=="number"),[i,s]=[Math.min(...t),Math.max(...t)];return n.map(r=>r.bound).filter(r=>r>=i-(s-i)&&r<=s+(s-i))}var pC=12,[Pf,ws]=[200,76],ja=130;function $x(n,{marginals:e,pairs:t},i){let s=b("div",{className:"marginals"}),r=b("div",{className:"pairs"}),[o,a]=[e,t].map(h=>h.map(n.indexOf).filter(d=>d>=0)),l=()=>{s.replaceChildren(...o.map(h=>xC(n,h))),r.replaceChildren(..._C(n,a,i))};r.style.setProperty("--columns",Math.max(1,a.length-1)),n.whenAsked(l),l();let u=[b("h2",{},"Single unknowns"),b("p",{className:"note"},"Blue: samples that agree. Grey: all drawn samples. Each colour is scaled by its number of samples. Unknowns that the facts narrow most come first."),s];return a.length>1&&u.push(b("h2",{},"Pairs of unknowns"),b("p",{className:"note"},"Press a pair to enlarge it."),r),{element:b("section",{className:"agreeing"},...u)}}var mC=n=>Array.from({length:n.study.points},(e,t)=>t),Xx=n=>mC(n).filter(e=>!["placed","unbuilt"].includes(n.word(n.study.verdicts[e]).pattern));function gC(n,e,t){let i=e.words.length||pC,s=new Array(i).fill(0);for(let r of t)s[Math.min(i-1,Math.floor(e.share(n.values[r])*i))]+=1/t.length;return s}function xC(n,e){let t=n.columns[e],i=Fo(t),s=Xx(n),r=s.filter(g=>n.good(g)&&n.shown(g)),[o,a]=[s,r].map(g=>gC(t,i,g)),l=Math.max(...o,...r.length?a:[0]),c=Pf/o.length,u=(g,x)=>It("path",{class:x,d:g.map((_,M)=>`M${M*c+1} ${ws}v${-_/l*(ws-4)}h${c-2}V${ws}z`).join("")}),h=g=>It("path",{class:"agree",d:`M0 ${ws}${g.map((x,_)=>`V${ws-x/l*(ws-4)}H${(_+1)*c}`).join("")}V${ws}`}),d=`${t.name}: ${Wx(t,i,r)}`,f=It("svg",{viewBox:`0 0 ${Pf} ${ws}`,role:"img","aria-label":d,preserveAspectRatio:"none"},u(o,"all"),...r.length?[h(a)]:[],It("path",{class:"axis",d:`M0 ${ws}H${Pf}`})),p=i.words.length?i.words:[0,1].map(g=>ji(i.value(g))),m=t.unit?` (${t.unit})`:"";return b("figure",{},b("figcaption",{},`${t.name}${m}`),f,b("div",{className:"ends"},...p.map(g=>b("span",{},g))),b("small",{},Wx(t,i,r)))}function Wx(n,e,t){if(!t.length)return"no sample agrees";if(e.words.length)return e.words.map(r=>`${Math.round(100*t.filter(o=>n.values[o]===r).length/t.length)} % ${r}`).join(", ");let i=t.map(r=>n.values[r]).sort((r,o)=>r-o),s=r=>ji(i[Math.round(r*(i.length-1))]);return`middle half: ${s(.25)} to ${s(.75)}`}function _C(n,e,t){return e.slice(1).flatMap((i,s)=>e.slice(0,-1).map((r,o)=>o>s?b("span",{}):yC(n,r,i,t)))}function yC(n,e,t,i){let[s,r]=[e,t].map(f=>n.columns[f]),[o,a]=[s,r].map(f=>Fo(f)),l=(f,p)=>It("path",{class:p,d:f.map(m=>`M${(4+o.share(s.values[m])*(ja-8)).toFixed(1)} ${(ja-4-a.share(r.values[m])*(ja-8)).toFixed(1)}h0`).join("")}),c=Xx(n),u=c.filter(f=>n.good(f)&&n.shown(f)),h=It("svg",{viewBox:`0 0 ${ja} ${ja}`,"aria-hidden":"true"},l(c.filter(f=>!u.includes(f)),"all"),l(u,"agree")),d=b("button",{type:"button","aria-label":`${r.name} over ${s.name}, large`},h,b("small",{},`${r.name} ↑, ${s.name} →`));return d.addEventListener("click",()=>i(e,t)),d}var[qx,If]=[600,420],Bu={left:64,right:14,top:12,bottom:52},Yx=60,Zx={ArrowLeft:-1,ArrowUp:-1,ArrowRight:1,ArrowDown:1};function zu(n,e,t){let{columns:i,study:s}=n,{quantity:r}=e,o=Array.from({length:s.points},(x,_)=>_),a=n.scaleOf(r),l=Cf(i[e.x].values,i[e.x],Bu.left,qx-Bu.right,e.cells?.across),c=e.y===null?r.values??o.map(()=>0):i[e.y].values,u=e.y===null?{name:r.title,unit:r.unit}:i[e.y],h=Cf(c,u,If-Bu.bottom,Bu.top,e.cells?.upwards),d=`${r.title} of ${s.points} ${s.noun}s; arrows move between them, enter opens one`,f=It("svg",{viewBox:`0 0 ${qx} ${If}`,class:["scatter",o.length>Yx&&"many",e.ordered&&"judged"].filter(Boolean).join(" "),role:"listbox","aria-label":d});e.cells&&f.append(...SC(e.cells,l,h)),f.append(...Ux(l,h,If),...Jx(i[e.x],l,h,!0),...e.y===null?[]:Jx(i[e.y],h,l,!1));let p=o.map(x=>[l.place(x),h.place(x)]);e.joined&&f.append(MC(e.front,p,i[e.x].aim));let m=o.length>Yx?6:8,g=o.map(x=>bC(n,e,a,x,p[x],m));return f.append(...(e.ordered?vC(n,e,o):o).map(x=>g[x])),(g[e.current??0]??g[0])?.setAttribute("tabindex","0"),wC(f,g,e.ordered?[...o].sort((x,_)=>p[x][0]-p[_][0]):o,t),{element:b("div",{className:"scroll"},f),points:o}}function vC(n,e,t){let i=s=>(n.shown(s)?0:1e6)+(e.best===s?-1:n.study.verdicts[s]);return[...t].sort((s,r)=>i(r)-i(s))}function bC(n,e,t,i,[s,r],o){let{quantity:a}=e,l=a.values?.[i]??null,c=`${n.nameOf(i)}${n.pointText(i)}: ${n.valueText(a,i)}`,u=It("g",{role:"option",tabindex:"-1","aria-label":c,"aria-selected":String(e.opened===i),"data-point":i,transform:`translate(${s.toFixed(1)} ${r.toFixed(1)})`},It("title",{},c)),{sign:h,pattern:d}=l===null?n.word(a.reasons[i]):{};return h&&u.setAttribute("class",`what ${d}`),n.shown(i)||u.classList.add("out"),e.front?.includes(i)&&u.append(It("circle",{r:o+3,class:"front"})),u.append(It("circle",{r:o,class:l===null?"missing":"found",fill:l===null?"transparent":t.colour(l).face})),h&&u.append(It("text",{"text-anchor":"middle",dy:"0.36em"},h)),e.best===i&&u.append(It("text",{class:"best","text-anchor":"middle",dy:-o-6},e.bestWord)),u}function SC(n,e,t){let[i,s]=[Kx(n.across.map(e.at)),Kx(n.upwards.map(t.at))];return n.works.flatMap((r,o)=>r.map((a,l)=>It("rect",{class:a?"map-works":"map-fails",x:i[o],width:i[o+1]-i[o],y:s[l+1],height:s[l]-s[l+1]})))}function Kx(n){let e=n.slice(1).map((s,r)=>(s+n[r])/2),[t,i]=[n[0],n.at(-1)];return[t,...e,i]}function Jx(n,e,t,i){let s=(a,l)=>It("path",{class:l,d:i?`M${a} ${t.from}V${t.to}`:`M${t.from} ${a}H${t.to}`}),r=a=>a>=Math.min(e.from,e.to)&&a<=Math.max(e.from,e.to),o=[];typeof n.own=="number"&&r(e.at(n.own))&&o.push(s(e.at(n.own),"own"));for(let{kind:a,bound:l}of n.limits??[]){let c=e.at(l);if(!r(c))continue;let u=a===">="?e.from:e.to,[h,d]=[Math.min(c,u),Math.abs(c-u)],f=i?{x:h,width:d,y:t.to,height:t.from-t.to}:{y:h,height:d,x:t.from,width:t.to-t.from};o.push(It("rect",{class:"beyond",...f}),s(c,"limit"))}return o}function MC(n,e,t){let i=n.map(r=>e[r]).sort((r,o)=>r[0]-o[0]),s=([r,o])=>t==="least"?`H${r.toFixed(1)}V${o.toFixed(1)}`:`V${o.toFixed(1)}H${r.toFixed(1)}`;return It("path",{class:"front",d:i.map((r,o)=>o?s(r):`M${r.join(" ")}`).join("")})}function wC(n,e,t,i){let s=r=>r.target.closest("[data-point]");n.addEventListener("click",r=>{s(r)&&i(Number(s(r).dataset.point))}),n.addEventListener("focusin",r=>{for(let o of e)o.setAttribute("tabindex",o===r.target?"0":"-1")}),n.addEventListener("keydown",r=>{let o=s(r);if(!o||r.ctrlKey||r.metaKey||r.altKey)return;let a=Number(o.dataset.point);if(r.key==="Enter"||r.key===" ")i(a);else if(r.key in Zx)e[t[t.indexOf(a)+Zx[r.key]]]?.focus();else return;r.preventDefault()})}function jx(n,{plane:e,front:t,best:i,best_word:s,joined:r},o){let{quantities:a}=n.study,[l,c]=[e.x,e.y].map(n.indexOf),[u,h]=[l,c],d={quantity:a[0],x:l,y:c,current:i??0,opened:null,front:t,best:i,bestWord:s,ordered:!0},f=b("div",{className:"map-place"}),p=b("div",{className:"map-legend"}),m=()=>{let S=d.x===u&&d.y===h;d.cells=S?e.cells:void 0,d.joined=r&&new Set([d.x,d.y,u,h]).size===2;let P=zu(n,d,g);f.replaceChildren(P.element),p.replaceChildren(...AC(n,d))},g=S=>{x(S),o(S)};function x(S){d.current=d.opened=S;let P=f.contains(document.activeElement);m(),P&&f.querySelector(`[data-point="${S}"]`)?.focus()}let _=n.columns.map((S,P)=>[P,S.name]),M={across:v("across",_,()=>d.x,S=>A("x","y",S)),upwards:v("upwards",_,()=>d.y,S=>A("y","x",S)),show:v("show",a.map((S,P)=>[P,S.title]),()=>a.indexOf(d.quantity),S=>{d.quantity=a[S]})};function v(S,P,L,I){let O=b("select",{},...P.map(([N,V])=>b("option",{value:String(N)},V)));O.value=String(L()),O.addEventListener("change",()=>{I(Number(O.value)),E(),m()});let k=b("label",{},`${S} `,O);return k.dataset.name=S,{element:k,fill:()=>{O.value=String(L())}}}let E=()=>Object.values(M).forEach(S=>S.fill());function A(S,P,L){d[P]===L&&(d[P]=d[S]),d[S]=L}let y=b("section",{className:"map"},b("h2",{},e.title),b("div",{className:"choices"},...Object.values(M).map(S=>S.element)),f,p);return n.whenAsked(m),m(),{element:y,show:x,over(S,P){[d.x,d.y]=[S,P],E(),m()}}}function AC(n,{quantity:e,front:t,cells:i,x:s,y:r}){let o=Uu(n,e),a=e.values?e.reasons:n.study.verdicts,l=n.study.words.flatMap((u,h)=>{let d=a.filter((f,p)=>f===h&&n.shown(p)).length;return d?[b("li",{},Oo(u),`${u.word} (${d})`)]:[]});t.length&&l.push(b("li",{},b("span",{className:"ring","aria-hidden":"true"}),"Pareto front"));let c=[s,r].map(u=>n.columns[u]);if(c.some(u=>typeof u.own=="number")&&l.push(b("li",{},b("span",{className:"dashes","aria-hidden":"true"}),"as designed")),c.some(u=>u.limits.length)&&l.push(b("li",{},b("span",{className:"shade","aria-hidden":"true"}),"beyond a limit")),i)for(let u of["works","fails"])l.push(b("li",{},b("span",{className:`map-${u}`,"aria-hidden":"true"}),`${u} if only these two deviate`));return l.length&&o.push(b("ul",{},...l)),o}var EC=2e4,TC=16,CC=16,Qx={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]};function n_(n,e){let{quantities:t,sampled:i}=n.study,s=n.study.axes.filter(m=>n.sizes[m]>1),[r,o]=s.length>1?s:[null,s[0]??0],a={quantity:t[0],x:o,y:r,fixed:[...n.study.cuts],current:null,opened:null},l=b("div",{className:"map-place"}),c=b("div",{className:"map-legend"}),u=b("p",{className:"note"}),h=()=>{let m=i?zu(n,a,d):IC(n,a,d);l.replaceChildren(m.element),c.replaceChildren(...DC(n,a.quantity,m.points)),u.textContent=UC(n,a.quantity,m.points)},d=m=>{a.current=a.opened=m,RC(l,m),e(m,a.quantity)},f=PC(n,a,s,h),p=b("section",{className:"map"},b("h2",{},"Map"),f.element,l,c,u);return h(),{element:p,show(m){a.current=a.opened=m,i||(a.fixed=n.placesOf(m)),f.fill(),h()}}}function RC(n,e){for(let t of n.querySelectorAll("[data-point]")){let i=Number(t.dataset.point)===e;t.setAttribute("aria-selected",String(i)),t.tabIndex=i?0:-1}}function PC(n,e,t,i){let{factors:s,quantities:r,sampled:o}=n.study,a=b("div",{className:"choices"}),l=(h,d,f,p)=>{let m=b("select",{},...d.map(([g,x])=>b("option",{value:String(g)},x)));return m.value=String(f),m.addEventListener("change",()=>{p(Number(m.value)),u(),i(),[...a.querySelectorAll("label")].find(g=>g.dataset.name===h)?.querySelector("select").focus()}),b("label",{},`${h} `,m)},c=(h,d)=>f=>{e[d]===f&&(e[d]=e[h]),e[h]=f};function u(){let h=[l("show",r.map((d,f)=>[f,d.title]),r.indexOf(e.quantity),d=>{e.quantity=r[d]})];if(t.length>2){let d=t.map(f=>[f,s[f].name]);h.push(l("across",d,e.x,c("x","y")),l("upwards",d,e.y,c("y","x")))}for(let d of t.filter(f=>!o&&f!==e.x&&f!==e.y)){let f=s[d].texts.map((p,m)=>[m,s[d].unit?`${p} ${s[d].unit}`:p]);h.push(l(s[d].name,f,e.fixed[d],p=>{e.fixed[d]=p}))}for(let d of h)d.dataset.name=d.firstChild.textContent.trim();a.replaceChildren(...h)}return u(),{element:a,fill:u}}function IC(n,e,t){let{factors:i}=n.study,[s,r]=[n.sizes[e.x],e.y===null?1:n.sizes[e.y]];if(s*r>EC)return{element:b("p",{className:"note"},"This map has too many cells for a page; see the figures of the study."),points:[]};let o=n.scaleOf(e.quantity),a=s<=TC,l=(x,_)=>n.pointAt(e.fixed.map((M,v)=>v===e.x?x:v===e.y?_:M)),c=new Map,u=[],h=[];for(let x=r-1;x>=0;x--){let _=b("tr",{},b("th",{scope:"row"},e.y===null?"":t_(i[e.y],x)));for(let M=0;M<s;M++){let v=l(M,x),E=b("td",{tabIndex:-1,role:"gridcell"});LC(E,n,e,o,v,a),c.set(`${M} ${x}`,E),h.push(v),_.append(E)}u.push(_)}let d=i[e.x].texts.map((x,_)=>b("th",{scope:"col"},t_(i[e.x],_)));u.push(b("tr",{className:"feet"},b("td"),...d));let f=b("table",{role:"grid",className:a?"grid":"grid small","aria-label":FC(n,e)},b("tbody",{},...u));f.style.setProperty("--columns",s);let p=[...c.values()].find(x=>Number(x.dataset.point)===e.current)??c.get("0 0");p.tabIndex=0,NC(f,c,t);let m=b("div",{className:"upwards"},e.y===null?"":e_(i[e.y])),g=b("div",{className:"across"},e_(i[e.x]));return{element:b("div",{className:r<6?"axes low":"axes"},m,b("div",{},b("div",{className:"scroll"},f),g)),points:h}}function LC(n,e,t,i,s,r){let{quantity:o}=t,a=o.values?.[s]??null;n.dataset.point=s,n.setAttribute("aria-selected",String(t.opened===s));let l=`${e.pointText(s)}: ${o.values?`${o.title} `:""}${e.valueText(o,s)}`;if(n.setAttribute("aria-label",l),n.title=l,a===null){let{sign:h,pattern:d}=e.word(o.reasons[s]);n.className=`what ${d}`,n.append(b("span",{},r?h:""));return}let{face:c,ink:u}=i.colour(a);n.style.background=c,n.style.color=u,n.textContent=r?i.text(a):""}function NC(n,e,t){let i=new Map([...e].map(([s,r])=>[r,s.split(" ").map(Number)]));n.addEventListener("click",s=>{let r=s.target.closest("[data-point]");r&&t(Number(r.dataset.point))}),n.addEventListener("keydown",s=>{let r=s.target.closest("[data-point]");if(!r||s.ctrlKey||s.metaKey||s.altKey)return;let[o,a]=i.get(r),[l,c]=Qx[s.key]??[0,0],u=Math.max(...[...i.values()].map(([d])=>d)),h={Home:`0 ${a}`,End:`${u} ${a}`}[s.key]??`${o+l} ${a+c}`;if(s.key==="Enter"||s.key===" ")t(Number(r.dataset.point));else{if(!(s.key in Qx)&&s.key!=="Home"&&s.key!=="End")return;e.has(h)&&(r.tabIndex=-1,e.get(h).tabIndex=0,e.get(h).focus())}s.preventDefault()})}function DC(n,e,t){let i=Uu(n,e),s=[...i_(e,t)].map(([r,o])=>{let a=n.word(r);return b("li",{},Oo(a),`${a.word} (${o})`)});return s.length&&i.push(b("ul",{},...s)),i}function i_(n,e){let t=new Map;for(let i of e){let s=n.reasons[i];s!==null&&t.set(s,(t.get(s)??0)+1)}return new Map([...t].sort(([i],[s])=>i-s))}function UC(n,e,t){let i=t.filter(c=>(e.values?.[c]??null)!==null),s=[...i_(e,t)].map(([c,u])=>`${u} ${n.word(c).word}`),r=`${e.title[0].toUpperCase()}${e.title.slice(1)}`;if(!i.length)return`${r} of ${t.length} points: ${s.join(", ")||"none"}.`;let o=s.length?` Other points: ${s.join(", ")}.`:"",[a,l]=[Math.min,Math.max].map(c=>OC(n,e,i,c));return`${r}, known for ${i.length} of ${t.length} points: from ${a} to ${l}.${o}`}function OC(n,e,t,i){let s=t.map(a=>e.values[a]).reduce((a,l)=>i(a,l)),r=t.filter(a=>e.values[a]===s),o=r.length>1?`${r.length} points`:n.pointText(r[0]);return`${n.valueText(e,r[0])} (${o})`}function FC(n,e){let{factors:t}=n.study,i=e.y===null?t[e.x].name:`${t[e.x].name} across and ${t[e.y].name} upwards`;return`${e.quantity.title} over ${i}; arrows move between cells, enter opens one`}function e_(n){return n.unit?`${n.name} (${n.unit})`:n.name}function t_(n,e){let t=Math.ceil(n.texts.length/CC);return e%t?"":n.texts[e]}var s_=2,kC=20;function a_(n){let e=document.getElementById("live")?.textContent??null,t=e&&JSON.parse(e),i=b("div",{className:"answer"}),s=b("p",{className:"outcome",role:"status"}),r=b("div"),o=b("div"),a=null,l=!1,c=0,u=Promise.resolve(),h=0;function d(_,M){if(h+=1,c=_,!t)return[];if(!su())return M?[]:[b("p",{className:"note"},`It cannot be simulated here either: ${t.refused}.`)];if(a)m(_);else if(!l){let v=b("button",{type:"button",className:"try"},M?"Try it and refine here":"Simulate it here"),E=b("p",{className:"note"});v.addEventListener("click",()=>f(v,E)),o.replaceChildren(b("div",{className:"offer"},v,E))}return[o]}async function f(_,M){l=_.disabled=!0,M.textContent="Starting the simulator …";try{a=await Ao(Zn(t.bench.clips[0]),t.bench,e,Mo),o.replaceChildren(i),i.replaceChildren(a.element),a.begin(),m(c)}catch(v){M.textContent=`It cannot be simulated here: ${v.message}.`}}async function p(_,M){if(await u.catch(()=>null),M!==h)return null;u=a.engine.ask({act:"answer",values:_,search:t.search});let{answer:v}=await u;return M===h?v:null}async function m(_){let M=++h,v=b("button",{type:"button"},"Refine here");v.addEventListener("click",()=>x(_)),r.replaceChildren(),i.replaceChildren(s,...l_(n,t).length?[v]:[],r,a.element),s.textContent="Simulating …",a.sliders.set(t.points[_]);let E=await p(t.points[_],M);E&&(s.textContent=`${kt(n.pointText(_))}: ${o_(t,E)}.`,g(_))}function g(_){a.sliders.set(t.points[_]),a.engine.send({act:"restart",through:!1})}async function x(_){let M=++h,v=zC(n,t,_),E=new Map,A=b("p",{className:"note",role:"status"}),y=v[1].values.map(O=>v[0].values.map(k=>BC(v,k,O))).reverse(),S=y.map((O,k)=>b("tr",{},b("th",{scope:"row"},r_(v[1],v[1].values.length-1-k)),...O.map(({cell:N})=>N))),P=b("tr",{className:"feet"},b("td"),...v[0].values.map((O,k)=>b("th",{scope:"col"},r_(v[0],k)))),L=b("table",{className:"grid"},b("caption",{},GC(v,n.study.sampled)),b("tbody",{},...S,P));r.replaceChildren(b("div",{className:"table",tabIndex:0,role:"group","aria-label":"finer map"},L),A);let I=y.flat();for(let[O,{cell:k,values:N,where:V}]of I.entries()){A.textContent=`${O} of ${I.length} points simulated`;let X=await p({...t.points[_],...N},M);if(!X)return;let{sign:G,pattern:oe}=n.study.words.find(({word:Z})=>Z===X.word)??n.study.other;k.className=`what ${oe}`,k.replaceChildren(b("span",{},G)),k.title=`${V}: ${o_(t,X)}`,k.setAttribute("aria-label",k.title),E.set(X.word,G)}A.textContent=[...E].map(([O,k])=>`${k} ${O}`).join(" · "),g(_)}return{offer:d,get panel(){return a}}}function BC(n,e,t){let i={[n[0].key]:e};n[1].key&&(i[n[1].key]=t);let s=n.filter(({key:r})=>r).map(r=>`${r.name} ${vt(r.factor*i[r.key])} ${r.unit}`).join(", ");return{cell:b("td",{"aria-label":`${s}: not simulated yet`}),values:i,where:s}}function l_(n,e){let t=i=>e.knobs.some(({key:s})=>s===n.study.factors[i].key);return n.study.axes.filter(i=>n.sizes[i]>1&&t(i))}function zC(n,e,t){let i=l_(n,e),[s,r]=i.length>1?i:[null,i[0]??0],o=a=>{if(a===null)return{key:"",name:"",unit:"",factor:1,values:[0]};let{key:l,name:c}=n.study.factors[a],u=e.knobs.find(g=>g.key===l);if(n.study.sampled)return{key:l,name:c,unit:u.unit,factor:u.factor,values:VC(e.points.map(g=>g[l]),t)};let h=n.placesOf(t),d=g=>e.points[n.pointAt(h.map((x,_)=>_===a?g:x))][l],[f,p]=[Math.max(0,h[a]-1),Math.min(n.sizes[a]-1,h[a]+1)],m=[];for(let g=f;g<p;g++)for(let x=0;x<s_;x++)m.push(d(g)+x/s_*(d(g+1)-d(g)));return{key:l,name:c,unit:u.unit,factor:u.factor,values:[...m,d(p)]}};return[o(r),o(s)]}function VC(n,e){let[t,i]=[Math.min(...n),Math.max(...n)],s=[-2,-1,0,1,2].map(r=>n[e]+r*(i-t)/kC);return[...new Set(s.map(r=>Math.min(i,Math.max(t,r))))].sort((r,o)=>r-o)}var r_=({key:n,factor:e,unit:t,values:i},s)=>n?`${vt(e*i[s])} ${t}`:"";function GC([n,e],t){return`${e.key?`${kt(n.name)} across, ${e.name} upwards`:kt(n.name)}, ${t?"around it":"at half the steps"}`}function o_(n,{status:e,least:t}){let s=(n.search?[n.search.first,n.search.second].filter(Boolean):[]).filter(({name:r})=>t[r]!==null&&t[r]!==void 0).map(({key:r,name:o,title:a})=>{let{factor:l,unit:c}=n.knobs.find(u=>u.key===r);return`${a} ${vt(l*t[o])} ${c}`});return[e,...s].join("; ")}function Vu(n){let e=b("h2"),t=b("p",{className:"outcome",role:"status"}),i=b("table",{className:"numbers"}),s=b("section",{className:"facts",id:"point"},e,t,b("div",{className:"table"},i)),r=b("div",{className:"parts",role:"group","aria-label":`runs of this ${n.study.noun}`}),o=b("div"),a=b("div",{className:"more"}),l=b("section",{className:"run",id:"run","aria-label":"the run that is open"},r,o,a),c=a_(n),u={facts:s,element:l,point:null,playing:null,answers:c,open:f,show:g},h=null,d=Ks();function f(_,{play:M=!1,transition:v=null}={}){u.point=_;let E=n.runsOf(_);e.textContent=kt(`${n.study.noun} ${_+1}`),t.textContent=`${kt(n.pointText(_))}: ${n.study.statuses[_]}.`,i.replaceChildren(b("caption",{},"Values in the table"),b("tbody",{},...qC(n,_))),r.replaceChildren(...E.length>1?E.map(p):E.map(S=>b("b",{},kt(S.title))));let A=v===null?null:E.find(S=>S.transition===v),y=M?E.find(S=>S.failed):null;E.length?g(A??y??E[0],{play:M}):(m(),o.replaceChildren(b("p",{className:"note"},YC(n,_)))),a.replaceChildren(...n.study.built[_]?c.offer(_,E.length>0):[])}function p(_){let M=b("button",{type:"button"},_.title);return M.dataset.part=_.part,M.addEventListener("click",()=>g(_,{play:!0})),M}function m(){u.playing?.dispose(),u.playing=null}function g(_,{play:M=!1}={}){m();for(let L of r.querySelectorAll("button"))L.setAttribute("aria-pressed",String(L.dataset.part===_.part));let v=h&&h!==_?h:null,E=v?[v,_]:[_],A={player:b("div"),plots:b("div"),readouts:E.map(()=>b("div"))},[y,S]=[ZC,KC].map(L=>E.map((I,O)=>L(I,c_(E,n)[O]))),P=_.advice?[b("p",{className:"note"},_.advice)]:[];o.replaceChildren(b("p",{},_.text),x(_),...P,A.player,A.plots,...A.readouts,...y,...S),d.scale=n.largestSpan/_.play.clips[0].span_m,u.playing={run:_,beside:v,...HC(A,_,v,n,d)},wo(o),M&&!matchMedia("(prefers-reduced-motion: reduce)").matches&&u.playing.clock.play()}function x(_){let v=b("button",{type:"button",className:"pin"},h?`unpin ${n.study.noun} ${h.point+1}`:"pin to compare with another");return v.addEventListener("click",()=>{h=h?null:_,g(_),o.querySelector(".pin").focus()}),v}return u}function HC(n,e,t,i,s){let r=t?[t,e]:[e],o=r.map((f,p)=>$C(f,c_(r,i)[p],i)),a=r.map((f,p)=>({...Zn(f.play.clips[0]),...t?{name:o[p]}:{}})),l=Li(a,t?[XC(a)]:e.play.spans),c=r.map(f=>f.play.energy).reduce((f,p)=>p.largest_J>f.largest_J?p:f),u=t?`${kt(a[0].name)} and ${a[1].name}, side by side with a common clock.`:e.play.text,h=js(n.player,a,l,{...e.play,energy:c,text:u},s);t&&h.stage&&Ef(h.stage.cells,a,l,c);let d=nr(n.plots,t?WC(r,a):e.play.plots,a,l);n.plots.classList.toggle("paired",t!==null);for(let[f,p]of a.entries())Qs(n.readouts[f],p,l,c,f,t!==null);return{clips:a,clock:l,player:h,plots:d,dispose(){h.dispose(),d.dispose()}}}function WC(n,e){let t=n.map(({play:s},r)=>s.plots.map(o=>({...o,owner:e[r].name,sharing:`${o.title} ${o.unit}`,lines:o.lines.map(a=>({...a,clip:r}))})));return[...new Set(t.flat().map(s=>s.title))].flatMap(s=>t.flat().filter(r=>r.title===s))}function c_(n,{study:e}){if(n.length===1)return[""];let t=new Set(n.map(i=>i.point)).size<n.length;return n.map(i=>`${e.noun} ${i.point+1}${t?`, ${i.title}`:""}`)}function $C(n,e,t){let{factors:i}=t.study,s=t.placesOf(n.point).map((r,o)=>`${i[o].texts[r]} ${i[o].unit}`.trim());return`${e}: ${s.join(", ")}`}function XC(n){let e=n.map(s=>s.stages.find(r=>r.driven)?.start??s.start),[t,i]=[Math.min(...n.map((s,r)=>s.start-e[r])),Math.max(...n.map((s,r)=>s.end-e[r]))];return{name:"whole runs",label:"time since the first drive acts",start:t,end:i,origins:e,whole:!0}}function qC(n,e){return n.numbers.map(t=>b("tr",{},b("th",{scope:"row"},t.title),b("td",{},n.valueText(t,e))))}function YC(n,e){return n.study.built[e]?`This run was not kept, so it cannot be played here. ${n.study.keeps}`:n.study.unbuilt}function ZC(n,e){let t=b("div");return t.innerHTML=n.numbers,b("details",{},b("summary",{},`States of ${e||"this run"}`),t)}function KC(n,e){let t=[`forficula run ${n.folder}/design.toml`,`forficula film ${n.folder} --out film.mp4`];return b("details",{},b("summary",{},e?`Commands for ${e}`:"Commands"),b("p",{className:"note"},"In the folder of this page, these commands repeat the run and make a film of it:"),b("pre",{},b("code",{},t.join(`
`))))}function Gu(n,e,t,i){let s=n?.querySelector("table");if(!s)return()=>{};let r=[...s.tBodies[0].rows],o=b("p",{className:"note",role:"status"}),a=JC(e,()=>{let u=a.shown(),h=0;for(let[d,f]of r.entries())f.hidden=!u.has(e.study.verdicts[d])||!e.shown(d),h+=f.hidden?0:1;o.textContent=`${h} of ${r.length} ${e.study.noun}s shown.`});for(let[u,h]of r.entries()){let d=b("button",{type:"button","aria-label":`open ${e.study.noun} ${u+1}`},h.cells[0].textContent);d.addEventListener("click",()=>i(u)),h.cells[0].replaceChildren(d)}let l=e.study.factors.length+1;for(let u of[s.tHead.rows[0],...r])u.cells[l].classList.add("words");QC(s,r,jC(e));let c=b("div",{className:"choices"},a.element,...t?[tR(t,e.study.file)]:[]);return s.closest(".table").before(c,o),a.changed(),a.changed}function JC(n,e){let t=new Map,i=n.study.words.flatMap((r,o)=>{if(!r.count)return[];let a=b("input",{type:"checkbox",checked:!0});return a.addEventListener("change",e),t.set(o,a),[b("label",{},a,Oo(r),`${r.word} (${r.count})`)]});return{element:b("fieldset",{className:"filter"},b("legend",{},`Show ${n.study.noun}s that`),...i),changed:e,shown:()=>new Set([...t].filter(([,r])=>r.checked).map(([r])=>r))}}function jC(n){let{study:e}=n,t=e.statuses.map((r,o)=>o),i=e.factors.map((r,o)=>t.map(a=>r.values[n.placesOf(a)[o]])),s=n.numbers.map(r=>r.values);return[t,...i,e.statuses,...s]}function QC(n,e,t){let i=[...n.tHead.rows[0].cells];for(let[s,r]of i.entries()){let o=b("button",{type:"button"},...r.childNodes);r.replaceChildren(o),o.addEventListener("click",()=>{let a=r.getAttribute("aria-sort")==="ascending";for(let c of i)c.removeAttribute("aria-sort");r.setAttribute("aria-sort",a?"descending":"ascending");let l=e.map((c,u)=>u).sort((c,u)=>eR(t[s][c],t[s][u],a?-1:1)||c-u);n.tBodies[0].append(...l.map(c=>e[c]))})}i[0].setAttribute("aria-sort","ascending")}function eR(n,e,t){if(n===null||e===null)return(n===null)-(e===null);let i=typeof n=="number"?n-e:String(n).localeCompare(String(e),"en");return t*i}function tR(n,e){let t=b("button",{type:"button",className:"button"},`Download ${e}`);return t.addEventListener("click",()=>{let i=URL.createObjectURL(new Blob([n],{type:"text/csv;charset=utf-8"}));b("a",{href:i,download:e}).click(),setTimeout(()=>URL.revokeObjectURL(i),1e4)}),t}function u_(n){let e=Ou(n.study,n.runs),t=Vu(e),i=(a,l=null)=>{t.open(a,{play:!0,transition:l}),Lf(t)},s=n_(e,(a,l)=>i(a,l.transition)),r=b("div",{},s.element,t.facts);document.getElementById("explorer").replaceChildren(b("div",{className:"explorer"},r,t.element)),Gu(document.getElementById("points"),e,n.csv,a=>{s.show(a),i(a)});let o=nR(e,n.runs);return t.open(o),s.show(o),{model:e,map:s,panel:t,open:i}}function nR(n,e){let t=n.study.quantities.filter(o=>o.group==="torque"),i=o=>[n.study.verdicts[o],...t.map(a=>a.values[o]??1/0),o],s=(o,a)=>{let l=o.findIndex((c,u)=>c!==a[u]);return l>=0&&o[l]<a[l]};return e.map(o=>o.point).reduce((o,a)=>o===null||s(i(a),i(o))?a:o,null)??0}function Lf({facts:n,element:e}){let{top:t}=e.getBoundingClientRect();if(t>=0&&t<.5*innerHeight)return;let i=n.getBoundingClientRect().left===e.getBoundingClientRect().left,s=matchMedia("(prefers-reduced-motion: reduce)").matches;(i?n:e).scrollIntoView({behavior:s?"auto":"smooth",block:"start"})}function h_(n){let{views:e}=n,t=Hx(n.study,n.runs),i=Vu(t),s=[],r=(g,x)=>{i.open(g,{play:x});for(let _ of s)_.show?.(g)},o=g=>{r(g,!0),Lf(i)},a=zx(t,e.lines,e,o),l=t.columns.filter(g=>g.aim).length===2,c=jx(t,{...e,joined:l},o),u=e.pairs?.length?$x(t,e,h):null;s.push(a,c);function h(g,x){c.over(g,x),c.element.scrollIntoView({block:"start"})}let d=n.runs.length?[[c.element,i.facts],[i.element]]:[[c.element],[i.facts]],f=b("div",{className:"explorer"},...d.map(g=>b("div",{},...g))),p={lines:a.element,pairs:u?.element,plane:f};document.getElementById("explorer").replaceChildren(...e.order.map(g=>p[g]));let m=Gu(document.getElementById("points"),t,n.csv,o);return t.whenAsked(m),n.study.points&&r(iR(t,n),!1),{model:t,panel:i,lines:a,plane:c,open:o}}function iR(n,{runs:e,views:t,study:i}){let{best:s}=t,r=e.map(o=>o.point);return s!==null&&r.includes(s)?s:r.find(o=>n.good(o))??r[0]??s??i.verdicts.findIndex((o,a)=>n.good(a)||a===i.points-1)}async function d_(n){let e=new Blob([$t(n,Uint8Array)]).stream(),t=await new Response(e.pipeThrough(new DecompressionStream("deflate"))).arrayBuffer();function i({kind:s,start:r,shape:o,low:a,step:l}){let c=o.reduce((d,f)=>d*f,1);if(s==="f4")return new Float32Array(t,r,c);if(s==="f8")return new Float64Array(t,r,c);let u=new(s==="u2"?Uint16Array:Uint32Array)(t,r,c),h=sR(u,...o);return a?Float32Array.from(h,(d,f)=>a[f%o[1]]+l[f%o[1]]*d):h}return i}function sR(n,e,t){let i=n.constructor,s=new i(1),r=new i(n.length);for(let o=0;o<t;o++){s[0]=0;for(let a=0;a<e;a++)s[0]+=n[o*e+a],r[a*t+o]=s[0]}return r}var rR="M7 4.5v15l12-7.5z",oR="M7 5h3.5v14H7zM13.5 5H17v14h-3.5z",ir=180/Math.PI,Hu=1,f_=10,p_=720;function x_(n,e,t,i){let[s,r]=[n.lowest,n.highest].map(p=>p*ir),o=uR(n),a=cR(n,s,r,o),l=b("button",{type:"button",className:"play"}),c=b("input",{type:"range",min:s,max:r,step:"any","aria-label":"hinge angle"});c.dataset.keys="own";let u=b("p",{className:"time"}),h=p=>{e.pause(),e.seek(i(Math.min(r,Math.max(s,p))/ir))},d=()=>e.playing?e.pause():e.play(),f=a.map(({angle:p,name:m})=>{let g=b("button",{type:"button"},b("b",{},m_(p)),` ${m}`);return g.addEventListener("click",()=>h(p)),g});return c.addEventListener("input",()=>h(Number(c.value))),lR(c,()=>t(e.time)*ir,h,d),l.addEventListener("click",d),e.onChange(()=>{let p=t(e.time)*ir;c.value=p,u.textContent=`${m_(p,1)}${g_(n,p)}`,c.setAttribute("aria-valuetext",`${Ln(p,1)} degrees${g_(n,p)}`);for(let[g,x]of a.entries())f[g].setAttribute("aria-pressed",String(Math.abs(x.angle-p)<.005));let m=e.playing?"pause":"play: fold from stop to stop";l.getAttribute("aria-label")!==m&&l.replaceChildren(il(e.playing?oR:rR)),l.setAttribute("aria-label",m)}),b("div",{className:"transport"},b("div",{className:"line"},l,aR(c,s,r,o,a)),b("div",{className:"choices"},u,b("div",{className:"states"},...f)))}function aR(n,e,t,i,s){let r=b("div",{className:"bands","aria-hidden":"true"}),o=b("div",{className:"ticks","aria-hidden":"true"}),a=l=>`${100*l/(t-e)}%`;for(let[l,c]of i){let u=b("span",{className:"band"});Object.assign(u.style,{left:a(l-e),width:a(c-l)}),r.append(u)}for(let{angle:l,stop:c}of s){let u=b("span",{className:c?"tick stop":"tick"});u.style.left=a(l-e),o.append(u)}return b("div",{className:"track"},r,n,o)}function lR(n,e,t,i){let s={ArrowLeft:-Hu,ArrowDown:-Hu,ArrowRight:Hu,ArrowUp:Hu},r={PageDown:-f_,PageUp:f_,Home:-1/0,End:1/0};n.addEventListener("keydown",o=>{if(!(o.shiftKey||o.ctrlKey||o.metaKey||o.altKey)){if(o.key===" ")i();else if(o.key in s)t(Math.round(e()+s[o.key]));else if(o.key in r)t(e()+r[o.key]);else return;o.preventDefault()}})}var m_=(n,e=null)=>`${e===null?Ln(n,Number.isInteger(Number(n.toFixed(3)))?0:1):Ln(n,e)}°`;function cR(n,e,t,i){let s=a=>[...new Set(n.joints.map(l=>Number((l[a]*ir).toFixed(6))))],r=[...s("lower").map(a=>({angle:a,name:"folding stop",stop:!0})),...i.flatMap(([a,l])=>[a,l].map(c=>({angle:c,name:"all straps slack"}))),...e<0&&t>0?[{angle:0,name:"flat"}]:[],...s("upper").map(a=>({angle:a,name:t>0?"overbend stop":"stop, flat",stop:!0}))],o=a=>Math.abs(a-e)<1e-6||Math.abs(a-t)<1e-6;return r.filter(a=>a.stop||a.name==="flat"||!o(a.angle)).sort((a,l)=>a.angle-l.angle)}function uR(n){let e=a=>__(n,a).every(({longer:l})=>l<0),[t,i]=[n.lowest*ir,n.highest*ir],s=(a,l)=>{let c=e(a);for(let u=0;u<40;u++){let h=(a+l)/2;e(h)===c?a=h:l=h}return l},r=[];if(!n.straps.length)return r;let o=e(t)?null:t;for(let a=1;a<=p_;a++){let[l,c]=[a-1,a].map(u=>t+(i-t)*u/p_);e(l)!==e(c)&&(o===null?o=s(l,c):(r.push([o,s(l,c)]),o=null))}return o!==null&&r.push([o,i]),r}function __(n,e){let t=n.turn(n.anglesTogether(e/ir));return n.straps.flatMap(i=>n.strapStretches(i,t).map(s=>({longer:s,rest:i.rest})))}function g_(n,e){let t=__(n,e);if(!t.length)return"";let i=t.filter(({longer:a})=>a<0).length,s=Math.max(...t.map(({longer:a})=>a));if(i===t.length)return`, straps slack by ${Ln(-1e3*s,1)} mm or more`;let r=Math.max(...t.map(({longer:a,rest:l})=>a/l)),o=`stretched by up to ${Ln(1e3*s,1)} mm (${Ln(100*r,1)} %)`;return i?`, ${i} of ${t.length} straps slack, others ${o}`:`, straps ${o}`}function y_(n){let e=b("input",{type:"range",min:0,max:100,step:1,value:0});return e.dataset.keys="own",e.addEventListener("input",()=>n(Number(e.value)/100)),e.setAttribute("aria-valuetext","together"),e.addEventListener("input",()=>{e.setAttribute("aria-valuetext",e.value==="0"?"together":`${e.value} % apart`)}),b("label",{className:"slide"},"take apart ",e)}function v_(n,e,t){let i=n.map((s,r)=>{let o=b("input",{type:"checkbox",checked:!0});o.dataset.keys="own",o.addEventListener("change",()=>t(r,o.checked));let a=b("span",{className:"swatch panel","aria-hidden":"true"});return a.style.background=s.colour,b("label",{},o,a,`${s.name}${e[r]>1?`, ${e[r]}`:""}`)});return b("fieldset",{className:"kinds"},b("legend",{},"show"),...i)}function Nf(n,e,t){let i=b("select",{},...e.map((s,r)=>b("option",{value:String(r)},s)));return i.addEventListener("change",()=>t(Number(i.value))),b("label",{},`${n} `,i)}var Wu=28,b_=24;function S_(n,e){return n.ends.map(t=>{let[i,s]=t.map((r,o)=>new H(...r).applyMatrix4(ko(e,n.bodies[o])));return i.distanceTo(s)-n.rest})}var hR=new pt,ko=(n,e)=>e<0?hR:n[e];function Df(n,e,t,i,s){let r=new H(...n.axis).transformDirection(ko(e,n.bodies[0])),o=new H(...n.up).transformDirection(ko(e,n.bodies[0]));return n.ends.map(a=>{let l=a.map((_,M)=>new H(..._).applyMatrix4(ko(e,n.bodies[M])).add(i)),c=l[1].clone().sub(l[0]),u=c.dot(r);c.addScaledVector(r,-u);let h=c.length(),d=h>1e-9?c.divideScalar(h):new H().crossVectors(r,o),f=new H().crossVectors(r,d).multiplyScalar(t),m=n.rest>Math.hypot(h,u)?Math.sqrt(n.rest**2-u**2):h,g=dR(s,m>1e-9?h/m:1);return{points:g.map(([_,M],v)=>l[0].clone().addScaledVector(d,_*m).addScaledVector(f,M*m).addScaledVector(r,u*v/(g.length-1))),wide:r,ends:l}})}function dR({values:n,shape:e},t){let[i,s]=e,r=Math.sqrt(Math.max(0,1-t))*(i-1),o=Math.min(i-2,Math.floor(r)),a=Math.min(1,r-o),l=(d,f,p)=>n[(d*s+f)*2+p],c=(d,f)=>l(o,d,f)+a*(l(o+1,d,f)-l(o,d,f)),u=c(s-1,0),h=u>1e-6?t/u:1;return Array.from({length:s},(d,f)=>[h*c(f,0),c(f,1)])}function M_(n,e,t){let i={triangles:[],edges:[]};for(let{points:s,wide:r,ends:o}of e){let a=r.clone().multiplyScalar(n.width/2),l=s.map((c,u)=>{let d=s[Math.min(u+1,s.length-1)].clone().sub(s[Math.max(u-1,0)]).cross(r).setLength(n.thickness/2);return[[-1,-1],[1,-1],[1,1],[-1,1]].map(([f,p])=>c.clone().addScaledVector(a,f).addScaledVector(d,p))});A_(i,l,[0,1,2,3]);for(let[c,u]of o.entries()){let h=new H(...n.across[c]).transformDirection(ko(t,n.bodies[c]));pR(i,u,h,n.width,n.eye/2,n.peg/2)}}return i}function Uf(n,e,t){let i=n.places.map(m=>new H(...m).add(t)),[s,r,o,a]=i,l=ko(e,n.body),[c,u]=[o,a].map(m=>m.clone().sub(t).applyMatrix4(l).add(t)),h=r.clone().sub(s).normalize(),d=u.clone().sub(c).normalize(),f=r.distanceTo(o),p=[s];for(let m=0;m<=b_;m++)p.push(fR(r,h,c,d,f,m/b_));return[...p,u]}function fR(n,e,t,i,s,r){let[o,a]=[1-r,r];return n.clone().multiplyScalar(o*o*(1+2*a)).addScaledVector(t,a*a*(1+2*o)).addScaledVector(e,s*o*o*a).addScaledVector(i,-s*a*a*o)}function w_(n,e){let t={triangles:[],edges:[]},i=n[1].clone().sub(n[0]).normalize(),s=new H(Math.abs(i.z)<.9?0:1,0,Math.abs(i.z)<.9?1:0),r=n.map((o,a)=>{let l=n[Math.min(a+1,n.length-1)].clone().sub(n[Math.max(a-1,0)]).normalize();s=s.clone().addScaledVector(l,-s.dot(l)).normalize();let c=new H().crossVectors(l,s);return Array.from({length:Wu},(u,h)=>{let d=2*Math.PI*h/Wu;return o.clone().addScaledVector(s,Math.cos(d)*e/2).addScaledVector(c,Math.sin(d)*e/2)})});return A_(t,r,[]),t}function A_({triangles:n,edges:e},t,i){let s=t[0].length;for(let r=1;r<t.length;r++){let[o,a]=[t[r-1],t[r]];for(let l=0;l<s;l++){let c=(l+1)%s;n.push(o[l],o[c],a[c],o[l],a[c],a[l]),i.includes(l)&&e.push(o[l],a[l])}}for(let r of[t[0],t.at(-1)])for(let o=1;o<s-1;o++)n.push(r[0],r[o],r[o+1])}function pR({triangles:n,edges:e},t,i,s,r,o){let a=new H(Math.abs(i.z)<.9?0:1,0,Math.abs(i.z)<.9?1:0);a.addScaledVector(i,-a.dot(i)).normalize();let l=new H().crossVectors(i,a),c=(u,h,d)=>t.clone().addScaledVector(i,d*s/2).addScaledVector(a,h*Math.cos(u)).addScaledVector(l,h*Math.sin(u));for(let u=0;u<Wu;u++){let[h,d]=[u,u+1].map(p=>2*Math.PI*p/Wu),f=(p,m,g,x)=>n.push(p,m,g,p,g,x);f(c(h,r,-1),c(d,r,-1),c(d,r,1),c(h,r,1));for(let p of[-1,1])f(c(h,o,p),c(d,o,p),c(d,r,p),c(h,r,p)),e.push(c(h,r,p),c(d,r,p))}}function E_(n,e){let t=e.map(({origin:a,axis:l})=>[new H(...a),new H(...l)]),i=n.map((a,l)=>e.flatMap((c,u)=>c.body===l?[u]:[])),s=n.map(()=>new pt),r=new pt,o=new H;return function(l){for(let[c,u]of n.entries()){let h=s[c];u<0?h.identity():h.copy(s[u]);for(let d of i[c]){let[f,p]=t[d];r.makeRotationAxis(p,l[d]-e[d].built),o.copy(f).applyMatrix4(r),r.setPosition(f.x-o.x,f.y-o.y,f.z-o.z),h.multiply(r)}}return s}}var mR=[-1,0,1].flatMap(n=>[-1,0,1].flatMap(e=>[-1,0,1].map(t=>[n,e,t]))),gR=new pt;function T_(n,e){let t=n.parts.map(f=>({...f,...f.mesh?xR(f.mesh,e):{}})),i={values:e(n.bows),shape:n.bows.shape},s=E_(n.bodies,n.turns),r=Math.min(...n.joints.map(f=>f.lower)),o=Math.max(...n.joints.map(f=>f.upper)),a=new Float64Array(n.turns.length);function l(f){for(let[p,m]of n.turns.entries())a[p]=m.built;for(let p of n.joints)a[p.turn]=Math.min(p.upper,Math.max(p.lower,f));return a}let c=(f,p)=>new H(...f.apart).multiplyScalar(p);function u(f,p,m,g=new pt){let x=c(f,m);return g.copy(f.body===null||f.body<0?gR:p[f.body]).multiply(new pt().makeTranslation(x.x,x.y,x.z))}function h(f,p,{apart:m,side:g}){let x=c(f,m);return f.root?w_(Uf(f.root,p,x),f.root.diameter):M_(f.strap,Df(f.strap,p,g,x,i),p)}function d(f,p,{apart:m,side:g}){let x=[];for(let _ of f){if(_.outer){let E=u(_,p,m);for(let A of _.outer)x.push(...A.clone().applyMatrix4(E).toArray());continue}let M=c(_,m),v=_.root?[Uf(_.root,p,M)]:Df(_.strap,p,g,M,i).map(E=>E.points);for(let E of v)for(let A=0;A<E.length;A+=4)x.push(...E[A].toArray())}return Float64Array.from(x)}return{parts:t,looks:n.looks,joints:n.joints,turns:n.turns,lowest:r,highest:o,turn:s,anglesTogether:l,matrixOf:u,bentMesh:h,outline:d,straps:t.filter(f=>f.strap).map(f=>f.strap),strapStretches:S_}}function xR({points:n,triangles:e,stops:t,edges:i},s){let r=s(n),o=s(e),a=n.shape[0];for(let l=0;l<o.length;l+=3)o[l+1]=(o[l]+o[l+1])%a,o[l+2]=(o[l]+o[l+2])%a;return{places:r,corners:o,stops:t,edges:s(i),outer:_R(r)}}function _R(n){let e=new Set;for(let[t,i,s]of mR){let[r,o]=[0,-1/0];for(let a=0;a<n.length;a+=3){let l=t*n[a]+i*n[a+1]+s*n[a+2];l>o&&([r,o]=[a,l])}e.add(r)}return Array.from(e,t=>new H().fromArray(n,t))}function C_(n,e){let t=e(n.time),i=e(n.angles),[,s]=n.angles.shape,r=new Float64Array(s);function o(a){let[l,c]=vs(t,a),u=Math.min(l+1,t.length-1);for(let h=0;h<s;h++){let d=i[l*s+h];r[h]=d+c*(i[u*s+h]-d)}return r}return{time:t,anglesAt:o,marks:n.marks,stages:n.stages,spans:n.spans}}var yR="#14171a",vR=.55,bR=Math.cos(Math.PI/9),SR=.42;function R_(n,e,t,i){let s=n.parts.map(f=>MR(f,n.looks[f.look].colour,i)),r=new kn;for(let f of s)r.add(f.mesh,f.lines);let o=new kn,a=n.turn(n.anglesTogether(0));function l(f){a=n.turn(t(f));for(let[p,m]of n.parts.entries()){let{mesh:g,lines:x}=s[p],_=!e.hidden.has(m.look);for(let M of[g,x])M.visible=_;_&&(m.places?n.matrixOf(m,a,e.apart,g.matrix):ER(s[p],n.bentMesh(m,a,e)))}}function c(){let f=new Qe(Bt("--accent"));for(let[p,{mesh:m}]of s.entries())for(let g of[m.material].flat())g.emissive.copy(f),g.emissiveIntensity=e.chosen===p?SR:0}function u(f,p){let m=new mr;m.setFromCamera(f,p),r.updateMatrixWorld(!0);for(let{mesh:x}of s)x.geometry.boundingSphere===null&&x.geometry.computeBoundingSphere();let[g]=m.intersectObjects(s.map(x=>x.mesh).filter(x=>x.visible),!1);return g?s.findIndex(x=>x.mesh===g.object):null}function h(f){let p=n.parts.findIndex(_=>_.name===f),{mesh:m}=s[p],g=m.geometry.getAttribute("position"),x=new on(g.array.slice(),3);return Array.from(x.applyMatrix4(m.matrix).array)}function d(){for(let{mesh:f,lines:p}of s){f.geometry.dispose(),p.geometry.dispose();for(let m of[f.material,p.material].flat())m.dispose()}}return{group:r,shadow:o,pose:l,paint:c,sort:()=>{},at:u,verticesOf:h,dispose:d,current:()=>a}}function MR(n,e,t){let i=(u,h)=>new ms({color:u,side:Bn,flatShading:h,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}),s=n.places?wR(n):new _n,r=n.places?[i(t,!1),i(e,!1)]:i(e,!0),o=new Dn(s,r),a=new _n;n.places&&a.setAttribute("position",new on(P_(n.places,n.edges),3));let l=new zs({color:yR,transparent:!0,opacity:vR}),c=new pr(a,l);for(let u of[o,c])Object.assign(u,{frustumCulled:!1,matrixAutoUpdate:!1});return c.matrix=o.matrix,{mesh:o,lines:c}}function wR({places:n,corners:e,stops:t}){let i=new _n;return i.setAttribute("position",new on(P_(n,e),3)),i.setAttribute("normal",new on(AR(n,e),3)),i.addGroup(0,3*t,0),i.addGroup(3*t,e.length-3*t,1),i}function P_(n,e){let t=new Float32Array(3*e.length);for(let[i,s]of e.entries())for(let r=0;r<3;r++)t[3*i+r]=n[3*s+r];return t}function AR(n,e){let t=e.length/3,i=new Float64Array(e.length),s=Array.from({length:n.length/3},()=>[]);for(let l=0;l<t;l++){let[c,u,h]=[0,1,2].map(f=>3*e[3*l+f]),d=(f,p,m)=>n[p+m%3]-n[f+m%3];for(let f=0;f<3;f++)i[3*l+f]=d(c,u,f+1)*d(c,h,f+2)-d(c,u,f+2)*d(c,h,f+1);for(let f=0;f<3;f++)s[e[3*l+f]].push(l)}let r=Float64Array.from({length:t},(l,c)=>Math.hypot(...i.subarray(3*c,3*c+3))),o=new Float32Array(3*e.length),a=(l,c)=>i[3*l]*i[3*c]+i[3*l+1]*i[3*c+1]+i[3*l+2]*i[3*c+2];for(let l=0;l<e.length;l++){let c=Math.floor(l/3),u=[0,0,0];for(let d of s[e[l]])if(d===c||a(c,d)>=bR*r[c]*r[d])for(let f=0;f<3;f++)u[f]+=i[3*d+f];let h=Math.hypot(...u)||1;for(let d=0;d<3;d++)o[3*l+d]=u[d]/h}return o}function ER({mesh:n,lines:e},{triangles:t,edges:i}){for(let[s,r]of[[n,t],[e,i]]){let{geometry:o}=s,a=o.getAttribute("position");a?.count!==r.length&&(a=new on(new Float32Array(3*r.length),3),o.setAttribute("position",a));for(let[l,c]of r.entries())c.toArray(a.array,3*l);a.needsUpdate=!0,o.boundingSphere=null}}var TR=.25,I_=60,CR=4;async function N_(n){let e=await d_(n.arrays),t=T_(n,e),i={apart:0,side:1,hidden:new Set,chosen:null},s=[RR(t,i),...n.motion?[PR(t,i,C_(n.motion,e))]:[]],r=IR(s),o=document.getElementById("player"),a=LR(o,n,t,i,r),l=kR(t,n,i,a);return a.onPress(l.choose),{model:t,state:i,clock:s[0].clock,run:s[1]?.clock??null,...a,choose:l.choose}}function RR(n,e){let t=c=>n.highest+c*(n.lowest-n.highest),i=c=>(c-n.highest)/(n.lowest-n.highest||1),s=Float64Array.from({length:I_+1},(c,u)=>u/I_),r=c=>n.anglesTogether(t(c)),o=D_(n,e,{time:s,anglesAt:r,marks:[],stages:[]}),a=Li([U_(n,o,r)],[{name:"",label:"",start:0,end:1,origins:[0],whole:!1}]);a.setSpeed(TR);let l=x_(n,a,t,i);return{name:"all joints together",clip:o,clock:a,anglesAt:r,control:l}}function PR(n,e,t){let i=D_(n,e,t),s=Li([U_(n,i,t.anglesAt)],t.spans);return{name:"as in the simulated run",clip:i,clock:s,anglesAt:t.anglesAt,control:cu([i],s)}}function D_(n,e,{time:t,anglesAt:i,marks:s,stages:r}){let o=()=>{let a=n.parts.filter(l=>!e.hidden.has(l.look));return a.length?a:n.parts};return{name:"",time:t,start:t[0],end:t[t.length-1],marks:s,stages:r,readings:[],reach:0,mesh:{tubes:[],joints:[],jointRadius:0},pointsAt:a=>n.outline(o(),n.turn(i(a)),e),stageAt:a=>r.findLast(l=>l.start<=a)??r[0],markAt:a=>s.find(l=>Math.abs(l.time-a)<1e-9)}}function U_(n,e,t){let i=n.parts.filter(s=>s.outer).map(s=>({...s,outer:[s.outer[0],s.outer.at(-1)]}));return{...e,pointsAt:s=>n.outline(i,n.turn(t(s)),{apart:0,side:1})}}function IR(n){let e=n[0],t={of:null},i=new Set;for(let a of n)a.clock.onChange(()=>{if(a===e)for(let l of i)l()});let s=()=>e.clock.redraw(),r={get time(){return e.clock.time},get playing(){return e.clock.playing},get span(){return t.of!==e.clock.span&&(t={...e.clock.span,of:e.clock.span}),t},clipTime:(a,l)=>e.clock.clipTime(a,l),timeAt:a=>e.clock.timeAt(a),wayAt:a=>e.clock.wayAt(a),onChange(a){return i.add(a),s(),()=>i.delete(a)},seek:a=>e.clock.seek(a),seekClip:(a,l)=>e.clock.seekClip(a,l),step:a=>e.clock.step(a),play:()=>e.clock.play(),pause:()=>e.clock.pause()};return{clip:{...n[0].clip,pointsAt:a=>e.clip.pointsAt(a)},clock:r,sources:n,get now(){return e},anglesAt:a=>e.anglesAt(a),take(a){e.clock.pause(),e=n[a],t={of:null},s()},changed(){t={of:null},s()}}}var O_="Press a part, or its name in the table, for details.",L_="parts";function LR(n,e,t,i,s){let{clip:r,clock:o,sources:a}=s,l=null,u=Ha([r],o,()=>l=R_(t,i,s.anglesAt,e.stopColour),e.text),h=u?b("div",{className:"picture"},u.element,fu(u.eye,null)):b("p",{className:"note"},du(L_)),d=b("p",{className:"chosen",role:"status"},O_),f=b("div",{},a[0].control);return n.replaceChildren(h,d,f,NR(t,i,s,f),DR(t,i,s),UR(e,t,u),au([r],u!==null,L_)),n.classList.add("player"),n.setAttribute("role","region"),n.setAttribute("aria-label","the moving parts"),lu(n,[r],o,u?.eye,Sr[0]),{stage:u,shape:l,info:d,repaint:()=>{l?.paint(),o.seek(o.time)},onPress:p=>u&&FR(u.canvas,m=>p(l.at(m,u.eye.camera)))}}function NR(n,e,t,i){let s=l=>{Object.assign(e,l),t.changed()},r=t.sources.map(l=>l.name),o=Nf("motion",r,l=>{t.take(l),i.replaceChildren(t.now.control)}),a=Nf("slack straps bow",["away from the hinge","towards the hinge"],l=>s({side:l?-1:1}));return b("div",{className:"choices"},...r.length>1?[o]:[],y_(l=>s({apart:l})),...n.straps.length?[a]:[])}function DR(n,e,t){let i=n.looks.map((s,r)=>n.parts.reduce((o,a)=>o+(a.look===r?a.count:0),0));return v_(n.looks,i,(s,r)=>{r?e.hidden.delete(s):e.hidden.add(s),t.changed()})}function UR(n,e,t){let i=b("span",{className:"swatch taut","aria-hidden":"true"});return b("ul",{className:"legend"},...e.parts.some(s=>s.stops)?[OR(n.stopColour,"face of a stop")]:[],...e.straps.length?[b("li",{},i,"on the slider: range of taut straps")]:[],...t?[b("li",{},`squares of the grid: ${vt(1e3*Ga(t.eye.size))} mm`)]:[])}function OR(n,e){let t=b("span",{className:"swatch panel","aria-hidden":"true"});return t.style.background=n,b("li",{},t,e)}function FR(n,e){let t=null;n.addEventListener("pointerdown",i=>{t=i.isPrimary?[i.clientX,i.clientY]:null}),n.addEventListener("pointerup",i=>{if(t===null||Math.hypot(i.clientX-t[0],i.clientY-t[1])>CR)return;let s=n.getBoundingClientRect(),[r,o]=[(i.clientX-s.left)/s.width,(i.clientY-s.top)/s.height];e(new qe(2*r-1,1-2*o))})}function kR(n,e,t,i){let r=Array.from(document.querySelectorAll("#bill tbody tr")).map((l,c)=>{let[u]=l.querySelector("th").childNodes,h=b("button",{type:"button",className:"name","aria-pressed":"false"},u.textContent);return u.replaceWith(h),h.addEventListener("click",()=>o(t.chosen===c?null:c)),h});function o(l){t.chosen=l;for(let[c,u]of r.entries())u.setAttribute("aria-pressed",String(c===l));i.info.textContent=l===null?O_:a(l),i.repaint()}function a(l){let c=n.parts[l],[u,h,d]=c.facts,f=c.count>1?`${c.count} identical ones, each `:"";return`${c.name}: ${n.looks[c.look].name} of ${u}, ${f}${h}, ${d}`}return{choose:o}}var BR=[.1,.2,.5,1,2,5,10,15,30,45,60,90,180],zR=1.35;function Of(n,e,t=[],i=null){let s=e.map(r=>VR(r,t[0],i));n.replaceChildren(...s.map(r=>r.element)),n.classList.add("plots");for(let r of s)r.start();return s}function VR(n,e,t){let[i,s,r]=[n.lines,n.balls,n.marks].map(A=>A.map(GR)),{element:o,key:a,place:l}=bf(n),c=(s.length?s:[i[0]]).map(A=>b("span",{className:"ball"},s.length&&A.name.length<3?A.name:"")),u=s.map(A=>[A.places[0],A.values[0]]),h=Math.round(zR*Lu),d=HR(i),f=d,p=null,m=[];function g(){let A=i.map((S,P)=>b("li",{},ar(ys(P)),S.name)),y=s.length?`the ${n.along} now`:"moved by the slider";a.replaceChildren(...A,b("li",{},b("span",{className:"ball still"}),y))}function x(){for(let[A,[y,S]]of u.entries()){let[P,L]=[p.valToPos(y,"x"),p.valToPos(S,"y")];c[A].style.transform=`translate(${P.toFixed(2)}px, ${L.toFixed(2)}px)`}}function _(){let[A,y]=vs(e.time,t.clipTime(0));for(let[S,{places:P,values:L}]of s.entries())u[S]=[F_(P,A,y),F_(L,A,y)];x()}function M(A){f=A,p.setScale("x",{min:A[0],max:A[1]})}function v(A,y,S){if(f!==d){let{places:I,values:O}=i[0],k=O.filter((X,G)=>I[G]>=f[0]&&I[G]<=f[1]),[N,V]=[Math.min(...k),Math.max(...k)];return[N-.25*(V-N),V+.25*(V-N)]}let P=s.reduce((I,O)=>Math.max(I,O.most),S),L=Math.min(0,y);return[L-.06*(P-L||1),P+.1*(P-L||1)]}function E(){let A=an.join(i.map(P=>[P.sorted.places,P.sorted.values]));p=new an(WR({data:n,lines:i,balls:s,marks:r,energyRange:v},l.clientWidth,h),A,l),p.over.append(...c);let y=new ResizeObserver(()=>p.setSize({width:l.clientWidth,height:h}));y.observe(l),p.hooks.setSize=[x],p.hooks.setScale=[x],g(),m=[Ys(()=>{g(),p.redraw(!1)}),()=>y.disconnect(),()=>p.destroy()],n.top&&l.after(qR(d,n.top,M)),s.length?(t.onChange(_),YR(p,s,e,t)):ZR(n,i[0],l,(P,L)=>{u[0]=[P,L],x()}),M(d)}return{element:o,start:E,dispose:()=>m.forEach(A=>A()),now:u,get chart(){return p}}}function GR({name:n,places:e,values:t}){let i={name:n,places:$t(e,Float32Array),values:$t(t,Float32Array)},s=Array.from(i.places.keys()).sort((r,o)=>i.places[r]-i.places[o]);return i.most=i.values.reduce((r,o)=>Math.max(r,o),0),i.sorted={places:s.map(r=>i.places[r]),values:s.map(r=>i.values[r])},i}function F_(n,e,t){let i=n[Math.min(e+1,n.length-1)];return n[e]+t*(i-n[e])}function HR(n){let e=n.flatMap(s=>[s.sorted.places[0],s.sorted.places.at(-1)]),[t,i]=[Math.min(...e),Math.max(...e)];return[t-.03*(i-t),i+.03*(i-t)]}function WR({data:n,lines:e,balls:t,marks:i,energyRange:s},r,o){let a=Nu(),l=wf(n);return{width:r,height:o,legend:{show:!1},cursor:{show:!1},pxAlign:0,padding:[10,12,0,0],scales:{x:{time:!1,auto:!1,dir:n.backwards?-1:1},y:{range:s}},series:[{},...Sf(e)],axes:[{...a,...Mf,labelFont:a.font,label:`${n.axis} (deg)`,values:l.values,incrs:BR,space:44},l],hooks:{draw:[c=>$R(c,n.along==="run"?t:[]),c=>XR(c,i)]}}}function $R(n,e){let{ctx:t,bbox:i}=n,s=1.6*devicePixelRatio;t.save(),t.globalAlpha=.55,t.fillStyle=Bt("--accent");for(let{places:r,values:o}of e)for(let a=0;a<r.length;a++){let[l,c]=[n.valToPos(r[a],"x",!0),n.valToPos(o[a],"y",!0)];l>i.left&&l<i.left+i.width&&c>i.top&&c<i.top+i.height&&t.fillRect(l-s/2,c-s/2,s,s)}t.restore()}function XR(n,e){let{ctx:t,bbox:i}=n,s=devicePixelRatio;t.save(),t.beginPath(),t.rect(i.left-6*s,i.top,i.width+12*s,i.height+6*s),t.clip(),t.setLineDash([]),t.font=`${12*s}px system-ui, sans-serif`;for(let{name:r,places:o,values:a}of e){let l=Array.from(o,f=>n.valToPos(f,"x",!0)),c=Array.from(a,f=>n.valToPos(f,"y",!0)),[u,h]=[l[l.length>>1],c[c.length>>1]];if(t.beginPath(),l.length===1)t.arc(u,h,4.5*s,0,2*Math.PI),t.fillStyle=Bt("--page"),t.fill(),t.strokeStyle=Bt("--ink"),t.lineWidth=1.4*s,t.stroke();else{t.globalAlpha=.35;for(let f of l.keys())t.lineTo(l[f],c[f]);t.strokeStyle=Bt("--line-2"),t.lineWidth=7*s,t.stroke(),t.globalAlpha=1}let d=l.length>1?0:u>i.left+i.width/2?-1:1;t.fillStyle=Bt("--ink"),t.textAlign=["right","center","left"][d+1],t.fillText(r,u+12*d*s,h-9*s)}t.restore()}function qR(n,e,t){let i=[["whole curve",n],["barrier enlarged",e]].map(([s,r],o)=>{let a=b("button",{type:"button","aria-pressed":String(o===0)},s);return a.addEventListener("click",()=>{for(let l of i)l.setAttribute("aria-pressed",String(l===a));t(r)}),a});return b("div",{className:"ranges",role:"group","aria-label":"part of the curve"},...i)}function YR(n,e,t,i){Af(n,r=>{let o=n.over.getBoundingClientRect(),[a,l]=[r.clientX-o.left,r.clientY-o.top],[c,u]=[0,1/0];for(let{places:h,values:d}of e)for(let f=0;f<h.length;f++){let p=Math.hypot(n.valToPos(h[f],"x")-a,n.valToPos(d[f],"y")-l);p<u&&([c,u]=[f,p])}i.pause(),i.seekClip(0,t.time[c])})}function ZR(n,e,t,i){let s=e.places.length-1,r=b("input",{type:"range",min:"0",max:String(s),value:"0"});r.setAttribute("aria-label",`${n.axis} along the curve`);let o=b("output",{"aria-live":"off"}),a=()=>{let l=Number(r.value);i(e.places[l],e.values[l]);let[c,u]=[vt(e.places[l]),`${vt(e.values[l])} ${n.unit}`];o.textContent=`${c}°, ${u}`,r.setAttribute("aria-valuetext",`${n.axis} ${c} degrees, energy ${u}`)};r.addEventListener("input",a),t.after(b("div",{className:"slide"},r,o)),a()}function Ff(n){let e=(n.paths??[]).map(c=>({...c,clips:c.clips.map(u=>({...n.clips?.[0],...u}))})),i=[...n.clips?[{...n,name:"motion",title:"in time, as simulated"}]:[],...e].map(KR),s={views:i};if(!i.length)return{...s,curves:Of(document.getElementById("curves"),n.curves)};let r=document.getElementById("player"),o=null,a;s.choose=c=>{o?.leave(),o=c,a=c.show(a)??a,Object.assign(s,c);for(let u of l)u.setAttribute("aria-pressed",String(u.textContent===c.name))};let l=i.map(c=>{let u=b("button",{type:"button",title:`${c.name}: ${c.title}`},c.name);return u.addEventListener("click",()=>s.choose(c)),u});if(i.length>1){let c=i.map(({name:h,title:d})=>`${h}: ${d}`).join(" · "),u=`how the ${n.whole} moves`;r.before(b("div",{className:"colours modes",role:"group","aria-label":u},b("span",{},...l),b("small",{},c)))}if(s.choose(i[0]),n.clips){Du(r,s.clock);let c=i.find(h=>h!==i[0]),u=c&&(()=>{s.choose(c),r.scrollIntoView({block:"start"}),r.querySelector("input[type=range]").focus({preventScroll:!0})});s.trial=gu(document.getElementById("try"),i[0].clips[0],n,()=>s.clock.pause(),u)}return s}function KR(n){let{name:e,title:t}=n,i=n.clips.map(Zn),s={name:e,title:t,clips:i,clock:null},r=[];return s.show=o=>{let a=u=>document.getElementById(u),l=Li(i,n.spans);return s.clock&&l.seek(s.clock.time),s.clock=l,s.player=js(a("player"),i,l,n,o,!1),s.curves=n.curves?Of(a("curves"),n.curves,i,l):[],s.plots=nr(a("plots"),n.plots,i,l),n.notes&&a("player").append(...n.notes.map(u=>b("p",{className:"note"},u))),r=[Qs(a("readout"),i[0],l,n.energy),()=>s.player.dispose(),()=>s.plots.dispose(),()=>s.curves.forEach(u=>u.dispose())],s.player.stage?.eye.look},s.leave=()=>r.forEach(o=>o()),s}var B_={"Content-Type":"application/json"},k_=19e6;async function As(n,e,t){let i=JSON.stringify(e);if(i.length>k_)return{refused:`need files of at most ${k_/1e6} MB in all`};try{return await(await fetch(n,{method:"POST",headers:B_,body:i,signal:t})).json()}catch(s){if(s.name==="AbortError")throw s;return{refused:kf}}}async function $u(n,e,t,i){let s="",r={};try{let a=(await fetch(n,{method:"POST",headers:B_,body:JSON.stringify(e),signal:t})).body.pipeThrough(new TextDecoderStream).getReader();for(let l=await a.read();!l.done;l=await a.read()){let c=`${s}${l.value}`.split(`
`);s=c.pop();for(let u of c)r=JSON.parse(u),i(r)}s&&(r=JSON.parse(s))}catch(o){if(o.name==="AbortError")throw o;return{refused:kf}}return r.done||r.refused?r:{refused:kf}}var kf="the workbench does not answer; is forficula open still running?";var Bf=`forficula ${location.pathname}`;function V_(n){let e={asked:null,base:null,reply:null,rejected:new Map};e.open=async(r,o)=>{let a=r.files[0]?.name||r.design||"the design",l={...r,settings:o};n.says.wait(`Opening ${a}`);let c=n.picture(l,!0),u=await As("design",{...r,settings:{}}),h=u.refused??await t(l,u,c);return h?(n.says.refuse(`${a} is not opened: ${h}`),n.resume()):e.rejected.clear(),e.reply&&s(e.reply),h};async function t(r,o,a=null){let l=performance.now(),c=new AbortController,u=()=>{Object.assign(e,{asked:r,base:o}),s(h)};n.says.wait("Building",()=>c.abort());let h=o;try{if(Object.keys(r.settings).length&&(h=await As("design",r,c.signal)),h.refused)return h.refused;let d=await JR(a??n.picture(r,!1),c.signal);if(d.refused)return d.refused;d.shown&&(u(),n.says.wait("Building"));let f=await As("model",r,d.shown?void 0:c.signal);if(f.refused&&!d.shown)return f.refused;d.shown||u(),await n.model(f.refused?{live:f,warnings:[]}:f),n.says.done(`Built in ${((performance.now()-l)/1e3).toFixed(1)} s.`)}catch(d){if(d.name!=="AbortError")throw d;return"building was stopped"}return""}e.change=async(r,o)=>{let{asked:a,rejected:l}=e,c=[...l].filter(([f])=>f!==r).map(([f,p])=>[f,p.text]),u=i(a.settings,[[r,o]]),h=c.length?[i(a.settings,[...c,[r,o]]),u]:[u],d="";for(let f of h)if(d=z_(f,a.settings)?"":await t({...a,settings:f},e.base),!d){f===h[0]?l.clear():l.delete(r);break}d?(l.set(r,{text:o,why:d}),n.says.refuse(`${d} – the last working model is kept`),n.resume()):z_(u,a.settings)&&n.says.done(""),s(e.reply)},e.slide=async r=>{let o=i(e.asked.settings,Object.entries(r)),a=await As("design",{...e.asked,settings:o});return a.refused?n.says.refuse(a.refused):(e.asked={...e.asked,settings:o},s(a))};function i(r,o){let a={...r};for(let[l,c]of o)c===""||c===e.base.keys.find(u=>u.key===l)?.value?delete a[l]:a[l]=c;return a}function s(r){e.reply=r,jR(e.asked),n.reply(e)}return e}function JR(n,e){let t=new Promise((i,s)=>e.addEventListener("abort",()=>s(e.reason)));return Promise.race([n,t])}var z_=(n,e)=>JSON.stringify(Object.entries(n).sort())===JSON.stringify(Object.entries(e).sort());function G_(){return JSON.parse(sessionStorage.getItem(Bf)??"null")}function jR(n){try{sessionStorage.setItem(Bf,JSON.stringify(n))}catch{sessionStorage.removeItem(Bf)}}function H_(n){let e=b("textarea",{id:"file-text",className:"file",rows:24,spellcheck:!1,"aria-describedby":"file-note"}),t=b("button",{type:"button"},"Build this text"),s=b("div",{},b("label",{htmlFor:"file-text"},"The design file"),b("p",{className:"note",id:"file-note"},"Add or remove stages, tendons and whole sections here. The result counts as a new design file."),e,b("p",{className:"choices"},t));t.addEventListener("click",()=>n(e.value));let r="";return{element:s,show(o){o.text!==r&&(e.value=r=o.text)}}}function Xu(n,e){let t="";for(let i of new TextEncoder().encode(n))t+=String.fromCharCode(i);return`data:${e};base64,${btoa(t)}`}var zf=40,QR=0;function W_(n,e){let t=`key-${++QR}`,i=n.key.split(".").at(-1).replaceAll("_"," "),s=eP(n,t),r=b("button",{type:"button",className:"home",hidden:!0},"undo"),o=b("p",{className:"wrong",id:`${t}-wrong`}),a="",l=b("p",{className:"note",id:`${t}-notes`}),c=b("div",{className:"field"},b("label",{htmlFor:t,title:n.key},i),b("span",{className:"entry"},s,...tP(n,t),r),o,l);s.setAttribute("aria-describedby",`${t}-wrong ${t}-notes`),s.addEventListener("change",()=>{a=s.value.trim(),e(a)}),r.addEventListener("click",()=>{e(""),s.focus()}),r.setAttribute("aria-label",`undo the change of ${i}`);function u(d,f,p){(document.activeElement!==s||s.value.trim()===a)&&(s.value=f??d.value),a=s.value.trim(),h("");let m=f===void 0?null:p?.value||"left out";c.classList.toggle("changed",m!==null),r.hidden=m===null;let g=d.default&&d.default!=="needed"?`if left out ${d.default}`:"",_=[d.allowed,m===null?g:`was ${m}`,d.chosen&&`chosen: ${d.chosen}`].filter(Boolean).join(" · ").replaceAll(">=","≥").replaceAll("<=","≤");l.replaceChildren(kt(d.meaning),b("span",{className:"may"},_))}function h(d,f){f!==void 0&&(s.value=a=f),o.textContent=d,c.classList.toggle("rejected",d!==""),d?(s.setAttribute("aria-invalid","true"),r.hidden=!1):s.removeAttribute("aria-invalid")}return{element:c,input:s,fact:n,show:u,reject:h}}function eP({key:n,value:e,words:t,onlyWords:i,default:s},r){if(i){let l=e?[]:[b("option",{value:""},s&&s!=="needed"?`left out: ${s}`:"left out")];return b("select",{id:r,"data-key":n},...l,...t.map(c=>b("option",{value:c},c)))}let o={id:r,spellcheck:!1,autocomplete:"off",autocapitalize:"off","data-key":n};if(e.length>zf)return b("textarea",{...o,rows:Math.min(6,Math.ceil(e.length/zf))});let a=b("input",{...o,type:"text"});return t.length&&a.setAttribute("list",`${r}-words`),a}function tP({words:n,onlyWords:e,value:t},i){return e||!n.length||t.length>zf?[]:[b("datalist",{id:`${i}-words`},...n.map(s=>b("option",{value:s})))]}var nP=["pattern","tendon"];function $_(n){let e=b("input",{type:"search",id:"find-key",spellcheck:!1,placeholder:"stiffness, length, torque …"}),t=b("p",{className:"note",role:"status"}),i=b("div",{className:"sections"}),s=b("section",{className:"keys-of-design","aria-label":"keys of the design"},b("h2",{},"Keys"),b("label",{className:"find",htmlFor:"find-key"},"Find a key",e),t,i),r=new Map,o=[];e.addEventListener("input",a);function a(){let h=e.value.toLowerCase().split(/\s+/).filter(Boolean),d=0;for(let{fact:f,element:p}of r.values()){let m=`${f.key.replaceAll("_"," ")} ${f.key} ${f.meaning}`.toLowerCase();p.hidden=!h.every(g=>m.includes(g)),d+=p.hidden?0:1}for(let f of o){f.element.hidden=f.fields.every(p=>p.element.hidden);for(let{heading:p,fields:m}of f.parts)p.hidden=m.every(g=>g.element.hidden);h.length&&!f.element.hidden&&(f.element.open=!0)}t.textContent=h.length?`${d} of ${r.size} keys`:`${r.size} keys; enter values with units, as in a design file`}function l(h,d,f){let p=new Map(f.keys.map(m=>[m.key,m]));iP(h.keys,r)||c(h);for(let m of h.keys)r.get(m.key).show(m,d[m.key],p.get(m.key));for(let m of o)m.count(d);a()}function c(h){let d=new Set(o.length?o.filter(({element:m})=>m.open).map(({name:m})=>m):nP),f=document.activeElement?.dataset?.key;r=new Map(h.keys.map(m=>[m.key,W_(m,g=>n(m.key,g))])),o=[...new Set(h.keys.map(({key:m})=>m.includes(".")?m.split(".")[0]:""))].sort((m,g)=>(g===""?-1:0)-(m===""?-1:0)).map(m=>sP(m,h,r));for(let m of o)m.element.open=d.has(m.name);i.replaceChildren(...o.map(m=>m.element)),f&&r.get(f)?.input.focus()}function u(h,d,f){let p=r.get(h);if(p){p.reject(f,d);for(let m of o)m.fields.includes(p)&&(m.element.open=!0)}}return{element:s,show:l,reject:u,field:h=>r.get(h)}}function iP(n,e){let t=[...e.keys()],i=(s,r)=>s.key===r&&s.onlyWords===e.get(r).fact.onlyWords;return n.length===t.length&&n.every((s,r)=>i(s,t[r]))}function sP(n,e,t){let i=e.keys.filter(({key:d})=>(d.includes(".")?d.split(".")[0]:"")===n),s=i.map(({key:d})=>t.get(d)),r=b("summary"),o=e.sections[n],a=[],l=[];for(let{key:d}of i){let f=d.split(".").slice(1,-1).join(".");if(f!==(a.at(-1)?.within??"")){let p=e.keys.find(g=>g.key===`${n}.${f}.name`)?.value,m=b("h3",{},`${n}.${f}${p?` · ${p}`:""}`);a.push({within:f,heading:m,fields:[]}),l.push(m)}a.at(-1)?.fields.push(t.get(d)),l.push(t.get(d).element)}let c=o?[b("p",{className:"note"},`${kt(o).replace(/\.$/,"")}.`)]:[],u=b("details",{},r,...c,...l);function h(d){let f=i.filter(({key:p})=>p in d).length;r.replaceChildren(n?kt(n):"Name",...f?[b("small",{},` ${f} changed`)]:[])}return{name:n,element:u,fields:s,parts:a.filter(({heading:d})=>d),count:h}}function X_(n,e,t){let i=b("option",{value:""},e),s=n.filter(({name:f})=>f!==e).map(({name:f,shows:p})=>b("option",{value:f,title:p},f)),r=b("select",{id:"which-design"},i,...s),o=b("input",{type:"file",id:"which-files",multiple:!0,accept:".toml,.fold,.svg,.dxf",className:"spoken"}),a=b("input",{type:"text",id:"which-unit",placeholder:"1 cm",size:6,spellcheck:!1}),l="A design (.toml, with the files that it names), a FOLD file or a drawing (.svg, .dxf) can be dropped anywhere on the page.",c=b("label",{className:"button",htmlFor:"which-files"},"Open files …"),u=b("div",{className:"opening choices"},b("label",{htmlFor:"which-design"},"design ",r),b("span",{className:"choosing"},o,c),b("label",{htmlFor:"which-unit",title:"for a FOLD file or a drawing without a unit"},"unit of a drawing ",a),b("p",{className:"note"},l));r.addEventListener("change",()=>t({design:r.value,files:[],unit:""})),o.addEventListener("change",async()=>{o.files.length&&await d([...o.files]),o.value=""}),a.addEventListener("change",()=>{h&&t({design:"",files:h,unit:a.value.trim()})});let h=null;async function d(f){let p=await Promise.all(f.map(async m=>({name:m.name,text:await m.text()})));h=rP(p),await t({design:"",files:h,unit:a.value.trim()})}return oP(d),{element:u,show({design:f,files:p}){r.querySelector(".sent")?.remove(),p.length&&r.append(b("option",{value:p[0].name,className:"sent"},p[0].name)),r.value=p.length?p[0].name:f,h=p.length?p:null}}}function rP(n){let e=n.filter(({name:i})=>/\.toml$/i.test(i)),t=e.find(({name:i})=>!e.some(s=>s.name!==i&&s.text.includes(i)))??n[0];return[t,...n.filter(i=>i!==t)]}function oP(n){let{body:e}=document,t=i=>{i.dataTransfer?.types.includes("Files")&&(i.preventDefault(),e.classList.add("dropping"))};e.addEventListener("dragenter",t),e.addEventListener("dragover",t),e.addEventListener("dragleave",i=>{i.relatedTarget||e.classList.remove("dropping")}),e.addEventListener("drop",i=>{e.classList.remove("dropping"),i.dataTransfer?.files.length&&(i.preventDefault(),n([...i.dataTransfer.files]))})}function q_(n,{button:e,text:t,title:i},s){let r=b("button",{type:"button",className:"try"},e),o=b("button",{type:"button",hidden:!0},"Stop"),a=b("p",{className:"note",role:"status"},t),l=b("div"),c=b("div",{className:"results"},b("div",{className:"offer"},r,o,a),l),u=null,h=null;async function d(){if(h)return;let m=s(),g=performance.now();h=new AbortController,r.disabled=!0,o.hidden=!1,a.textContent="Starting …";let x=!1;try{let _=await $u(n,m,h.signal,M=>{M.doing&&(a.textContent=`${M.doing} …`)});_.refused?a.textContent=`No result: ${_.refused}.`:f(_.done,m,(performance.now()-g)/1e3),x=!_.refused}catch{a.textContent="Stopped."}h=null,r.disabled=!1,o.hidden=!0,x&&p()}function f(m,g,x){u=JSON.stringify(g),a.textContent=`Done in ${x.toFixed(x<10?1:0)} s.`;let _=b("a",{href:m,target:"_blank",rel:"noopener"},"Open in a new window"),M=b("iframe",{src:m,title:i,sandbox:"allow-scripts allow-downloads"});l.replaceChildren(b("p",{},_),M)}function p(){u!==null&&!h&&u!==JSON.stringify(s())&&(a.textContent="This result belongs to the design before its last change.")}return r.addEventListener("click",d),o.addEventListener("click",()=>h?.abort()),{element:c,find:d,seen:p}}var aP=1500;function Y_(){let n=b("p",{role:"status"}),e=b("p",{className:"wrong",role:"alert"}),t=b("button",{type:"button",hidden:!0},"Stop building"),i=0,s=null;t.addEventListener("click",()=>s?.());function r(o,a=""){clearTimeout(i),t.hidden=!0,n.textContent=o,e.textContent=a}return{element:b("div",{className:"says"},n,t,e),wait(o,a){r(`${o} …`),s=a,a&&(i=setTimeout(()=>t.hidden=!1,aP))},done:o=>r(o),refuse:o=>r("",o.endsWith(".")?o:`${o}.`)}}function Z_(){let n=b("a",{className:"button"},"Download the design"),e=b("code"),t=b("pre",{tabIndex:0,role:"group","aria-label":"the command that runs it"},e);return{element:b("div",{className:"taking"},n,t),show(i){n.href=Xu(i.text,"application/toml"),n.download=`${i.name}.toml`,e.textContent=i.command}}}function K_(n){let e=b("div"),t=null;async function i(){let s=n();if(!s)return;let r=JSON.stringify(s);if(r===t)return;t=r,e.querySelector("img")||e.replaceChildren(b("p",{className:"note",role:"status"},"Drawing …"));let o=await As("pattern",s);if(t!==r)return;if(o.refused){e.replaceChildren(b("p",{className:"note",role:"status"},`No pattern is drawn: ${o.refused}.`));return}let a=b("img",{src:`data:image/svg+xml;base64,${o.drawing}`,alt:o.said}),l=(u,h,d)=>b("a",{className:"button",download:h,href:d},u),c=Xu(o.fold,"application/json");e.replaceChildren(b("figure",{className:"drawn"},a),b("p",{className:"choices"},l("Drawing as SVG","pattern.svg",a.src),l("Pattern as FOLD","pattern.fold",c)))}return{element:e,seen:i}}function J_(n){let e={},t=0;function i(){if(clearTimeout(t),!Object.keys(e).length)return;let s=e;return e={},n(s)}return{put(s,r){e[s]=r,clearTimeout(t),t=setTimeout(i,250)},hand:i}}function j_(n,e){let t=n.map(({name:o,title:a,element:l},c)=>{l.id=`view-${o}`,l.setAttribute("role","tabpanel"),l.setAttribute("aria-labelledby",`tab-${o}`);let u=b("button",{type:"button",id:`tab-${o}`,role:"tab","aria-controls":l.id},a);return u.addEventListener("click",()=>r(c)),u}),i=b("div",{className:"tabs",role:"tablist","aria-label":e},...t),s=0;function r(o){s=o;for(let[a,l]of t.entries())l.setAttribute("aria-selected",String(a===o)),l.tabIndex=a===o?0:-1,n[a].element.hidden=a!==o;n[o].seen?.()}return i.addEventListener("keydown",({key:o})=>{let a={ArrowRight:s+1,ArrowLeft:s-1,Home:0,End:t.length-1};o in a&&(r((a[o]+t.length)%t.length),t[s].focus())}),{element:b("div",{className:"views-of-bench"},i,...n.map(({element:o})=>o)),choose:o=>r(n.findIndex(a=>a.name===o)),name:(o,a)=>t[n.findIndex(l=>l.name===o)].textContent=a,seen:()=>n[s].seen?.()}}var Q_=.02,Vf=[["←","left","ArrowLeft",[-1,0]],["↑","up","ArrowUp",[0,1]],["↓","down","ArrowDown",[0,-1]],["→","right","ArrowRight",[1,0]]];function ey(n,{moving:e,shape:t,names:i,asked:s,held:r}){let o=b("p",{className:"note",role:"status"}),a=b("button",{type:"button","aria-pressed":"false",title:"drag panels as well; otherwise dragging a panel turns the picture"},"drag panels");a.addEventListener("click",()=>a.setAttribute("aria-pressed",String(a.getAttribute("aria-pressed")!=="true")));let l=null,c=!1,u=!0,h=!0;async function d(){if(c||!l)return;let{place:A,target:y}=l,S={...s(),weights:Object.fromEntries(A),target:y,begins:u};l=null,u=!1,c=!0;let P=await As("drag",S);c=!1,h||f(P),d()}function f(A){let y=A.refused?`Not dragged: ${A.refused}.`:A.text;A.points&&(e.hold($t(A.points,Float32Array)),r(!0)),x.say(y),o.textContent=y}function p(A,y){h&&(u=!0),h=!1,l={place:A,target:y.toArray()},d()}function m(){h=!0,l=null,e.hold(null),r(!1)}function g(A,y){if(a.getAttribute("aria-pressed")!=="true")return null;let S=new mr;S.setFromCamera(new qe(A,y),n.eye.camera);let{mesh:P}=e,L=null,I=[new H,new H,new H],O=new H,{vertices:k}=n.views[0].shape;for(let V=0;V<P.triangles.length;V+=3){let X=P.triangles.slice(V,V+3);for(let[oe,Z]of X.entries())I[oe].fromArray(k,3*Z);if(!S.ray.intersectTriangle(...I,!1,O))continue;let G=O.distanceTo(S.ray.origin);(!L||G<L.away)&&(L={away:G,numbers:X,shares:lP(O,...I)})}if(!L)return null;let N=new Map;for(let[V,X]of L.numbers.entries())for(let[G,oe]of[[P.between[2*X],1-P.share[X]],[P.between[2*X+1],P.share[X]]])oe&&N.set(G,(N.get(G)??0)+oe*L.shares[V]);return[...N]}let x=pu(n,{points:t,movable:i.map(A=>A!==null),between:g,moved:(A,y,S)=>p(A,S),left:m}),_=cP(n,t,i,p,m),M=b("p",{className:"note"},"Drag a vertex: the package computes the equilibrium with the springs of the creases, and the force that holds it."),v=b("div",{className:"drag"},M,o,_.element);return n.element.parentElement.querySelector(".views").prepend(b("span",{className:"panels"},a)),{element:v,end:_.end}}function lP(n,...e){let[t,i,s]=[e[1],e[2],n].map(d=>d.clone().sub(e[0])),[r,o,a,l,c]=[t.dot(t),t.dot(i),i.dot(i),s.dot(t),s.dot(i)],[u,h]=[a*l-o*c,r*c-o*l].map(d=>d/(r*a-o*o));return[1-u-h,u,h]}function cP(n,e,t,i,s){let r=t.map((m,g)=>[m,g]).filter(([m])=>m!==null),o=b("select",{},...r.map(([m,g])=>b("option",{value:g},m))),a=Vf.map(([m,g,x])=>b("button",{type:"button",title:`drag ${g}`,"aria-label":`drag ${g}`,"data-way":x},m)),l=b("span",{className:"pad",role:"group","aria-label":"drag in the plane of the picture"},...a),c=b("button",{type:"button"},"Release"),u=b("p",{className:"note"},"On these buttons, every arrow key drags the vertex by 2 % of the structure's size. It stays there until it is released."),h=null;function d([m,g]){let x=Number(o.value);h??=new H().fromArray(e(),3*x);let{camera:_,size:M}=n.eye;h.addScaledVector(new H().setFromMatrixColumn(_.matrixWorld,0),Q_*M*m),h.addScaledVector(new H().setFromMatrixColumn(_.matrixWorld,1),Q_*M*g),i([[x,1]],h)}function f(){h=null,s()}l.addEventListener("keydown",m=>{let g=Vf.find(([,,x])=>x===m.key);!g||m.shiftKey||m.ctrlKey||m.metaKey||m.altKey||(m.preventDefault(),m.stopPropagation(),d(g[3]))});for(let[m,g]of a.entries())g.addEventListener("click",()=>d(Vf[m][3]));return o.addEventListener("change",f),c.addEventListener("click",f),{element:b("details",{className:"push-keys"},b("summary",{},"Drag without a pointer"),b("div",{className:"choices"},b("label",{},"point ",o),l,c),u),end:f}}function ty(n){let e=new Set,t={start:n.start,end:n.end,origins:[0]},i=n.start,s=0;function r(){s||=requestAnimationFrame(()=>{s=0;for(let o of e)o()})}return{get time(){return i},span:t,clipTime:(o,a=i)=>Math.min(n.end,Math.max(n.start,a)),timeAt:o=>t.start+o*(t.end-t.start),wayAt:o=>(o-t.start)/(t.end-t.start||1),onChange(o){return e.add(o),r(),()=>e.delete(o)},seek(o){i=Math.min(t.end,Math.max(t.start,o)),r()}}}var Gf=100;function ny(){let n=b("p",{className:"note",role:"status"}),[e,t,i,s]=["","notes","",""].map(p=>b("div",{className:p})),r=b("div",{className:"folding"},n,e,t,i,s),o={element:r,whole:"structure",share:0,complete:!1,clock:null,path:null},a=null,l=null,c=null;Object.defineProperty(o,"look",{get:()=>c?.look}),o.show=(p,{fresh:m=!1,look:g}={})=>{o.leave(),m&&(o.share=0);let x=l=Object.assign(new AbortController,{wanted:p}),_=performance.now(),M=null;return new Promise(v=>{let E=A=>{A.picture&&(M=A.picture,o.whole=M.whole,(m||!c?.grow)&&h(M,g),a=p,o.complete=!1,n.textContent="Computing the fold path …",v({shown:!0})),A.path&&d(M,A.path,x),A.done&&(n.textContent=hP(o.path,(performance.now()-_)/1e3))};$u("fold",{...p,share:m?null:o.share},x.signal,E).then(({refused:A})=>{v({refused:A}),!(!A||l!==x)&&(M&&c?.grow&&h(M,g),M&&(n.textContent=`No fold path is shown: ${A}.`))},()=>v({refused:"building was stopped"}))})},o.shows=p=>c!==null&&JSON.stringify(a)===JSON.stringify(p),o.leave=()=>{l?.abort(),l=null},o.resume=()=>{!l||l.wanted===a||(o.leave(),a&&!o.complete&&o.show(a))},o.clear=()=>{o.leave(),u(),a=null};function u(){if(!c)return;let{look:p}=c;c.dispose(),c=null,o.clock=o.path=null;for(let m of[e,t,i,s])m.replaceChildren();return p}function h(p,m){let g=u()??m??Ks(),x=Zn(p.clips[0]),{stage:_}=hu(e,[x],ty(x),{...p,text:`${p.shape}, as built.`},{...g,following:!1});e.setAttribute("aria-label",`the ${p.whole} as built`),c={clip:()=>x,look:_?.eye.look??g,dispose:()=>_?.dispose()}}function d(p,m,g){let x=Zn({...p.clips[0],...m.clips[0]});o.path=m,c?.mine===g&&c.largest===m.energy.largest_J?c.grow(x,m):f(x,m,g,p.points),m.complete&&c.complete(m),o.complete=m.complete}function f(p,m,g,x){let _=e.contains(document.activeElement),M=c?.clip(),v=u()??Ks(),E=uP(p);M?.mesh.pointCount===p.mesh.pointCount&&E.lend(M);let A=Li([E],m.spans);A.seek(Gf*o.share);let y=js(e,[E],A,m,v,!1);y.stage?.eye.aim(),E.lend(null);let S=null,P=()=>{o.share!==A.time/Gf&&S?.end(),o.share=A.time/Gf},L=[()=>y.dispose(),A.onChange(P)];c={mine:g,clip:E.now,look:y.stage?.eye.look??v,largest:m.energy.largest_J,dispose:()=>L.forEach(I=>I()),grow(I){E.replace(I),A.redraw()},complete({plots:I,notes:O,energy:k,spans:N}){A.setSpan({...N[0]}),t.replaceChildren(...O.map(G=>b("p",{className:"note"},G)));let V=G=>{r.classList.toggle("pulled",G),A.redraw()};if(y.stage){let G=()=>E.pointsAt(A.clipTime(0));S=ey(y.stage,{moving:E,shape:G,names:x,asked:()=>({...a,share:o.share}),held:V}),(e.querySelector(".crease-choice")??e.querySelector(".transport")).after(S.element)}let X=nr(i,I,[E],A);L.push(()=>X.dispose(),Qs(s,E,A,k))}},Object.assign(o,{clock:A,stage:y.stage,moving:E,path:m}),_&&e.querySelector("input[type=range]").focus({preventScroll:!0})}return o}function uP(n){let e=n,t=null,i=null,s={now:()=>e,replace:r=>e=r,lend:r=>t=r,hold:r=>i=r,pointsAt(r,o){return i?o?(o.set(i),o):i:(t??e).pointsAt(r,o)},verticesAt:(r,o)=>i?e.verticesOf(i,o):e.verticesAt(r,o)};return new Proxy(s,{get:(r,o)=>s[o]??e[o]})}function hP(n,e){let t=`${e.toFixed(e<10?1:0)} s`;return n.reached?`The fold path was computed in ${t}.`:`The fold path was computed in ${t}; it does not reach its goal.`}var iy=[["live","simulated in time"],["fold","slowly along its path"]];function ry(n,e,t){let i=b("div"),s=ny(),r={element:i,fold:s,panel:null,whole:"structure",refused:"",engine:null},o="live",a=null,l,c;function u(){let x=r.panel?.stage?.eye.look;l=x?{...x,closer:x.closer/mu}:s.look??l,c=r.panel?.pace??c}function h(){u(),r.panel?.leave(),r.panel=null}r.begin=async(x,_)=>{if(!_&&r.panel)return{};let M=await s.show(x,{fresh:_,look:l});return M.shown&&(h(),r.whole=s.whole,i.contains(s.element)||i.replaceChildren(s.element)),M},r.resume=()=>s.resume(),r.show=async x=>{a=x,r.whole=a.bench?.whole??s.whole,r.refused=a.live.refused??"",!r.refused&&o==="live"?await d():await f()};async function d(){let{bench:x,live:_,warnings:M}=a;u();try{let v=await Ao(Zn(x.clips[0]),x,JSON.stringify(_),m,{look:dP(l),pace:c,set:e});h(),s.clear(),i.replaceChildren(p(),v.element,...sy(M)),v.begin(),r.panel=v}catch(v){r.engine?.end(),r.engine=null,r.refused=v.message,await f()}}async function f(){h(),i.replaceChildren(...r.refused?[]:[p()],s.element,...r.refused?[g()]:[],...sy(a.warnings)),s.shows(n())||await s.show(n(),{look:l})}function p(){let x=iy.map(([M,v])=>{let E=b("button",{type:"button",title:v,"aria-pressed":String(M===o)},M);return E.addEventListener("click",async()=>{M!==o&&(o=M,await(M==="live"?d():f()),[...i.querySelectorAll(".modes button")].find(A=>A.textContent===o)?.focus())}),E}),_=iy.map(([M,v])=>`${M}: ${v}`).join(" · ");return b("div",{className:"colours modes",role:"group","aria-label":`how the ${r.whole} moves`},b("span",{},...x),_)}async function m(x,_){return r.engine?r.engine.take(x,_):(r.engine=await Mo(x,_),r.engine)}function g(){let x=b("p",{className:"note"},`The motion in time is not simulated in this page: ${r.refused}. The package simulates it.`),_=b("button",{type:"button"},"Run it");return _.addEventListener("click",t),b("div",{className:"offer"},_,x)}return r}var dP=n=>n&&{...n,following:!1,closer:mu*n.closer};function sy(n){if(!n.length)return[];let e=t=>`${t.replace(/^[a-z](?=\S* )/,i=>i.toUpperCase()).replace(/\.$/,"")}.`;return[b("h2",{},"What to know"),b("ul",{className:"warnings"},...n.map(t=>b("li",{},e(t))))]}var fP={landscape:{button:"Compute it",text:"Statics computes the equilibria, the barriers between them, and the motion under the drives.",title:"landscape"},run:{button:"Run it",text:"The package simulates the protocol, checks the energy balance and reports the outcome.",title:"run"}};async function oy(n){let e=Y_(),t=Promise.resolve(),i=p=>t=t.then(p).catch(m=>e.refuse(m.message)),s=V_({says:e,reply:h,picture:(p,m)=>c.wing.begin(p,m),model:d,resume:()=>c.wing.resume()}),r=J_(p=>i(()=>s.slide(p))),o=p=>i(()=>s.open(p,{})),a=X_(n.designs,n.opened,o),l=$_((p,m)=>{r.hand(),i(()=>s.change(p,m))}),c=mP(s,r,o),u=Z_();function h({asked:p,base:m,reply:g,rejected:x}){document.title=`${g.title}: workbench`,document.querySelector("h1").textContent=g.title,a.show(p),l.show(g,p.settings,m);for(let[_,{text:M,why:v}]of x)l.reject(_,M,v);c.file.show(g),u.show(g),c.tabs.seen()}async function d(p){await c.wing.show(p),c.tabs.name("wing",kt(c.wing.whole))}let f=b("div",{className:"masthead"},a.element,u.element,e.element);return document.getElementById("workbench").append(f,l.element,c.tabs.element),c.tabs.choose("wing"),await i(()=>pP(s,n)),Object.assign(s,{wing:c.wing,idle:()=>t})}async function pP(n,e){let t=G_();t&&!await n.open({design:t.design,files:t.files,unit:t.unit},t.settings)||await n.open({design:"",files:[],unit:""},e.settings)}function mP(n,e,t){let i=()=>n.asked,s=Object.fromEntries(Object.entries(fP).map(([c,u])=>[c,q_(c,u,i)])),r=ry(i,e.put,()=>{l.choose("run"),s.run.find()}),o=K_(i),a=H_(c=>t({design:"",files:[{name:`${n.reply?.name??"design"}.toml`,text:c}],unit:""})),l=j_([{name:"wing",title:"Structure",element:r.element},{name:"sheet",title:"Pattern",...o},{name:"landscape",title:"Landscape",...s.landscape},{name:"run",title:"Run",...s.run},{name:"file",title:"File",element:a.element}],"views of the design");return{tabs:l,wing:r,file:a}}var gP={run:Ff,compare:Lx,curves:Ff,study:u_,goals:h_,parts:N_,bench:i0,workbench:oy},Hf=JSON.parse(document.getElementById("data").textContent);cp(Hf.reading_units);function ay(n){let e=`Moving pictures cannot be shown in this browser (${n.message}); all numbers are below.`;throw document.querySelector("main").prepend(b("p",{className:"note",role:"alert"},e)),n}function ly(n){window.forficula=n}try{let n=gP[Hf.kind](Hf);n instanceof Promise?n.then(ly,ay):ly(n)}catch(n){ay(n)}wo();})();
