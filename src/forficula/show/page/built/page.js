/* forficula, MIT; with three.js and uPlot, MIT: see LICENSES.txt; sources d98c436085b746573db8d5804c84f5904a9975e334acd53f256257fdc0668160 */
(()=>{function W(n,t={},...e){let i=document.createElement(n);for(let[s,r]of Object.entries(t))s.includes("-")||s==="role"?i.setAttribute(s,r):i[s]=r;return i.append(...e),i}function rd(n){let t="http://www.w3.org/2000/svg",e=document.createElementNS(t,"svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidden","true");let i=document.createElementNS(t,"path");return i.setAttribute("d",n),e.append(i),e}function qs({colour:n,dash:t}){let e="http://www.w3.org/2000/svg",i=document.createElementNS(e,"svg");i.setAttribute("viewBox","0 0 24 8"),i.setAttribute("aria-hidden","true"),i.classList.add("sample");let s=document.createElementNS(e,"path");return s.setAttribute("d","M0 4H24"),s.setAttribute("stroke",n),s.setAttribute("stroke-dasharray",t.join(" ")),i.append(s),i}var Is={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Ls={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Fd=0,$h=1,Od=2;var ca=1,Bd=2,jr=3,Ds=0,Hn=1,qn=2,tr=0,Qr=1,Zh=2,Kh=3,Jh=4,kd=5;var er=100,zd=101,Vd=102,Gd=103,Hd=104,Wd=200,Xd=201,qd=202,Yd=203,jh=204,Qh=205,$d=206,Zd=207,Kd=208,Jd=209,jd=210,Qd=211,tp=212,ep=213,np=214,ll=0,cl=1,hl=2,Vr=3,ul=4,fl=5,dl=6,pl=7,zl=0,ip=1,sp=2,Hi=0,tu=1,eu=2,nu=3,iu=4,su=5,ru=6,ou=7;var au=300,nr=301,to=302,Vl=303,Gl=304,ml=1e3,ki=1001,gl=1002,wn=1003,rp=1004;var ha=1005;var zn=1006,Hl=1007;var cs=1008;var Yn=1009,lu=1010,cu=1011,eo=1012,Wl=1013,Ti=1014,mi=1015,Ai=1016,Xl=1017,ql=1018,ir=1020,hu=35902,uu=35899,fu=1021,du=1022,Ei=1023,ss=1026,hs=1027,Yl=1028,$l=1029,Ns=1030,Zl=1031;var Kl=1033,ua=33776,fa=33777,da=33778,pa=33779,Jl=35840,jl=35841,Ql=35842,tc=35843,ec=36196,nc=37492,ic=37496,sc=37488,rc=37489,ma=37490,oc=37491,ac=37808,lc=37809,cc=37810,hc=37811,uc=37812,fc=37813,dc=37814,pc=37815,mc=37816,gc=37817,_c=37818,xc=37819,yc=37820,vc=37821,Sc=36492,Mc=36494,bc=36495,wc=36283,Tc=36284,ga=36285,Ac=36286;var ko=2300,_l=2301,ol=2302,Vh=2303,Gh=2400,Hh=2401,Wh=2402;var op=3200;var Ec=0,ap=1,us="",ei="srgb",zo="srgb-linear",Vo="linear",we="srgb";var al=7680,pu=7681;var mu=517;var lp=519,cp=512,hp=513,up=514,gu=515,fp=516,dp=517,_u=518,xu=519,pp=35044,_a=35048;var yu="300 es",pi=2e3,Gr=2001;function q0(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function Y0(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Go(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function mp(){let n=Go("canvas");return n.style.display="block",n}var od={},Hr=null;function vu(...n){let t="THREE."+n.shift();Hr?Hr("log",t,...n):console.log(t,...n)}function gp(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function qt(...n){n=gp(n);let t="THREE."+n.shift();if(Hr)Hr("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function Qt(...n){n=gp(n);let t="THREE."+n.shift();if(Hr)Hr("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function Fo(...n){let t=n.join(" ");t in od||(od[t]=!0,qt(...n))}function _p(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var xp={[ll]:ll,[hl]:dl,[ul]:ul,[Vr]:fl,[cl]:cl,[dl]:hl,[pl]:pl,[fl]:Vr},wi=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Pn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],ad=1234567,Oo=Math.PI/180,Wr=180/Math.PI;function no(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Pn[n&255]+Pn[n>>8&255]+Pn[n>>16&255]+Pn[n>>24&255]+"-"+Pn[t&255]+Pn[t>>8&255]+"-"+Pn[t>>16&15|64]+Pn[t>>24&255]+"-"+Pn[e&63|128]+Pn[e>>8&255]+"-"+Pn[e>>16&255]+Pn[e>>24&255]+Pn[i&255]+Pn[i>>8&255]+Pn[i>>16&255]+Pn[i>>24&255]).toLowerCase()}function de(n,t,e){return Math.max(t,Math.min(e,n))}function Su(n,t){return(n%t+t)%t}function $0(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function Z0(n,t,e){return n!==t?(e-n)/(t-n):0}function Bo(n,t,e){return(1-e)*n+e*t}function K0(n,t,e,i){return Bo(n,t,1-Math.exp(-e*i))}function J0(n,t=1){return t-Math.abs(Su(n,t*2)-t)}function j0(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function Q0(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function t_(n,t){return n+Math.floor(Math.random()*(t-n+1))}function e_(n,t){return n+Math.random()*(t-n)}function n_(n){return n*(.5-Math.random())}function i_(n){n!==void 0&&(ad=n);let t=ad+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function s_(n){return n*Oo}function r_(n){return n*Wr}function o_(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function a_(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Mu(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function l_(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),u=o((t+i)/2),h=r((t-i)/2),f=o((t-i)/2),d=r((i-t)/2),g=o((i-t)/2);switch(s){case"XYX":n.set(a*u,l*h,l*f,a*c);break;case"YZY":n.set(l*f,a*u,l*h,a*c);break;case"ZXZ":n.set(l*h,l*f,a*u,a*c);break;case"XZX":n.set(a*u,l*g,l*d,a*c);break;case"YXY":n.set(l*d,a*u,l*g,a*c);break;case"ZYZ":n.set(l*g,l*d,a*u,a*c);break;default:qt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function bu(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function yp(n,t){if(t.constructor===Float32Array)return n;let e=bu(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function vp(n,t){if(t.constructor===Float32Array)return n;let e=bu(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var wu={DEG2RAD:Oo,RAD2DEG:Wr,generateUUID:no,clamp:de,euclideanModulo:Su,mapLinear:$0,inverseLerp:Z0,lerp:Bo,damp:K0,pingpong:J0,smoothstep:j0,smootherstep:Q0,randInt:t_,randFloat:e_,randFloatSpread:n_,seededRandom:i_,degToRad:s_,radToDeg:r_,isPowerOfTwo:o_,ceilPowerOfTwo:a_,floorPowerOfTwo:Mu,setQuaternionFromProperEuler:l_,normalize:vp,denormalize:yp},Jt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=de(this.x,t.x,e.x),this.y=de(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=de(this.x,t,e),this.y=de(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(de(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(de(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},si=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],f=r[o+0],d=r[o+1],g=r[o+2],y=r[o+3];if(h!==y||l!==f||c!==d||u!==g){let m=l*f+c*d+u*g+h*y;m<0&&(f=-f,d=-d,g=-g,y=-y,m=-m);let p=1-a;if(m<.9995){let _=Math.acos(m),E=Math.sin(_);p=Math.sin(p*_)/E,a=Math.sin(a*_)/E,l=l*p+f*a,c=c*p+d*a,u=u*p+g*a,h=h*p+y*a}else{l=l*p+f*a,c=c*p+d*a,u=u*p+g*a,h=h*p+y*a;let _=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=_,c*=_,u*=_,h*=_}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],f=r[o+1],d=r[o+2],g=r[o+3];return t[e]=a*g+u*h+l*d-c*f,t[e+1]=l*g+u*f+c*h-a*d,t[e+2]=c*g+u*d+a*f-l*h,t[e+3]=u*g-a*h-l*f-c*d,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),f=l(i/2),d=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=f*u*h+c*d*g,this._y=c*d*h-f*u*g,this._z=c*u*g+f*d*h,this._w=c*u*h-f*d*g;break;case"YXZ":this._x=f*u*h+c*d*g,this._y=c*d*h-f*u*g,this._z=c*u*g-f*d*h,this._w=c*u*h+f*d*g;break;case"ZXY":this._x=f*u*h-c*d*g,this._y=c*d*h+f*u*g,this._z=c*u*g+f*d*h,this._w=c*u*h-f*d*g;break;case"ZYX":this._x=f*u*h-c*d*g,this._y=c*d*h+f*u*g,this._z=c*u*g-f*d*h,this._w=c*u*h+f*d*g;break;case"YZX":this._x=f*u*h+c*d*g,this._y=c*d*h+f*u*g,this._z=c*u*g-f*d*h,this._w=c*u*h-f*d*g;break;case"XZY":this._x=f*u*h-c*d*g,this._y=c*d*h-f*u*g,this._z=c*u*g+f*d*h,this._w=c*u*h+f*d*g;break;default:qt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],h=e[10],f=i+a+h;if(f>0){let d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(u-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(i>a&&i>h){let d=2*Math.sqrt(1+i-a-h);this._w=(u-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>h){let d=2*Math.sqrt(1+a-i-h);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+u)/d}else{let d=2*Math.sqrt(1+h-i-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(de(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,e=Math.sin(e*c)/u,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},X=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(ld.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(ld.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),u=2*(a*e-r*s),h=2*(r*i-o*e);return this.x=e+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=de(this.x,t.x,e.x),this.y=de(this.y,t.y,e.y),this.z=de(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=de(this.x,t,e),this.y=de(this.y,t,e),this.z=de(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(de(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return vh.copy(this).projectOnVector(t),this.sub(vh)}reflect(t){return this.sub(vh.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(de(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},vh=new X,ld=new si,te=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],f=i[2],d=i[5],g=i[8],y=s[0],m=s[3],p=s[6],_=s[1],E=s[4],S=s[7],C=s[2],b=s[5],x=s[8];return r[0]=o*y+a*_+l*C,r[3]=o*m+a*E+l*b,r[6]=o*p+a*S+l*x,r[1]=c*y+u*_+h*C,r[4]=c*m+u*E+h*b,r[7]=c*p+u*S+h*x,r[2]=f*y+d*_+g*C,r[5]=f*m+d*E+g*b,r[8]=f*p+d*S+g*x,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=u*o-a*c,f=a*l-u*r,d=c*r-o*l,g=e*h+i*f+s*d;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/g;return t[0]=h*y,t[1]=(s*c-u*i)*y,t[2]=(a*i-s*o)*y,t[3]=f*y,t[4]=(u*e-s*l)*y,t[5]=(s*r-a*e)*y,t[6]=d*y,t[7]=(i*l-c*e)*y,t[8]=(o*e-i*r)*y,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return Fo("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Sh.makeScale(t,e)),this}rotate(t){return Fo("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Sh.makeRotation(-t)),this}translate(t,e){return Fo("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Sh.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Sh=new te,cd=new te().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),hd=new te().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function c_(){let n={enabled:!0,workingColorSpace:zo,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===we&&(s.r=is(s.r),s.g=is(s.g),s.b=is(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===we&&(s.r=zr(s.r),s.g=zr(s.g),s.b=zr(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===us?Vo:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[zo]:{primaries:t,whitePoint:i,transfer:Vo,toXYZ:cd,fromXYZ:hd,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:ei},outputColorSpaceConfig:{drawingBufferColorSpace:ei}},[ei]:{primaries:t,whitePoint:i,transfer:we,toXYZ:cd,fromXYZ:hd,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:ei}}}),n}var ge=c_();function is(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function zr(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Ar,xl=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{Ar===void 0&&(Ar=Go("canvas")),Ar.width=t.width,Ar.height=t.height;let s=Ar.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=Ar}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=Go("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=is(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(is(e[i]/255)*255):e[i]=is(e[i]);return{data:e,width:t.width,height:t.height}}else return qt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},h_=0,Xr=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:h_++}),this.uuid=no(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Mh(s[o].image)):r.push(Mh(s[o]))}else r=Mh(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function Mh(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?xl.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(qt("Texture: Unable to serialize Texture."),{})}var u_=0,bh=new X,Xn=class n extends wi{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=ki,s=ki,r=zn,o=cs,a=Ei,l=Yn,c=n.DEFAULT_ANISOTROPY,u=us){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:u_++}),this.uuid=no(),this.name="",this.source=new Xr(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Jt(0,0),this.repeat=new Jt(1,1),this.center=new Jt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new te,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(bh).x}get height(){return this.source.getSize(bh).y}get depth(){return this.source.getSize(bh).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){qt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){qt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==au)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case ml:t.x=t.x-Math.floor(t.x);break;case ki:t.x=t.x<0?0:1;break;case gl:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case ml:t.y=t.y-Math.floor(t.y);break;case ki:t.y=t.y<0?0:1;break;case gl:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Xn.DEFAULT_IMAGE=null;Xn.DEFAULT_MAPPING=au;Xn.DEFAULT_ANISOTROPY=1;var We=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],u=l[4],h=l[8],f=l[1],d=l[5],g=l[9],y=l[2],m=l[6],p=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-y)<.01&&Math.abs(g-m)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+y)<.1&&Math.abs(g+m)<.1&&Math.abs(c+d+p-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let E=(c+1)/2,S=(d+1)/2,C=(p+1)/2,b=(u+f)/4,x=(h+y)/4,T=(g+m)/4;return E>S&&E>C?E<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(E),s=b/i,r=x/i):S>C?S<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),i=b/s,r=T/s):C<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),i=x/r,s=T/r),this.set(i,s,r,e),this}let _=Math.sqrt((m-g)*(m-g)+(h-y)*(h-y)+(f-u)*(f-u));return Math.abs(_)<.001&&(_=1),this.x=(m-g)/_,this.y=(h-y)/_,this.z=(f-u)/_,this.w=Math.acos((c+d+p-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=de(this.x,t.x,e.x),this.y=de(this.y,t.y,e.y),this.z=de(this.z,t.z,e.z),this.w=de(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=de(this.x,t,e),this.y=de(this.y,t,e),this.z=de(this.z,t,e),this.w=de(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(de(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},yl=class extends wi{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:zn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new We(0,0,t,e),this.scissorTest=!1,this.viewport=new We(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Xn({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:zn,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new Xr(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},ri=class extends yl{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},Ho=class extends Xn{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=wn,this.minFilter=wn,this.wrapR=ki,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var vl=class extends Xn{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=wn,this.minFilter=wn,this.wrapR=ki,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Ie=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,l,c,u,h,f,d,g,y,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,u,h,f,d,g,y,m)}set(t,e,i,s,r,o,a,l,c,u,h,f,d,g,y,m){let p=this.elements;return p[0]=t,p[4]=e,p[8]=i,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=u,p[10]=h,p[14]=f,p[3]=d,p[7]=g,p[11]=y,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/Er.setFromMatrixColumn(t,0).length(),r=1/Er.setFromMatrixColumn(t,1).length(),o=1/Er.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(t.order==="XYZ"){let f=o*u,d=o*h,g=a*u,y=a*h;e[0]=l*u,e[4]=-l*h,e[8]=c,e[1]=d+g*c,e[5]=f-y*c,e[9]=-a*l,e[2]=y-f*c,e[6]=g+d*c,e[10]=o*l}else if(t.order==="YXZ"){let f=l*u,d=l*h,g=c*u,y=c*h;e[0]=f+y*a,e[4]=g*a-d,e[8]=o*c,e[1]=o*h,e[5]=o*u,e[9]=-a,e[2]=d*a-g,e[6]=y+f*a,e[10]=o*l}else if(t.order==="ZXY"){let f=l*u,d=l*h,g=c*u,y=c*h;e[0]=f-y*a,e[4]=-o*h,e[8]=g+d*a,e[1]=d+g*a,e[5]=o*u,e[9]=y-f*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let f=o*u,d=o*h,g=a*u,y=a*h;e[0]=l*u,e[4]=g*c-d,e[8]=f*c+y,e[1]=l*h,e[5]=y*c+f,e[9]=d*c-g,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let f=o*l,d=o*c,g=a*l,y=a*c;e[0]=l*u,e[4]=y-f*h,e[8]=g*h+d,e[1]=h,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=d*h+g,e[10]=f-y*h}else if(t.order==="XZY"){let f=o*l,d=o*c,g=a*l,y=a*c;e[0]=l*u,e[4]=-h,e[8]=c*u,e[1]=f*h+y,e[5]=o*u,e[9]=d*h-g,e[2]=g*h-d,e[6]=a*u,e[10]=y*h+f}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(f_,t,d_)}lookAt(t,e,i){let s=this.elements;return Qn.subVectors(t,e),Qn.lengthSq()===0&&(Qn.z=1),Qn.normalize(),Ss.crossVectors(i,Qn),Ss.lengthSq()===0&&(Math.abs(i.z)===1?Qn.x+=1e-4:Qn.z+=1e-4,Qn.normalize(),Ss.crossVectors(i,Qn)),Ss.normalize(),Oa.crossVectors(Qn,Ss),s[0]=Ss.x,s[4]=Oa.x,s[8]=Qn.x,s[1]=Ss.y,s[5]=Oa.y,s[9]=Qn.y,s[2]=Ss.z,s[6]=Oa.z,s[10]=Qn.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],f=i[9],d=i[13],g=i[2],y=i[6],m=i[10],p=i[14],_=i[3],E=i[7],S=i[11],C=i[15],b=s[0],x=s[4],T=s[8],L=s[12],P=s[1],R=s[5],F=s[9],k=s[13],N=s[2],V=s[6],Y=s[10],G=s[14],lt=s[3],K=s[7],Q=s[11],it=s[15];return r[0]=o*b+a*P+l*N+c*lt,r[4]=o*x+a*R+l*V+c*K,r[8]=o*T+a*F+l*Y+c*Q,r[12]=o*L+a*k+l*G+c*it,r[1]=u*b+h*P+f*N+d*lt,r[5]=u*x+h*R+f*V+d*K,r[9]=u*T+h*F+f*Y+d*Q,r[13]=u*L+h*k+f*G+d*it,r[2]=g*b+y*P+m*N+p*lt,r[6]=g*x+y*R+m*V+p*K,r[10]=g*T+y*F+m*Y+p*Q,r[14]=g*L+y*k+m*G+p*it,r[3]=_*b+E*P+S*N+C*lt,r[7]=_*x+E*R+S*V+C*K,r[11]=_*T+E*F+S*Y+C*Q,r[15]=_*L+E*k+S*G+C*it,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],h=t[6],f=t[10],d=t[14],g=t[3],y=t[7],m=t[11],p=t[15],_=l*d-c*f,E=a*d-c*h,S=a*f-l*h,C=o*d-c*u,b=o*f-l*u,x=o*h-a*u;return e*(y*_-m*E+p*S)-i*(g*_-m*C+p*b)+s*(g*E-y*C+p*x)-r*(g*S-y*b+m*x)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],u=t[10];return e*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=t[9],f=t[10],d=t[11],g=t[12],y=t[13],m=t[14],p=t[15],_=e*a-i*o,E=e*l-s*o,S=e*c-r*o,C=i*l-s*a,b=i*c-r*a,x=s*c-r*l,T=u*y-h*g,L=u*m-f*g,P=u*p-d*g,R=h*m-f*y,F=h*p-d*y,k=f*p-d*m,N=_*k-E*F+S*R+C*P-b*L+x*T;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/N;return t[0]=(a*k-l*F+c*R)*V,t[1]=(s*F-i*k-r*R)*V,t[2]=(y*x-m*b+p*C)*V,t[3]=(f*b-h*x-d*C)*V,t[4]=(l*P-o*k-c*L)*V,t[5]=(e*k-s*P+r*L)*V,t[6]=(m*S-g*x-p*E)*V,t[7]=(u*x-f*S+d*E)*V,t[8]=(o*F-a*P+c*T)*V,t[9]=(i*P-e*F-r*T)*V,t[10]=(g*b-y*S+p*_)*V,t[11]=(h*S-u*b-d*_)*V,t[12]=(a*L-o*R-l*T)*V,t[13]=(e*R-i*L+s*T)*V,t[14]=(y*E-g*C-m*_)*V,t[15]=(u*C-h*E+f*_)*V,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,u=o+o,h=a+a,f=r*c,d=r*u,g=r*h,y=o*u,m=o*h,p=a*h,_=l*c,E=l*u,S=l*h,C=i.x,b=i.y,x=i.z;return s[0]=(1-(y+p))*C,s[1]=(d+S)*C,s[2]=(g-E)*C,s[3]=0,s[4]=(d-S)*b,s[5]=(1-(f+p))*b,s[6]=(m+_)*b,s[7]=0,s[8]=(g+E)*x,s[9]=(m-_)*x,s[10]=(1-(f+y))*x,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=Er.set(s[0],s[1],s[2]).length(),a=Er.set(s[4],s[5],s[6]).length(),l=Er.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Si.copy(this);let c=1/o,u=1/a,h=1/l;return Si.elements[0]*=c,Si.elements[1]*=c,Si.elements[2]*=c,Si.elements[4]*=u,Si.elements[5]*=u,Si.elements[6]*=u,Si.elements[8]*=h,Si.elements[9]*=h,Si.elements[10]*=h,e.setFromRotationMatrix(Si),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=pi,l=!1){let c=this.elements,u=2*r/(e-t),h=2*r/(i-s),f=(e+t)/(e-t),d=(i+s)/(i-s),g,y;if(l)g=r/(o-r),y=o*r/(o-r);else if(a===pi)g=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===Gr)g=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=h,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=pi,l=!1){let c=this.elements,u=2/(e-t),h=2/(i-s),f=-(e+t)/(e-t),d=-(i+s)/(i-s),g,y;if(l)g=1/(o-r),y=o/(o-r);else if(a===pi)g=-2/(o-r),y=-(o+r)/(o-r);else if(a===Gr)g=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=h,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},Er=new X,Si=new Ie,f_=new X(0,0,0),d_=new X(1,1,1),Ss=new X,Oa=new X,Qn=new X,ud=new Ie,fd=new si,rs=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],f=s[6],d=s[10];switch(e){case"XYZ":this._y=Math.asin(de(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-de(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(de(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-de(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(de(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-de(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:qt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return ud.makeRotationFromQuaternion(t),this.setFromRotationMatrix(ud,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return fd.setFromEuler(this),this.setFromQuaternion(fd,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};rs.DEFAULT_ORDER="XYZ";var Wo=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},p_=0,dd=new X,Cr=new si,ji=new Ie,Ba=new X,Ro=new X,m_=new X,g_=new si,pd=new X(1,0,0),md=new X(0,1,0),gd=new X(0,0,1),_d={type:"added"},__={type:"removed"},Rr={type:"childadded",child:null},wh={type:"childremoved",child:null},En=class n extends wi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:p_++}),this.uuid=no(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new X,e=new rs,i=new si,s=new X(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Ie},normalMatrix:{value:new te}}),this.matrix=new Ie,this.matrixWorld=new Ie,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Wo,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Cr.setFromAxisAngle(t,e),this.quaternion.multiply(Cr),this}rotateOnWorldAxis(t,e){return Cr.setFromAxisAngle(t,e),this.quaternion.premultiply(Cr),this}rotateX(t){return this.rotateOnAxis(pd,t)}rotateY(t){return this.rotateOnAxis(md,t)}rotateZ(t){return this.rotateOnAxis(gd,t)}translateOnAxis(t,e){return dd.copy(t).applyQuaternion(this.quaternion),this.position.add(dd.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(pd,t)}translateY(t){return this.translateOnAxis(md,t)}translateZ(t){return this.translateOnAxis(gd,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(ji.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?Ba.copy(t):Ba.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Ro.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ji.lookAt(Ro,Ba,this.up):ji.lookAt(Ba,Ro,this.up),this.quaternion.setFromRotationMatrix(ji),s&&(ji.extractRotation(s.matrixWorld),Cr.setFromRotationMatrix(ji),this.quaternion.premultiply(Cr.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(Qt("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(_d),Rr.child=t,this.dispatchEvent(Rr),Rr.child=null):Qt("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(__),wh.child=t,this.dispatchEvent(wh),wh.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),ji.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),ji.multiply(t.parent.matrixWorld)),t.applyMatrix4(ji),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(_d),Rr.child=t,this.dispatchEvent(Rr),Rr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ro,t,m_),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ro,g_,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(t.shapes,h)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),h=o(t.shapes),f=o(t.skeletons),d=o(t.animations),g=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),f.length>0&&(i.skeletons=f),d.length>0&&(i.animations=d),g.length>0&&(i.nodes=g)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};En.DEFAULT_UP=new X(0,1,0);En.DEFAULT_MATRIX_AUTO_UPDATE=!0;En.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var ii=class extends En{constructor(){super(),this.isGroup=!0,this.type="Group"}},x_={type:"move"},qr=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new ii,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new ii,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new X,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new X),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new ii,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new X,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new X,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let y of t.hand.values()){let m=e.getJointPose(y,i),p=this._getHandJoint(c,y);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),d=.02,g=.005;c.inputState.pinching&&f>d+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&f<=d-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(x_)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new ii;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},Sp={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ms={h:0,s:0,l:0},ka={h:0,s:0,l:0};function Th(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var ee=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=ei){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,ge.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=ge.workingColorSpace){return this.r=t,this.g=e,this.b=i,ge.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=ge.workingColorSpace){if(t=Su(t,1),e=de(e,0,1),i=de(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=Th(o,r,t+1/3),this.g=Th(o,r,t),this.b=Th(o,r,t-1/3)}return ge.colorSpaceToWorking(this,s),this}setStyle(t,e=ei){function i(r){r!==void 0&&parseFloat(r)<1&&qt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:qt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);qt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=ei){let i=Sp[t.toLowerCase()];return i!==void 0?this.setHex(i,e):qt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=is(t.r),this.g=is(t.g),this.b=is(t.b),this}copyLinearToSRGB(t){return this.r=zr(t.r),this.g=zr(t.g),this.b=zr(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=ei){return ge.workingToColorSpace(In.copy(this),t),Math.round(de(In.r*255,0,255))*65536+Math.round(de(In.g*255,0,255))*256+Math.round(de(In.b*255,0,255))}getHexString(t=ei){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=ge.workingColorSpace){ge.workingToColorSpace(In.copy(this),e);let i=In.r,s=In.g,r=In.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=ge.workingColorSpace){return ge.workingToColorSpace(In.copy(this),e),t.r=In.r,t.g=In.g,t.b=In.b,t}getStyle(t=ei){ge.workingToColorSpace(In.copy(this),t);let e=In.r,i=In.g,s=In.b;return t!==ei?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(Ms),this.setHSL(Ms.h+t,Ms.s+e,Ms.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(Ms),t.getHSL(ka);let i=Bo(Ms.h,ka.h,e),s=Bo(Ms.s,ka.s,e),r=Bo(Ms.l,ka.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},In=new ee;ee.NAMES=Sp;var Xo=class extends En{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new rs,this.environmentIntensity=1,this.environmentRotation=new rs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Mi=new X,Qi=new X,Ah=new X,ts=new X,Pr=new X,Ir=new X,xd=new X,Eh=new X,Ch=new X,Rh=new X,Ph=new We,Ih=new We,Lh=new We,As=class n{constructor(t=new X,e=new X,i=new X){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),Mi.subVectors(t,e),s.cross(Mi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){Mi.subVectors(s,e),Qi.subVectors(i,e),Ah.subVectors(t,e);let o=Mi.dot(Mi),a=Mi.dot(Qi),l=Mi.dot(Ah),c=Qi.dot(Qi),u=Qi.dot(Ah),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let f=1/h,d=(c*l-a*u)*f,g=(o*u-a*l)*f;return r.set(1-d-g,g,d)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,ts)===null?!1:ts.x>=0&&ts.y>=0&&ts.x+ts.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,ts)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ts.x),l.addScaledVector(o,ts.y),l.addScaledVector(a,ts.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return Ph.setScalar(0),Ih.setScalar(0),Lh.setScalar(0),Ph.fromBufferAttribute(t,e),Ih.fromBufferAttribute(t,i),Lh.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(Ph,r.x),o.addScaledVector(Ih,r.y),o.addScaledVector(Lh,r.z),o}static isFrontFacing(t,e,i,s){return Mi.subVectors(i,e),Qi.subVectors(t,e),Mi.cross(Qi).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Mi.subVectors(this.c,this.b),Qi.subVectors(this.a,this.b),Mi.cross(Qi).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;Pr.subVectors(s,i),Ir.subVectors(r,i),Eh.subVectors(t,i);let l=Pr.dot(Eh),c=Ir.dot(Eh);if(l<=0&&c<=0)return e.copy(i);Ch.subVectors(t,s);let u=Pr.dot(Ch),h=Ir.dot(Ch);if(u>=0&&h<=u)return e.copy(s);let f=l*h-u*c;if(f<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),e.copy(i).addScaledVector(Pr,o);Rh.subVectors(t,r);let d=Pr.dot(Rh),g=Ir.dot(Rh);if(g>=0&&d<=g)return e.copy(r);let y=d*c-l*g;if(y<=0&&c>=0&&g<=0)return a=c/(c-g),e.copy(i).addScaledVector(Ir,a);let m=u*g-d*h;if(m<=0&&h-u>=0&&d-g>=0)return xd.subVectors(r,s),a=(h-u)/(h-u+(d-g)),e.copy(s).addScaledVector(xd,a);let p=1/(m+y+f);return o=y*p,a=f*p,e.copy(i).addScaledVector(Pr,o).addScaledVector(Ir,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},zi=class{constructor(t=new X(1/0,1/0,1/0),e=new X(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(bi.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(bi.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=bi.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,bi):bi.fromBufferAttribute(r,o),bi.applyMatrix4(t.matrixWorld),this.expandByPoint(bi);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),za.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),za.copy(i.boundingBox)),za.applyMatrix4(t.matrixWorld),this.union(za)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,bi),bi.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Po),Va.subVectors(this.max,Po),Lr.subVectors(t.a,Po),Dr.subVectors(t.b,Po),Nr.subVectors(t.c,Po),bs.subVectors(Dr,Lr),ws.subVectors(Nr,Dr),Ys.subVectors(Lr,Nr);let e=[0,-bs.z,bs.y,0,-ws.z,ws.y,0,-Ys.z,Ys.y,bs.z,0,-bs.x,ws.z,0,-ws.x,Ys.z,0,-Ys.x,-bs.y,bs.x,0,-ws.y,ws.x,0,-Ys.y,Ys.x,0];return!Dh(e,Lr,Dr,Nr,Va)||(e=[1,0,0,0,1,0,0,0,1],!Dh(e,Lr,Dr,Nr,Va))?!1:(Ga.crossVectors(bs,ws),e=[Ga.x,Ga.y,Ga.z],Dh(e,Lr,Dr,Nr,Va))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,bi).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(bi).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(es[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),es[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),es[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),es[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),es[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),es[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),es[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),es[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(es),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},es=[new X,new X,new X,new X,new X,new X,new X,new X],bi=new X,za=new zi,Lr=new X,Dr=new X,Nr=new X,bs=new X,ws=new X,Ys=new X,Po=new X,Va=new X,Ga=new X,$s=new X;function Dh(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){$s.fromArray(n,r);let a=s.x*Math.abs($s.x)+s.y*Math.abs($s.y)+s.z*Math.abs($s.z),l=t.dot($s),c=e.dot($s),u=i.dot($s);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var cn=new X,Ha=new Jt,y_=0,kn=class extends wi{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:y_++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=pp,this.updateRanges=[],this.gpuType=mi,this.version=0,this._normalizationScale=t!==void 0?bu(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)Ha.fromBufferAttribute(this,e),Ha.applyMatrix3(t),this.setXY(e,Ha.x,Ha.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)cn.fromBufferAttribute(this,e),cn.applyMatrix3(t),this.setXYZ(e,cn.x,cn.y,cn.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)cn.fromBufferAttribute(this,e),cn.applyMatrix4(t),this.setXYZ(e,cn.x,cn.y,cn.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)cn.fromBufferAttribute(this,e),cn.applyNormalMatrix(t),this.setXYZ(e,cn.x,cn.y,cn.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)cn.fromBufferAttribute(this,e),cn.transformDirection(t),this.setXYZ(e,cn.x,cn.y,cn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):yp(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):vp(t,this.array)}};var qo=class extends kn{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var Yo=class extends kn{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var je=class extends kn{constructor(t,e,i){super(new Float32Array(t),e,i)}},v_=new zi,Io=new X,Nh=new X,os=class{constructor(t=new X,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):v_.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Io.subVectors(t,this.center);let e=Io.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(Io,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Nh.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Io.copy(t.center).add(Nh)),this.expandByPoint(Io.copy(t.center).sub(Nh))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},S_=0,di=new Ie,Uh=new En,Ur=new X,ti=new zi,Lo=new zi,bn=new X,Vn=class n extends wi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:S_++}),this.uuid=no(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(q0(t)?Yo:qo)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new te().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return di.makeRotationFromQuaternion(t),this.applyMatrix4(di),this}rotateX(t){return di.makeRotationX(t),this.applyMatrix4(di),this}rotateY(t){return di.makeRotationY(t),this.applyMatrix4(di),this}rotateZ(t){return di.makeRotationZ(t),this.applyMatrix4(di),this}translate(t,e,i){return di.makeTranslation(t,e,i),this.applyMatrix4(di),this}scale(t,e,i){return di.makeScale(t,e,i),this.applyMatrix4(di),this}lookAt(t){return Uh.lookAt(t),Uh.updateMatrix(),this.applyMatrix4(Uh.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Ur).negate(),this.translate(Ur.x,Ur.y,Ur.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new je(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&qt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new zi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Qt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new X(-1/0,-1/0,-1/0),new X(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];ti.setFromBufferAttribute(r),this.morphTargetsRelative?(bn.addVectors(this.boundingBox.min,ti.min),this.boundingBox.expandByPoint(bn),bn.addVectors(this.boundingBox.max,ti.max),this.boundingBox.expandByPoint(bn)):(this.boundingBox.expandByPoint(ti.min),this.boundingBox.expandByPoint(ti.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Qt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new os);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Qt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new X,1/0);return}if(t){let i=this.boundingSphere.center;if(ti.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Lo.setFromBufferAttribute(a),this.morphTargetsRelative?(bn.addVectors(ti.min,Lo.min),ti.expandByPoint(bn),bn.addVectors(ti.max,Lo.max),ti.expandByPoint(bn)):(ti.expandByPoint(Lo.min),ti.expandByPoint(Lo.max))}ti.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)bn.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(bn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)bn.fromBufferAttribute(a,c),l&&(Ur.fromBufferAttribute(t,c),bn.add(Ur)),s=Math.max(s,i.distanceToSquared(bn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Qt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){Qt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new kn(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let L=0;L<i.count;L++)a[L]=new X,l[L]=new X;let u=new X,h=new X,f=new X,d=new Jt,g=new Jt,y=new Jt,m=new X,p=new X;function _(L,P,R){c[L]=c[P]=c[R]=1,u.fromBufferAttribute(i,L),h.fromBufferAttribute(i,P),f.fromBufferAttribute(i,R),d.fromBufferAttribute(r,L),g.fromBufferAttribute(r,P),y.fromBufferAttribute(r,R),h.sub(u),f.sub(u),g.sub(d),y.sub(d);let F=1/(g.x*y.y-y.x*g.y);isFinite(F)&&(m.copy(h).multiplyScalar(y.y).addScaledVector(f,-g.y).multiplyScalar(F),p.copy(f).multiplyScalar(g.x).addScaledVector(h,-y.x).multiplyScalar(F),a[L].add(m),a[P].add(m),a[R].add(m),l[L].add(p),l[P].add(p),l[R].add(p))}let E=this.groups;E.length===0&&(E=[{start:0,count:t.count}]);for(let L=0,P=E.length;L<P;++L){let R=E[L],F=R.start,k=R.count;for(let N=F,V=F+k;N<V;N+=3)_(t.getX(N+0),t.getX(N+1),t.getX(N+2))}let S=new X,C=new X,b=new X,x=new X;function T(L){b.fromBufferAttribute(s,L),x.copy(b);let P=a[L];S.copy(P),S.sub(b.multiplyScalar(b.dot(P))).normalize(),C.crossVectors(x,P);let F=C.dot(l[L])<0?-1:1;o.setXYZW(L,S.x,S.y,S.z,F)}for(let L=0,P=i.count;L<P;++L)c[L]&&T(L);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new kn(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let f=0,d=i.count;f<d;f++)i.setXYZ(f,0,0,0);let s=new X,r=new X,o=new X,a=new X,l=new X,c=new X,u=new X,h=new X;if(t)for(let f=0,d=t.count;f<d;f+=3){let g=t.getX(f+0),y=t.getX(f+1),m=t.getX(f+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,y),o.fromBufferAttribute(e,m),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,g),l.fromBufferAttribute(i,y),c.fromBufferAttribute(i,m),a.add(u),l.add(u),c.add(u),i.setXYZ(g,a.x,a.y,a.z),i.setXYZ(y,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let f=0,d=e.count;f<d;f+=3)s.fromBufferAttribute(e,f+0),r.fromBufferAttribute(e,f+1),o.fromBufferAttribute(e,f+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(f+0,u.x,u.y,u.z),i.setXYZ(f+1,u.x,u.y,u.z),i.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)bn.fromBufferAttribute(t,e),bn.normalize(),t.setXYZ(e,bn.x,bn.y,bn.z)}toNonIndexed(){function t(a,l){let c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u),d=0,g=0;for(let y=0,m=l.length;y<m;y++){a.isInterleavedBufferAttribute?d=l[y]*a.data.stride+a.offset:d=l[y]*u;for(let p=0;p<u;p++)f[g++]=c[d++]}return new kn(f,u,h)}if(this.index===null)return qt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let f=c[u],d=t(f,i);l.push(d)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){let d=c[h];u.push(d.toJSON(t.data))}u.length>0&&(s[l]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(e))}let r=t.morphAttributes;for(let c in r){let u=[],h=r[c];for(let f=0,d=h.length;f<d;f++)u.push(h[f].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Fh=new X,M_=new X,b_=new te,ni=class{constructor(t=new X(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=Fh.subVectors(i,e).cross(M_.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(Fh),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||b_.getNormalMatrix(t),s=this.coplanarPoint(Fh).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},w_=0,as=class extends wi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:w_++}),this.uuid=no(),this.name="",this.type="Material",this.blending=Qr,this.side=Ds,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=jh,this.blendDst=Qh,this.blendEquation=er,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ee(0,0,0),this.blendAlpha=0,this.depthFunc=Vr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=lp,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=al,this.stencilZFail=al,this.stencilZPass=al,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){qt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){qt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new ee().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new ni().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Jt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Jt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var ns=new X,Oh=new X,Wa=new X,Xa=new X,Js=class{constructor(t=new X,e=new X(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,ns)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=ns.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(ns.copy(this.origin).addScaledVector(this.direction,e),ns.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){Oh.copy(t).add(e).multiplyScalar(.5),Wa.copy(e).sub(t).normalize(),Xa.copy(this.origin).sub(Oh);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Wa),a=Xa.dot(this.direction),l=-Xa.dot(Wa),c=Xa.lengthSq(),u=Math.abs(1-o*o),h,f,d,g;if(u>0)if(h=o*l-a,f=o*a-l,g=r*u,h>=0)if(f>=-g)if(f<=g){let y=1/u;h*=y,f*=y,d=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f=-r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f<=-g?(h=Math.max(0,-(-o*r+a)),f=h>0?-r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c):f<=g?(h=0,f=Math.min(Math.max(-r,-l),r),d=f*(f+2*l)+c):(h=Math.max(0,-(o*r+a)),f=h>0?r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c);else f=o>0?-r:r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Oh).addScaledVector(Wa,f),d}intersectSphere(t,e){if(t.radius<0)return null;ns.subVectors(t.center,this.origin);let i=ns.dot(this.direction),s=ns.dot(ns)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(i=(t.min.x-f.x)*c,s=(t.max.x-f.x)*c):(i=(t.max.x-f.x)*c,s=(t.min.x-f.x)*c),u>=0?(r=(t.min.y-f.y)*u,o=(t.max.y-f.y)*u):(r=(t.max.y-f.y)*u,o=(t.min.y-f.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(t.min.z-f.z)*h,l=(t.max.z-f.z)*h):(a=(t.max.z-f.z)*h,l=(t.min.z-f.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,ns)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=t.x-o.x,f=t.y-o.y,d=t.z-o.z,g=e.x-o.x,y=e.y-o.y,m=e.z-o.z,p=i.x-o.x,_=i.y-o.y,E=i.z-o.z,S=Math.abs(l),C=Math.abs(c),b=Math.abs(u),x,T,L,P,R,F,k,N,V,Y,G,lt;if(S>=C&&S>=b?(L=l,F=h,V=g,lt=p,l>=0?(x=c,T=u,P=f,R=d,k=y,N=m,Y=_,G=E):(x=u,T=c,P=d,R=f,k=m,N=y,Y=E,G=_)):C>=b?(L=c,F=f,V=y,lt=_,c>=0?(x=u,T=l,P=d,R=h,k=m,N=g,Y=E,G=p):(x=l,T=u,P=h,R=d,k=g,N=m,Y=p,G=E)):(L=u,F=d,V=m,lt=E,u>=0?(x=l,T=c,P=h,R=f,k=g,N=y,Y=p,G=_):(x=c,T=l,P=f,R=h,k=y,N=g,Y=_,G=p)),L===0)return null;let K=x/L,Q=T/L,it=1/L,dt=P-K*F,ft=R-Q*F,tt=k-K*V,ut=N-Q*V,gt=Y-K*lt,Mt=G-Q*lt,bt=gt*ut-Mt*tt,Ht=dt*Mt-ft*gt,se=tt*ft-ut*dt;if(s){if(bt<0||Ht<0||se<0)return null}else if((bt<0||Ht<0||se<0)&&(bt>0||Ht>0||se>0))return null;let Vt=bt+Ht+se;if(Vt===0)return null;let he=it*(bt*F+Ht*V+se*lt);return(Vt>0?he<0:he>0)?null:this.at(he/Vt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},js=class extends as{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ee(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new rs,this.combine=zl,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},yd=new Ie,Zs=new Js,qa=new os,vd=new X,Ya=new X,$a=new X,Za=new X,Bh=new X,Ka=new X,Sd=new X,Ja=new X,Gn=class extends En{constructor(t=new Vn,e=new js){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Ka.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(Bh.fromBufferAttribute(h,t),o?Ka.addScaledVector(Bh,u):Ka.addScaledVector(Bh.sub(e),u))}e.add(Ka)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),qa.copy(i.boundingSphere),qa.applyMatrix4(r),Zs.copy(t.ray).recast(t.near),!(qa.containsPoint(Zs.origin)===!1&&(Zs.intersectSphere(qa,vd)===null||Zs.origin.distanceToSquared(vd)>(t.far-t.near)**2))&&(yd.copy(r).invert(),Zs.copy(t.ray).applyMatrix4(yd),!(i.boundingBox!==null&&Zs.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,Zs)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,f=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,y=f.length;g<y;g++){let m=f[g],p=o[m.materialIndex],_=Math.max(m.start,d.start),E=Math.min(a.count,Math.min(m.start+m.count,d.start+d.count));for(let S=_,C=E;S<C;S+=3){let b=a.getX(S),x=a.getX(S+1),T=a.getX(S+2);s=ja(this,p,t,i,c,u,h,b,x,T),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let g=Math.max(0,d.start),y=Math.min(a.count,d.start+d.count);for(let m=g,p=y;m<p;m+=3){let _=a.getX(m),E=a.getX(m+1),S=a.getX(m+2);s=ja(this,o,t,i,c,u,h,_,E,S),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,y=f.length;g<y;g++){let m=f[g],p=o[m.materialIndex],_=Math.max(m.start,d.start),E=Math.min(l.count,Math.min(m.start+m.count,d.start+d.count));for(let S=_,C=E;S<C;S+=3){let b=S,x=S+1,T=S+2;s=ja(this,p,t,i,c,u,h,b,x,T),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let g=Math.max(0,d.start),y=Math.min(l.count,d.start+d.count);for(let m=g,p=y;m<p;m+=3){let _=m,E=m+1,S=m+2;s=ja(this,o,t,i,c,u,h,_,E,S),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function T_(n,t,e,i,s,r,o,a){let l;if(t.side===Hn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===Ds,a),l===null)return null;Ja.copy(a),Ja.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Ja);return c<e.near||c>e.far?null:{distance:c,point:Ja.clone(),object:n}}function ja(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,Ya),n.getVertexPosition(l,$a),n.getVertexPosition(c,Za);let u=T_(n,t,e,i,Ya,$a,Za,Sd);if(u){let h=new X;As.getBarycoord(Sd,Ya,$a,Za,h),s&&(u.uv=As.getInterpolatedAttribute(s,a,l,c,h,new Jt)),r&&(u.uv1=As.getInterpolatedAttribute(r,a,l,c,h,new Jt)),o&&(u.normal=As.getInterpolatedAttribute(o,a,l,c,h,new X),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new X,materialIndex:0};As.getNormal(Ya,$a,Za,f.normal),u.face=f,u.barycoord=h}return u}var $o=class extends Xn{constructor(t=null,e=1,i=1,s,r,o,a,l,c=wn,u=wn,h,f){super(null,o,a,l,c,u,s,r,h,f),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Zo=class extends kn{constructor(t,e,i,s=1){super(t,e,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},Fr=new Ie,Md=new Ie,Qa=[],bd=new zi,A_=new Ie,Do=new Gn,No=new os,oi=class extends Gn{constructor(t,e,i){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new Zo(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,A_)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new zi),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Fr),bd.copy(t.boundingBox).applyMatrix4(Fr),this.boundingBox.union(bd)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new os),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Fr),No.copy(t.boundingSphere).applyMatrix4(Fr),this.boundingSphere.union(No)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let i=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=t*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(t,e){let i=this.matrixWorld,s=this.count;if(Do.geometry=this.geometry,Do.material=this.material,Do.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),No.copy(this.boundingSphere),No.applyMatrix4(i),t.ray.intersectsSphere(No)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Fr),Md.multiplyMatrices(i,Fr),Do.matrixWorld=Md,Do.raycast(t,Qa);for(let o=0,a=Qa.length;o<a;o++){let l=Qa[o];l.instanceId=r,l.object=this,e.push(l)}Qa.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new Zo(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let i=e.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new $o(new Float32Array(s*this.count),s,this.count,Yl,mi));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*t;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Ks=new os,E_=new Jt(.5,.5),tl=new X,Es=class{constructor(t=new ni,e=new ni,i=new ni,s=new ni,r=new ni,o=new ni){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=pi,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],f=r[6],d=r[7],g=r[8],y=r[9],m=r[10],p=r[11],_=r[12],E=r[13],S=r[14],C=r[15];if(s[0].setComponents(c-o,d-u,p-g,C-_).normalize(),s[1].setComponents(c+o,d+u,p+g,C+_).normalize(),s[2].setComponents(c+a,d+h,p+y,C+E).normalize(),s[3].setComponents(c-a,d-h,p-y,C-E).normalize(),i)s[4].setComponents(l,f,m,S).normalize(),s[5].setComponents(c-l,d-f,p-m,C-S).normalize();else if(s[4].setComponents(c-l,d-f,p-m,C-S).normalize(),e===pi)s[5].setComponents(c+l,d+f,p+m,C+S).normalize();else if(e===Gr)s[5].setComponents(l,f,m,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Ks.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Ks.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Ks)}intersectsSprite(t){Ks.center.set(0,0,0);let e=E_.distanceTo(t.center);return Ks.radius=.7071067811865476+e,Ks.applyMatrix4(t.matrixWorld),this.intersectsSphere(Ks)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(tl.x=s.normal.x>0?t.max.x:t.min.x,tl.y=s.normal.y>0?t.max.y:t.min.y,tl.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(tl)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},wd=new Ie,Sl=class n{constructor(){this.coordinateSystem=pi,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];wd.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Es),i[s].setFromProjectionMatrix(wd,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Es),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var Yr=class extends as{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ee(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Ml=new X,bl=new X,Td=new Ie,Uo=new Js,el=new os,kh=new X,Ad=new X,wl=class extends En{constructor(t=new Vn,e=new Yr){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)Ml.fromBufferAttribute(e,s-1),bl.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=Ml.distanceTo(bl);t.setAttribute("lineDistance",new je(i,1))}else qt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),el.copy(i.boundingSphere),el.applyMatrix4(s),el.radius+=r,t.ray.intersectsSphere(el)===!1)return;Td.copy(s).invert(),Uo.copy(t.ray).applyMatrix4(Td);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,f=i.attributes.position;if(u!==null){let d=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let y=d,m=g-1;y<m;y+=c){let p=u.getX(y),_=u.getX(y+1),E=nl(this,t,Uo,l,p,_,y);E&&e.push(E)}if(this.isLineLoop){let y=u.getX(g-1),m=u.getX(d),p=nl(this,t,Uo,l,y,m,g-1);p&&e.push(p)}}else{let d=Math.max(0,o.start),g=Math.min(f.count,o.start+o.count);for(let y=d,m=g-1;y<m;y+=c){let p=nl(this,t,Uo,l,y,y+1,y);p&&e.push(p)}if(this.isLineLoop){let y=nl(this,t,Uo,l,g-1,d,g-1);y&&e.push(y)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function nl(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(Ml.fromBufferAttribute(a,s),bl.fromBufferAttribute(a,r),e.distanceSqToSegment(Ml,bl,kh,Ad)>i)return;kh.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(kh);if(!(c<t.near||c>t.far))return{distance:c,point:Ad.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var Ed=new X,Cd=new X,Ko=class extends wl{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)Ed.fromBufferAttribute(e,s),Cd.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+Ed.distanceTo(Cd);t.setAttribute("lineDistance",new je(i,1))}else qt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Jo=class extends Xn{constructor(t=[],e=nr,i,s,r,o,a,l,c,u){super(t,e,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var ls=class extends Xn{constructor(t,e,i=Ti,s,r,o,a=wn,l=wn,c,u=ss,h=1){if(u!==ss&&u!==hs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:t,height:e,depth:h};super(f,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Xr(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},jo=class extends ls{constructor(t,e=Ti,i=nr,s,r,o=wn,a=wn,l,c=ss){let u={width:t,height:t,depth:1},h=[u,u,u,u,u,u];super(t,t,e,i,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},Qo=class extends Xn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},$r=class n extends Vn{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],f=0,d=0;g("z","y","x",-1,-1,i,e,t,o,r,0),g("z","y","x",1,-1,i,e,-t,o,r,1),g("x","z","y",1,1,t,i,e,s,o,2),g("x","z","y",1,-1,t,i,-e,s,o,3),g("x","y","z",1,-1,t,e,i,s,r,4),g("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new je(c,3)),this.setAttribute("normal",new je(u,3)),this.setAttribute("uv",new je(h,2));function g(y,m,p,_,E,S,C,b,x,T,L){let P=S/x,R=C/T,F=S/2,k=C/2,N=b/2,V=x+1,Y=T+1,G=0,lt=0,K=new X;for(let Q=0;Q<Y;Q++){let it=Q*R-k;for(let dt=0;dt<V;dt++){let ft=dt*P-F;K[y]=ft*_,K[m]=it*E,K[p]=N,c.push(K.x,K.y,K.z),K[y]=0,K[m]=0,K[p]=b>0?1:-1,u.push(K.x,K.y,K.z),h.push(dt/x),h.push(1-Q/T),G+=1}}for(let Q=0;Q<T;Q++)for(let it=0;it<x;it++){let dt=f+it+V*Q,ft=f+it+V*(Q+1),tt=f+(it+1)+V*(Q+1),ut=f+(it+1)+V*Q;l.push(dt,ft,ut),l.push(ft,tt,ut),lt+=6}a.addGroup(d,lt,L),d+=lt,f+=G}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var Vi=class n extends Vn{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],f=[],d=[],g=0,y=[],m=i/2,p=0;_(),o===!1&&(t>0&&E(!0),e>0&&E(!1)),this.setIndex(u),this.setAttribute("position",new je(h,3)),this.setAttribute("normal",new je(f,3)),this.setAttribute("uv",new je(d,2));function _(){let S=new X,C=new X,b=0,x=(e-t)/i;for(let T=0;T<=r;T++){let L=[],P=T/r,R=P*(e-t)+t;for(let F=0;F<=s;F++){let k=F/s,N=k*l+a,V=Math.sin(N),Y=Math.cos(N);C.x=R*V,C.y=-P*i+m,C.z=R*Y,h.push(C.x,C.y,C.z),S.set(V,x,Y).normalize(),f.push(S.x,S.y,S.z),d.push(k,1-P),L.push(g++)}y.push(L)}for(let T=0;T<s;T++)for(let L=0;L<r;L++){let P=y[L][T],R=y[L+1][T],F=y[L+1][T+1],k=y[L][T+1];(t>0||L!==0)&&(u.push(P,R,k),b+=3),(e>0||L!==r-1)&&(u.push(R,F,k),b+=3)}c.addGroup(p,b,0),p+=b}function E(S){let C=g,b=new Jt,x=new X,T=0,L=S===!0?t:e,P=S===!0?1:-1;for(let F=1;F<=s;F++)h.push(0,m*P,0),f.push(0,P,0),d.push(.5,.5),g++;let R=g;for(let F=0;F<=s;F++){let N=F/s*l+a,V=Math.cos(N),Y=Math.sin(N);x.x=L*Y,x.y=m*P,x.z=L*V,h.push(x.x,x.y,x.z),f.push(0,P,0),b.x=V*.5+.5,b.y=Y*.5*P+.5,d.push(b.x,b.y),g++}for(let F=0;F<s;F++){let k=C+F,N=R+F;S===!0?u.push(N,N+1,k):u.push(N+1,N,k),T+=3}c.addGroup(p,T,S===!0?1:2),p+=T}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},ta=class n extends Vi{constructor(t=1,e=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new n(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var ea=class n extends Vn{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=t/a,f=e/l,d=[],g=[],y=[],m=[];for(let p=0;p<u;p++){let _=p*f-o;for(let E=0;E<c;E++){let S=E*h-r;g.push(S,-_,0),y.push(0,0,1),m.push(E/a),m.push(1-p/l)}}for(let p=0;p<l;p++)for(let _=0;_<a;_++){let E=_+c*p,S=_+c*(p+1),C=_+1+c*(p+1),b=_+1+c*p;d.push(E,S,b),d.push(S,C,b)}this.setIndex(d),this.setAttribute("position",new je(g,3)),this.setAttribute("normal",new je(y,3)),this.setAttribute("uv",new je(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var Zr=class n extends Vn{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new X,f=new X,d=[],g=[],y=[],m=[];for(let p=0;p<=i;p++){let _=[],E=p/i,S=o+E*a,C=t*Math.cos(S),b=Math.sqrt(t*t-C*C),x=0;p===0&&o===0?x=.5/e:p===i&&l===Math.PI&&(x=-.5/e);for(let T=0;T<=e;T++){let L=T/e,P=s+L*r;h.x=-b*Math.cos(P),h.y=C,h.z=b*Math.sin(P),g.push(h.x,h.y,h.z),f.copy(h).normalize(),y.push(f.x,f.y,f.z),m.push(L+x,1-E),_.push(c++)}u.push(_)}for(let p=0;p<i;p++)for(let _=0;_<e;_++){let E=u[p][_+1],S=u[p][_],C=u[p+1][_],b=u[p+1][_+1];(p!==0||o>0)&&d.push(E,S,b),(p!==i-1||l<Math.PI)&&d.push(S,C,b)}this.setIndex(d),this.setAttribute("position",new je(g,3)),this.setAttribute("normal",new je(y,3)),this.setAttribute("uv",new je(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};function sr(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(Rd(s))s.isRenderTargetTexture?(qt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(Rd(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function Ln(n){let t={};for(let e=0;e<n.length;e++){let i=sr(n[e]);for(let s in i)t[s]=i[s]}return t}function Rd(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function C_(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function Tu(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:ge.workingColorSpace}var Mp={clone:sr,merge:Ln},R_=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,P_=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Gi=class extends as{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=R_,this.fragmentShader=P_,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=sr(t.uniforms),this.uniformsGroups=C_(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new ee().setHex(s.value);break;case"v2":this.uniforms[i].value=new Jt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new X().fromArray(s.value);break;case"v4":this.uniforms[i].value=new We().fromArray(s.value);break;case"m3":this.uniforms[i].value=new te().fromArray(s.value);break;case"m4":this.uniforms[i].value=new Ie().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Tl=class extends Gi{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Qs=class extends as{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new ee(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ee(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Ec,this.normalScale=new Jt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new rs,this.combine=zl,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},Al=class extends as{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=op,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},El=class extends as{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Or(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function il(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Cs=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Cl=class extends Cs{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Gh,endingEnd:Gh}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Hh:r=t,a=2*e-i;break;case Wh:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Hh:o=t,l=2*i-e;break;case Wh:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,u=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,f=this._weightPrev,d=this._weightNext,g=(i-e)/(s-e),y=g*g,m=y*g,p=-f*m+2*f*y-f*g,_=(1+f)*m+(-1.5-2*f)*y+(-.5+f)*g+1,E=(-1-d)*m+(1.5+d)*y+.5*g,S=d*m-d*y;for(let C=0;C!==a;++C)r[C]=p*o[u+C]+_*o[c+C]+E*o[l+C]+S*o[h+C];return r}},Rl=class extends Cs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=(i-e)/(s-e),h=1-u;for(let f=0;f!==a;++f)r[f]=o[c+f]*h+o[l+f]*u;return r}},Pl=class extends Cs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Il=class extends Cs{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let g=(i-e)/(s-e),y=1-g;for(let m=0;m!==a;++m)r[m]=o[c+m]*y+o[l+m]*g;return r}let f=a*2,d=t-1;for(let g=0;g!==a;++g){let y=o[c+g],m=o[l+g],p=d*f+g*2,_=h[p],E=h[p+1],S=t*f+g*2,C=u[S],b=u[S+1],x=L_(i,e,_,C,s);r[g]=bp(x,y,E,b,m)}return r}};function bp(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function I_(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function L_(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=bp(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=I_(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var ai=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Or(e,this.TimeBufferType),this.values=Or(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:Or(t.times,Array),values:Or(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),il(t.settings)&&(i.settings={inTangents:Or(t.settings.inTangents,Array),outTangents:Or(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new Pl(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Rl(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Cl(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Il(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case ko:e=this.InterpolantFactoryMethodDiscrete;break;case _l:e=this.InterpolantFactoryMethodLinear;break;case ol:e=this.InterpolantFactoryMethodSmooth;break;case Vh:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return qt("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ko;case this.InterpolantFactoryMethodLinear:return _l;case this.InterpolantFactoryMethodSmooth:return ol;case this.InterpolantFactoryMethodBezier:return Vh}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;il(this.settings)&&(Pd(this.settings.inTangents,t),Pd(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;il(this.settings)&&(Id(this.settings.inTangents,t),Id(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(Qt("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(Qt("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){Qt("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){Qt("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&Y0(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){Qt("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===ol,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],u=t[a+1];if(c!==u&&(a!==1||c!==t[0]))if(s)l=!0;else{let h=a*i,f=h-i,d=h+i;for(let g=0;g!==i;++g){let y=e[h+g];if(y!==e[f+g]||y!==e[d+g]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let h=a*i,f=o*i;for(let d=0;d!==i;++d)e[f+d]=e[h+d]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,il(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Pd(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function Id(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}ai.prototype.ValueTypeName="";ai.prototype.TimeBufferType=Float32Array;ai.prototype.ValueBufferType=Float32Array;ai.prototype.DefaultInterpolation=_l;var Rs=class extends ai{constructor(t,e,i){super(t,e,i)}};Rs.prototype.ValueTypeName="bool";Rs.prototype.ValueBufferType=Array;Rs.prototype.DefaultInterpolation=ko;Rs.prototype.InterpolantFactoryMethodLinear=void 0;Rs.prototype.InterpolantFactoryMethodSmooth=void 0;var Ll=class extends ai{constructor(t,e,i,s){super(t,e,i,s)}};Ll.prototype.ValueTypeName="color";var Dl=class extends ai{constructor(t,e,i,s){super(t,e,i,s)}};Dl.prototype.ValueTypeName="number";var Nl=class extends Cs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let u=c+a;c!==u;c+=4)si.slerpFlat(r,0,o,c-a,o,c,l);return r}},na=class extends ai{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new Nl(this.times,this.values,this.getValueSize(),t)}};na.prototype.ValueTypeName="quaternion";na.prototype.InterpolantFactoryMethodSmooth=void 0;var Ps=class extends ai{constructor(t,e,i){super(t,e,i)}};Ps.prototype.ValueTypeName="string";Ps.prototype.ValueBufferType=Array;Ps.prototype.DefaultInterpolation=ko;Ps.prototype.InterpolantFactoryMethodLinear=void 0;Ps.prototype.InterpolantFactoryMethodSmooth=void 0;var Ul=class extends ai{constructor(t,e,i,s){super(t,e,i,s)}};Ul.prototype.ValueTypeName="vector";var Fl=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,f=c.length;h<f;h+=2){let d=c[h],g=c[h+1];if(d.global&&(d.lastIndex=0),d.test(u))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},wp=new Fl,Ol=class{constructor(t){this.manager=t!==void 0?t:wp,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Ol.DEFAULT_MATERIAL_NAME="__DEFAULT";var ia=class extends En{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new ee(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},sa=class extends ia{constructor(t,e,i){super(t,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(En.DEFAULT_UP),this.updateMatrix(),this.groundColor=new ee(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},zh=new Ie,Ld=new X,Dd=new X,Bl=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Jt(512,512),this.mapType=Yn,this.map=null,this.mapPass=null,this.matrix=new Ie,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Es,this._frameExtents=new Jt(1,1),this._viewportCount=1,this._viewports=[new We(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;Ld.setFromMatrixPosition(t.matrixWorld),e.position.copy(Ld),Dd.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(Dd),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,i,s){zh.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),i.setFromProjectionMatrix(zh,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===Gr||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(zh)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},sl=new X,rl=new si,Bi=new X,ra=class extends En{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Ie,this.projectionMatrix=new Ie,this.projectionMatrixInverse=new Ie,this.coordinateSystem=pi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(sl,rl,Bi),Bi.x===1&&Bi.y===1&&Bi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(sl,rl,Bi.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(sl,rl,Bi),Bi.x===1&&Bi.y===1&&Bi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(sl,rl,Bi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Ts=new X,Nd=new Jt,Ud=new Jt,Bn=class extends ra{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Wr*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(Oo*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Wr*2*Math.atan(Math.tan(Oo*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){Ts.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Ts.x,Ts.y).multiplyScalar(-t/Ts.z),Ts.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Ts.x,Ts.y).multiplyScalar(-t/Ts.z)}getViewSize(t,e){return this.getViewBounds(t,Nd,Ud),e.subVectors(Ud,Nd)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(Oo*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var oa=class extends ra{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Xh=class extends Bl{constructor(){super(new oa(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},aa=class extends ia{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(En.DEFAULT_UP),this.updateMatrix(),this.target=new En,this.shadow=new Xh}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}};var Br=-90,kr=1,Kr=class extends En{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Bn(Br,kr,t,e);s.layers=this.layers,this.add(s);let r=new Bn(Br,kr,t,e);r.layers=this.layers,this.add(r);let o=new Bn(Br,kr,t,e);o.layers=this.layers,this.add(o);let a=new Bn(Br,kr,t,e);a.layers=this.layers,this.add(a);let l=new Bn(Br,kr,t,e);l.layers=this.layers,this.add(l);let c=new Bn(Br,kr,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===pi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===Gr)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=t.getRenderTarget(),f=t.getActiveCubeFace(),d=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;let y=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=y,t.setRenderTarget(i,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,u),t.setRenderTarget(h,f,d),t.xr.enabled=g,i.texture.needsPMREMUpdate=!0}},kl=class extends Bn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Au="\\[\\]\\.:\\/",D_=new RegExp("["+Au+"]","g"),Eu="[^"+Au+"]",N_="[^"+Au.replace("\\.","")+"]",U_=/((?:WC+[\/:])*)/.source.replace("WC",Eu),F_=/(WCOD+)?/.source.replace("WCOD",N_),O_=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Eu),B_=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Eu),k_=new RegExp("^"+U_+F_+O_+B_+"$"),z_=["material","materials","bones","map"],qh=class{constructor(t,e,i){let s=i||ze.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},ze=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(D_,"")}static parseTrackName(t){let e=k_.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);z_.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){qt("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){Qt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){Qt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){Qt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let u=0;u<t.length;u++)if(t[u].name===c){c=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){Qt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){Qt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){Qt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){Qt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;Qt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){Qt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){Qt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};ze.Composite=qh;ze.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};ze.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};ze.prototype.GetterByBindingType=[ze.prototype._getValue_direct,ze.prototype._getValue_array,ze.prototype._getValue_arrayElement,ze.prototype._getValue_toArray];ze.prototype.SetterByBindingTypeAndVersioning=[[ze.prototype._setValue_direct,ze.prototype._setValue_direct_setNeedsUpdate,ze.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[ze.prototype._setValue_array,ze.prototype._setValue_array_setNeedsUpdate,ze.prototype._setValue_array_setMatrixWorldNeedsUpdate],[ze.prototype._setValue_arrayElement,ze.prototype._setValue_arrayElement_setNeedsUpdate,ze.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[ze.prototype._setValue_fromArray,ze.prototype._setValue_fromArray_setNeedsUpdate,ze.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var KT=new Float32Array(1);var Jr=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=de(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(de(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Yh=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var la=class extends wi{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Cu(n,t,e,i){let s=V_(i);switch(e){case fu:return n*t;case Yl:return n*t/s.components*s.byteLength;case $l:return n*t/s.components*s.byteLength;case Ns:return n*t*2/s.components*s.byteLength;case Zl:return n*t*2/s.components*s.byteLength;case du:return n*t*3/s.components*s.byteLength;case Ei:return n*t*4/s.components*s.byteLength;case Kl:return n*t*4/s.components*s.byteLength;case ua:case fa:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case da:case pa:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case jl:case tc:return Math.max(n,16)*Math.max(t,8)/4;case Jl:case Ql:return Math.max(n,8)*Math.max(t,8)/2;case ec:case nc:case sc:case rc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case ic:case ma:case oc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case ac:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case lc:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case cc:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case hc:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case uc:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case fc:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case dc:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case pc:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case mc:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case gc:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case _c:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case xc:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case yc:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case vc:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case Sc:case Mc:case bc:return Math.ceil(n/4)*Math.ceil(t/4)*16;case wc:case Tc:return Math.ceil(n/4)*Math.ceil(t/4)*8;case ga:case Ac:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function V_(n){switch(n){case Yn:case lu:return{byteLength:1,components:1};case eo:case cu:case Ai:return{byteLength:2,components:1};case Xl:case ql:return{byteLength:2,components:4};case Ti:case Wl:case mi:return{byteLength:4,components:1};case hu:case uu:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?qt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function qp(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function H_(n){let t=new WeakMap;function e(a,l){let c=a.array,u=a.usage,h=c.byteLength,f=n.createBuffer();n.bindBuffer(l,f),n.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=n.HALF_FLOAT:d=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=n.SHORT;else if(c instanceof Uint32Array)d=n.UNSIGNED_INT;else if(c instanceof Int32Array)d=n.INT;else if(c instanceof Int8Array)d=n.BYTE;else if(c instanceof Uint8Array)d=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((d,g)=>d.start-g.start);let f=0;for(let d=1;d<h.length;d++){let g=h[f],y=h[d];y.start<=g.start+g.count+1?g.count=Math.max(g.count,y.start+y.count-g.start):(++f,h[f]=y)}h.length=f+1;for(let d=0,g=h.length;d<g;d++){let y=h[d];n.bufferSubData(c,y.start*u.BYTES_PER_ELEMENT,u,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var W_=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,X_=`#ifdef USE_ALPHAHASH
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
#endif`,q_=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Y_=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,$_=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Z_=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,K_=`#ifdef USE_AOMAP
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
#endif`,J_=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,j_=`#ifdef USE_BATCHING
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
#endif`,Q_=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,tx=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,ex=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,nx=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,ix=`#ifdef USE_IRIDESCENCE
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
#endif`,sx=`#ifdef USE_BUMPMAP
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
#endif`,rx=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,ox=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,ax=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,lx=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,cx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,hx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,ux=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,fx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,dx=`#define PI 3.141592653589793
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
} // validated`,px=`vec3 transformedNormal = objectNormal;
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
#endif`,mx=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,gx=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,_x=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,xx=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,yx="gl_FragColor = linearToOutputTexel( gl_FragColor );",vx=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Sx=`#ifdef USE_ENVMAP
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
#endif`,Mx=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,bx=`#ifdef USE_ENVMAP
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
#endif`,wx=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Tx=`#ifdef USE_ENVMAP
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
#endif`,Ax=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Ex=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Cx=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Rx=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Px=`#ifdef USE_GRADIENTMAP
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
}`,Ix=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Lx=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Dx=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Nx=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,Ux=`#ifdef USE_ENVMAP
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
#endif`,Fx=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Ox=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Bx=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,kx=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,zx=`PhysicalMaterial material;
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
#endif`,Vx=`uniform sampler2D dfgLUT;
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
}`,Gx=`
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
#endif`,Hx=`#if defined( RE_IndirectDiffuse )
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
#endif`,Wx=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Xx=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,qx=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Yx=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,$x=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Zx=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Kx=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Jx=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,jx=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,Qx=`#if defined( USE_POINTS_UV )
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
#endif`,ty=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,ey=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,ny=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,iy=`#if defined( USE_MORPHCOLORS )
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
#endif`,sy=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,ry=`#ifdef USE_MORPHTARGETS
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
#endif`,oy=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,ay=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,ly=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,cy=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,hy=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,uy=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,fy=`#ifdef USE_NORMALMAP
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
#endif`,dy=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,py=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,my=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,gy=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,_y=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,xy=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,yy=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,vy=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Sy=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,My=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,by=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,wy=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Ty=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Ay=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Ey=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,Cy=`float getShadowMask() {
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
}`,Ry=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Py=`#ifdef USE_SKINNING
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
#endif`,Iy=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Ly=`#ifdef USE_SKINNING
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
#endif`,Dy=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Ny=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Uy=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Fy=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,Oy=`#ifdef USE_TRANSMISSION
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
#endif`,By=`#ifdef USE_TRANSMISSION
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
#endif`,ky=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,zy=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Vy=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Gy=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Hy=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Wy=`uniform sampler2D t2D;
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
}`,Xy=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,qy=`uniform float backgroundBlurriness;
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
}`,Yy=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,$y=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Zy=`#include <common>
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
}`,Ky=`#if DEPTH_PACKING == 3200
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
}`,Jy=`#define DISTANCE
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
}`,jy=`#define DISTANCE
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
}`,Qy=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,tv=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,ev=`uniform float scale;
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
}`,nv=`uniform vec3 diffuse;
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
}`,iv=`#include <common>
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
}`,sv=`uniform vec3 diffuse;
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
}`,rv=`#define LAMBERT
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
}`,ov=`#define LAMBERT
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
}`,av=`#define MATCAP
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
}`,lv=`#define MATCAP
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
}`,cv=`#define NORMAL
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
}`,hv=`#define NORMAL
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
}`,uv=`#define PHONG
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
}`,fv=`#define PHONG
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
}`,dv=`#define STANDARD
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
}`,pv=`#define STANDARD
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
}`,mv=`#define TOON
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
}`,gv=`#define TOON
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
}`,_v=`uniform float size;
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
}`,xv=`uniform vec3 diffuse;
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
}`,yv=`#include <common>
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
}`,vv=`uniform vec3 color;
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
}`,Sv=`uniform float rotation;
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
}`,Mv=`uniform vec3 diffuse;
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
}`,ce={alphahash_fragment:W_,alphahash_pars_fragment:X_,alphamap_fragment:q_,alphamap_pars_fragment:Y_,alphatest_fragment:$_,alphatest_pars_fragment:Z_,aomap_fragment:K_,aomap_pars_fragment:J_,batching_pars_vertex:j_,batching_vertex:Q_,begin_vertex:tx,beginnormal_vertex:ex,bsdfs:nx,iridescence_fragment:ix,bumpmap_pars_fragment:sx,clipping_planes_fragment:rx,clipping_planes_pars_fragment:ox,clipping_planes_pars_vertex:ax,clipping_planes_vertex:lx,color_fragment:cx,color_pars_fragment:hx,color_pars_vertex:ux,color_vertex:fx,common:dx,defaultnormal_vertex:px,displacementmap_pars_vertex:mx,displacementmap_vertex:gx,emissivemap_fragment:_x,emissivemap_pars_fragment:xx,colorspace_fragment:yx,colorspace_pars_fragment:vx,envmap_fragment:Sx,envmap_common_pars_fragment:Mx,envmap_pars_fragment:bx,envmap_pars_vertex:wx,envmap_physical_pars_fragment:Ux,envmap_vertex:Tx,fog_vertex:Ax,fog_pars_vertex:Ex,fog_fragment:Cx,fog_pars_fragment:Rx,gradientmap_pars_fragment:Px,lightmap_pars_fragment:Ix,lights_lambert_fragment:Lx,lights_lambert_pars_fragment:Dx,lights_pars_begin:Nx,lights_toon_fragment:Fx,lights_toon_pars_fragment:Ox,lights_phong_fragment:Bx,lights_phong_pars_fragment:kx,lights_physical_fragment:zx,lights_physical_pars_fragment:Vx,lights_fragment_begin:Gx,lights_fragment_maps:Hx,lights_fragment_end:Wx,lightprobes_pars_fragment:Xx,logdepthbuf_fragment:qx,logdepthbuf_pars_fragment:Yx,logdepthbuf_pars_vertex:$x,logdepthbuf_vertex:Zx,map_fragment:Kx,map_pars_fragment:Jx,map_particle_fragment:jx,map_particle_pars_fragment:Qx,metalnessmap_fragment:ty,metalnessmap_pars_fragment:ey,morphinstance_vertex:ny,morphcolor_vertex:iy,morphnormal_vertex:sy,morphtarget_pars_vertex:ry,morphtarget_vertex:oy,normal_fragment_begin:ay,normal_fragment_maps:ly,normal_pars_fragment:cy,normal_pars_vertex:hy,normal_vertex:uy,normalmap_pars_fragment:fy,clearcoat_normal_fragment_begin:dy,clearcoat_normal_fragment_maps:py,clearcoat_pars_fragment:my,iridescence_pars_fragment:gy,opaque_fragment:_y,packing:xy,premultiplied_alpha_fragment:yy,project_vertex:vy,dithering_fragment:Sy,dithering_pars_fragment:My,roughnessmap_fragment:by,roughnessmap_pars_fragment:wy,shadowmap_pars_fragment:Ty,shadowmap_pars_vertex:Ay,shadowmap_vertex:Ey,shadowmask_pars_fragment:Cy,skinbase_vertex:Ry,skinning_pars_vertex:Py,skinning_vertex:Iy,skinnormal_vertex:Ly,specularmap_fragment:Dy,specularmap_pars_fragment:Ny,tonemapping_fragment:Uy,tonemapping_pars_fragment:Fy,transmission_fragment:Oy,transmission_pars_fragment:By,uv_pars_fragment:ky,uv_pars_vertex:zy,uv_vertex:Vy,worldpos_vertex:Gy,background_vert:Hy,background_frag:Wy,backgroundCube_vert:Xy,backgroundCube_frag:qy,cube_vert:Yy,cube_frag:$y,depth_vert:Zy,depth_frag:Ky,distance_vert:Jy,distance_frag:jy,equirect_vert:Qy,equirect_frag:tv,linedashed_vert:ev,linedashed_frag:nv,meshbasic_vert:iv,meshbasic_frag:sv,meshlambert_vert:rv,meshlambert_frag:ov,meshmatcap_vert:av,meshmatcap_frag:lv,meshnormal_vert:cv,meshnormal_frag:hv,meshphong_vert:uv,meshphong_frag:fv,meshphysical_vert:dv,meshphysical_frag:pv,meshtoon_vert:mv,meshtoon_frag:gv,points_vert:_v,points_frag:xv,shadow_vert:yv,shadow_frag:vv,sprite_vert:Sv,sprite_frag:Mv},Lt={common:{diffuse:{value:new ee(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new te},alphaMap:{value:null},alphaMapTransform:{value:new te},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new te}},envmap:{envMap:{value:null},envMapRotation:{value:new te},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new te}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new te}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new te},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new te},normalScale:{value:new Jt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new te},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new te}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new te}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new te}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ee(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ee(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new te},alphaTest:{value:0},uvTransform:{value:new te}},sprite:{diffuse:{value:new ee(16777215)},opacity:{value:1},center:{value:new Jt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new te},alphaMap:{value:null},alphaMapTransform:{value:new te},alphaTest:{value:0}}},Xi={basic:{uniforms:Ln([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.fog]),vertexShader:ce.meshbasic_vert,fragmentShader:ce.meshbasic_frag},lambert:{uniforms:Ln([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,Lt.lights,{emissive:{value:new ee(0)},envMapIntensity:{value:1}}]),vertexShader:ce.meshlambert_vert,fragmentShader:ce.meshlambert_frag},phong:{uniforms:Ln([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,Lt.lights,{emissive:{value:new ee(0)},specular:{value:new ee(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ce.meshphong_vert,fragmentShader:ce.meshphong_frag},standard:{uniforms:Ln([Lt.common,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.roughnessmap,Lt.metalnessmap,Lt.fog,Lt.lights,{emissive:{value:new ee(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ce.meshphysical_vert,fragmentShader:ce.meshphysical_frag},toon:{uniforms:Ln([Lt.common,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.gradientmap,Lt.fog,Lt.lights,{emissive:{value:new ee(0)}}]),vertexShader:ce.meshtoon_vert,fragmentShader:ce.meshtoon_frag},matcap:{uniforms:Ln([Lt.common,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,{matcap:{value:null}}]),vertexShader:ce.meshmatcap_vert,fragmentShader:ce.meshmatcap_frag},points:{uniforms:Ln([Lt.points,Lt.fog]),vertexShader:ce.points_vert,fragmentShader:ce.points_frag},dashed:{uniforms:Ln([Lt.common,Lt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ce.linedashed_vert,fragmentShader:ce.linedashed_frag},depth:{uniforms:Ln([Lt.common,Lt.displacementmap]),vertexShader:ce.depth_vert,fragmentShader:ce.depth_frag},normal:{uniforms:Ln([Lt.common,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,{opacity:{value:1}}]),vertexShader:ce.meshnormal_vert,fragmentShader:ce.meshnormal_frag},sprite:{uniforms:Ln([Lt.sprite,Lt.fog]),vertexShader:ce.sprite_vert,fragmentShader:ce.sprite_frag},background:{uniforms:{uvTransform:{value:new te},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ce.background_vert,fragmentShader:ce.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new te}},vertexShader:ce.backgroundCube_vert,fragmentShader:ce.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ce.cube_vert,fragmentShader:ce.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ce.equirect_vert,fragmentShader:ce.equirect_frag},distance:{uniforms:Ln([Lt.common,Lt.displacementmap,{referencePosition:{value:new X},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ce.distance_vert,fragmentShader:ce.distance_frag},shadow:{uniforms:Ln([Lt.lights,Lt.fog,{color:{value:new ee(0)},opacity:{value:1}}]),vertexShader:ce.shadow_vert,fragmentShader:ce.shadow_frag}};Xi.physical={uniforms:Ln([Xi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new te},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new te},clearcoatNormalScale:{value:new Jt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new te},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new te},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new te},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new te},sheen:{value:0},sheenColor:{value:new ee(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new te},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new te},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new te},transmissionSamplerSize:{value:new Jt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new te},attenuationDistance:{value:0},attenuationColor:{value:new ee(0)},specularColor:{value:new ee(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new te},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new te},anisotropyVector:{value:new Jt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new te}}]),vertexShader:ce.meshphysical_vert,fragmentShader:ce.meshphysical_frag};var Cc={r:0,b:0,g:0},bv=new Ie,Yp=new te;Yp.set(-1,0,0,0,1,0,0,0,1);function wv(n,t,e,i,s,r){let o=new ee(0),a=s===!0?0:1,l,c,u=null,h=0,f=null;function d(_){let E=_.isScene===!0?_.background:null;if(E&&E.isTexture){let S=_.backgroundBlurriness>0;E=t.get(E,S)}return E}function g(_){let E=!1,S=d(_);S===null?m(o,a):S&&S.isColor&&(m(S,1),E=!0);let C=n.xr.getEnvironmentBlendMode();C==="additive"?e.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||E)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function y(_,E){let S=d(E);S&&S.isCubeTexture?(c===void 0&&(c=new Gn(new $r(1,1,1),new Gi({name:"BackgroundCubeMaterial",uniforms:sr(Xi.backgroundCube.uniforms),vertexShader:Xi.backgroundCube.vertexShader,fragmentShader:Xi.backgroundCube.fragmentShader,side:Hn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,b,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=E.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(bv.makeRotationFromEuler(E.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Yp),c.material.toneMapped=ge.getTransfer(S.colorSpace)!==we,(u!==S||h!==S.version||f!==n.toneMapping)&&(c.material.needsUpdate=!0,u=S,h=S.version,f=n.toneMapping),c.layers.enableAll(),_.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new Gn(new ea(2,2),new Gi({name:"BackgroundMaterial",uniforms:sr(Xi.background.uniforms),vertexShader:Xi.background.vertexShader,fragmentShader:Xi.background.fragmentShader,side:Ds,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,l.material.toneMapped=ge.getTransfer(S.colorSpace)!==we,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(u!==S||h!==S.version||f!==n.toneMapping)&&(l.material.needsUpdate=!0,u=S,h=S.version,f=n.toneMapping),l.layers.enableAll(),_.unshift(l,l.geometry,l.material,0,0,null))}function m(_,E){_.getRGB(Cc,Tu(n)),e.buffers.color.setClear(Cc.r,Cc.g,Cc.b,E,r)}function p(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(_,E=1){o.set(_),a=E,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(_){a=_,m(o,a)},render:g,addToRenderList:y,dispose:p}}function Tv(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=f(null),r=s,o=!1;function a(R,F,k,N,V){let Y=!1,G=h(R,N,k,F);r!==G&&(r=G,c(r.object)),Y=d(R,N,k,V),Y&&g(R,N,k,V),V!==null&&t.update(V,n.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,S(R,F,k,N),V!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(V).buffer))}function l(){return n.createVertexArray()}function c(R){return n.bindVertexArray(R)}function u(R){return n.deleteVertexArray(R)}function h(R,F,k,N){let V=N.wireframe===!0,Y=i[F.id];Y===void 0&&(Y={},i[F.id]=Y);let G=R.isInstancedMesh===!0?R.id:0,lt=Y[G];lt===void 0&&(lt={},Y[G]=lt);let K=lt[k.id];K===void 0&&(K={},lt[k.id]=K);let Q=K[V];return Q===void 0&&(Q=f(l()),K[V]=Q),Q}function f(R){let F=[],k=[],N=[];for(let V=0;V<e;V++)F[V]=0,k[V]=0,N[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:F,enabledAttributes:k,attributeDivisors:N,object:R,attributes:{},index:null}}function d(R,F,k,N){let V=r.attributes,Y=F.attributes,G=0,lt=k.getAttributes();for(let K in lt)if(lt[K].location>=0){let it=V[K],dt=Y[K];if(dt===void 0&&(K==="instanceMatrix"&&R.instanceMatrix&&(dt=R.instanceMatrix),K==="instanceColor"&&R.instanceColor&&(dt=R.instanceColor)),it===void 0||it.attribute!==dt||dt&&it.data!==dt.data)return!0;G++}return r.attributesNum!==G||r.index!==N}function g(R,F,k,N){let V={},Y=F.attributes,G=0,lt=k.getAttributes();for(let K in lt)if(lt[K].location>=0){let it=Y[K];it===void 0&&(K==="instanceMatrix"&&R.instanceMatrix&&(it=R.instanceMatrix),K==="instanceColor"&&R.instanceColor&&(it=R.instanceColor));let dt={};dt.attribute=it,it&&it.data&&(dt.data=it.data),V[K]=dt,G++}r.attributes=V,r.attributesNum=G,r.index=N}function y(){let R=r.newAttributes;for(let F=0,k=R.length;F<k;F++)R[F]=0}function m(R){p(R,0)}function p(R,F){let k=r.newAttributes,N=r.enabledAttributes,V=r.attributeDivisors;k[R]=1,N[R]===0&&(n.enableVertexAttribArray(R),N[R]=1),V[R]!==F&&(n.vertexAttribDivisor(R,F),V[R]=F)}function _(){let R=r.newAttributes,F=r.enabledAttributes;for(let k=0,N=F.length;k<N;k++)F[k]!==R[k]&&(n.disableVertexAttribArray(k),F[k]=0)}function E(R,F,k,N,V,Y,G){G===!0?n.vertexAttribIPointer(R,F,k,V,Y):n.vertexAttribPointer(R,F,k,N,V,Y)}function S(R,F,k,N){y();let V=N.attributes,Y=k.getAttributes(),G=F.defaultAttributeValues;for(let lt in Y){let K=Y[lt];if(K.location>=0){let Q=V[lt];if(Q===void 0&&(lt==="instanceMatrix"&&R.instanceMatrix&&(Q=R.instanceMatrix),lt==="instanceColor"&&R.instanceColor&&(Q=R.instanceColor)),Q!==void 0){let it=Q.normalized,dt=Q.itemSize,ft=t.get(Q);if(ft===void 0)continue;let tt=ft.buffer,ut=ft.type,gt=ft.bytesPerElement,Mt=ut===n.INT||ut===n.UNSIGNED_INT||Q.gpuType===Wl;if(Q.isInterleavedBufferAttribute){let bt=Q.data,Ht=bt.isInterleavedBuffer===!0?bt.stride:bt.itemSize,se=Q.offset;if(bt.isInstancedInterleavedBuffer||bt.isInstancedBufferAttribute){for(let Vt=0;Vt<K.locationSize;Vt++)p(K.location+Vt,bt.meshPerAttribute);R.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=bt.meshPerAttribute*bt.count)}else for(let Vt=0;Vt<K.locationSize;Vt++)m(K.location+Vt);n.bindBuffer(n.ARRAY_BUFFER,tt);for(let Vt=0;Vt<K.locationSize;Vt++)E(K.location+Vt,dt/K.locationSize,ut,it,Ht*gt,(se+dt/K.locationSize*Vt)*gt,Mt)}else{if(Q.isInstancedBufferAttribute){for(let bt=0;bt<K.locationSize;bt++)p(K.location+bt,Q.meshPerAttribute);R.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let bt=0;bt<K.locationSize;bt++)m(K.location+bt);n.bindBuffer(n.ARRAY_BUFFER,tt);for(let bt=0;bt<K.locationSize;bt++)E(K.location+bt,dt/K.locationSize,ut,it,dt*gt,dt/K.locationSize*bt*gt,Mt)}}else if(G!==void 0){let it=G[lt];if(it!==void 0)switch(it.length){case 2:n.vertexAttrib2fv(K.location,it);break;case 3:n.vertexAttrib3fv(K.location,it);break;case 4:n.vertexAttrib4fv(K.location,it);break;default:n.vertexAttrib1fv(K.location,it)}}}}_()}function C(){L();for(let R in i){let F=i[R];for(let k in F){let N=F[k];for(let V in N){let Y=N[V];for(let G in Y)u(Y[G].object),delete Y[G];delete N[V]}}delete i[R]}}function b(R){if(i[R.id]===void 0)return;let F=i[R.id];for(let k in F){let N=F[k];for(let V in N){let Y=N[V];for(let G in Y)u(Y[G].object),delete Y[G];delete N[V]}}delete i[R.id]}function x(R){for(let F in i){let k=i[F];for(let N in k){let V=k[N];if(V[R.id]===void 0)continue;let Y=V[R.id];for(let G in Y)u(Y[G].object),delete Y[G];delete V[R.id]}}}function T(R){for(let F in i){let k=i[F],N=R.isInstancedMesh===!0?R.id:0,V=k[N];if(V!==void 0){for(let Y in V){let G=V[Y];for(let lt in G)u(G[lt].object),delete G[lt];delete V[Y]}delete k[N],Object.keys(k).length===0&&delete i[F]}}}function L(){P(),o=!0,r!==s&&(r=s,c(r.object))}function P(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:L,resetDefaultState:P,dispose:C,releaseStatesOfGeometry:b,releaseStatesOfObject:T,releaseStatesOfProgram:x,initAttributes:y,enableAttribute:m,disableUnusedAttributes:_}}function Av(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),e.update(c,i,u))}function a(l,c,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let f=0;for(let d=0;d<u;d++)f+=c[d];e.update(f,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function Ev(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let x=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(x){return!(x!==Ei&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let T=x===Ai&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(x!==Yn&&x!==mi&&!T&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(x){if(x==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",u=l(c);u!==c&&(qt("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),f=e.logarithmicDepthBuffer===!0&&h===!1;e.reversedDepthBuffer===!0&&h===!1&&qt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&h===!0&&qt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),p=n.getParameter(n.MAX_VERTEX_ATTRIBS),_=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),E=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),C=n.getParameter(n.MAX_SAMPLES),b=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:h,maxTextures:d,maxVertexTextures:g,maxTextureSize:y,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:_,maxVaryings:E,maxFragmentUniforms:S,maxSamples:C,samples:b}}function Cv(n){let t=this,e=null,i=0,s=!1,r=!1,o=new ni,a=new te,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){let d=h.length!==0||f||i!==0||s;return s=f,i=h.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,f){e=u(h,f,0)},this.setState=function(h,f,d){let g=h.clippingPlanes,y=h.clipIntersection,m=h.clipShadows,p=n.get(h);if(!s||g===null||g.length===0||r&&!m)r?u(null):c();else{let _=r?0:i,E=_*4,S=p.clippingState||null;l.value=S,S=u(g,f,E,d);for(let C=0;C!==E;++C)S[C]=e[C];p.clippingState=S,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=_}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function u(h,f,d,g){let y=h!==null?h.length:0,m=null;if(y!==0){if(m=l.value,g!==!0||m===null){let p=d+y*4,_=f.matrixWorldInverse;a.getNormalMatrix(_),(m===null||m.length<p)&&(m=new Float32Array(p));for(let E=0,S=d;E!==y;++E,S+=4)o.copy(h[E]).applyMatrix4(_,a),o.normal.toArray(m,S),m[S+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=y,t.numIntersection=0,m}}var va=class extends ri{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new Jo(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new $r(5,5,5),r=new Gi({name:"CubemapFromEquirect",uniforms:sr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Hn,blending:tr});r.uniforms.tEquirect.value=e;let o=new Gn(s,r),a=e.minFilter;return e.minFilter===cs&&(e.minFilter=zn),new Kr(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},Tp=256,Rv=3,Pv=20,$p=256,Zp=16,Iv=3,Lv=new X,Dv=new ee,Pc=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Kr(1,10,null),this._boxMesh=new Gn(new $r(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=Lv}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);e>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,f=l.autoClearColor,d=l.autoClearDepth,g=l.autoClearStencil,y=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(t.background=l.getClearColor(Dv));let m=new Kr(i,s,u);return m.position.copy(a),m.update(l,t),l.autoClear=h,l.autoClearColor=f,l.autoClearDepth=d,l.autoClearStencil=g,t.background=y,e>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Cp(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Ep(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Tp,Mu(t))}_fromTexture(t,e){t.mapping===nr||t.mapping===to?this._setSize(t.image.length===0?Tp:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=Ap(t,!1,!1),i=Math.log2(t)-Rv;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Ap(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===nr||t.mapping===to?(this._cubemapMaterial===null&&(this._cubemapMaterial=Cp()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Ep()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=Nv(),this._integrationMaterial=Uv());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/Zp);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-Iv)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/($p*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=Fv());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function Ap(n,t,e){return new va(n,{minFilter:cs,generateMipmaps:t,type:Ai,colorSpace:zo,depthBuffer:e})}function Sa(n,t,e){return new Gi({name:n,uniforms:t,vertexShader:ce.cube_vert,fragmentShader:e,side:Hn,blending:tr,depthTest:!1,depthWrite:!1})}function Nv(){return Sa("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${$p}u

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
	`)}function Uv(){return Sa("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Zp}},`

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
	`)}function Fv(){return Sa("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${Pv}
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
	`)}function Ep(){return Sa("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function Cp(){return Sa("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function Ov(n){let t=new WeakMap,e=new WeakMap,i=null;function s(f,d=!1){return f==null?null:d?o(f):r(f)}function r(f){if(f&&f.isTexture){let d=f.mapping;if(d===Vl||d===Gl)if(t.has(f)){let g=t.get(f).texture;return a(g,f.mapping)}else{let g=f.image;if(g&&g.height>0){let y=new va(g.height);return y.fromEquirectangularTexture(n,f),t.set(f,y),f.addEventListener("dispose",c),a(y.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let d=f.mapping,g=d===Vl||d===Gl,y=d===nr||d===to;if(g||y){let m=e.get(f),p=m!==void 0?m.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==p)return i===null&&(i=new Pc(n)),m=g?i.fromEquirectangular(f,m):i.fromCubemap(f,m),m.texture.pmremVersion=f.pmremVersion,e.set(f,m),m.texture;if(m!==void 0)return m.texture;{let _=f.image;return g&&_&&_.height>0||y&&_&&l(_)?(i===null&&(i=new Pc(n)),m=g?i.fromEquirectangular(f):i.fromCubemap(f),m.texture.pmremVersion=f.pmremVersion,e.set(f,m),f.addEventListener("dispose",u),m.texture):null}}}return f}function a(f,d){return d===Vl?f.mapping=nr:d===Gl&&(f.mapping=to),f}function l(f){let d=0,g=6;for(let y=0;y<g;y++)f[y]!==void 0&&d++;return d===g}function c(f){let d=f.target;d.removeEventListener("dispose",c);let g=t.get(d);g!==void 0&&(t.delete(d),g.dispose())}function u(f){let d=f.target;d.removeEventListener("dispose",u);let g=e.get(d);g!==void 0&&(e.delete(d),g.dispose())}function h(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function Bv(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&Fo("WebGLRenderer: "+i+" extension not supported."),s}}}function kv(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&t.remove(g.index);for(let m in g.attributes)t.remove(g.attributes[m]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let y=r.get(g);y&&(t.remove(y),r.delete(g)),i.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,e.memory.geometries--}function c(g,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),e.memory.geometries++),y}function u(g){let y=g.attributes;for(let m in y)t.update(y[m],n.ARRAY_BUFFER)}function h(g){let y=g.index,m=g.attributes.position,p=0;if(m===void 0)return;let _=y!==null?y.array.length:m.array.length/3-1,E=m.count>=65535?Yo:qo,S=new E(Math.ceil(_/3)*6,1),C=S.array;if(y!==null){let x=y.array;p=y.version;for(let T=0,L=0;T<_;T+=3){let P=x[T+0],R=x[T+1],F=x[T+2];C[L++]=P,C[L++]=R,C[L++]=R,C[L++]=F,C[L++]=F,C[L++]=P}}else{p=m.version;for(let x=0,T=0;x<_;x+=3){let L=x+0,P=x+1,R=x+2;C[T++]=L,C[T++]=P,C[T++]=P,C[T++]=R,C[T++]=R,C[T++]=L}}S.version=p;let b=r.get(g);b&&t.remove(b),r.set(g,S)}function f(g){let y=r.get(g);if(y){let m=g.index;m!==null&&y.version<m.version&&h(g)}else h(g);return r.get(g)}function d(){for(let g in s){let y=s[g].deref();y!==void 0&&l(y)}}return{get:c,update:u,getWireframeAttribute:f,dispose:d}}function zv(n,t,e){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,f){n.drawElements(i,f,r,h*o),e.update(f,i,1)}function c(h,f,d){d!==0&&(n.drawElementsInstanced(i,f,r,h*o,d),e.update(f,i,d))}function u(h,f,d){if(d===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,f,0,r,h,0,d);let y=0;for(let m=0;m<d;m++)y+=f[m];e.update(y,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function Vv(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:Qt("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function Gv(n,t,e){let i=new WeakMap,s=new We;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,f=i.get(a);if(f===void 0||f.count!==h){let L=function(){x.dispose(),i.delete(a),a.removeEventListener("dispose",L)};f!==void 0&&f.texture.dispose();let d=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],_=a.morphAttributes.color||[],E=0;d===!0&&(E=1),g===!0&&(E=2),y===!0&&(E=3);let S=a.attributes.position.count*E,C=1;S>t.maxTextureSize&&(C=Math.ceil(S/t.maxTextureSize),S=t.maxTextureSize);let b=new Float32Array(S*C*4*h),x=new Ho(b,S,C,h);x.type=mi,x.needsUpdate=!0;let T=E*4;for(let P=0;P<h;P++){let R=m[P],F=p[P],k=_[P],N=S*C*4*P;for(let V=0;V<R.count;V++){let Y=V*T;d===!0&&(s.fromBufferAttribute(R,V),b[N+Y+0]=s.x,b[N+Y+1]=s.y,b[N+Y+2]=s.z,b[N+Y+3]=0),g===!0&&(s.fromBufferAttribute(F,V),b[N+Y+4]=s.x,b[N+Y+5]=s.y,b[N+Y+6]=s.z,b[N+Y+7]=0),y===!0&&(s.fromBufferAttribute(k,V),b[N+Y+8]=s.x,b[N+Y+9]=s.y,b[N+Y+10]=s.z,b[N+Y+11]=k.itemSize===4?s.w:1)}}f={count:h,texture:x,size:new Jt(S,C)},i.set(a,f),a.addEventListener("dispose",L)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let d=0;for(let y=0;y<c.length;y++)d+=c[y];let g=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(n,"morphTargetBaseInfluence",g),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",f.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",f.size)}return{update:r}}function Hv(n,t,e,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,f=t.get(c,h);if(r.get(f)!==u&&(t.update(f),r.set(f,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==u&&(d.update(),r.set(d,u))}return f}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),e.remove(u.instanceMatrix),u.instanceColor!==null&&e.remove(u.instanceColor)}return{update:o,dispose:a}}var Wv={[tu]:"LINEAR_TONE_MAPPING",[eu]:"REINHARD_TONE_MAPPING",[nu]:"CINEON_TONE_MAPPING",[iu]:"ACES_FILMIC_TONE_MAPPING",[ru]:"AGX_TONE_MAPPING",[ou]:"NEUTRAL_TONE_MAPPING",[su]:"CUSTOM_TONE_MAPPING"};function Xv(n,t,e,i,s,r){let o=new ri(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new Vn;u.setAttribute("position",new je([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new je([0,2,0,0,2,0],2));let h=new Tl({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),f=new Gn(u,h),d=new oa(-1,1,1,-1,0,1),g=null,y=null,m=!1,p,_=null,E=[],S=!1;this.setSize=function(C,b){o.setSize(C,b),a!==null&&a.setSize(C,b),l!==null&&l.setSize(C,b);for(let x=0;x<E.length;x++){let T=E[x];T.setSize&&T.setSize(C,b)}},this.setEffects=function(C){E=C,S=E.length>0&&E[0].isRenderPass===!0;let b=o.width,x=o.height;E.length>0&&a===null&&(a=new ri(b,x,{type:Ai,depthBuffer:!1,stencilBuffer:!1}),l=new ri(b,x,{type:Ai,depthBuffer:!1,stencilBuffer:!1}));let T=s===!0&&E.some(L=>L.needsDepthTexture===!0);T!==(o.depthTexture!==null)&&(T===!0&&c===null&&(c=new ls(b,x),r===!0&&(c.format=hs,c.type=ir)),o.dispose(),o.depthTexture=T?c:null,o.resolveDepthBuffer=T,o.storeMultisampledDepthBuffer=T);for(let L=0;L<E.length;L++){let P=E[L];P.setSize&&P.setSize(b,x),T&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(c)}},this.begin=function(C,b){if(m||C.toneMapping===Hi&&E.length===0)return!1;if(_=b,b!==null){let x=b.width,T=b.height;(o.width!==x||o.height!==T)&&this.setSize(x,T)}return S===!1&&C.setRenderTarget(o),p=C.toneMapping,C.toneMapping=Hi,!0},this.hasRenderPass=function(){return S},this.end=function(C,b){C.toneMapping=p,m=!0;let x=o,T=a;for(let L=0;L<E.length;L++){let P=E[L];P.enabled!==!1&&(P.render(C,T,x,b),P.needsSwap!==!1&&(x=T,T=T===a?l:a))}if(g!==C.outputColorSpace||y!==C.toneMapping){g=C.outputColorSpace,y=C.toneMapping,h.defines={},ge.getTransfer(g)===we&&(h.defines.SRGB_TRANSFER="");let L=Wv[y];L&&(h.defines[L]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=x.texture,C.setRenderTarget(_),C.render(f,d),_=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var Kp=new Xn,Jp=new ls(1,1),jp=new jo(1),Qp=new Ho,tm=new vl,em=new Jo,Rp=[],Pp=[],Ip=new Float32Array(16),Lp=new Float32Array(9),Dp=new Float32Array(4);function so(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=Rp[s];if(r===void 0&&(r=new Float32Array(s),Rp[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function dn(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function pn(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function Lc(n,t){let e=Pp[t];e===void 0&&(e=new Int32Array(t),Pp[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function qv(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function Yv(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(dn(e,t))return;n.uniform2fv(this.addr,t),pn(e,t)}}function $v(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(dn(e,t))return;n.uniform3fv(this.addr,t),pn(e,t)}}function Zv(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(dn(e,t))return;n.uniform4fv(this.addr,t),pn(e,t)}}function Kv(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(dn(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),pn(e,t)}else{if(dn(e,i))return;Dp.set(i),n.uniformMatrix2fv(this.addr,!1,Dp),pn(e,i)}}function Jv(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(dn(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),pn(e,t)}else{if(dn(e,i))return;Lp.set(i),n.uniformMatrix3fv(this.addr,!1,Lp),pn(e,i)}}function jv(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(dn(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),pn(e,t)}else{if(dn(e,i))return;Ip.set(i),n.uniformMatrix4fv(this.addr,!1,Ip),pn(e,i)}}function Qv(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function tS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(dn(e,t))return;n.uniform2iv(this.addr,t),pn(e,t)}}function eS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(dn(e,t))return;n.uniform3iv(this.addr,t),pn(e,t)}}function nS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(dn(e,t))return;n.uniform4iv(this.addr,t),pn(e,t)}}function iS(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function sS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(dn(e,t))return;n.uniform2uiv(this.addr,t),pn(e,t)}}function rS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(dn(e,t))return;n.uniform3uiv(this.addr,t),pn(e,t)}}function oS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(dn(e,t))return;n.uniform4uiv(this.addr,t),pn(e,t)}}function Dc(n){return n.version===0&&(n.compareFunction=xu,n.needsUpdate=!0),n}function aS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Dc(Jp):r=Kp,e.setTexture2D(t||r,s)}function lS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||tm,s)}function cS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Dc(jp):r=em,e.setTextureCube(t||r,s)}function hS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||Qp,s)}function uS(n){switch(n){case 5126:return qv;case 35664:return Yv;case 35665:return $v;case 35666:return Zv;case 35674:return Kv;case 35675:return Jv;case 35676:return jv;case 5124:case 35670:return Qv;case 35667:case 35671:return tS;case 35668:case 35672:return eS;case 35669:case 35673:return nS;case 5125:return iS;case 36294:return sS;case 36295:return rS;case 36296:return oS;case 35678:case 36198:case 36298:case 36306:case 35682:return aS;case 35679:case 36299:case 36307:return lS;case 35680:case 36300:case 36308:case 36293:return cS;case 36289:case 36303:case 36311:case 36292:return hS}}function fS(n,t){n.uniform1fv(this.addr,t)}function dS(n,t){let e=so(t,this.size,2);n.uniform2fv(this.addr,e)}function pS(n,t){let e=so(t,this.size,3);n.uniform3fv(this.addr,e)}function mS(n,t){let e=so(t,this.size,4);n.uniform4fv(this.addr,e)}function gS(n,t){let e=so(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function _S(n,t){let e=so(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function xS(n,t){let e=so(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function yS(n,t){n.uniform1iv(this.addr,t)}function vS(n,t){n.uniform2iv(this.addr,t)}function SS(n,t){n.uniform3iv(this.addr,t)}function MS(n,t){n.uniform4iv(this.addr,t)}function bS(n,t){n.uniform1uiv(this.addr,t)}function wS(n,t){n.uniform2uiv(this.addr,t)}function TS(n,t){n.uniform3uiv(this.addr,t)}function AS(n,t){n.uniform4uiv(this.addr,t)}function ES(n,t,e){let i=this.cache,s=t.length,r=Lc(e,s);dn(i,r)||(n.uniform1iv(this.addr,r),pn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Dc(Jp):o=Kp;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function CS(n,t,e){let i=this.cache,s=t.length,r=Lc(e,s);dn(i,r)||(n.uniform1iv(this.addr,r),pn(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||tm,r[o])}function RS(n,t,e){let i=this.cache,s=t.length,r=Lc(e,s);dn(i,r)||(n.uniform1iv(this.addr,r),pn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Dc(jp):o=em;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function PS(n,t,e){let i=this.cache,s=t.length,r=Lc(e,s);dn(i,r)||(n.uniform1iv(this.addr,r),pn(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||Qp,r[o])}function IS(n){switch(n){case 5126:return fS;case 35664:return dS;case 35665:return pS;case 35666:return mS;case 35674:return gS;case 35675:return _S;case 35676:return xS;case 5124:case 35670:return yS;case 35667:case 35671:return vS;case 35668:case 35672:return SS;case 35669:case 35673:return MS;case 5125:return bS;case 36294:return wS;case 36295:return TS;case 36296:return AS;case 35678:case 36198:case 36298:case 36306:case 35682:return ES;case 35679:case 36299:case 36307:return CS;case 35680:case 36300:case 36308:case 36293:return RS;case 36289:case 36303:case 36311:case 36292:return PS}}var Iu=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=uS(e.type)}},Lu=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=IS(e.type)}},Du=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},Ru=/(\w+)(\])?(\[|\.)?/g;function Np(n,t){n.seq.push(t),n.map[t.id]=t}function LS(n,t,e){let i=n.name,s=i.length;for(Ru.lastIndex=0;;){let r=Ru.exec(i),o=Ru.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Np(e,c===void 0?new Iu(a,n,t):new Lu(a,n,t));break}else{let h=e.map[a];h===void 0&&(h=new Du(a),Np(e,h)),e=h}}}var io=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);LS(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function Up(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var DS=37297,NS=0;function US(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var Fp=new te;function FS(n){ge._getMatrix(Fp,ge.workingColorSpace,n);let t=`mat3( ${Fp.elements.map(e=>e.toFixed(4))} )`;switch(ge.getTransfer(n)){case Vo:return[t,"LinearTransferOETF"];case we:return[t,"sRGBTransferOETF"];default:return qt("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function Op(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+US(n.getShaderSource(t),a)}else return r}function OS(n,t){let e=FS(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var BS={[tu]:"Linear",[eu]:"Reinhard",[nu]:"Cineon",[iu]:"ACESFilmic",[ru]:"AgX",[ou]:"Neutral",[su]:"Custom"};function kS(n,t){let e=BS[t];return e===void 0?(qt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Rc=new X;function zS(){ge.getLuminanceCoefficients(Rc);let n=Rc.x.toFixed(4),t=Rc.y.toFixed(4),e=Rc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function VS(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(ya).join(`
`)}function GS(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function HS(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function ya(n){return n!==""}function Bp(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function kp(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var WS=/^[ \t]*#include +<([\w\d./]+)>/gm;function Nu(n){return n.replace(WS,XS)}function XS(n,t){let e=ce[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Nu(e)}var qS=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function zp(n){return n.replace(qS,YS)}function YS(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Vp(n){let t=`precision ${n.precision} float;
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
#define LOW_PRECISION`),t}var $S={[ca]:"SHADOWMAP_TYPE_PCF",[jr]:"SHADOWMAP_TYPE_VSM"};function ZS(n){return $S[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var KS={[to]:"ENVMAP_MODE_REFRACTION"};function JS(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":KS[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var jS={[zl]:"ENVMAP_BLENDING_MULTIPLY",[ip]:"ENVMAP_BLENDING_MIX",[sp]:"ENVMAP_BLENDING_ADD"};function QS(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":jS[n.combine]||"ENVMAP_BLENDING_NONE"}function tM(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=ZS(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=JS(e),h=QS(e),f=VS(e),d=GS(r),g=s.createProgram(),y,m,p=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(y=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(ya).join(`
`),y.length>0&&(y+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(ya).join(`
`),m.length>0&&(m+=`
`)):(y=[Vp(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(ya).join(`
`),m=[Vp(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+h:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==Hi?"#define TONE_MAPPING":"",e.toneMapping!==Hi?ce.tonemapping_pars_fragment:"",e.toneMapping!==Hi?kS("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",ce.colorspace_pars_fragment,OS("linearToOutputTexel",e.outputColorSpace),zS(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(ya).join(`
`)),o=Nu(o),o=Bp(o,e),o=kp(o,e),a=Nu(a),a=Bp(a,e),a=kp(a,e),o=zp(o),a=zp(a),e.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,y=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,m=["#define varying in",e.glslVersion===yu?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===yu?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let _=p+y+o,E=p+m+a,S=Up(s,s.VERTEX_SHADER,_),C=Up(s,s.FRAGMENT_SHADER,E);s.attachShader(g,S),s.attachShader(g,C),e.index0AttributeName!==void 0?s.bindAttribLocation(g,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function b(P){if(n.debug.checkShaderErrors){let R=s.getProgramInfoLog(g)||"",F=s.getShaderInfoLog(S)||"",k=s.getShaderInfoLog(C)||"",N=R.trim(),V=F.trim(),Y=k.trim(),G=!0,lt=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(G=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,g,S,C);else{let K=Op(s,S,"vertex"),Q=Op(s,C,"fragment");Qt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+N+`
`+K+`
`+Q)}else N!==""?qt("WebGLProgram: Program Info Log:",N):(V===""||Y==="")&&(lt=!1);lt&&(P.diagnostics={runnable:G,programLog:N,vertexShader:{log:V,prefix:y},fragmentShader:{log:Y,prefix:m}})}s.deleteShader(S),s.deleteShader(C),x=new io(s,g),T=HS(s,g)}let x;this.getUniforms=function(){return x===void 0&&b(this),x};let T;this.getAttributes=function(){return T===void 0&&b(this),T};let L=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return L===!1&&(L=s.getProgramParameter(g,DS)),L},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=NS++,this.cacheKey=t,this.usedTimes=1,this.program=g,this.vertexShader=S,this.fragmentShader=C,this}var eM=0,Uu=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new Fu(t),e.set(t,i)),i}},Fu=class{constructor(t){this.id=eM++,this.code=t,this.usedTimes=0}};function nM(n){return n===Ns||n===ma||n===ga}function iM(n,t,e,i,s,r){let o=new Wo,a=new Uu,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(x){return l.add(x),x===0?"uv":`uv${x}`}function g(x,T,L,P,R,F){let k=P.fog,N=R.geometry,V=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?P.environment:null,Y=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,G=t.get(x.envMap||V,Y),lt=f[x.type],K=i.precision;x.precision!==null&&(K=i.getMaxPrecision(x.precision),K!==x.precision&&qt("WebGLProgram.getParameters:",x.precision,"not supported, using",K,"instead."));let Q=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,it=Q!==void 0?Q.length:0,dt=0;N.morphAttributes.position!==void 0&&(dt=1),N.morphAttributes.normal!==void 0&&(dt=2),N.morphAttributes.color!==void 0&&(dt=3);let ft,tt,ut,gt;if(lt){let Ct=Xi[lt];ft=Ct.vertexShader,tt=Ct.fragmentShader}else{ft=x.vertexShader,tt=x.fragmentShader;let Ct=a.getVertexShaderStage(x),oe=a.getFragmentShaderStage(x);a.update(x,Ct,oe),ut=Ct.id,gt=oe.id}let Mt=n.getRenderTarget(),bt=n.state.buffers.depth.getReversed(),Ht=R.isInstancedMesh===!0,se=R.isBatchedMesh===!0,Vt=!!x.map,he=!!x.matcap,ae=!!G,ne=ae&&G.isPMREMTexture===!0,Ge=!!x.aoMap,Ue=!!x.lightMap,nn=!!x.bumpMap&&x.wireframe===!1,Re=!!x.normalMap,xn=!!x.displacementMap,xe=!!x.emissiveMap,un=!!x.metalnessMap,Ye=!!x.roughnessMap,sn=x.anisotropy>0,B=x.clearcoat>0,Rt=x.diffuseRoughness>0,Yt=x.dispersion>0,re=x.retroreflectivity>0,wt=x.iridescence>0,Le=x.sheen>0,zt=x.transmission>0,Xt=sn&&!!x.anisotropyMap,I=B&&!!x.clearcoatMap,M=B&&!!x.clearcoatNormalMap,q=B&&!!x.clearcoatRoughnessMap,ht=Rt&&!!x.diffuseRoughnessMap,ot=wt&&!!x.iridescenceMap,xt=wt&&!!x.iridescenceThicknessMap,yt=Le&&!!x.sheenColorMap,et=Le&&!!x.sheenRoughnessMap,st=!!x.specularMap,mt=!!x.specularColorMap,O=!!x.specularIntensityMap,rt=zt&&!!x.transmissionMap,nt=zt&&!!x.thicknessMap,Tt=!!x.gradientMap,_t=!!x.alphaMap,St=x.alphaTest>0,Gt=!!x.alphaHash,Zt=!!x.extensions,ct=Hi;x.toneMapped&&(Mt===null||Mt.isXRRenderTarget===!0)&&(ct=n.toneMapping);let Ot=ne?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,Kt={shaderID:lt,shaderType:x.type,shaderName:x.name,vertexShader:ft,fragmentShader:tt,defines:x.defines,customVertexShaderID:ut,customFragmentShaderID:gt,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:K,batching:se,batchingColor:se&&R._colorsTexture!==null,instancing:Ht,instancingColor:Ht&&R.instanceColor!==null,instancingMorph:Ht&&R.morphTexture!==null,outputColorSpace:Mt===null?n.outputColorSpace:Mt.isXRRenderTarget===!0?Mt.texture.colorSpace:ge.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:Vt,matcap:he,envMap:ae,envMapMode:ae&&G.mapping,envMapPMREM:ne,envMapMaxLod:ne?Ot.length-1:null,envMapSize:ne?Ot[0].width:null,aoMap:Ge,lightMap:Ue,bumpMap:nn,normalMap:Re,displacementMap:xn,emissiveMap:xe,normalMapObjectSpace:Re&&x.normalMapType===ap,normalMapTangentSpace:Re&&x.normalMapType===Ec,packedNormalMap:Re&&x.normalMapType===Ec&&nM(x.normalMap.format),metalnessMap:un,roughnessMap:Ye,anisotropy:sn,anisotropyMap:Xt,clearcoat:B,clearcoatMap:I,clearcoatNormalMap:M,clearcoatRoughnessMap:q,diffuseRoughness:Rt,diffuseRoughnessMap:ht,dispersion:Yt,retroreflection:re,iridescence:wt,iridescenceMap:ot,iridescenceThicknessMap:xt,sheen:Le,sheenColorMap:yt,sheenRoughnessMap:et,specularMap:st,specularColorMap:mt,specularIntensityMap:O,transmission:zt,transmissionMap:rt,thicknessMap:nt,gradientMap:Tt,opaque:x.transparent===!1&&x.blending===Qr&&x.alphaToCoverage===!1,alphaMap:_t,alphaTest:St,alphaHash:Gt,combine:x.combine,mapUv:Vt&&d(x.map.channel),aoMapUv:Ge&&d(x.aoMap.channel),lightMapUv:Ue&&d(x.lightMap.channel),bumpMapUv:nn&&d(x.bumpMap.channel),normalMapUv:Re&&d(x.normalMap.channel),displacementMapUv:xn&&d(x.displacementMap.channel),emissiveMapUv:xe&&d(x.emissiveMap.channel),metalnessMapUv:un&&d(x.metalnessMap.channel),roughnessMapUv:Ye&&d(x.roughnessMap.channel),anisotropyMapUv:Xt&&d(x.anisotropyMap.channel),clearcoatMapUv:I&&d(x.clearcoatMap.channel),clearcoatNormalMapUv:M&&d(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&d(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ht&&d(x.diffuseRoughnessMap.channel),iridescenceMapUv:ot&&d(x.iridescenceMap.channel),iridescenceThicknessMapUv:xt&&d(x.iridescenceThicknessMap.channel),sheenColorMapUv:yt&&d(x.sheenColorMap.channel),sheenRoughnessMapUv:et&&d(x.sheenRoughnessMap.channel),specularMapUv:st&&d(x.specularMap.channel),specularColorMapUv:mt&&d(x.specularColorMap.channel),specularIntensityMapUv:O&&d(x.specularIntensityMap.channel),transmissionMapUv:rt&&d(x.transmissionMap.channel),thicknessMapUv:nt&&d(x.thicknessMap.channel),alphaMapUv:_t&&d(x.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(Re||sn),vertexNormals:!!N.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:R.isPoints===!0&&!!N.attributes.uv&&(Vt||_t),fog:!!k,useFog:x.fog===!0,fogExp2:!!k&&k.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||N.attributes.normal===void 0&&Re===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:bt,skinning:R.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:it,morphTextureStride:dt,numSunLights:T.sun.length,numDirLights:T.directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.hemi.length,numSunLightShadows:T.sunShadowMap.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numLightProbeGrids:F.filter(Ct=>Ct.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:n.shadowMap.enabled&&L.length>0,shadowMapType:n.shadowMap.type,toneMapping:ct,decodeVideoTexture:Vt&&x.map.isVideoTexture===!0&&ge.getTransfer(x.map.colorSpace)===we,decodeVideoTextureEmissive:xe&&x.emissiveMap.isVideoTexture===!0&&ge.getTransfer(x.emissiveMap.colorSpace)===we,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===qn,flipSided:x.side===Hn,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:Zt&&x.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Zt&&x.extensions.multiDraw===!0||se)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return Kt.vertexUv1s=l.has(1),Kt.vertexUv2s=l.has(2),Kt.vertexUv3s=l.has(3),l.clear(),Kt}function y(x){let T=[];if(x.shaderID?T.push(x.shaderID):(T.push(x.customVertexShaderID),T.push(x.customFragmentShaderID)),x.defines!==void 0)for(let L in x.defines)T.push(L),T.push(x.defines[L]);return x.isRawShaderMaterial===!1&&(m(T,x),p(T,x),T.push(n.outputColorSpace)),T.push(x.customProgramCacheKey),T.join()}function m(x,T){x.push(T.precision),x.push(T.outputColorSpace),x.push(T.envMapMode),x.push(T.envMapPMREM),x.push(T.envMapMaxLod),x.push(T.envMapSize),x.push(T.mapUv),x.push(T.alphaMapUv),x.push(T.lightMapUv),x.push(T.aoMapUv),x.push(T.bumpMapUv),x.push(T.normalMapUv),x.push(T.displacementMapUv),x.push(T.emissiveMapUv),x.push(T.metalnessMapUv),x.push(T.roughnessMapUv),x.push(T.anisotropyMapUv),x.push(T.clearcoatMapUv),x.push(T.clearcoatNormalMapUv),x.push(T.clearcoatRoughnessMapUv),x.push(T.diffuseRoughnessMapUv),x.push(T.iridescenceMapUv),x.push(T.iridescenceThicknessMapUv),x.push(T.sheenColorMapUv),x.push(T.sheenRoughnessMapUv),x.push(T.specularMapUv),x.push(T.specularColorMapUv),x.push(T.specularIntensityMapUv),x.push(T.transmissionMapUv),x.push(T.thicknessMapUv),x.push(T.combine),x.push(T.fogExp2),x.push(T.sizeAttenuation),x.push(T.morphTargetsCount),x.push(T.numSunLights),x.push(T.numDirLights),x.push(T.numPointLights),x.push(T.numSpotLights),x.push(T.numSpotLightMaps),x.push(T.numHemiLights),x.push(T.numRectAreaLights),x.push(T.numSunLightShadows),x.push(T.numDirLightShadows),x.push(T.numPointLightShadows),x.push(T.numSpotLightShadows),x.push(T.numSpotLightShadowsWithMaps),x.push(T.numLightProbes),x.push(T.numLightProbeGrids),x.push(T.shadowMapType),x.push(T.toneMapping),x.push(T.numClippingPlanes),x.push(T.numClipIntersection),x.push(T.depthPacking)}function p(x,T){o.disableAll(),T.instancing&&o.enable(0),T.instancingColor&&o.enable(1),T.instancingMorph&&o.enable(2),T.matcap&&o.enable(3),T.envMap&&o.enable(4),T.normalMapObjectSpace&&o.enable(5),T.normalMapTangentSpace&&o.enable(6),T.clearcoat&&o.enable(7),T.iridescence&&o.enable(8),T.alphaTest&&o.enable(9),T.vertexColors&&o.enable(10),T.vertexAlphas&&o.enable(11),T.vertexUv1s&&o.enable(12),T.vertexUv2s&&o.enable(13),T.vertexUv3s&&o.enable(14),T.vertexTangents&&o.enable(15),T.anisotropy&&o.enable(16),T.alphaHash&&o.enable(17),T.batching&&o.enable(18),T.dispersion&&o.enable(19),T.retroreflection&&o.enable(24),T.diffuseRoughness&&o.enable(25),T.batchingColor&&o.enable(20),T.gradientMap&&o.enable(21),T.packedNormalMap&&o.enable(22),T.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),T.fog&&o.enable(0),T.useFog&&o.enable(1),T.flatShading&&o.enable(2),T.logarithmicDepthBuffer&&o.enable(3),T.reversedDepthBuffer&&o.enable(4),T.skinning&&o.enable(5),T.morphTargets&&o.enable(6),T.morphNormals&&o.enable(7),T.morphColors&&o.enable(8),T.premultipliedAlpha&&o.enable(9),T.shadowMapEnabled&&o.enable(10),T.doubleSided&&o.enable(11),T.flipSided&&o.enable(12),T.useDepthPacking&&o.enable(13),T.dithering&&o.enable(14),T.transmission&&o.enable(15),T.sheen&&o.enable(16),T.opaque&&o.enable(17),T.pointsUvs&&o.enable(18),T.decodeVideoTexture&&o.enable(19),T.decodeVideoTextureEmissive&&o.enable(20),T.alphaToCoverage&&o.enable(21),T.numLightProbeGrids>0&&o.enable(22),T.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function _(x){let T=f[x.type],L;if(T){let P=Xi[T];L=Mp.clone(P.uniforms)}else L=x.uniforms;return L}function E(x,T){let L=u.get(T);return L!==void 0?++L.usedTimes:(L=new tM(n,T,x,s),c.push(L),u.set(T,L)),L}function S(x){if(--x.usedTimes===0){let T=c.indexOf(x);c[T]=c[c.length-1],c.pop(),u.delete(x.cacheKey),x.destroy()}}function C(x){a.remove(x)}function b(){a.dispose()}return{getParameters:g,getProgramCacheKey:y,getUniforms:_,acquireProgram:E,releaseProgram:S,releaseShaderCache:C,programs:c,dispose:b}}function sM(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function rM(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function Gp(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function Hp(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(f){let d=0;return f.isInstancedMesh&&(d+=2),f.isSkinnedMesh&&(d+=1),d}function a(f,d,g,y,m,p){let _=n[t];return _===void 0?(_={id:f.id,object:f,geometry:d,material:g,materialVariant:o(f),groupOrder:y,renderOrder:f.renderOrder,z:m,group:p},n[t]=_):(_.id=f.id,_.object=f,_.geometry=d,_.material=g,_.materialVariant=o(f),_.groupOrder=y,_.renderOrder=f.renderOrder,_.z=m,_.group=p),t++,_}function l(f,d,g,y,m,p,_){_.reversedDepth===!0&&(m=-m);let E=a(f,d,g,y,m,p);g.transmission>0?i.push(E):g.transparent===!0?s.push(E):e.push(E)}function c(f,d,g,y,m,p){let _=a(f,d,g,y,m,p);g.transmission>0?i.unshift(_):g.transparent===!0?s.unshift(_):e.unshift(_)}function u(f,d){e.length>1&&e.sort(f||rM),i.length>1&&i.sort(d||Gp),s.length>1&&s.sort(d||Gp)}function h(){for(let f=t,d=n.length;f<d;f++){let g=n[f];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function oM(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new Hp,n.set(i,[o])):s>=r.length?(o=new Hp,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function aM(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new X,color:new ee};break;case"SpotLight":e={position:new X,direction:new X,color:new ee,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new X,color:new ee,distance:0,decay:0};break;case"HemisphereLight":e={direction:new X,skyColor:new ee,groundColor:new ee};break;case"RectAreaLight":e={color:new ee,position:new X,halfWidth:new X,halfHeight:new X};break}return n[t.id]=e,e}}}function lM(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Jt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Jt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Jt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var cM=0;function hM(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function uM(n){let t=new aM,e=lM(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new X);let s=new X,r=new Ie,o=new Ie;function a(c){let u=0,h=0,f=0;for(let F=0;F<9;F++)i.probe[F].set(0,0,0);let d=0,g=0,y=0,m=0,p=0,_=0,E=0,S=0,C=0,b=0,x=0,T=0,L=0,P=0;c.sort(hM);for(let F=0,k=c.length;F<k;F++){let N=c[F],V=N.color,Y=N.intensity,G=N.distance,lt=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===Ns?lt=N.shadow.map.texture:lt=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)u+=V.r*Y,h+=V.g*Y,f+=V.b*Y;else if(N.isLightProbe){for(let K=0;K<9;K++)i.probe[K].addScaledVector(N.sh.coefficients[K],Y);P++}else if(N.isSunLight){let K=t.get(N);if(K.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,it=e.get(N);it.shadowIntensity=Q.intensity,it.shadowBias=Q.bias,it.shadowNormalBias=Q.normalBias,it.shadowRadius=Q.radius,it.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[g]=it,i.sunShadowMap[g]=lt;let dt=Q.getViewportCount();for(let ft=0;ft<dt;ft++)i.sunShadowMatrix[y+ft]=Q.getMatrix(ft),i.sunShadowCascade[y+ft]=Q._cascadeData[ft];y+=dt,g++}i.sun[d]=K,d++}else if(N.isDirectionalLight){let K=t.get(N);if(K.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,it=e.get(N);it.shadowIntensity=Q.intensity,it.shadowBias=Q.bias,it.shadowNormalBias=Q.normalBias,it.shadowRadius=Q.radius,it.shadowMapSize=Q.mapSize,i.directionalShadow[m]=it,i.directionalShadowMap[m]=lt,i.directionalShadowMatrix[m]=N.shadow.matrix,C++}i.directional[m]=K,m++}else if(N.isSpotLight){let K=t.get(N);K.position.setFromMatrixPosition(N.matrixWorld),K.color.copy(V).multiplyScalar(Y),K.distance=G,K.coneCos=Math.cos(N.angle),K.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),K.decay=N.decay,i.spot[_]=K;let Q=N.shadow;if(N.map&&(i.spotLightMap[T]=N.map,T++,Q.updateMatrices(N),N.castShadow&&L++),i.spotLightMatrix[_]=Q.matrix,N.castShadow){let it=e.get(N);it.shadowIntensity=Q.intensity,it.shadowBias=Q.bias,it.shadowNormalBias=Q.normalBias,it.shadowRadius=Q.radius,it.shadowMapSize=Q.mapSize,i.spotShadow[_]=it,i.spotShadowMap[_]=lt,x++}_++}else if(N.isRectAreaLight){let K=t.get(N);K.color.copy(V).multiplyScalar(Y),K.halfWidth.set(N.width*.5,0,0),K.halfHeight.set(0,N.height*.5,0),i.rectArea[E]=K,E++}else if(N.isPointLight){let K=t.get(N);if(K.color.copy(N.color).multiplyScalar(N.intensity),K.distance=N.distance,K.decay=N.decay,N.castShadow){let Q=N.shadow,it=e.get(N);it.shadowIntensity=Q.intensity,it.shadowBias=Q.bias,it.shadowNormalBias=Q.normalBias,it.shadowRadius=Q.radius,it.shadowMapSize=Q.mapSize,it.shadowCameraNear=Q.camera.near,it.shadowCameraFar=Q.camera.far,i.pointShadow[p]=it,i.pointShadowMap[p]=lt,i.pointShadowMatrix[p]=N.shadow.matrix,b++}i.point[p]=K,p++}else if(N.isHemisphereLight){let K=t.get(N);K.skyColor.copy(N.color).multiplyScalar(Y),K.groundColor.copy(N.groundColor).multiplyScalar(Y),i.hemi[S]=K,S++}}E>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Lt.LTC_FLOAT_1,i.rectAreaLTC2=Lt.LTC_FLOAT_2):(i.rectAreaLTC1=Lt.LTC_HALF_1,i.rectAreaLTC2=Lt.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=f;let R=i.hash;(R.sunLength!==d||R.directionalLength!==m||R.pointLength!==p||R.spotLength!==_||R.rectAreaLength!==E||R.hemiLength!==S||R.numSunShadows!==g||R.numDirectionalShadows!==C||R.numPointShadows!==b||R.numSpotShadows!==x||R.numSpotMaps!==T||R.numLightProbes!==P)&&(i.sun.length=d,i.directional.length=m,i.spot.length=_,i.rectArea.length=E,i.point.length=p,i.hemi.length=S,i.sunShadow.length=g,i.sunShadowMap.length=g,i.sunShadowMatrix.length=y,i.sunShadowCascade.length=y,i.directionalShadow.length=C,i.directionalShadowMap.length=C,i.directionalShadowMatrix.length=C,i.pointShadow.length=b,i.pointShadowMap.length=b,i.pointShadowMatrix.length=b,i.spotShadow.length=x,i.spotShadowMap.length=x,i.spotLightMatrix.length=x+T-L,i.spotLightMap.length=T,i.numSpotLightShadowsWithMaps=L,i.numLightProbes=P,R.sunLength=d,R.directionalLength=m,R.pointLength=p,R.spotLength=_,R.rectAreaLength=E,R.hemiLength=S,R.numSunShadows=g,R.numDirectionalShadows=C,R.numPointShadows=b,R.numSpotShadows=x,R.numSpotMaps=T,R.numLightProbes=P,i.version=cM++)}function l(c,u){let h=0,f=0,d=0,g=0,y=0,m=0,p=u.matrixWorldInverse;for(let _=0,E=c.length;_<E;_++){let S=c[_];if(S.isSunLight){let C=i.sun[h];C.direction.setFromMatrixPosition(S.matrixWorld),C.direction.transformDirection(p),h++}else if(S.isDirectionalLight){let C=i.directional[f];C.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(p),f++}else if(S.isSpotLight){let C=i.spot[g];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(p),C.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(p),g++}else if(S.isRectAreaLight){let C=i.rectArea[y];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(p),o.identity(),r.copy(S.matrixWorld),r.premultiply(p),o.extractRotation(r),C.halfWidth.set(S.width*.5,0,0),C.halfHeight.set(0,S.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),y++}else if(S.isPointLight){let C=i.point[d];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(p),d++}else if(S.isHemisphereLight){let C=i.hemi[m];C.direction.setFromMatrixPosition(S.matrixWorld),C.direction.transformDirection(p),m++}}}return{setup:a,setupView:l,state:i}}function Wp(n){let t=new uM(n),e=[],i=[],s=[];function r(h){u.camera=h,e.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):e.push(h)}function a(h){i.push(h)}function l(){t.setup(e),s.sort((h,f)=>h.priority-f.priority||h.id-f.id)}function c(h){t.setupView(e,h)}let u={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function fM(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new Wp(n),t.set(s,[a])):r>=o.length?(a=new Wp(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var dM=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,pM=`uniform sampler2D shadow_pass;
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
}`,mM=[new X(1,0,0),new X(-1,0,0),new X(0,1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1)],gM=[new X(0,-1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1),new X(0,-1,0),new X(0,-1,0)],Xp=new Ie,xa=new X,Pu=new X;function _M(n,t,e){let i=new Es,s=new Jt,r=new Jt,o=new We,a=new Al,l=new El,c={},u=e.maxTextureSize,h={[Ds]:Hn,[Hn]:Ds,[qn]:qn},f=new Gi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Jt},radius:{value:4}},vertexShader:dM,fragmentShader:pM}),d=f.clone();d.defines.HORIZONTAL_PASS=1;let g=new Vn;g.setAttribute("position",new kn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new Gn(g,f),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=ca;let p=this.type;this.render=function(b,x,T){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||b.length===0)return;this.type===Bd&&(qt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=ca);let L=n.getRenderTarget(),P=n.getActiveCubeFace(),R=n.getActiveMipmapLevel(),F=n.state;F.setBlending(tr),F.buffers.depth.getReversed()===!0?F.buffers.color.setClear(0,0,0,0):F.buffers.color.setClear(1,1,1,1),F.buffers.depth.setTest(!0),F.setScissorTest(!1);let k=p!==this.type;k&&x.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(V=>V.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,V=b.length;N<V;N++){let Y=b[N],G=Y.shadow;if(G===void 0){qt("WebGLShadowMap:",Y,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;s.copy(G.mapSize);let lt=G.getFrameExtents();s.multiply(lt),r.copy(G.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/lt.x),s.x=r.x*lt.x,G.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/lt.y),s.y=r.y*lt.y,G.mapSize.y=r.y));let K=n.state.buffers.depth.getReversed();if(G.camera._reversedDepth=K,G.map===null||k===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===jr){if(Y.isPointLight){qt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new ri(s.x,s.y,{format:Ns,type:Ai,minFilter:zn,magFilter:zn,generateMipmaps:!1}),G.map.texture.name=Y.name+".shadowMap",G.map.depthTexture=new ls(s.x,s.y,mi),G.map.depthTexture.name=Y.name+".shadowMapDepth",G.map.depthTexture.format=ss,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=wn,G.map.depthTexture.magFilter=wn}else Y.isPointLight?(G.map=new va(s.x),G.map.depthTexture=new jo(s.x,Ti)):(G.map=new ri(s.x,s.y),G.map.depthTexture=new ls(s.x,s.y,Ti)),G.map.depthTexture.name=Y.name+".shadowMap",G.map.depthTexture.format=ss,this.type===ca?(G.map.depthTexture.compareFunction=K?_u:gu,G.map.depthTexture.minFilter=zn,G.map.depthTexture.magFilter=zn):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=wn,G.map.depthTexture.magFilter=wn);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==s.x||G.map.height!==s.y)&&G.map.setSize(s.x,s.y);let Q=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();Y.isPointLight!==!0&&G.updateMatrices(Y,T);let it=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:T.layers;for(let dt=0;dt<Q;dt++){let ft=G.getCamera(dt);if(Y.isPointLight){let tt=G.camera,ut=G.matrix,gt=Y.distance||tt.far;gt!==tt.far&&(tt.far=gt,tt.updateProjectionMatrix()),xa.setFromMatrixPosition(Y.matrixWorld),tt.position.copy(xa),Pu.copy(tt.position),Pu.add(mM[dt]),tt.up.copy(gM[dt]),tt.lookAt(Pu),tt.updateMatrixWorld(),ut.makeTranslation(-xa.x,-xa.y,-xa.z),Xp.multiplyMatrices(tt.projectionMatrix,tt.matrixWorldInverse),G._frustum.setFromProjectionMatrix(Xp,tt.coordinateSystem,tt.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)n.setRenderTarget(G.map,dt),n.clear();else{dt===0&&(n.setRenderTarget(G.map),n.clear());let tt=G.getViewport(dt);o.set(r.x*tt.x,r.y*tt.y,r.x*tt.z,r.y*tt.w),F.viewport(o)}i=G.getFrustum(dt),S(x,T,ft,Y,it,this.type)}G.isPointLightShadow!==!0&&this.type===jr&&_(G,T),G.needsUpdate=!1}p=this.type,m.needsUpdate=!1,n.setRenderTarget(L,P,R)};function _(b,x){let T=t.update(y);f.defines.VSM_SAMPLES!==b.blurSamples&&(f.defines.VSM_SAMPLES=b.blurSamples,d.defines.VSM_SAMPLES=b.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),b.mapPass===null?b.mapPass=new ri(s.x,s.y,{format:Ns,type:Ai}):(b.mapPass.width!==b.map.width||b.mapPass.height!==b.map.height)&&b.mapPass.setSize(b.map.width,b.map.height),f.uniforms.shadow_pass.value=b.map.depthTexture,f.uniforms.resolution.value.set(b.map.width,b.map.height),f.uniforms.radius.value=b.radius,n.setRenderTarget(b.mapPass),n.clear(),n.renderBufferDirect(x,null,T,f,y,null),d.uniforms.shadow_pass.value=b.mapPass.texture,d.uniforms.resolution.value.set(b.map.width,b.map.height),d.uniforms.radius.value=b.radius,n.setRenderTarget(b.map),n.clear(),n.renderBufferDirect(x,null,T,d,y,null)}function E(b,x,T,L){let P=null,R=T.isPointLight===!0?b.customDistanceMaterial:b.customDepthMaterial;if(R!==void 0)P=R;else if(P=T.isPointLight===!0?l:a,n.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let F=P.uuid,k=x.uuid,N=c[F];N===void 0&&(N={},c[F]=N);let V=N[k];V===void 0&&(V=P.clone(),N[k]=V,x.addEventListener("dispose",C)),P=V}if(P.visible=x.visible,P.wireframe=x.wireframe,L===jr?P.side=x.shadowSide!==null?x.shadowSide:x.side:P.side=x.shadowSide!==null?x.shadowSide:h[x.side],P.alphaMap=x.alphaMap,P.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,P.map=x.map,P.clipShadows=x.clipShadows,P.clippingPlanes=x.clippingPlanes,P.clipIntersection=x.clipIntersection,P.displacementMap=x.displacementMap,P.displacementScale=x.displacementScale,P.displacementBias=x.displacementBias,P.wireframeLinewidth=x.wireframeLinewidth,P.linewidth=x.linewidth,T.isPointLight===!0&&P.isMeshDistanceMaterial===!0){let F=n.properties.get(P);F.light=T}return P}function S(b,x,T,L,P,R){if(b.visible===!1)return;if(b.layers.test(P)&&(b.isMesh||b.isLine||b.isPoints)&&(b.castShadow||b.receiveShadow&&R===jr)&&(!b.frustumCulled||b.intersectsFrustum(i))){b.modelViewMatrix.multiplyMatrices(T.matrixWorldInverse,b.matrixWorld);let N=t.update(b),V=b.material;if(Array.isArray(V)){let Y=N.groups;for(let G=0,lt=Y.length;G<lt;G++){let K=Y[G],Q=V[K.materialIndex];if(Q&&Q.visible){let it=E(b,Q,L,R);b.onBeforeShadow(n,b,x,T,N,it,K),n.renderBufferDirect(T,null,N,it,b,K),b.onAfterShadow(n,b,x,T,N,it,K)}}}else if(V.visible){let Y=E(b,V,L,R);b.onBeforeShadow(n,b,x,T,N,Y,null),n.renderBufferDirect(T,null,N,Y,b,null),b.onAfterShadow(n,b,x,T,N,Y,null)}}let k=b.children;for(let N=0,V=k.length;N<V;N++)S(k[N],x,T,L,P,R)}function C(b){b.target.removeEventListener("dispose",C);for(let T in c){let L=c[T],P=b.target.uuid;P in L&&(L[P].dispose(),delete L[P])}}}function xM(n,t){function e(){let O=!1,rt=new We,nt=null,Tt=new We(0,0,0,0);return{setMask:function(_t){nt!==_t&&!O&&(n.colorMask(_t,_t,_t,_t),nt=_t)},setLocked:function(_t){O=_t},setClear:function(_t,St,Gt,Zt,ct){ct===!0&&(_t*=Zt,St*=Zt,Gt*=Zt),rt.set(_t,St,Gt,Zt),Tt.equals(rt)===!1&&(n.clearColor(_t,St,Gt,Zt),Tt.copy(rt))},reset:function(){O=!1,nt=null,Tt.set(-1,0,0,0)}}}function i(){let O=!1,rt=!1,nt=null,Tt=null,_t=null;return{setReversed:function(St){if(rt!==St){let Gt=t.get("EXT_clip_control");St?Gt.clipControlEXT(Gt.LOWER_LEFT_EXT,Gt.ZERO_TO_ONE_EXT):Gt.clipControlEXT(Gt.LOWER_LEFT_EXT,Gt.NEGATIVE_ONE_TO_ONE_EXT),rt=St;let Zt=_t;_t=null,this.setClear(Zt)}},getReversed:function(){return rt},setTest:function(St){St?bt(n.DEPTH_TEST):Ht(n.DEPTH_TEST)},setMask:function(St){nt!==St&&!O&&(n.depthMask(St),nt=St)},setFunc:function(St){if(rt&&(St=xp[St]),Tt!==St){switch(St){case ll:n.depthFunc(n.NEVER);break;case cl:n.depthFunc(n.ALWAYS);break;case hl:n.depthFunc(n.LESS);break;case Vr:n.depthFunc(n.LEQUAL);break;case ul:n.depthFunc(n.EQUAL);break;case fl:n.depthFunc(n.GEQUAL);break;case dl:n.depthFunc(n.GREATER);break;case pl:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Tt=St}},setLocked:function(St){O=St},setClear:function(St){_t!==St&&(_t=St,rt&&(St=1-St),n.clearDepth(St))},reset:function(){O=!1,nt=null,Tt=null,_t=null,rt=!1}}}function s(){let O=!1,rt=null,nt=null,Tt=null,_t=null,St=null,Gt=null,Zt=null,ct=null;return{setTest:function(Ot){O||(Ot?bt(n.STENCIL_TEST):Ht(n.STENCIL_TEST))},setMask:function(Ot){rt!==Ot&&!O&&(n.stencilMask(Ot),rt=Ot)},setFunc:function(Ot,Kt,Ct){(nt!==Ot||Tt!==Kt||_t!==Ct)&&(n.stencilFunc(Ot,Kt,Ct),nt=Ot,Tt=Kt,_t=Ct)},setOp:function(Ot,Kt,Ct){(St!==Ot||Gt!==Kt||Zt!==Ct)&&(n.stencilOp(Ot,Kt,Ct),St=Ot,Gt=Kt,Zt=Ct)},setLocked:function(Ot){O=Ot},setClear:function(Ot){ct!==Ot&&(n.clearStencil(Ot),ct=Ot)},reset:function(){O=!1,rt=null,nt=null,Tt=null,_t=null,St=null,Gt=null,Zt=null,ct=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,u={},h={},f={},d=new WeakMap,g=[],y=null,m=!1,p=null,_=null,E=null,S=null,C=null,b=null,x=null,T=new ee(0,0,0),L=0,P=!1,R=null,F=null,k=null,N=null,V=null,Y=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),G=!1,lt=0,K=n.getParameter(n.VERSION);K.indexOf("WebGL")!==-1?(lt=parseFloat(/^WebGL (\d)/.exec(K)[1]),G=lt>=1):K.indexOf("OpenGL ES")!==-1&&(lt=parseFloat(/^OpenGL ES (\d)/.exec(K)[1]),G=lt>=2);let Q=null,it={},dt=n.getParameter(n.SCISSOR_BOX),ft=n.getParameter(n.VIEWPORT),tt=new We().fromArray(dt),ut=new We().fromArray(ft);function gt(O,rt,nt,Tt){let _t=new Uint8Array(4),St=n.createTexture();n.bindTexture(O,St),n.texParameteri(O,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(O,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Gt=0;Gt<nt;Gt++)O===n.TEXTURE_3D||O===n.TEXTURE_2D_ARRAY?n.texImage3D(rt,0,n.RGBA,1,1,Tt,0,n.RGBA,n.UNSIGNED_BYTE,_t):n.texImage2D(rt+Gt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,_t);return St}let Mt={};Mt[n.TEXTURE_2D]=gt(n.TEXTURE_2D,n.TEXTURE_2D,1),Mt[n.TEXTURE_CUBE_MAP]=gt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Mt[n.TEXTURE_2D_ARRAY]=gt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Mt[n.TEXTURE_3D]=gt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),bt(n.DEPTH_TEST),o.setFunc(Vr),nn(!1),Re($h),bt(n.CULL_FACE),Ge(tr);function bt(O){u[O]!==!0&&(n.enable(O),u[O]=!0)}function Ht(O){u[O]!==!1&&(n.disable(O),u[O]=!1)}function se(O,rt){return f[O]!==rt?(n.bindFramebuffer(O,rt),f[O]=rt,O===n.DRAW_FRAMEBUFFER&&(f[n.FRAMEBUFFER]=rt),O===n.FRAMEBUFFER&&(f[n.DRAW_FRAMEBUFFER]=rt),!0):!1}function Vt(O,rt){let nt=g,Tt=!1;if(O){nt=d.get(rt),nt===void 0&&(nt=[],d.set(rt,nt));let _t=O.textures;if(nt.length!==_t.length||nt[0]!==n.COLOR_ATTACHMENT0){for(let St=0,Gt=_t.length;St<Gt;St++)nt[St]=n.COLOR_ATTACHMENT0+St;nt.length=_t.length,Tt=!0}}else nt[0]!==n.BACK&&(nt[0]=n.BACK,Tt=!0);Tt&&n.drawBuffers(nt)}function he(O){return y!==O?(n.useProgram(O),y=O,!0):!1}let ae={[er]:n.FUNC_ADD,[zd]:n.FUNC_SUBTRACT,[Vd]:n.FUNC_REVERSE_SUBTRACT};ae[Gd]=n.MIN,ae[Hd]=n.MAX;let ne={[Wd]:n.ZERO,[Xd]:n.ONE,[qd]:n.SRC_COLOR,[jh]:n.SRC_ALPHA,[jd]:n.SRC_ALPHA_SATURATE,[Kd]:n.DST_COLOR,[$d]:n.DST_ALPHA,[Yd]:n.ONE_MINUS_SRC_COLOR,[Qh]:n.ONE_MINUS_SRC_ALPHA,[Jd]:n.ONE_MINUS_DST_COLOR,[Zd]:n.ONE_MINUS_DST_ALPHA,[Qd]:n.CONSTANT_COLOR,[tp]:n.ONE_MINUS_CONSTANT_COLOR,[ep]:n.CONSTANT_ALPHA,[np]:n.ONE_MINUS_CONSTANT_ALPHA};function Ge(O,rt,nt,Tt,_t,St,Gt,Zt,ct,Ot){if(O===tr){m===!0&&(Ht(n.BLEND),m=!1);return}if(m===!1&&(bt(n.BLEND),m=!0),O!==kd){if(O!==p||Ot!==P){if((_!==er||C!==er)&&(n.blendEquation(n.FUNC_ADD),_=er,C=er),Ot)switch(O){case Qr:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Zh:n.blendFunc(n.ONE,n.ONE);break;case Kh:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Jh:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:Qt("WebGLState: Invalid blending: ",O);break}else switch(O){case Qr:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Zh:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Kh:Qt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Jh:Qt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Qt("WebGLState: Invalid blending: ",O);break}E=null,S=null,b=null,x=null,T.set(0,0,0),L=0,p=O,P=Ot}return}_t=_t||rt,St=St||nt,Gt=Gt||Tt,(rt!==_||_t!==C)&&(n.blendEquationSeparate(ae[rt],ae[_t]),_=rt,C=_t),(nt!==E||Tt!==S||St!==b||Gt!==x)&&(n.blendFuncSeparate(ne[nt],ne[Tt],ne[St],ne[Gt]),E=nt,S=Tt,b=St,x=Gt),(Zt.equals(T)===!1||ct!==L)&&(n.blendColor(Zt.r,Zt.g,Zt.b,ct),T.copy(Zt),L=ct),p=O,P=!1}function Ue(O,rt){O.side===qn?Ht(n.CULL_FACE):bt(n.CULL_FACE);let nt=O.side===Hn;rt&&(nt=!nt),nn(nt),O.blending===Qr&&O.transparent===!1?Ge(tr):Ge(O.blending,O.blendEquation,O.blendSrc,O.blendDst,O.blendEquationAlpha,O.blendSrcAlpha,O.blendDstAlpha,O.blendColor,O.blendAlpha,O.premultipliedAlpha),o.setFunc(O.depthFunc),o.setTest(O.depthTest),o.setMask(O.depthWrite),r.setMask(O.colorWrite);let Tt=O.stencilWrite;a.setTest(Tt),Tt&&(a.setMask(O.stencilWriteMask),a.setFunc(O.stencilFunc,O.stencilRef,O.stencilFuncMask),a.setOp(O.stencilFail,O.stencilZFail,O.stencilZPass)),xe(O.polygonOffset,O.polygonOffsetFactor,O.polygonOffsetUnits),O.alphaToCoverage===!0?bt(n.SAMPLE_ALPHA_TO_COVERAGE):Ht(n.SAMPLE_ALPHA_TO_COVERAGE)}function nn(O){R!==O&&(O?n.frontFace(n.CW):n.frontFace(n.CCW),R=O)}function Re(O){O!==Fd?(bt(n.CULL_FACE),O!==F&&(O===$h?n.cullFace(n.BACK):O===Od?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Ht(n.CULL_FACE),F=O}function xn(O){O!==k&&(G&&n.lineWidth(O),k=O)}function xe(O,rt,nt){O?(bt(n.POLYGON_OFFSET_FILL),(N!==rt||V!==nt)&&(N=rt,V=nt,o.getReversed()&&(rt=-rt,nt=-nt),n.polygonOffset(rt,nt))):Ht(n.POLYGON_OFFSET_FILL)}function un(O){O?bt(n.SCISSOR_TEST):Ht(n.SCISSOR_TEST)}function Ye(O){O===void 0&&(O=n.TEXTURE0+Y-1),Q!==O&&(n.activeTexture(O),Q=O)}function sn(O,rt,nt){nt===void 0&&(Q===null?nt=n.TEXTURE0+Y-1:nt=Q);let Tt=it[nt];Tt===void 0&&(Tt={type:void 0,texture:void 0},it[nt]=Tt),(Tt.type!==O||Tt.texture!==rt)&&(Q!==nt&&(n.activeTexture(nt),Q=nt),n.bindTexture(O,rt||Mt[O]),Tt.type=O,Tt.texture=rt)}function B(){let O=it[Q];O!==void 0&&O.type!==void 0&&(n.bindTexture(O.type,null),O.type=void 0,O.texture=void 0)}function Rt(){try{n.compressedTexImage2D(...arguments)}catch(O){Qt("WebGLState:",O)}}function Yt(){try{n.compressedTexImage3D(...arguments)}catch(O){Qt("WebGLState:",O)}}function re(){try{n.texSubImage2D(...arguments)}catch(O){Qt("WebGLState:",O)}}function wt(){try{n.texSubImage3D(...arguments)}catch(O){Qt("WebGLState:",O)}}function Le(){try{n.compressedTexSubImage2D(...arguments)}catch(O){Qt("WebGLState:",O)}}function zt(){try{n.compressedTexSubImage3D(...arguments)}catch(O){Qt("WebGLState:",O)}}function Xt(){try{n.texStorage2D(...arguments)}catch(O){Qt("WebGLState:",O)}}function I(){try{n.texStorage3D(...arguments)}catch(O){Qt("WebGLState:",O)}}function M(){try{n.texImage2D(...arguments)}catch(O){Qt("WebGLState:",O)}}function q(){try{n.texImage3D(...arguments)}catch(O){Qt("WebGLState:",O)}}function ht(O){return h[O]!==void 0?h[O]:n.getParameter(O)}function ot(O,rt){h[O]!==rt&&(n.pixelStorei(O,rt),h[O]=rt)}function xt(O){tt.equals(O)===!1&&(n.scissor(O.x,O.y,O.z,O.w),tt.copy(O))}function yt(O){ut.equals(O)===!1&&(n.viewport(O.x,O.y,O.z,O.w),ut.copy(O))}function et(O,rt){let nt=c.get(rt);nt===void 0&&(nt=new WeakMap,c.set(rt,nt));let Tt=nt.get(O);Tt===void 0&&(Tt=n.getUniformBlockIndex(rt,O.name),n.uniformBlockBinding(rt,Tt,Tt),nt.set(O,Tt))}function st(O,rt,nt){let _t=c.get(rt).get(O);l[_t]!==nt&&(n.bindBufferBase(n.UNIFORM_BUFFER,_t,nt),l[_t]=nt)}function mt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},Q=null,it={},f={},l={},d=new WeakMap,g=[],y=null,m=!1,p=null,_=null,E=null,S=null,C=null,b=null,x=null,T=new ee(0,0,0),L=0,P=!1,R=null,F=null,k=null,N=null,V=null,tt.set(0,0,n.canvas.width,n.canvas.height),ut.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:bt,disable:Ht,bindFramebuffer:se,drawBuffers:Vt,useProgram:he,setBlending:Ge,setMaterial:Ue,setFlipSided:nn,setCullFace:Re,setLineWidth:xn,setPolygonOffset:xe,setScissorTest:un,activeTexture:Ye,bindTexture:sn,unbindTexture:B,compressedTexImage2D:Rt,compressedTexImage3D:Yt,texImage2D:M,texImage3D:q,pixelStorei:ot,getParameter:ht,updateUBOMapping:et,uniformBlockBinding:st,texStorage2D:Xt,texStorage3D:I,texSubImage2D:re,texSubImage3D:wt,compressedTexSubImage2D:Le,compressedTexSubImage3D:zt,scissor:xt,viewport:yt,reset:mt}}function yM(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Jt,u=new WeakMap,h=new Set,f,d=new WeakMap,g=new Set,y=new FinalizationRegistry(I=>g.delete(I)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(I,M){return m?new OffscreenCanvas(I,M):Go("canvas")}function _(I,M,q){let ht=1,ot=Xt(I);if((ot.width>q||ot.height>q)&&(ht=q/Math.max(ot.width,ot.height)),ht<1)if(typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&I instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&I instanceof ImageBitmap||typeof VideoFrame<"u"&&I instanceof VideoFrame){let xt=Math.floor(ht*ot.width),yt=Math.floor(ht*ot.height);f===void 0&&(f=p(xt,yt));let et=M?p(xt,yt):f;return et.width=xt,et.height=yt,et.getContext("2d").drawImage(I,0,0,xt,yt),qt("WebGLRenderer: Texture has been resized from ("+ot.width+"x"+ot.height+") to ("+xt+"x"+yt+")."),et}else return"data"in I&&qt("WebGLRenderer: Image in DataTexture is too big ("+ot.width+"x"+ot.height+")."),I;return I}function E(I){return I.generateMipmaps}function S(I){n.generateMipmap(I)}function C(I){return I.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:I.isWebGL3DRenderTarget?n.TEXTURE_3D:I.isWebGLArrayRenderTarget||I.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function b(I,M,q,ht,ot,xt=!1){if(I!==null){if(n[I]!==void 0)return n[I];qt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+I+"'")}let yt;ht&&(yt=t.get("EXT_texture_norm16"),yt||qt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let et=M;if(M===n.RED&&(q===n.FLOAT&&(et=n.R32F),q===n.HALF_FLOAT&&(et=n.R16F),q===n.UNSIGNED_BYTE&&(et=n.R8),q===n.UNSIGNED_SHORT&&yt&&(et=yt.R16_EXT),q===n.SHORT&&yt&&(et=yt.R16_SNORM_EXT)),M===n.RED_INTEGER&&(q===n.UNSIGNED_BYTE&&(et=n.R8UI),q===n.UNSIGNED_SHORT&&(et=n.R16UI),q===n.UNSIGNED_INT&&(et=n.R32UI),q===n.BYTE&&(et=n.R8I),q===n.SHORT&&(et=n.R16I),q===n.INT&&(et=n.R32I)),M===n.RG&&(q===n.FLOAT&&(et=n.RG32F),q===n.HALF_FLOAT&&(et=n.RG16F),q===n.UNSIGNED_BYTE&&(et=n.RG8),q===n.UNSIGNED_SHORT&&yt&&(et=yt.RG16_EXT),q===n.SHORT&&yt&&(et=yt.RG16_SNORM_EXT)),M===n.RG_INTEGER&&(q===n.UNSIGNED_BYTE&&(et=n.RG8UI),q===n.UNSIGNED_SHORT&&(et=n.RG16UI),q===n.UNSIGNED_INT&&(et=n.RG32UI),q===n.BYTE&&(et=n.RG8I),q===n.SHORT&&(et=n.RG16I),q===n.INT&&(et=n.RG32I)),M===n.RGB_INTEGER&&(q===n.UNSIGNED_BYTE&&(et=n.RGB8UI),q===n.UNSIGNED_SHORT&&(et=n.RGB16UI),q===n.UNSIGNED_INT&&(et=n.RGB32UI),q===n.BYTE&&(et=n.RGB8I),q===n.SHORT&&(et=n.RGB16I),q===n.INT&&(et=n.RGB32I)),M===n.RGBA_INTEGER&&(q===n.UNSIGNED_BYTE&&(et=n.RGBA8UI),q===n.UNSIGNED_SHORT&&(et=n.RGBA16UI),q===n.UNSIGNED_INT&&(et=n.RGBA32UI),q===n.BYTE&&(et=n.RGBA8I),q===n.SHORT&&(et=n.RGBA16I),q===n.INT&&(et=n.RGBA32I)),M===n.RGB&&(q===n.UNSIGNED_SHORT&&yt&&(et=yt.RGB16_EXT),q===n.SHORT&&yt&&(et=yt.RGB16_SNORM_EXT),q===n.UNSIGNED_INT_5_9_9_9_REV&&(et=n.RGB9_E5),q===n.UNSIGNED_INT_10F_11F_11F_REV&&(et=n.R11F_G11F_B10F)),M===n.RGBA){let st=xt?Vo:ge.getTransfer(ot);q===n.FLOAT&&(et=n.RGBA32F),q===n.HALF_FLOAT&&(et=n.RGBA16F),q===n.UNSIGNED_BYTE&&(et=st===we?n.SRGB8_ALPHA8:n.RGBA8),q===n.UNSIGNED_SHORT&&yt&&(et=yt.RGBA16_EXT),q===n.SHORT&&yt&&(et=yt.RGBA16_SNORM_EXT),q===n.UNSIGNED_SHORT_4_4_4_4&&(et=n.RGBA4),q===n.UNSIGNED_SHORT_5_5_5_1&&(et=n.RGB5_A1)}return(et===n.R16F||et===n.R32F||et===n.RG16F||et===n.RG32F||et===n.RGBA16F||et===n.RGBA32F)&&t.get("EXT_color_buffer_float"),et}function x(I,M){let q;return I?M===null||M===Ti||M===ir?q=n.DEPTH24_STENCIL8:M===mi?q=n.DEPTH32F_STENCIL8:M===eo&&(q=n.DEPTH24_STENCIL8,qt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===Ti||M===ir?q=n.DEPTH_COMPONENT24:M===mi?q=n.DEPTH_COMPONENT32F:M===eo&&(q=n.DEPTH_COMPONENT16),q}function T(I,M){return E(I)===!0||I.isFramebufferTexture&&I.minFilter!==wn&&I.minFilter!==zn?Math.log2(Math.max(M.width,M.height))+1:I.mipmaps.length>0?I.mipmaps.length:I.isCompressedTexture&&Array.isArray(I.image)?M.mipmaps.length:1}function L(I){let M=new WeakRef(I);i.get(I).__ref=M,g.add(M),y.register(I,M,M)}function P(I){let M=i.get(I).__ref;M!==void 0&&(g.delete(M),y.unregister(M))}function R(I){k(I.target)}function F(I){N(I.target)}function k(I){I.removeEventListener("dispose",R),P(I),Y(I),I.isVideoTexture&&u.delete(I),I.isHTMLTexture&&h.delete(I)}function N(I){I.removeEventListener("dispose",F),P(I),lt(I)}function V(){for(let I of g){let M=I.deref();M!==void 0&&(M.isRenderTarget===!0?N(M):k(M))}g.clear(),h.clear()}function Y(I){let M=i.get(I);if(M.__webglInit===void 0)return;let q=I.source,ht=d.get(q);if(ht){let ot=ht[M.__cacheKey];ot.usedTimes--,ot.usedTimes===0&&G(I),Object.keys(ht).length===0&&d.delete(q)}i.remove(I)}function G(I){let M=i.get(I);n.deleteTexture(M.__webglTexture);let q=I.source,ht=d.get(q);delete ht[M.__cacheKey],o.memory.textures--}function lt(I){let M=i.get(I);M.__depthDisposeCallback&&M.__depthDisposeCallback();let q=I.depthTexture;if(q&&q.renderTarget===I&&k(q),I.isWebGLCubeRenderTarget)for(let ot=0;ot<6;ot++){if(Array.isArray(M.__webglFramebuffer[ot]))for(let xt=0;xt<M.__webglFramebuffer[ot].length;xt++)n.deleteFramebuffer(M.__webglFramebuffer[ot][xt]);else n.deleteFramebuffer(M.__webglFramebuffer[ot]);M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer[ot])}else{if(Array.isArray(M.__webglFramebuffer))for(let ot=0;ot<M.__webglFramebuffer.length;ot++)n.deleteFramebuffer(M.__webglFramebuffer[ot]);else n.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&n.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let ot=0;ot<M.__webglColorRenderbuffer.length;ot++)M.__webglColorRenderbuffer[ot]&&n.deleteRenderbuffer(M.__webglColorRenderbuffer[ot]);M.__webglDepthRenderbuffer&&n.deleteRenderbuffer(M.__webglDepthRenderbuffer)}let ht=I.textures;for(let ot=0,xt=ht.length;ot<xt;ot++){let yt=i.get(ht[ot]);yt.__webglTexture&&(n.deleteTexture(yt.__webglTexture),o.memory.textures--),i.remove(ht[ot])}i.remove(I)}let K=0;function Q(){K=0}function it(){return K}function dt(I){K=I}function ft(){let I=K;return I>=s.maxTextures&&qt("WebGLTextures: Trying to use "+(I+1)+" texture units while this GPU supports only "+s.maxTextures),K+=1,I}function tt(I){let M=[];return M.push(I.wrapS),M.push(I.wrapT),M.push(I.wrapR||0),M.push(I.magFilter),M.push(I.minFilter),M.push(I.anisotropy),M.push(I.internalFormat),M.push(I.format),M.push(I.type),M.push(I.generateMipmaps),M.push(I.mipmapsAutoUpdate),M.push(I.premultiplyAlpha),M.push(I.flipY),M.push(I.unpackAlignment),M.push(I.colorSpace),M.join()}function ut(I,M){let q=i.get(I);if(I.isVideoTexture&&Le(I),I.isRenderTargetTexture===!1&&I.isExternalTexture!==!0&&I.version>0&&q.__version!==I.version){let ht=I.image;if(ht===null)qt("WebGLRenderer: Texture marked for update but no image data found.");else if(ht.complete===!1)qt("WebGLRenderer: Texture marked for update but image is incomplete");else{Ue(q,I,M);return}}else I.isExternalTexture&&(q.__webglTexture=I.sourceTexture?I.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,q.__webglTexture,n.TEXTURE0+M)}function gt(I,M){let q=i.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&q.__version!==I.version){Ue(q,I,M);return}else I.isExternalTexture&&(q.__webglTexture=I.sourceTexture?I.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,q.__webglTexture,n.TEXTURE0+M)}function Mt(I,M){let q=i.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&q.__version!==I.version){Ue(q,I,M);return}e.bindTexture(n.TEXTURE_3D,q.__webglTexture,n.TEXTURE0+M)}function bt(I,M){let q=i.get(I);if(I.version>0&&q.__version!==I.version){nn(q,I,M);return}e.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture,n.TEXTURE0+M)}let Ht={[ml]:n.REPEAT,[ki]:n.CLAMP_TO_EDGE,[gl]:n.MIRRORED_REPEAT},se={[wn]:n.NEAREST,[rp]:n.NEAREST_MIPMAP_NEAREST,[ha]:n.NEAREST_MIPMAP_LINEAR,[zn]:n.LINEAR,[Hl]:n.LINEAR_MIPMAP_NEAREST,[cs]:n.LINEAR_MIPMAP_LINEAR},Vt={[cp]:n.NEVER,[xu]:n.ALWAYS,[hp]:n.LESS,[gu]:n.LEQUAL,[up]:n.EQUAL,[_u]:n.GEQUAL,[fp]:n.GREATER,[dp]:n.NOTEQUAL};function he(I,M){if(M.type===mi&&t.has("OES_texture_float_linear")===!1&&(M.magFilter===zn||M.magFilter===Hl||M.magFilter===ha||M.magFilter===cs||M.minFilter===zn||M.minFilter===Hl||M.minFilter===ha||M.minFilter===cs)&&qt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(I,n.TEXTURE_WRAP_S,Ht[M.wrapS]),n.texParameteri(I,n.TEXTURE_WRAP_T,Ht[M.wrapT]),(I===n.TEXTURE_3D||I===n.TEXTURE_2D_ARRAY)&&n.texParameteri(I,n.TEXTURE_WRAP_R,Ht[M.wrapR]),n.texParameteri(I,n.TEXTURE_MAG_FILTER,se[M.magFilter]),n.texParameteri(I,n.TEXTURE_MIN_FILTER,se[M.minFilter]),M.compareFunction&&(n.texParameteri(I,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(I,n.TEXTURE_COMPARE_FUNC,Vt[M.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===wn||M.minFilter!==ha&&M.minFilter!==cs||M.type===mi&&t.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||i.get(M).__currentAnisotropy){let q=t.get("EXT_texture_filter_anisotropic");n.texParameterf(I,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,s.getMaxAnisotropy())),i.get(M).__currentAnisotropy=M.anisotropy}}}function ae(I,M){let q=!1;I.__webglInit===void 0&&(I.__webglInit=!0,M.addEventListener("dispose",R),L(M));let ht=M.source,ot=d.get(ht);ot===void 0&&(ot={},d.set(ht,ot));let xt=tt(M);if(xt!==I.__cacheKey){ot[xt]===void 0&&(ot[xt]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,q=!0),ot[xt].usedTimes++;let yt=ot[I.__cacheKey];yt!==void 0&&(ot[I.__cacheKey].usedTimes--,yt.usedTimes===0&&G(M)),I.__cacheKey=xt,I.__webglTexture=ot[xt].texture}return q}function ne(I,M,q){return Math.floor(Math.floor(I/q)/M)}function Ge(I,M,q,ht){let xt=I.updateRanges;if(xt.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,M.width,M.height,q,ht,M.data);else{xt.sort((O,rt)=>O.start-rt.start);let yt=0;for(let O=1;O<xt.length;O++){let rt=xt[yt],nt=xt[O],Tt=rt.start+rt.count,_t=ne(nt.start,M.width,4),St=ne(rt.start,M.width,4);nt.start<=Tt+1&&_t===St&&ne(nt.start+nt.count-1,M.width,4)===_t?rt.count=Math.max(rt.count,nt.start+nt.count-rt.start):(++yt,xt[yt]=nt)}xt.length=yt+1;let et=e.getParameter(n.UNPACK_ROW_LENGTH),st=e.getParameter(n.UNPACK_SKIP_PIXELS),mt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,M.width);for(let O=0,rt=xt.length;O<rt;O++){let nt=xt[O],Tt=Math.floor(nt.start/4),_t=Math.ceil(nt.count/4),St=Tt%M.width,Gt=Math.floor(Tt/M.width),Zt=_t,ct=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,St),e.pixelStorei(n.UNPACK_SKIP_ROWS,Gt),e.texSubImage2D(n.TEXTURE_2D,0,St,Gt,Zt,ct,q,ht,M.data)}I.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,et),e.pixelStorei(n.UNPACK_SKIP_PIXELS,st),e.pixelStorei(n.UNPACK_SKIP_ROWS,mt)}}function Ue(I,M,q){let ht=n.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(ht=n.TEXTURE_2D_ARRAY),M.isData3DTexture&&(ht=n.TEXTURE_3D);let ot=ae(I,M),xt=M.source;e.bindTexture(ht,I.__webglTexture,n.TEXTURE0+q);let yt=i.get(xt);if(xt.version!==yt.__version||ot===!0){if(e.activeTexture(n.TEXTURE0+q),(typeof ImageBitmap<"u"&&M.image instanceof ImageBitmap)===!1){let ct=ge.getPrimaries(ge.workingColorSpace),Ot=M.colorSpace===us?null:ge.getPrimaries(M.colorSpace),Kt=M.colorSpace===us||ct===Ot?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Kt)}e.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment);let st=_(M.image,!1,s.maxTextureSize);st=zt(M,st);let mt=r.convert(M.format,M.colorSpace),O=r.convert(M.type),rt=b(M.internalFormat,mt,O,M.normalized,M.colorSpace,M.isVideoTexture);he(ht,M);let nt,Tt=M.mipmaps,_t=M.isVideoTexture!==!0,St=yt.__version===void 0||ot===!0,Gt=xt.dataReady,Zt=T(M,st);if(M.isDepthTexture)rt=x(M.format===hs,M.type),St&&(_t?e.texStorage2D(n.TEXTURE_2D,1,rt,st.width,st.height):e.texImage2D(n.TEXTURE_2D,0,rt,st.width,st.height,0,mt,O,null));else if(M.isDataTexture)if(Tt.length>0){_t&&St&&e.texStorage2D(n.TEXTURE_2D,Zt,rt,Tt[0].width,Tt[0].height);for(let ct=0,Ot=Tt.length;ct<Ot;ct++)nt=Tt[ct],_t?Gt&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,nt.width,nt.height,mt,O,nt.data):e.texImage2D(n.TEXTURE_2D,ct,rt,nt.width,nt.height,0,mt,O,nt.data);M.generateMipmaps=!1}else _t?(St&&e.texStorage2D(n.TEXTURE_2D,Zt,rt,st.width,st.height),Gt&&Ge(M,st,mt,O)):e.texImage2D(n.TEXTURE_2D,0,rt,st.width,st.height,0,mt,O,st.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){_t&&St&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Zt,rt,Tt[0].width,Tt[0].height,st.depth);for(let ct=0,Ot=Tt.length;ct<Ot;ct++)if(nt=Tt[ct],M.format!==Ei)if(mt!==null)if(_t){if(Gt)if(M.layerUpdates.size>0){let Kt=Cu(nt.width,nt.height,M.format,M.type);for(let Ct of M.layerUpdates){let oe=nt.data.subarray(Ct*Kt/nt.data.BYTES_PER_ELEMENT,(Ct+1)*Kt/nt.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,Ct,nt.width,nt.height,1,mt,oe)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,0,nt.width,nt.height,st.depth,mt,nt.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ct,rt,nt.width,nt.height,st.depth,0,nt.data,0,0);else qt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else _t?Gt&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,0,nt.width,nt.height,st.depth,mt,O,nt.data):e.texImage3D(n.TEXTURE_2D_ARRAY,ct,rt,nt.width,nt.height,st.depth,0,mt,O,nt.data);M.layerUpdates.size>0&&M.clearLayerUpdates()}else{_t&&St&&e.texStorage2D(n.TEXTURE_2D,Zt,rt,Tt[0].width,Tt[0].height);for(let ct=0,Ot=Tt.length;ct<Ot;ct++)nt=Tt[ct],M.format!==Ei?mt!==null?_t?Gt&&e.compressedTexSubImage2D(n.TEXTURE_2D,ct,0,0,nt.width,nt.height,mt,nt.data):e.compressedTexImage2D(n.TEXTURE_2D,ct,rt,nt.width,nt.height,0,nt.data):qt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):_t?Gt&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,nt.width,nt.height,mt,O,nt.data):e.texImage2D(n.TEXTURE_2D,ct,rt,nt.width,nt.height,0,mt,O,nt.data)}else if(M.isDataArrayTexture)if(_t){if(St&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Zt,rt,st.width,st.height,st.depth),Gt)if(M.layerUpdates.size>0){let ct=Cu(st.width,st.height,M.format,M.type);for(let Ot of M.layerUpdates){let Kt=st.data.subarray(Ot*ct/st.data.BYTES_PER_ELEMENT,(Ot+1)*ct/st.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Ot,st.width,st.height,1,mt,O,Kt)}M.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,st.width,st.height,st.depth,mt,O,st.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,rt,st.width,st.height,st.depth,0,mt,O,st.data);else if(M.isData3DTexture)_t?(St&&e.texStorage3D(n.TEXTURE_3D,Zt,rt,st.width,st.height,st.depth),Gt&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,st.width,st.height,st.depth,mt,O,st.data)):e.texImage3D(n.TEXTURE_3D,0,rt,st.width,st.height,st.depth,0,mt,O,st.data);else if(M.isFramebufferTexture){if(St)if(_t)e.texStorage2D(n.TEXTURE_2D,Zt,rt,st.width,st.height);else{let ct=st.width,Ot=st.height;for(let Kt=0;Kt<Zt;Kt++)e.texImage2D(n.TEXTURE_2D,Kt,rt,ct,Ot,0,mt,O,null),ct>>=1,Ot>>=1}}else if(M.isHTMLTexture){if("texElementImage2D"in n){let ct=n.canvas;if(ct.hasAttribute("layoutsubtree")||ct.setAttribute("layoutsubtree","true"),st.parentNode!==ct){ct.appendChild(st),h.add(M),ct.onpaint=Ot=>{let Kt=Ot.changedElements;for(let Ct of h)Kt.includes(Ct.image)&&(Ct.needsUpdate=!0)},ct.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,st);else{let Kt=n.RGBA,Ct=n.RGBA,oe=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,Kt,Ct,oe,st)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Tt.length>0){if(_t&&St){let ct=Xt(Tt[0]);e.texStorage2D(n.TEXTURE_2D,Zt,rt,ct.width,ct.height)}for(let ct=0,Ot=Tt.length;ct<Ot;ct++)nt=Tt[ct],_t?Gt&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,mt,O,nt):e.texImage2D(n.TEXTURE_2D,ct,rt,mt,O,nt);M.generateMipmaps=!1}else if(_t){if(St){let ct=Xt(st);e.texStorage2D(n.TEXTURE_2D,Zt,rt,ct.width,ct.height)}Gt&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,mt,O,st)}else e.texImage2D(n.TEXTURE_2D,0,rt,mt,O,st);E(M)&&M.mipmapsAutoUpdate===!0&&S(ht),yt.__version=xt.version,M.onUpdate&&M.onUpdate(M)}I.__version=M.version}function nn(I,M,q){if(M.image.length!==6)return;let ht=ae(I,M),ot=M.source;e.bindTexture(n.TEXTURE_CUBE_MAP,I.__webglTexture,n.TEXTURE0+q);let xt=i.get(ot);if(ot.version!==xt.__version||ht===!0){e.activeTexture(n.TEXTURE0+q);let yt=ge.getPrimaries(ge.workingColorSpace),et=M.colorSpace===us?null:ge.getPrimaries(M.colorSpace),st=M.colorSpace===us||yt===et?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,st);let mt=M.isCompressedTexture||M.image[0].isCompressedTexture,O=M.image[0]&&M.image[0].isDataTexture,rt=[];for(let Ct=0;Ct<6;Ct++)!mt&&!O?rt[Ct]=_(M.image[Ct],!0,s.maxCubemapSize):rt[Ct]=O?M.image[Ct].image:M.image[Ct],rt[Ct]=zt(M,rt[Ct]);let nt=rt[0],Tt=r.convert(M.format,M.colorSpace),_t=r.convert(M.type),St=b(M.internalFormat,Tt,_t,M.normalized,M.colorSpace),Gt=M.isVideoTexture!==!0,Zt=xt.__version===void 0||ht===!0,ct=ot.dataReady,Ot=T(M,nt);he(n.TEXTURE_CUBE_MAP,M);let Kt;if(M.isDepthTexture){if(St=x(M.format===hs,M.type),Zt)if(Gt)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,St,nt.width,nt.height);else for(let Ct=0;Ct<6;Ct++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,St,nt.width,nt.height,0,Tt,_t,null)}else if(mt){Gt&&Zt&&e.texStorage2D(n.TEXTURE_CUBE_MAP,Ot,St,nt.width,nt.height);for(let Ct=0;Ct<6;Ct++){Kt=rt[Ct].mipmaps;for(let oe=0;oe<Kt.length;oe++){let Fe=Kt[oe];M.format!==Ei?Tt!==null?Gt?ct&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe,0,0,Fe.width,Fe.height,Tt,Fe.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe,St,Fe.width,Fe.height,0,Fe.data):qt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Gt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe,0,0,Fe.width,Fe.height,Tt,_t,Fe.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe,St,Fe.width,Fe.height,0,Tt,_t,Fe.data)}}}else{if(Kt=M.mipmaps,Gt&&Zt){Kt.length>0&&Ot++;let Ct=Xt(rt[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,Ot,St,Ct.width,Ct.height)}for(let Ct=0;Ct<6;Ct++)if(O){Gt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,rt[Ct].width,rt[Ct].height,Tt,_t,rt[Ct].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,St,rt[Ct].width,rt[Ct].height,0,Tt,_t,rt[Ct].data);for(let oe=0;oe<Kt.length;oe++){let Dn=Kt[oe].image[Ct].image;Gt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe+1,0,0,Dn.width,Dn.height,Tt,_t,Dn.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe+1,St,Dn.width,Dn.height,0,Tt,_t,Dn.data)}}else{Gt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,Tt,_t,rt[Ct]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,St,Tt,_t,rt[Ct]);for(let oe=0;oe<Kt.length;oe++){let Fe=Kt[oe];Gt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe+1,0,0,Tt,_t,Fe.image[Ct]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe+1,St,Tt,_t,Fe.image[Ct])}}}E(M)&&M.mipmapsAutoUpdate===!0&&S(n.TEXTURE_CUBE_MAP),xt.__version=ot.version,M.onUpdate&&M.onUpdate(M)}I.__version=M.version}function Re(I,M,q,ht,ot,xt){let yt=r.convert(q.format,q.colorSpace),et=r.convert(q.type),st=b(q.internalFormat,yt,et,q.normalized,q.colorSpace),mt=i.get(M),O=i.get(q);if(O.__renderTarget=M,!mt.__hasExternalTextures){let rt=Math.max(1,M.width>>xt),nt=Math.max(1,M.height>>xt);ot===n.TEXTURE_3D||ot===n.TEXTURE_2D_ARRAY?e.texImage3D(ot,xt,st,rt,nt,M.depth,0,yt,et,null):e.texImage2D(ot,xt,st,rt,nt,0,yt,et,null)}e.bindFramebuffer(n.FRAMEBUFFER,I),wt(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ht,ot,O.__webglTexture,0,re(M)):(ot===n.TEXTURE_2D||ot>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ot<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ht,ot,O.__webglTexture,xt),e.bindFramebuffer(n.FRAMEBUFFER,null)}function xn(I,M,q){if(n.bindRenderbuffer(n.RENDERBUFFER,I),M.depthBuffer){let ht=M.depthTexture,ot=ht&&ht.isDepthTexture?ht.type:null,xt=x(M.stencilBuffer,ot),yt=M.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;wt(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,re(M),xt,M.width,M.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,re(M),xt,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,xt,M.width,M.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,yt,n.RENDERBUFFER,I)}else{let ht=M.textures;for(let ot=0;ot<ht.length;ot++){let xt=ht[ot],yt=r.convert(xt.format,xt.colorSpace),et=r.convert(xt.type),st=b(xt.internalFormat,yt,et,xt.normalized,xt.colorSpace);wt(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,re(M),st,M.width,M.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,re(M),st,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,st,M.width,M.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function xe(I,M,q){let ht=M.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,I),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ot=i.get(M.depthTexture);ot.__renderTarget=M;let xt=ht?M.depthTexture.image[0]:M.depthTexture.image;(!ot.__webglTexture||xt.width!==M.width||xt.height!==M.height)&&(xt.width=M.width,xt.height=M.height,M.depthTexture.needsUpdate=!0),ht?bt(M.depthTexture,0):ut(M.depthTexture,0);let yt=ot.__webglTexture,et=re(M),st=ht?n.TEXTURE_CUBE_MAP_POSITIVE_X+q:n.TEXTURE_2D,mt=M.depthTexture.format===hs?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(M.depthTexture.format===ss)wt(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,mt,st,yt,0,et):n.framebufferTexture2D(n.FRAMEBUFFER,mt,st,yt,0);else if(M.depthTexture.format===hs)wt(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,mt,st,yt,0,et):n.framebufferTexture2D(n.FRAMEBUFFER,mt,st,yt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function un(I){let M=i.get(I),q=I.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==I.depthTexture){let ht=I.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),ht){let ot=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,ht.removeEventListener("dispose",ot)};ht.addEventListener("dispose",ot),M.__depthDisposeCallback=ot}M.__boundDepthTexture=ht}if(I.depthTexture&&!M.__autoAllocateDepthBuffer)if(q)for(let ht=0;ht<6;ht++)xe(M.__webglFramebuffer[ht],I,ht);else I.texture.mipmaps.length>0?xe(M.__webglFramebuffer[0],I,0):xe(M.__webglFramebuffer,I,0);else if(q){M.__webglDepthbuffer=[];for(let ht=0;ht<6;ht++)if(e.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[ht]),M.__webglDepthbuffer[ht]===void 0)M.__webglDepthbuffer[ht]=n.createRenderbuffer(),xn(M.__webglDepthbuffer[ht],I,!1);else{let ot=I.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xt=M.__webglDepthbuffer[ht];n.bindRenderbuffer(n.RENDERBUFFER,xt),n.framebufferRenderbuffer(n.FRAMEBUFFER,ot,n.RENDERBUFFER,xt)}}else if(I.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=n.createRenderbuffer(),xn(M.__webglDepthbuffer,I,!1);else{let ot=I.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xt=M.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,xt),n.framebufferRenderbuffer(n.FRAMEBUFFER,ot,n.RENDERBUFFER,xt)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function Ye(I,M,q){let ht=i.get(I);M!==void 0&&Re(ht.__webglFramebuffer,I,I.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),q!==void 0&&un(I)}function sn(I){let M=I.texture,q=i.get(I),ht=i.get(M);I.addEventListener("dispose",F),L(I);let ot=I.textures,xt=I.isWebGLCubeRenderTarget===!0,yt=ot.length>1;if(yt||(ht.__webglTexture===void 0&&(ht.__webglTexture=n.createTexture()),ht.__version=M.version,o.memory.textures++),xt){q.__webglFramebuffer=[];for(let et=0;et<6;et++)if(M.mipmaps.length>0){q.__webglFramebuffer[et]=[];for(let st=0;st<M.mipmaps.length;st++)q.__webglFramebuffer[et][st]=n.createFramebuffer()}else q.__webglFramebuffer[et]=n.createFramebuffer()}else{if(M.mipmaps.length>0){q.__webglFramebuffer=[];for(let et=0;et<M.mipmaps.length;et++)q.__webglFramebuffer[et]=n.createFramebuffer()}else q.__webglFramebuffer=n.createFramebuffer();if(yt)for(let et=0,st=ot.length;et<st;et++){let mt=i.get(ot[et]);mt.__webglTexture===void 0&&(mt.__webglTexture=n.createTexture(),o.memory.textures++)}if(I.samples>0&&wt(I)===!1){q.__webglMultisampledFramebuffer=n.createFramebuffer(),q.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let et=0;et<ot.length;et++){let st=ot[et];q.__webglColorRenderbuffer[et]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,q.__webglColorRenderbuffer[et]);let mt=r.convert(st.format,st.colorSpace),O=r.convert(st.type),rt=b(st.internalFormat,mt,O,st.normalized,st.colorSpace,I.isXRRenderTarget===!0),nt=re(I);n.renderbufferStorageMultisample(n.RENDERBUFFER,nt,rt,I.width,I.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+et,n.RENDERBUFFER,q.__webglColorRenderbuffer[et])}n.bindRenderbuffer(n.RENDERBUFFER,null),I.depthBuffer&&(q.__webglDepthRenderbuffer=n.createRenderbuffer(),xn(q.__webglDepthRenderbuffer,I,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(xt){e.bindTexture(n.TEXTURE_CUBE_MAP,ht.__webglTexture),he(n.TEXTURE_CUBE_MAP,M);for(let et=0;et<6;et++)if(M.mipmaps.length>0)for(let st=0;st<M.mipmaps.length;st++)Re(q.__webglFramebuffer[et][st],I,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+et,st);else Re(q.__webglFramebuffer[et],I,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+et,0);E(M)?S(n.TEXTURE_CUBE_MAP):M.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),e.unbindTexture()}else if(yt){for(let et=0,st=ot.length;et<st;et++){let mt=ot[et],O=i.get(mt),rt=n.TEXTURE_2D;(I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(rt=I.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(rt,O.__webglTexture),he(rt,mt),Re(q.__webglFramebuffer,I,mt,n.COLOR_ATTACHMENT0+et,rt,0),E(mt)&&S(rt)}e.unbindTexture()}else{let et=n.TEXTURE_2D;if((I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(et=I.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(et,ht.__webglTexture),he(et,M),M.mipmaps.length>0)for(let st=0;st<M.mipmaps.length;st++)Re(q.__webglFramebuffer[st],I,M,n.COLOR_ATTACHMENT0,et,st);else Re(q.__webglFramebuffer,I,M,n.COLOR_ATTACHMENT0,et,0);E(M)?S(et):M.mipmaps.length>0&&n.texParameteri(et,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),e.unbindTexture()}I.depthBuffer&&un(I)}function B(I){let M=I.textures;for(let q=0,ht=M.length;q<ht;q++){let ot=M[q];if(E(ot)&&ot.mipmapsAutoUpdate===!0){let xt=C(I),yt=i.get(ot).__webglTexture;e.bindTexture(xt,yt),S(xt),e.unbindTexture()}}}let Rt=[];function Yt(I){if(I.samples>0){if(wt(I)===!1){let M=I.textures,q=I.width,ht=I.height,ot=n.COLOR_BUFFER_BIT,xt=I.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,yt=i.get(I),et=M.length>1;if(et)for(let mt=0;mt<M.length;mt++)e.bindFramebuffer(n.FRAMEBUFFER,yt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,yt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,yt.__webglMultisampledFramebuffer),I.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,yt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,yt.__webglFramebuffer);for(let mt=0;mt<M.length;mt++){if(I.resolveDepthBuffer&&(I.depthBuffer&&(ot|=n.DEPTH_BUFFER_BIT),I.stencilBuffer&&I.resolveStencilBuffer&&(ot|=n.STENCIL_BUFFER_BIT)),et){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,yt.__webglColorRenderbuffer[mt]);let O=i.get(M[mt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,O,0)}n.blitFramebuffer(0,0,q,ht,0,0,q,ht,ot,n.NEAREST),l===!0&&(Rt.length=0,Rt.push(n.COLOR_ATTACHMENT0+mt),I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&Rt.push(xt),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Rt))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),et)for(let mt=0;mt<M.length;mt++){e.bindFramebuffer(n.FRAMEBUFFER,yt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.RENDERBUFFER,yt.__webglColorRenderbuffer[mt]);let O=i.get(M[mt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,yt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.TEXTURE_2D,O,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,yt.__webglMultisampledFramebuffer)}else if(I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&l){let M=I.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[M])}}}function re(I){return Math.min(s.maxSamples,I.samples)}function wt(I){let M=i.get(I);return I.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function Le(I){let M=o.render.frame;u.get(I)!==M&&(u.set(I,M),I.update())}function zt(I,M){let q=I.colorSpace,ht=I.format,ot=I.type;return I.isCompressedTexture===!0||I.isVideoTexture===!0||q!==zo&&q!==us&&(ge.getTransfer(q)===we?(ht!==Ei||ot!==Yn)&&qt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Qt("WebGLTextures: Unsupported texture color space:",q)),M}function Xt(I){return typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement?(c.width=I.naturalWidth||I.width,c.height=I.naturalHeight||I.height):typeof VideoFrame<"u"&&I instanceof VideoFrame?(c.width=I.displayWidth,c.height=I.displayHeight):(c.width=I.width,c.height=I.height),c}this.allocateTextureUnit=ft,this.resetTextureUnits=Q,this.getTextureUnits=it,this.setTextureUnits=dt,this.setTexture2D=ut,this.setTexture2DArray=gt,this.setTexture3D=Mt,this.setTextureCube=bt,this.rebindTextures=Ye,this.setupRenderTarget=sn,this.updateRenderTargetMipmap=B,this.updateMultisampleRenderTarget=Yt,this.setupDepthRenderbuffer=un,this.setupFrameBufferTexture=Re,this.useMultisampledRTT=wt,this.dispose=V}function vM(n,t){function e(i,s=us){let r,o=ge.getTransfer(s);if(i===Yn)return n.UNSIGNED_BYTE;if(i===Xl)return n.UNSIGNED_SHORT_4_4_4_4;if(i===ql)return n.UNSIGNED_SHORT_5_5_5_1;if(i===hu)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===uu)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===lu)return n.BYTE;if(i===cu)return n.SHORT;if(i===eo)return n.UNSIGNED_SHORT;if(i===Wl)return n.INT;if(i===Ti)return n.UNSIGNED_INT;if(i===mi)return n.FLOAT;if(i===Ai)return n.HALF_FLOAT;if(i===fu)return n.ALPHA;if(i===du)return n.RGB;if(i===Ei)return n.RGBA;if(i===ss)return n.DEPTH_COMPONENT;if(i===hs)return n.DEPTH_STENCIL;if(i===Yl)return n.RED;if(i===$l)return n.RED_INTEGER;if(i===Ns)return n.RG;if(i===Zl)return n.RG_INTEGER;if(i===Kl)return n.RGBA_INTEGER;if(i===ua||i===fa||i===da||i===pa)if(o===we)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===ua)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===fa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===da)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===pa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===ua)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===fa)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===da)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===pa)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Jl||i===jl||i===Ql||i===tc)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Jl)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===jl)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Ql)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===tc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===ec||i===nc||i===ic||i===sc||i===rc||i===ma||i===oc)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===ec||i===nc)return o===we?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===ic)return o===we?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===sc)return r.COMPRESSED_R11_EAC;if(i===rc)return r.COMPRESSED_SIGNED_R11_EAC;if(i===ma)return r.COMPRESSED_RG11_EAC;if(i===oc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===ac||i===lc||i===cc||i===hc||i===uc||i===fc||i===dc||i===pc||i===mc||i===gc||i===_c||i===xc||i===yc||i===vc)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===ac)return o===we?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===lc)return o===we?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===cc)return o===we?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===hc)return o===we?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===uc)return o===we?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===fc)return o===we?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===dc)return o===we?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===pc)return o===we?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===mc)return o===we?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===gc)return o===we?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===_c)return o===we?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===xc)return o===we?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===yc)return o===we?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===vc)return o===we?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Sc||i===Mc||i===bc)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===Sc)return o===we?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Mc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===bc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===wc||i===Tc||i===ga||i===Ac)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===wc)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Tc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===ga)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Ac)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===ir?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var SM=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,MM=`
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

}`,Ou=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new Qo(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new Gi({vertexShader:SM,fragmentShader:MM,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Gn(new ea(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Bu=class extends wi{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,d=null,g=null,y=typeof XRWebGLBinding<"u",m=new Ou,p={},_=e.getContextAttributes(),E=null,S=null,C=[],b=[],x=new Jt,T=null,L=null,P=new Bn;P.viewport=new We;let R=new Bn;R.viewport=new We;let F=[P,R],k=new kl,N=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(tt){let ut=C[tt];return ut===void 0&&(ut=new qr,C[tt]=ut),ut.getTargetRaySpace()},this.getControllerGrip=function(tt){let ut=C[tt];return ut===void 0&&(ut=new qr,C[tt]=ut),ut.getGripSpace()},this.getHand=function(tt){let ut=C[tt];return ut===void 0&&(ut=new qr,C[tt]=ut),ut.getHandSpace()};function Y(tt){let ut=b.indexOf(tt.inputSource);if(ut===-1)return;let gt=C[ut];gt!==void 0&&(gt.update(tt.inputSource,tt.frame,c||o),gt.dispatchEvent({type:tt.type,data:tt.inputSource}))}function G(){s.removeEventListener("select",Y),s.removeEventListener("selectstart",Y),s.removeEventListener("selectend",Y),s.removeEventListener("squeeze",Y),s.removeEventListener("squeezestart",Y),s.removeEventListener("squeezeend",Y),s.removeEventListener("end",G),s.removeEventListener("inputsourceschange",lt);for(let tt=0;tt<C.length;tt++){let ut=b[tt];ut!==null&&(b[tt]=null,C[tt].disconnect(ut))}N=null,V=null,m.reset();for(let tt in p)delete p[tt];if(t.setRenderTarget(E),d=null,f=null,h=null,s=null,S=null,ft.stop(),i.isPresenting=!1,t.setPixelRatio(T),t.setSize(x.width,x.height,!1),L!==null){let tt=L.camera;tt.fov=L.fov,tt.zoom=L.zoom,tt.updateProjectionMatrix(),L=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(tt){r=tt,i.isPresenting===!0&&qt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(tt){a=tt,i.isPresenting===!0&&qt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(tt){c=tt},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return h===null&&y&&(h=new XRWebGLBinding(s,e)),h},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(tt){if(s=tt,s!==null){if(E=t.getRenderTarget(),s.addEventListener("select",Y),s.addEventListener("selectstart",Y),s.addEventListener("selectend",Y),s.addEventListener("squeeze",Y),s.addEventListener("squeezestart",Y),s.addEventListener("squeezeend",Y),s.addEventListener("end",G),s.addEventListener("inputsourceschange",lt),_.xrCompatible!==!0&&await e.makeXRCompatible(),T=t.getPixelRatio(),t.getSize(x),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let gt=null,Mt=null,bt=null;_.depth&&(bt=_.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,gt=_.stencil?hs:ss,Mt=_.stencil?ir:Ti);let Ht={colorFormat:e.RGBA8,depthFormat:bt,scaleFactor:r};h=this.getBinding(),f=h.createProjectionLayer(Ht),s.updateRenderState({layers:[f]}),t.setPixelRatio(1),t.setSize(f.textureWidth,f.textureHeight,!1),S=new ri(f.textureWidth,f.textureHeight,{format:Ei,type:Yn,depthTexture:new ls(f.textureWidth,f.textureHeight,Mt,void 0,void 0,void 0,void 0,void 0,void 0,gt),stencilBuffer:_.stencil,colorSpace:t.outputColorSpace,samples:_.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let gt={antialias:_.antialias,alpha:!0,depth:_.depth,stencil:_.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,e,gt),s.updateRenderState({baseLayer:d}),t.setPixelRatio(1),t.setSize(d.framebufferWidth,d.framebufferHeight,!1),S=new ri(d.framebufferWidth,d.framebufferHeight,{format:Ei,type:Yn,colorSpace:t.outputColorSpace,stencilBuffer:_.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ft.setContext(s),ft.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function lt(tt){for(let ut=0;ut<tt.removed.length;ut++){let gt=tt.removed[ut],Mt=b.indexOf(gt);Mt>=0&&(b[Mt]=null,C[Mt].disconnect(gt))}for(let ut=0;ut<tt.added.length;ut++){let gt=tt.added[ut],Mt=b.indexOf(gt);if(Mt===-1){for(let Ht=0;Ht<C.length;Ht++)if(Ht>=b.length){b.push(gt),Mt=Ht;break}else if(b[Ht]===null){b[Ht]=gt,Mt=Ht;break}if(Mt===-1)break}let bt=C[Mt];bt&&bt.connect(gt)}}function K(tt,ut){ut===null?tt.matrixWorld.copy(tt.matrix):tt.matrixWorld.multiplyMatrices(ut.matrixWorld,tt.matrix),tt.matrixWorldInverse.copy(tt.matrixWorld).invert()}this.updateCamera=function(tt){if(s===null)return;let ut=tt.near,gt=tt.far;m.texture!==null&&(m.depthNear>0&&(ut=m.depthNear),m.depthFar>0&&(gt=m.depthFar)),k.near=R.near=P.near=ut,k.far=R.far=P.far=gt,(N!==k.near||V!==k.far)&&(s.updateRenderState({depthNear:k.near,depthFar:k.far}),N=k.near,V=k.far),k.layers.mask=tt.layers.mask|6,P.layers.mask=k.layers.mask&-5,R.layers.mask=k.layers.mask&-3;let Mt=tt.parent,bt=k.cameras;K(k,Mt);for(let Ht=0;Ht<bt.length;Ht++)K(bt[Ht],Mt);k.projectionMatrix.copy(P.projectionMatrix),k.projectionMatrixInverse.copy(P.projectionMatrixInverse),L===null&&tt.isPerspectiveCamera&&(L={camera:tt,fov:tt.fov,zoom:tt.zoom}),Q(tt,k,Mt)};function Q(tt,ut,gt){gt===null?tt.matrix.copy(ut.matrixWorld):(tt.matrix.copy(gt.matrixWorld),tt.matrix.invert(),tt.matrix.multiply(ut.matrixWorld)),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.updateMatrixWorld(!0),tt.projectionMatrix.copy(ut.projectionMatrix),tt.projectionMatrixInverse.copy(ut.projectionMatrixInverse),tt.isPerspectiveCamera&&(tt.fov=Wr*2*Math.atan(1/tt.projectionMatrix.elements[5]),tt.zoom=1)}this.getCamera=function(){return k},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(tt){l=tt,f!==null&&(f.fixedFoveation=tt),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=tt)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(k)},this.getCameraTexture=function(tt){return p[tt]};let it=null;function dt(tt,ut){if(u=ut.getViewerPose(c||o),g=ut,u!==null){let gt=u.views;d!==null&&(t.setRenderTargetFramebuffer(S,d.framebuffer),t.setRenderTarget(S));let Mt=!1;gt.length!==k.cameras.length&&(k.cameras.length=0,Mt=!0);for(let Vt=0;Vt<gt.length;Vt++){let he=gt[Vt],ae=null;if(d!==null)ae=d.getViewport(he);else{let Ge=h.getViewSubImage(f,he);ae=Ge.viewport,Vt===0&&(t.setRenderTargetTextures(S,Ge.colorTexture,Ge.depthStencilTexture),t.setRenderTarget(S))}let ne=F[Vt];ne===void 0&&(ne=new Bn,ne.layers.enable(Vt),ne.viewport=new We,F[Vt]=ne),ne.matrix.fromArray(he.transform.matrix),ne.matrix.decompose(ne.position,ne.quaternion,ne.scale),ne.projectionMatrix.fromArray(he.projectionMatrix),ne.projectionMatrixInverse.copy(ne.projectionMatrix).invert(),ne.viewport.set(ae.x,ae.y,ae.width,ae.height),Vt===0&&(k.matrix.copy(ne.matrix),k.matrix.decompose(k.position,k.quaternion,k.scale)),Mt===!0&&k.cameras.push(ne)}let bt=s.enabledFeatures;if(bt&&bt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){h=i.getBinding();let Vt=h.getDepthInformation(gt[0]);Vt&&Vt.isValid&&Vt.texture&&m.init(Vt,s.renderState)}if(bt&&bt.includes("camera-access")&&y){t.state.unbindTexture(),h=i.getBinding();for(let Vt=0;Vt<gt.length;Vt++){let he=gt[Vt].camera;if(he){let ae=p[he];ae||(ae=new Qo,p[he]=ae);let ne=h.getCameraImage(he);ae.sourceTexture=ne}}}}for(let gt=0;gt<C.length;gt++){let Mt=b[gt],bt=C[gt];Mt!==null&&bt!==void 0&&bt.update(Mt,ut,c||o)}it&&it(tt,ut),ut.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:ut}),g=null}let ft=new qp;ft.setAnimationLoop(dt),this.setAnimationLoop=function(tt){it=tt},this.dispose=function(){}}},bM=new Ie,nm=new te;nm.set(-1,0,0,0,1,0,0,0,1);function wM(n,t){function e(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function i(m,p){p.color.getRGB(m.fogColor.value,Tu(n)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}function s(m,p,_,E,S){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?r(m,p):p.isMeshLambertMaterial?(r(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(r(m,p),h(m,p)):p.isMeshPhongMaterial?(r(m,p),u(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(r(m,p),f(m,p),p.isMeshPhysicalMaterial&&d(m,p,S)):p.isMeshMatcapMaterial?(r(m,p),g(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),y(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(o(m,p),p.isLineDashedMaterial&&a(m,p)):p.isPointsMaterial?l(m,p,_,E):p.isSpriteMaterial?c(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,e(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===Hn&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,e(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===Hn&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.value=p.displacementMap,e(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,e(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,e(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);let _=t.get(p),E=_.envMap,S=_.envMapRotation;E&&(m.envMap.value=E,m.envMapRotation.value.setFromMatrix4(bM.makeRotationFromEuler(S)).transpose(),E.isCubeTexture&&E.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(nm),m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,e(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,e(p.aoMap,m.aoMapTransform))}function o(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform))}function a(m,p){m.dashSize.value=p.dashSize,m.totalSize.value=p.dashSize+p.gapSize,m.scale.value=p.scale}function l(m,p,_,E){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*_,m.scale.value=E*.5,p.map&&(m.map.value=p.map,e(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function c(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function u(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function h(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function f(m,p){m.metalness.value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,e(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,e(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function d(m,p,_){m.ior.value=p.ior,p.diffuseRoughness>0&&(m.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=p.diffuseRoughnessMap,e(p.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,e(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,e(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,e(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,e(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,e(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===Hn&&m.clearcoatNormalScale.value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.retroreflectivity>0&&(m.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,e(p.iridescenceMap,m.iridescenceMapTransform)),p.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,e(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=_.texture,m.transmissionSamplerSize.value.set(_.width,_.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,e(p.transmissionMap,m.transmissionMapTransform)),m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,e(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=p.anisotropyMap,e(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,e(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,e(p.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,p){p.matcap&&(m.matcap.value=p.matcap)}function y(m,p){let _=t.get(p).light;m.referencePosition.value.setFromMatrixPosition(_.matrixWorld),m.nearDistance.value=_.shadow.camera.near,m.farDistance.value=_.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function TM(n,t,e,i){let s={},r={};function o(_,E){let S=E.program;i.uniformBlockBinding(_,S,s[_.id])}function a(_,E){let S=s[_.id];S===void 0&&(g(_),S=l(_),s[_.id]=S,_.addEventListener("dispose",m));let C=E.program;i.updateUBOMapping(_,C);let b=t.render.frame;r[_.id]!==b&&(c(_),r[_.id]=b)}function l(_){let E=n.createBuffer(),S=_.__size,C=_.usage;return n.bindBuffer(n.UNIFORM_BUFFER,E),n.bufferData(n.UNIFORM_BUFFER,S,C),n.bindBuffer(n.UNIFORM_BUFFER,null),E}function c(_){let E=s[_.id],S=_.uniforms,C=_.__cache;n.bindBuffer(n.UNIFORM_BUFFER,E);for(let b=0,x=S.length;b<x;b++){let T=S[b];if(Array.isArray(T))for(let L=0,P=T.length;L<P;L++)u(T[L],b,L,C);else u(T,b,0,C)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(_,E,S,C){if(f(_,E,S,C)===!0){let b=_.__offset,x=_.value;if(Array.isArray(x)){let T=0;for(let L=0;L<x.length;L++){let P=x[L],R=y(P,!0);h(P,_.__data,T),T+=R.storage/Float32Array.BYTES_PER_ELEMENT}}else h(x,_.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,b,_.__data)}}function h(_,E,S){typeof _=="number"||typeof _=="boolean"?E[S]=_:_.isMatrix3?(E[S]=_.elements[0],E[S+1]=_.elements[1],E[S+2]=_.elements[2],E[S+3]=0,E[S+4]=_.elements[3],E[S+5]=_.elements[4],E[S+6]=_.elements[5],E[S+7]=0,E[S+8]=_.elements[6],E[S+9]=_.elements[7],E[S+10]=_.elements[8],E[S+11]=0):ArrayBuffer.isView(_)?E.set(_.subarray(0,E.length-S),S):_.toArray(E,S)}function f(_,E,S,C){let b=_.value,x=E+"_"+S;if(Array.isArray(b)){C[x]===void 0&&(C[x]=[]);let T=C[x],L=!1;for(let P=0;P<b.length;P++)d(b[P],T,P)===!0&&(L=!0);return L}return d(b,C,x)}function d(_,E,S){if(E[S]===void 0)return typeof _=="number"||typeof _=="boolean"?E[S]=_:ArrayBuffer.isView(_)?E[S]=_.slice():E[S]=_.clone(),!0;{let C=E[S];if(typeof _=="number"||typeof _=="boolean"){if(C!==_)return E[S]=_,!0}else{if(ArrayBuffer.isView(_))return!0;if(C.equals(_)===!1)return C.copy(_),!0}}return!1}function g(_){let E=_.uniforms,S=0,C=16;for(let x=0,T=E.length;x<T;x++){let L=Array.isArray(E[x])?E[x]:[E[x]];for(let P=0,R=L.length;P<R;P++){let F=L[P],k=Array.isArray(F.value)?F.value:[F.value],N=Array.isArray(E[x])||Array.isArray(F.value),V=S;for(let G=0,lt=k.length;G<lt;G++){let K=k[G],Q=y(K,N),it=S%C,dt=it%Q.boundary,ft=it+dt;S+=dt,ft!==0&&C-ft<Q.storage&&(S+=C-ft),G===0&&(V=S),S+=Q.storage}let Y=F.type==="int"?Int32Array:F.type==="uint"?Uint32Array:Float32Array;F.__data=new Y((S-V)/Float32Array.BYTES_PER_ELEMENT),F.__offset=V}}let b=S%C;return b>0&&(S+=C-b),_.__size=S,_.__cache={},this}function y(_,E){let S={boundary:0,storage:0};return typeof _=="number"||typeof _=="boolean"?(S.boundary=4,S.storage=4):_.isVector2?(S.boundary=8,S.storage=8):_.isVector3||_.isColor?(S.boundary=16,S.storage=12):_.isVector4?(S.boundary=16,S.storage=16):_.isMatrix3?(S.boundary=16,S.storage=48):_.isMatrix4?(S.boundary=16,S.storage=64):_.isTexture?qt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(_)?(S.boundary=16,S.storage=_.byteLength):qt("WebGLRenderer: Unsupported uniform value type.",_),E===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function m(_){let E=_.target;E.removeEventListener("dispose",m),n.deleteBuffer(s[E.id]),delete s[E.id],delete r[E.id]}function p(){for(let _ in s)n.deleteBuffer(s[_]);s={},r={}}return{bind:o,update:a,dispose:p}}var AM=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Wi=null;function EM(){return Wi===null&&(Wi=new $o(AM,16,16,Ns,Ai),Wi.name="DFG_LUT",Wi.minFilter=zn,Wi.magFilter=zn,Wi.wrapS=ki,Wi.wrapT=ki,Wi.generateMipmaps=!1,Wi.needsUpdate=!0),Wi}var Ic=class{constructor(t={}){let{canvas:e=mp(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:f=!1,outputBufferType:d=Yn}=t;this.isWebGLRenderer=!0;let g;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=i.getContextAttributes().alpha}else g=o;let y=d,m=new Set([Kl,Zl,$l]),p=new Set([Yn,Ti,eo,ir,Xl,ql]),_=new Uint32Array(4),E=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},C=null,b=null,x=[],T=[],L=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Hi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let P=this,R=!1,F=null,k=null,N=null,V=null;this._outputColorSpace=ei;let Y=0,G=0,lt=null,K=-1,Q=null,it=new We,dt=new We,ft=null,tt=new ee(0),ut=0,gt=e.width,Mt=e.height,bt=1,Ht=null,se=null,Vt=new We(0,0,gt,Mt),he=new We(0,0,gt,Mt),ae=!1,ne=new Es,Ge=new Sl,Ue=!1,nn=!1,Re=new Ie,xn=new X,xe=new We,un={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Ye=!1;function sn(){return lt===null?bt:1}let B=i;function Rt(A,z){return e.getContext(A,z)}let Yt,re,wt,Le,zt,Xt,I,M,q,ht,ot,xt,yt,et,st,mt,O,rt,nt,Tt,_t,St,Gt;try{let A={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Ot,!1),e.addEventListener("webglcontextrestored",Kt,!1),e.addEventListener("webglcontextcreationerror",Ct,!1),B===null){let z="webgl2";if(B=Rt(z,A),B===null)throw Rt(z)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Zt()}catch(A){throw e.removeEventListener("webglcontextlost",Ot,!1),e.removeEventListener("webglcontextrestored",Kt,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),Qt("WebGLRenderer: "+A.message),A}function Zt(){Yt=new Bv(B),Yt.init(),_t=new vM(B,Yt),re=new Ev(B,Yt,t,_t),wt=new xM(B,Yt),re.reversedDepthBuffer&&f&&wt.buffers.depth.setReversed(!0),k=B.createFramebuffer(),N=B.createFramebuffer(),V=B.createFramebuffer(),Le=new Vv(B),zt=new sM,Xt=new yM(B,Yt,wt,zt,re,_t,Le),I=new Ov(P),M=new H_(B),St=new Tv(B,M),q=new kv(B,M,Le,St),ht=new Hv(B,q,M,St,Le),rt=new Gv(B,re,Xt),st=new Cv(zt),ot=new iM(P,I,Yt,re,St,st),xt=new wM(P,zt),yt=new oM,et=new fM(Yt),O=new wv(P,I,wt,ht,g,l),mt=new _M(P,ht,re),Gt=new TM(B,Le,re,wt),nt=new Av(B,Yt,Le),Tt=new zv(B,Yt,Le),Le.programs=ot.programs,P.capabilities=re,P.extensions=Yt,P.properties=zt,P.renderLists=yt,P.shadowMap=mt,P.state=wt,P.info=Le}y!==Yn&&(L=new Xv(y,e.width,e.height,a,s,r));let ct=new Bu(P,B);this.xr=ct,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let A=Yt.get("WEBGL_lose_context");A&&A.loseContext()},this.forceContextRestore=function(){let A=Yt.get("WEBGL_lose_context");A&&A.restoreContext()},this.getPixelRatio=function(){return bt},this.setPixelRatio=function(A){A!==void 0&&(bt=A,this.setSize(gt,Mt,!1))},this.getSize=function(A){return A.set(gt,Mt)},this.setSize=function(A,z,j=!0){if(ct.isPresenting){qt("WebGLRenderer: Can't change size while VR device is presenting.");return}gt=A,Mt=z,e.width=Math.floor(A*bt),e.height=Math.floor(z*bt),j===!0&&(e.style.width=A+"px",e.style.height=z+"px"),L!==null&&L.setSize(e.width,e.height),this.setViewport(0,0,A,z)},this.getDrawingBufferSize=function(A){return A.set(gt*bt,Mt*bt).floor()},this.setDrawingBufferSize=function(A,z,j){gt=A,Mt=z,bt=j,e.width=Math.floor(A*j),e.height=Math.floor(z*j),this.setViewport(0,0,A,z)},this.setEffects=function(A){if(y===Yn){Qt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(A){for(let z=0;z<A.length;z++)if(A[z].isOutputPass===!0){qt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}L.setEffects(A||[])},this.getCurrentViewport=function(A){return A.copy(it)},this.getViewport=function(A){return A.copy(Vt)},this.setViewport=function(A,z,j,$){A.isVector4?Vt.set(A.x,A.y,A.z,A.w):Vt.set(A,z,j,$),wt.viewport(it.copy(Vt).multiplyScalar(sn()).round())},this.getScissor=function(A){return A.copy(he)},this.setScissor=function(A,z,j,$){A.isVector4?he.set(A.x,A.y,A.z,A.w):he.set(A,z,j,$),wt.scissor(dt.copy(he).multiplyScalar(sn()).round())},this.getScissorTest=function(){return ae},this.setScissorTest=function(A){wt.setScissorTest(ae=A)},this.setOpaqueSort=function(A){Ht=A},this.setTransparentSort=function(A){se=A},this.getClearColor=function(A){return A.copy(O.getClearColor())},this.setClearColor=function(){O.setClearColor(...arguments)},this.getClearAlpha=function(){return O.getClearAlpha()},this.setClearAlpha=function(){O.setClearAlpha(...arguments)},this.clear=function(A=!0,z=!0,j=!0){let $=0;if(A){let Z=!1;if(lt!==null){let At=lt.texture.format;Z=m.has(At)}if(Z){let At=lt.texture.type,Pt=p.has(At),Et=O.getClearColor(),It=O.getClearAlpha(),kt=Et.r,jt=Et.g,ue=Et.b;Pt?(_[0]=kt,_[1]=jt,_[2]=ue,_[3]=It,B.clearBufferuiv(B.COLOR,0,_)):(E[0]=kt,E[1]=jt,E[2]=ue,E[3]=It,B.clearBufferiv(B.COLOR,0,E))}else $|=B.COLOR_BUFFER_BIT}z&&($|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&($|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),$!==0&&B.clear($)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(A){A.setRenderer(this),F=A},this.dispose=function(){e.removeEventListener("webglcontextlost",Ot,!1),e.removeEventListener("webglcontextrestored",Kt,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),O.dispose(),yt.dispose(),et.dispose(),Xt.dispose(),zt.dispose(),I.dispose(),ht.dispose(),q.dispose(),St.dispose(),Gt.dispose(),ot.dispose(),ct.dispose(),ct.removeEventListener("sessionstart",Da),ct.removeEventListener("sessionend",Ii),Yi.stop()};function Ot(A){A.preventDefault(),vu("WebGLRenderer: Context Lost."),R=!0}function Kt(){vu("WebGLRenderer: Context Restored."),R=!1;let A=Le.autoReset,z=mt.enabled,j=mt.autoUpdate,$=mt.needsUpdate,Z=mt.type;Zt(),Le.autoReset=A,mt.enabled=z,mt.autoUpdate=j,mt.needsUpdate=$,mt.type=Z}function Ct(A){Qt("WebGLRenderer: A WebGL context could not be created. Reason: ",A.statusMessage)}function oe(A){let z=A.target;z.removeEventListener("dispose",oe),Fe(z)}function Fe(A){Dn(A),zt.remove(A)}function Dn(A){let z=zt.get(A).programs;z!==void 0&&(z.forEach(function(j){ot.releaseProgram(j)}),A.isShaderMaterial&&ot.releaseShaderCache(A))}this.renderBufferDirect=function(A,z,j,$,Z,At){z===null&&(z=un);let Pt=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Et=wo(A,z,j,$,Z);wt.setMaterial($,Pt);let It=j.index,kt=1;if($.wireframe===!0){if(It=q.getWireframeAttribute(j),It===void 0)return;kt=2}let jt=j.drawRange,ue=j.attributes.position,Bt=jt.start*kt,fe=(jt.start+jt.count)*kt;At!==null&&(Bt=Math.max(Bt,At.start*kt),fe=Math.min(fe,(At.start+At.count)*kt)),It!==null?(Bt=Math.max(Bt,0),fe=Math.min(fe,It.count)):ue!=null&&(Bt=Math.max(Bt,0),fe=Math.min(fe,ue.count));let qe=fe-Bt;if(qe<0||qe===1/0)return;St.setup(Z,$,Et,j,It);let Ae,Ee=nt;if(It!==null&&(Ae=M.get(It),Ee=Tt,Ee.setIndex(Ae)),Z.isMesh)$.wireframe===!0?(wt.setLineWidth($.wireframeLinewidth*sn()),Ee.setMode(B.LINES)):Ee.setMode(B.TRIANGLES);else if(Z.isLine){let fn=$.linewidth;fn===void 0&&(fn=1),wt.setLineWidth(fn*sn()),Z.isLineSegments?Ee.setMode(B.LINES):Z.isLineLoop?Ee.setMode(B.LINE_LOOP):Ee.setMode(B.LINE_STRIP)}else Z.isPoints?Ee.setMode(B.POINTS):Z.isSprite&&Ee.setMode(B.TRIANGLES);if(Z.isBatchedMesh)if(Yt.get("WEBGL_multi_draw"))Ee.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let fn=Z._multiDrawStarts,Ut=Z._multiDrawCounts,rn=Z._multiDrawCount,me=It?M.get(It).bytesPerElement:1,Zi=zt.get($).currentProgram.getUniforms();for(let on=0;on<rn;on++)Zi.setValue(B,"_gl_DrawID",on),Ee.render(fn[on]/me,Ut[on])}else if(Z.isInstancedMesh)Ee.renderInstances(Bt,qe,Z.count);else if(j.isInstancedBufferGeometry){let fn=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Ut=Math.min(j.instanceCount,fn);Ee.renderInstances(Bt,qe,Ut)}else Ee.render(Bt,qe)};function So(A,z,j,$){F!==null&&A.isNodeMaterial&&F.setObject($,A),Ue===!0&&st.setState(A,j,!1),A.transparent===!0&&A.side===qn&&A.forceSinglePass===!1?(A.side=Hn,A.needsUpdate=!0,Li(A,z,$),A.side=Ds,A.needsUpdate=!0,Li(A,z,$),A.side=qn):Li(A,z,$)}this.compile=function(A,z,j=null){j===null&&(j=A),F!==null&&F.renderStart(A,z,j),b=et.get(j),b.init(z),T.push(b),j.traverseVisible(function(Z){Z.isLight&&Z.layers.test(z.layers)&&(b.pushLight(Z),Z.castShadow&&b.pushShadow(Z))}),A!==j&&A.traverseVisible(function(Z){Z.isLight&&Z.layers.test(z.layers)&&(b.pushLight(Z),Z.castShadow&&b.pushShadow(Z))}),b.setupLights(),F!==null&&F.updateLights(b.state.lightsArray),nn=this.localClippingEnabled,Ue=st.init(this.clippingPlanes,nn),Ue===!0&&st.setGlobalState(this.clippingPlanes,z),F!==null&&mt.render(b.state.shadowsArray,j,z);let $=new Set;return A.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let At=Z.material;if(At)if(Array.isArray(At))for(let Pt=0;Pt<At.length;Pt++){let Et=At[Pt];So(Et,j,z,Z),$.add(Et)}else So(At,j,z,Z),$.add(At)}),b=T.pop(),F!==null&&F.renderEnd(),$},this.compileAsync=function(A,z,j=null){let $=this.compile(A,z,j);return new Promise(Z=>{function At(){if($.forEach(function(Pt){let It=zt.get(Pt).currentProgram;(It===void 0||It.isReady())&&$.delete(Pt)}),$.size===0){Z(A);return}setTimeout(At,10)}Yt.get("KHR_parallel_shader_compile")!==null?At():setTimeout(At,10)})};let mr=null;function hh(A){mr&&mr(A)}function Da(){Yi.stop()}function Ii(){Yi.start()}let Yi=new qp;Yi.setAnimationLoop(hh),typeof self<"u"&&Yi.setContext(self),this.setAnimationLoop=function(A){mr=A,ct.setAnimationLoop(A),A===null?Yi.stop():Yi.start()},ct.addEventListener("sessionstart",Da),ct.addEventListener("sessionend",Ii),this.render=function(A,z){if(z!==void 0&&z.isCamera!==!0){Qt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(R===!0)return;F!==null&&F.renderStart(A,z);let j=ct.enabled===!0&&ct.isPresenting===!0,$=L!==null&&(lt===null||j)&&L.begin(P,lt);if(A.matrixWorldAutoUpdate===!0&&A.updateMatrixWorld(),z.parent===null&&z.matrixWorldAutoUpdate===!0&&z.updateMatrixWorld(),ct.enabled===!0&&ct.isPresenting===!0&&(L===null||L.isCompositing()===!1)&&(ct.cameraAutoUpdate===!0&&ct.updateCamera(z),z=ct.getCamera()),A.isScene===!0&&A.onBeforeRender(P,A,z,lt),b=et.get(A,T.length),b.init(z),b.state.textureUnits=Xt.getTextureUnits(),T.push(b),Re.multiplyMatrices(z.projectionMatrix,z.matrixWorldInverse),z.isArrayCamera?Ge.setFromArrayCamera(z):ne.setFromProjectionMatrix(Re,pi,z.reversedDepth),nn=this.localClippingEnabled,Ue=st.init(this.clippingPlanes,nn),C=yt.get(A,x.length),C.init(),x.push(C),this.info.render.frame++,ct.enabled===!0&&ct.isPresenting===!0){let Pt=P.xr.getDepthSensingMesh();Pt!==null&&$i(Pt,z,-1/0,P.sortObjects)}$i(A,z,0,P.sortObjects),C.finish(),F!==null&&F.updateLights(b.state.lightsArray),P.sortObjects===!0&&C.sort(Ht,se),Ye=ct.enabled===!1||ct.isPresenting===!1||ct.hasDepthSensing()===!1,Ye&&O.addToRenderList(C,A),this.info.autoReset===!0&&this.info.reset(),Ue===!0&&st.beginShadows();let Z=b.state.shadowsArray;if(mt.render(Z,A,z),Ue===!0&&st.endShadows(),($&&L.hasRenderPass())===!1){let Pt=C.opaque,Et=C.transmissive;if(b.setupLights(),z.isArrayCamera){let It=z.cameras;if(Et.length>0)for(let kt=0,jt=It.length;kt<jt;kt++){let ue=It[kt];xi(Pt,Et,A,ue)}Ye&&O.render(A);for(let kt=0,jt=It.length;kt<jt;kt++){let ue=It[kt];Mo(C,A,ue,ue.viewport)}}else Et.length>0&&xi(Pt,Et,A,z),Ye&&O.render(A),Mo(C,A,z)}lt!==null&&G===0&&(Xt.updateMultisampleRenderTarget(lt),Xt.updateRenderTargetMipmap(lt)),$&&L.end(P),A.isScene===!0&&A.onAfterRender(P,A,z),St.resetDefaultState(),K=-1,Q=null,T.pop(),T.length>0?(b=T[T.length-1],Xt.setTextureUnits(b.state.textureUnits),Ue===!0&&st.setGlobalState(P.clippingPlanes,b.state.camera)):b=null,x.pop(),x.length>0?C=x[x.length-1]:C=null,F!==null&&F.renderEnd()};function $i(A,z,j,$){if(A.visible===!1)return;if(A.layers.test(z.layers)){if(A.isGroup)j=A.renderOrder;else if(A.isLOD)A.autoUpdate===!0&&A.update(z);else if(A.isLight)b.pushLight(A),A.castShadow&&b.pushShadow(A);else if(A.isSprite){let Pt=z.isArrayCamera?Ge:ne;if(!A.frustumCulled||A.intersectsFrustum(Pt)){$&&xe.setFromMatrixPosition(A.matrixWorld).applyMatrix4(Re);let Et=ht.update(A),It=A.material;It.visible&&C.push(A,Et,It,j,xe.z,null,z)}}else if(A.isMesh||A.isLine||A.isPoints){let Pt=z.isArrayCamera?Ge:ne;if(!A.frustumCulled||A.intersectsFrustum(Pt)){let Et=ht.update(A),It=A.material;if($&&(A.boundingSphere!==void 0?(A.boundingSphere===null&&A.computeBoundingSphere(),xe.copy(A.boundingSphere.center)):(Et.boundingSphere===null&&Et.computeBoundingSphere(),xe.copy(Et.boundingSphere.center)),xe.applyMatrix4(A.matrixWorld).applyMatrix4(Re)),Array.isArray(It)){let kt=Et.groups;for(let jt=0,ue=kt.length;jt<ue;jt++){let Bt=kt[jt],fe=It[Bt.materialIndex];fe&&fe.visible&&C.push(A,Et,fe,j,xe.z,Bt,z)}}else It.visible&&C.push(A,Et,It,j,xe.z,null,z)}}}let At=A.children;for(let Pt=0,Et=At.length;Pt<Et;Pt++)$i(At[Pt],z,j,$)}function Mo(A,z,j,$){let{opaque:Z,transmissive:At,transparent:Pt}=A;b.setupLightsView(j),Ue===!0&&st.setGlobalState(P.clippingPlanes,j),$&&wt.viewport(it.copy($)),Z.length>0&&$e(Z,z,j),At.length>0&&$e(At,z,j),Pt.length>0&&$e(Pt,z,j),wt.buffers.depth.setTest(!0),wt.buffers.depth.setMask(!0),wt.buffers.color.setMask(!0),wt.setPolygonOffset(!1)}function xi(A,z,j,$){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(b.state.transmissionRenderTarget[$.id]===void 0){let Bt=Yt.has("EXT_color_buffer_half_float")||Yt.has("EXT_color_buffer_float");b.state.transmissionRenderTarget[$.id]=new ri(1,1,{generateMipmaps:!0,type:Bt?Ai:Yn,minFilter:cs,samples:Math.max(4,re.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:ge.workingColorSpace})}let At=b.state.transmissionRenderTarget[$.id],Pt=$.viewport||it;At.setSize(Pt.z*P.transmissionResolutionScale,Pt.w*P.transmissionResolutionScale);let Et=P.getRenderTarget(),It=P.getActiveCubeFace(),kt=P.getActiveMipmapLevel();P.setRenderTarget(At),P.getClearColor(tt),ut=P.getClearAlpha(),ut<1&&P.setClearColor(16777215,.5),P.clear(),Ye&&O.render(j);let jt=P.toneMapping;P.toneMapping=Hi;let ue=$.viewport;if($.viewport!==void 0&&($.viewport=void 0),b.setupLightsView($),Ue===!0&&st.setGlobalState(P.clippingPlanes,$),$e(A,j,$),Xt.updateMultisampleRenderTarget(At),Xt.updateRenderTargetMipmap(At),Yt.has("WEBGL_multisampled_render_to_texture")===!1){let Bt=!1;for(let fe=0,qe=z.length;fe<qe;fe++){let Ae=z[fe],{object:Ee,geometry:fn,material:Ut,group:rn}=Ae;if(Ut.side===qn&&Ee.layers.test($.layers)){let me=Ut.side;Ut.side=Hn,Ut.needsUpdate=!0,Qe(Ee,j,$,fn,Ut,rn),Ut.side=me,Ut.needsUpdate=!0,Bt=!0}}Bt===!0&&(Xt.updateMultisampleRenderTarget(At),Xt.updateRenderTargetMipmap(At))}P.setRenderTarget(Et,It,kt),P.setClearColor(tt,ut),ue!==void 0&&($.viewport=ue),P.toneMapping=jt}function $e(A,z,j){let $=z.isScene===!0?z.overrideMaterial:null;for(let Z=0,At=A.length;Z<At;Z++){let Pt=A[Z],{object:Et,geometry:It,group:kt}=Pt,jt=Pt.material;jt.allowOverride===!0&&$!==null&&(jt=$),Et.layers.test(j.layers)&&Qe(Et,z,j,It,jt,kt)}}function Qe(A,z,j,$,Z,At){F!==null&&Z.isNodeMaterial&&F.setObject(A,Z),A.onBeforeRender(P,z,j,$,Z,At),A.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,A.matrixWorld),A.normalMatrix.getNormalMatrix(A.modelViewMatrix),Z.onBeforeRender(P,z,j,$,A,At),Z.transparent===!0&&Z.side===qn&&Z.forceSinglePass===!1?(Z.side=Hn,Z.needsUpdate=!0,P.renderBufferDirect(j,z,$,Z,A,At),Z.side=Ds,Z.needsUpdate=!0,P.renderBufferDirect(j,z,$,Z,A,At),Z.side=qn):P.renderBufferDirect(j,z,$,Z,A,At),A.onAfterRender(P,z,j,$,Z,At)}function tn(A){let z=0;for(let j of A)j.texture!==null&&z++;return z}function Li(A,z,j){z.isScene!==!0&&(z=un);let $=zt.get(A),Z=b.state.lights,At=b.state.shadowsArray,Pt=Z.state.version,Et=ot.getParameters(A,Z.state,At,z,j,b.state.lightProbeGridArray),It=ot.getProgramCacheKey(Et),kt=$.programs;$.environment=A.isMeshStandardMaterial||A.isMeshLambertMaterial||A.isMeshPhongMaterial?z.environment:null,$.fog=z.fog;let jt=A.isMeshStandardMaterial||A.isMeshLambertMaterial&&!A.envMap||A.isMeshPhongMaterial&&!A.envMap;$.envMap=I.get(A.envMap||$.environment,jt),$.envMapRotation=$.environment!==null&&A.envMap===null?z.environmentRotation:A.envMapRotation,kt===void 0&&(A.addEventListener("dispose",oe),kt=new Map,$.programs=kt,$.programVariants=new Map);let ue=kt.get(It);if(ue!==void 0){if($.currentProgram===ue&&$.lightsStateVersion===Pt)return bo(A,Et),ue}else Et.uniforms=ot.getUniforms(A),F!==null&&A.isNodeMaterial&&F.build(A,j,Et),A.onBeforeCompile(Et,P),ue=ot.acquireProgram(Et,It),kt.set(It,ue),$.uniforms=Et.uniforms;let Bt=$.uniforms;return(!A.isShaderMaterial&&!A.isRawShaderMaterial||A.clipping===!0)&&(Bt.clippingPlanes=st.uniform),bo(A,Et),$.needsLights=gs(A),$.lightsStateVersion=Pt,$.needsLights&&(Bt.ambientLightColor.value=Z.state.ambient,Bt.lightProbe.value=Z.state.probe,Bt.sunLights.value=Z.state.sun,Bt.sunLightShadows.value=Z.state.sunShadow,Bt.directionalLights.value=Z.state.directional,Bt.directionalLightShadows.value=Z.state.directionalShadow,Bt.spotLights.value=Z.state.spot,Bt.spotLightShadows.value=Z.state.spotShadow,Bt.rectAreaLights.value=Z.state.rectArea,Bt.ltc_1.value=Z.state.rectAreaLTC1,Bt.ltc_2.value=Z.state.rectAreaLTC2,Bt.pointLights.value=Z.state.point,Bt.pointLightShadows.value=Z.state.pointShadow,Bt.hemisphereLights.value=Z.state.hemi,Bt.sunShadowMatrix.value=Z.state.sunShadowMatrix,Bt.sunShadowCascade.value=Z.state.sunShadowCascade,Bt.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,Bt.spotLightMatrix.value=Z.state.spotLightMatrix,Bt.spotLightMap.value=Z.state.spotLightMap,Bt.pointShadowMatrix.value=Z.state.pointShadowMatrix),$.numLightProbeGrids=tn(b.state.lightProbeGridArray),$.currentProgram=ue,$.uniformsList=null,ue}function Zn(A,z,j,$,Z){let At=zt.get(A),Pt=At.currentProgram.id+","+$+","+Z,Et=At.programVariants.get(Pt);return Et===void 0?(Et=Li(A,z,j),At.programVariants.set(Pt,Et)):(At.currentProgram=Et,At.uniformsList=null,At.outputColorSpace=$,At.toneMapping=Z),Et}function ms(A){if(A.uniformsList===null){let z=A.currentProgram.getUniforms();A.uniformsList=io.seqWithValue(z.seq,A.uniforms)}return A.uniformsList}function bo(A,z){let j=zt.get(A);j.outputColorSpace=z.outputColorSpace,j.batching=z.batching,j.batchingColor=z.batchingColor,j.instancing=z.instancing,j.instancingColor=z.instancingColor,j.instancingMorph=z.instancingMorph,j.skinning=z.skinning,j.morphTargets=z.morphTargets,j.morphNormals=z.morphNormals,j.morphColors=z.morphColors,j.morphTargetsCount=z.morphTargetsCount,j.numClippingPlanes=z.numClippingPlanes,j.numIntersection=z.numClipIntersection,j.vertexAlphas=z.vertexAlphas,j.vertexTangents=z.vertexTangents,j.toneMapping=z.toneMapping}function wo(A,z,j,$,Z){z.isScene!==!0&&(z=un),Xt.resetTextureUnits();let At=z.fog,Pt=$.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial?z.environment:null,Et=lt===null?P.outputColorSpace:lt.isXRRenderTarget===!0?lt.texture.colorSpace:ge.workingColorSpace,It=$.isMeshStandardMaterial||$.isMeshLambertMaterial&&!$.envMap||$.isMeshPhongMaterial&&!$.envMap,kt=I.get($.envMap||Pt,It),jt=$.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,ue=!!j.attributes.tangent&&(!!$.normalMap||$.anisotropy>0),Bt=!!j.morphAttributes.position,fe=!!j.morphAttributes.normal,qe=!!j.morphAttributes.color,Ae=Hi;$.toneMapped&&(lt===null||lt.isXRRenderTarget===!0)&&(Ae=P.toneMapping);let Ee=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,fn=Ee!==void 0?Ee.length:0,Ut=zt.get($),rn=b.state.lights;if(Ue===!0&&(nn===!0||A!==Q)){let Ce=A===Q&&$.id===K;st.setState($,A,Ce)}let me=!1,Zi=!1;$.version===Ut.__version?Ut.needsLights&&Ut.lightsStateVersion!==rn.state.version||Z.isBatchedMesh&&Ut.batching===!1||!Z.isBatchedMesh&&Ut.batching===!0||Z.isBatchedMesh&&Ut.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Ut.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Ut.instancing===!1||!Z.isInstancedMesh&&Ut.instancing===!0||Z.isSkinnedMesh&&Ut.skinning===!1||!Z.isSkinnedMesh&&Ut.skinning===!0||Z.isInstancedMesh&&Ut.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&Ut.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Ut.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Ut.instancingMorph===!1&&Z.morphTexture!==null||Ut.envMap!==kt||$.fog===!0&&Ut.fog!==At||Ut.numClippingPlanes!==void 0&&(Ut.numClippingPlanes!==st.numPlanes||Ut.numIntersection!==st.numIntersection)||Ut.vertexAlphas!==jt||Ut.vertexTangents!==ue||Ut.morphTargets!==Bt||Ut.morphNormals!==fe||Ut.morphColors!==qe||Ut.morphTargetsCount!==fn||Ut.numLightProbeGrids!==tn(b.state.lightProbeGridArray)?me=!0:(Ut.outputColorSpace!==Et||Ut.toneMapping!==Ae)&&(Zi=!0):(me=!0,Ut.__version=$.version);let on=Ut.currentProgram;(me===!0||Zi===!0)&&(on=Zi===!0?Zn($,z,Z,Et,Ae):Li($,z,Z),F&&$.isNodeMaterial&&F.onUpdateProgram($,on,Ut));let xr=!1,Di=!1,Ki=!1,le=on.getUniforms(),Ze=Ut.uniforms;if(wt.useProgram(on.program)&&(xr=!0,Di=!0,Ki=!0),$.id!==K&&(K=$.id,Di=!0),xr||Q!==A){wt.buffers.depth.getReversed()&&A.reversedDepth!==!0&&(A._reversedDepth=!0,A.updateProjectionMatrix()),le.setValue(B,"projectionMatrix",A.projectionMatrix),le.setValue(B,"viewMatrix",A.matrixWorldInverse);let an=le.map.cameraPosition;an!==void 0&&an.setValue(B,xn.setFromMatrixPosition(A.matrixWorld)),re.logarithmicDepthBuffer&&le.setValue(B,"logDepthBufFC",2/(Math.log(A.far+1)/Math.LN2)),($.isMeshPhongMaterial||$.isMeshToonMaterial||$.isMeshLambertMaterial||$.isMeshBasicMaterial||$.isMeshStandardMaterial||$.isShaderMaterial)&&le.setValue(B,"isOrthographic",A.isOrthographicCamera===!0),Q!==A&&(Q=A,Di=!0,Ki=!0)}if(Ut.needsLights&&(rn.state.sunShadowMap.length>0&&le.setValue(B,"sunShadowMap",rn.state.sunShadowMap,Xt),rn.state.directionalShadowMap.length>0&&le.setValue(B,"directionalShadowMap",rn.state.directionalShadowMap,Xt),rn.state.spotShadowMap.length>0&&le.setValue(B,"spotShadowMap",rn.state.spotShadowMap,Xt),rn.state.pointShadowMap.length>0&&le.setValue(B,"pointShadowMap",rn.state.pointShadowMap,Xt)),Z.isSkinnedMesh){le.setOptional(B,Z,"bindMatrix"),le.setOptional(B,Z,"bindMatrixInverse");let Ce=Z.skeleton;Ce&&(Ce.boneTexture===null&&Ce.computeBoneTexture(),le.setValue(B,"boneTexture",Ce.boneTexture,Xt))}Z.isBatchedMesh&&(le.setOptional(B,Z,"batchingTexture"),le.setValue(B,"batchingTexture",Z._matricesTexture,Xt),le.setOptional(B,Z,"batchingIdTexture"),le.setValue(B,"batchingIdTexture",Z._indirectTexture,Xt),le.setOptional(B,Z,"batchingColorTexture"),Z._colorsTexture!==null&&le.setValue(B,"batchingColorTexture",Z._colorsTexture,Xt));let Nn=j.morphAttributes;if((Nn.position!==void 0||Nn.normal!==void 0||Nn.color!==void 0)&&rt.update(Z,j,on),(Di||Ut.receiveShadow!==Z.receiveShadow)&&(Ut.receiveShadow=Z.receiveShadow,le.setValue(B,"receiveShadow",Z.receiveShadow)),($.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial)&&$.envMap===null&&z.environment!==null&&(Ze.envMapIntensity.value=z.environmentIntensity),Ze.dfgLUT!==void 0&&(Ze.dfgLUT.value=EM()),Di){if(le.setValue(B,"toneMappingExposure",P.toneMappingExposure),Ut.needsLights&&gr(Ze,Ki),At&&$.fog===!0&&xt.refreshFogUniforms(Ze,At),xt.refreshMaterialUniforms(Ze,$,bt,Mt,b.state.transmissionRenderTarget[A.id]),Ut.needsLights&&Ut.numLightProbeGrids>0){let Ce=S,an=0;for(let Rn of b.state.lightProbeGridArray)Rn.texture!==null&&(Ce.textures[an]=Rn.texture,Ce.min[an]=Rn.boundingBox.min,Ce.max[an]=Rn.boundingBox.max,Ce.resolution[an]=Rn.resolution,an++);for(let Rn in Ce)Ce[Rn].length=an;Ze.probesSH.value=Ce.textures,Ze.probesMin.value=Ce.min,Ze.probesMax.value=Ce.max,Ze.probesResolution.value=Ce.resolution}io.upload(B,ms(Ut),Ze,Xt)}if($.isShaderMaterial&&$.uniformsNeedUpdate===!0&&(io.upload(B,ms(Ut),Ze,Xt),$.uniformsNeedUpdate=!1),$.isSpriteMaterial&&le.setValue(B,"center",Z.center),le.setValue(B,"modelViewMatrix",Z.modelViewMatrix),le.setValue(B,"normalMatrix",Z.normalMatrix),le.setValue(B,"modelMatrix",Z.matrixWorld),$.uniformsGroups!==void 0){let Ce=$.uniformsGroups;for(let an=0,Rn=Ce.length;an<Rn;an++){let Na=Ce[an];Gt.update(Na,on),Gt.bind(Na,on)}}return on}function gr(A,z){A.ambientLightColor.needsUpdate=z,A.lightProbe.needsUpdate=z,A.sunLights.needsUpdate=z,A.sunLightShadows.needsUpdate=z,A.directionalLights.needsUpdate=z,A.directionalLightShadows.needsUpdate=z,A.pointLights.needsUpdate=z,A.pointLightShadows.needsUpdate=z,A.spotLights.needsUpdate=z,A.spotLightShadows.needsUpdate=z,A.rectAreaLights.needsUpdate=z,A.hemisphereLights.needsUpdate=z}function gs(A){return A.isMeshLambertMaterial||A.isMeshToonMaterial||A.isMeshPhongMaterial||A.isMeshStandardMaterial||A.isShadowMaterial||A.isShaderMaterial&&A.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return lt},this.setRenderTargetTextures=function(A,z,j){let $=zt.get(A);$.__autoAllocateDepthBuffer=A.resolveDepthBuffer===!1,$.__autoAllocateDepthBuffer===!1&&($.__useRenderToTexture=!1),zt.get(A.texture).__webglTexture=z,zt.get(A.depthTexture).__webglTexture=$.__autoAllocateDepthBuffer?void 0:j,$.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(A,z){let j=zt.get(A);j.__webglFramebuffer=z,j.__useDefaultFramebuffer=z===void 0},this.setRenderTarget=function(A,z=0,j=0){lt=A,Y=z,G=j;let $=null,Z=!1,At=!1;if(A){let Et=zt.get(A);if(Et.__useDefaultFramebuffer!==void 0){wt.bindFramebuffer(B.FRAMEBUFFER,Et.__webglFramebuffer),it.copy(A.viewport),dt.copy(A.scissor),ft=A.scissorTest,wt.viewport(it),wt.scissor(dt),wt.setScissorTest(ft),K=-1;return}else if(Et.__webglFramebuffer===void 0)Xt.setupRenderTarget(A);else if(Et.__hasExternalTextures)Xt.rebindTextures(A,zt.get(A.texture).__webglTexture,zt.get(A.depthTexture).__webglTexture);else if(A.depthBuffer){let jt=A.depthTexture;if(Et.__boundDepthTexture!==jt){if(jt!==null&&zt.has(jt)&&(A.width!==jt.image.width||A.height!==jt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Xt.setupDepthRenderbuffer(A)}}let It=A.texture;(It.isData3DTexture||It.isDataArrayTexture||It.isCompressedArrayTexture)&&(At=!0);let kt=zt.get(A).__webglFramebuffer;A.isWebGLCubeRenderTarget?(Array.isArray(kt[z])?$=kt[z][j]:$=kt[z],Z=!0):A.samples>0&&Xt.useMultisampledRTT(A)===!1?$=zt.get(A).__webglMultisampledFramebuffer:Array.isArray(kt)?$=kt[j]:$=kt,it.copy(A.viewport),dt.copy(A.scissor),ft=A.scissorTest}else it.copy(Vt).multiplyScalar(bt).floor(),dt.copy(he).multiplyScalar(bt).floor(),ft=ae;if(j!==0&&($=k),wt.bindFramebuffer(B.FRAMEBUFFER,$)&&wt.drawBuffers(A,$),wt.viewport(it),wt.scissor(dt),wt.setScissorTest(ft),Z){let Et=zt.get(A.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+z,Et.__webglTexture,j)}else if(At){let Et=z;for(let It=0;It<A.textures.length;It++){let kt=zt.get(A.textures[It]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+It,kt.__webglTexture,j,Et)}}else if(A!==null&&j!==0){let Et=zt.get(A.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,Et.__webglTexture,j)}K=-1};function _r(A){let z=zt.get(A);return(z.__readFormat!==A.format||z.__readType!==A.type)&&(z.__readFormat=A.format,z.__readType=A.type,z.__formatReadable=re.textureFormatReadable(A.format),z.__typeReadable=re.textureTypeReadable(A.type)),z}this.readRenderTargetPixels=function(A,z,j,$,Z,At,Pt,Et=0){if(!(A&&A.isWebGLRenderTarget)){Qt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let It=zt.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Pt!==void 0&&(It=It[Pt],Array.isArray(It)&&(It=It[0])),It){wt.bindFramebuffer(B.FRAMEBUFFER,It);try{let kt=A.textures[Et],jt=kt.format,ue=kt.type;A.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Et);let Bt=_r(kt);if(Bt.__formatReadable===!1){Qt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Bt.__typeReadable===!1){Qt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}z>=0&&z<=A.width-$&&j>=0&&j<=A.height-Z&&B.readPixels(z,j,$,Z,_t.convert(jt),_t.convert(ue),At)}finally{let kt=lt!==null?zt.get(lt).__webglFramebuffer:null;wt.bindFramebuffer(B.FRAMEBUFFER,kt)}}},this.readRenderTargetPixelsAsync=async function(A,z,j,$,Z,At,Pt,Et=0){if(!(A&&A.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let It=zt.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Pt!==void 0&&(It=It[Pt],Array.isArray(It)&&(It=It[0])),It)if(z>=0&&z<=A.width-$&&j>=0&&j<=A.height-Z){wt.bindFramebuffer(B.FRAMEBUFFER,It);let kt=A.textures[Et],jt=kt.format,ue=kt.type;A.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Et);let Bt=_r(kt);if(Bt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Bt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let fe=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,fe),B.bufferData(B.PIXEL_PACK_BUFFER,At.byteLength,B.STREAM_READ),B.readPixels(z,j,$,Z,_t.convert(jt),_t.convert(ue),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let qe=lt!==null?zt.get(lt).__webglFramebuffer:null;wt.bindFramebuffer(B.FRAMEBUFFER,qe);let Ae=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await _p(B,Ae,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,fe),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,At),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(fe),B.deleteSync(Ae),At}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(A,z=null,j=0){let $=Math.pow(2,-j),Z=Math.floor(A.image.width*$),At=Math.floor(A.image.height*$),Pt=z!==null?z.x:0,Et=z!==null?z.y:0;Xt.setTexture2D(A,0),B.copyTexSubImage2D(B.TEXTURE_2D,j,0,0,Pt,Et,Z,At),wt.unbindTexture()},this.copyTextureToTexture=function(A,z,j=null,$=null,Z=0,At=0){let Pt,Et,It,kt,jt,ue,Bt,fe,qe,Ae=A.isCompressedTexture?A.mipmaps[At]:A.image;if(j!==null)Pt=j.max.x-j.min.x,Et=j.max.y-j.min.y,It=j.isBox3?j.max.z-j.min.z:1,kt=j.min.x,jt=j.min.y,ue=j.isBox3?j.min.z:0;else{let le=Math.pow(2,-Z);Pt=Math.floor(Ae.width*le),Et=Math.floor(Ae.height*le),A.isDataArrayTexture?It=Ae.depth:A.isData3DTexture?It=Math.floor(Ae.depth*le):It=1,kt=0,jt=0,ue=0}$!==null?(Bt=$.x,fe=$.y,qe=$.z):(Bt=0,fe=0,qe=0);let Ee=_t.convert(z.format),fn=_t.convert(z.type),Ut;z.isData3DTexture?(Xt.setTexture3D(z,0),Ut=B.TEXTURE_3D):z.isDataArrayTexture||z.isCompressedArrayTexture?(Xt.setTexture2DArray(z,0),Ut=B.TEXTURE_2D_ARRAY):(Xt.setTexture2D(z,0),Ut=B.TEXTURE_2D),wt.activeTexture(B.TEXTURE0),wt.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,z.flipY),wt.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,z.premultiplyAlpha),wt.pixelStorei(B.UNPACK_ALIGNMENT,z.unpackAlignment);let rn=wt.getParameter(B.UNPACK_ROW_LENGTH),me=wt.getParameter(B.UNPACK_IMAGE_HEIGHT),Zi=wt.getParameter(B.UNPACK_SKIP_PIXELS),on=wt.getParameter(B.UNPACK_SKIP_ROWS),xr=wt.getParameter(B.UNPACK_SKIP_IMAGES);wt.pixelStorei(B.UNPACK_ROW_LENGTH,Ae.width),wt.pixelStorei(B.UNPACK_IMAGE_HEIGHT,Ae.height),wt.pixelStorei(B.UNPACK_SKIP_PIXELS,kt),wt.pixelStorei(B.UNPACK_SKIP_ROWS,jt),wt.pixelStorei(B.UNPACK_SKIP_IMAGES,ue);let Di=A.isDataArrayTexture||A.isData3DTexture,Ki=z.isDataArrayTexture||z.isData3DTexture;if(A.isDepthTexture){let le=zt.get(A),Ze=zt.get(z),Nn=zt.get(le.__renderTarget),Ce=zt.get(Ze.__renderTarget);wt.bindFramebuffer(B.READ_FRAMEBUFFER,Nn.__webglFramebuffer),wt.bindFramebuffer(B.DRAW_FRAMEBUFFER,Ce.__webglFramebuffer);for(let an=0;an<It;an++)Di&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,zt.get(A).__webglTexture,Z,ue+an),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,zt.get(z).__webglTexture,At,qe+an)),B.blitFramebuffer(kt,jt,kt+Pt,jt+Et,Bt,fe,Bt+Pt,fe+Et,B.DEPTH_BUFFER_BIT,B.NEAREST);wt.bindFramebuffer(B.READ_FRAMEBUFFER,null),wt.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if(Z!==0||A.isRenderTargetTexture||zt.has(A)){let le=zt.get(A),Ze=zt.get(z);wt.bindFramebuffer(B.READ_FRAMEBUFFER,N),wt.bindFramebuffer(B.DRAW_FRAMEBUFFER,V);for(let Nn=0;Nn<It;Nn++)Di?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,le.__webglTexture,Z,ue+Nn):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,le.__webglTexture,Z),Ki?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Ze.__webglTexture,At,qe+Nn):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,Ze.__webglTexture,At),Z!==0?B.blitFramebuffer(kt,jt,kt+Pt,jt+Et,Bt,fe,Bt+Pt,fe+Et,B.COLOR_BUFFER_BIT,B.NEAREST):Ki?B.copyTexSubImage3D(Ut,At,Bt,fe,qe+Nn,kt,jt,Pt,Et):B.copyTexSubImage2D(Ut,At,Bt,fe,kt,jt,Pt,Et);wt.bindFramebuffer(B.READ_FRAMEBUFFER,null),wt.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else Ki?A.isDataTexture||A.isData3DTexture?B.texSubImage3D(Ut,At,Bt,fe,qe,Pt,Et,It,Ee,fn,Ae.data):z.isCompressedArrayTexture?B.compressedTexSubImage3D(Ut,At,Bt,fe,qe,Pt,Et,It,Ee,Ae.data):B.texSubImage3D(Ut,At,Bt,fe,qe,Pt,Et,It,Ee,fn,Ae):A.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,At,Bt,fe,Pt,Et,Ee,fn,Ae.data):A.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,At,Bt,fe,Ae.width,Ae.height,Ee,Ae.data):B.texSubImage2D(B.TEXTURE_2D,At,Bt,fe,Pt,Et,Ee,fn,Ae);wt.pixelStorei(B.UNPACK_ROW_LENGTH,rn),wt.pixelStorei(B.UNPACK_IMAGE_HEIGHT,me),wt.pixelStorei(B.UNPACK_SKIP_PIXELS,Zi),wt.pixelStorei(B.UNPACK_SKIP_ROWS,on),wt.pixelStorei(B.UNPACK_SKIP_IMAGES,xr),At===0&&z.generateMipmaps===!0&&z.mipmapsAutoUpdate===!0&&B.generateMipmap(Ut),wt.unbindTexture()},this.initRenderTarget=function(A){zt.get(A).__webglFramebuffer===void 0&&Xt.setupRenderTarget(A)},this.initTexture=function(A){A.isCubeTexture?Xt.setTextureCube(A,0):A.isData3DTexture?Xt.setTexture3D(A,0):A.isDataArrayTexture||A.isCompressedArrayTexture?Xt.setTexture2DArray(A,0):Xt.setTexture2D(A,0),wt.unbindTexture()},this.resetState=function(){Y=0,G=0,lt=null,wt.reset(),St.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return pi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=ge._getDrawingBufferColorSpace(t),e.unpackColorSpace=ge._getUnpackColorSpace()}};function rr(n){let t=new Qs;return n===0||(t.onBeforeCompile=e=>{e.vertexShader=e.vertexShader.replace("#include <project_vertex>",`#include <project_vertex>
      vec4 pulled = vec4(mvPosition.xyz - normalize(mvPosition.xyz) * ${n.toExponential()}, 1.0);
      vec4 there = projectionMatrix * pulled;
      gl_Position.z = there.z / there.w * gl_Position.w;`)},t.customProgramCacheKey=()=>`nearer ${n}`),t}function ro(n,t,e,i,s,r){let o=n[e]-n[t],a=n[e+1]-n[t+1],l=n[e+2]-n[t+2],c=Math.hypot(o,a,l)||1e-12;o/=c,a/=c,l/=c;let u=Math.abs(l)<.9,[h,f,d]=u?[a,-o,0]:[0,l,-a],g=Math.hypot(h,f,d);h/=g,f/=g,d/=g,s[r]=i*h,s[r+1]=i*f,s[r+2]=i*d,s[r+4]=c*o,s[r+5]=c*a,s[r+6]=c*l,s[r+8]=i*(f*l-d*a),s[r+9]=i*(d*o-h*l),s[r+10]=i*(h*a-f*o);for(let y=0;y<3;y++)s[r+12+y]=(n[t+y]+n[e+y])/2;s[r+15]=1}var Nc="#d55e00",Uc="#0072b2",im=["#e2cf9f","#c5bcd9","#b7cfa2","#d6aeb9","#9cc4dd","#cfcfcf"];function Ma(n){return im[n%im.length]}var CM=["#453781","#39568c","#2d708e","#20908d","#29af7f","#73d055","#b8de29","#fde725"],RM=["#00224e","#083370","#35456c","#4f576c","#666970","#7d7c78","#948e77","#aea371","#c8b866","#e5cf52","#fee838"],PM=["#ffffcc","#ffeda0","#fed976","#feb24c","#fd8c3c","#fc4d2a","#e2191c","#bb0026","#800026"];function ku(n){let t=n.map(i=>[1,3,5].map(s=>parseInt(i.slice(s,s+2),16)/255));function e(i,s=[0,0,0]){let r=Math.min(1,Math.max(0,i))*(n.length-1),o=Math.min(n.length-2,Math.floor(r));for(let a=0;a<3;a++){let l=t[o][a];s[a]=l+(r-o)*(t[o+1][a]-l)}return s}return{at:e,gradient:`linear-gradient(to right, ${n.join(", ")})`}}var oo=ku(CM),rm=ku(RM),Fc=ku(PM);function Xe(n){return getComputedStyle(document.documentElement).getPropertyValue(n).trim()}function Us(n){let t=matchMedia("(prefers-color-scheme: dark)");return t.addEventListener("change",n),()=>t.removeEventListener("change",n)}var sm=[[],[8,4],[8,3,2,3],[2,3]],IM=7;function fs(n){return{colour:Xe(`--line-${n%IM}`),dash:sm[n%sm.length]}}var LM=32767,Fs=24,DM=5/3*Math.PI,NM=.22,zu=.11,om=.7,am=3,lm=1e-6;function cm(n){let t=n.turns.map(l=>({...l,pivot:Tn(l.pivot,Float32Array),axis:Float32Array.from(Tn(l.axis,Int16Array),c=>c/LM),left:l.left&&Tn(l.left,Float32Array)})),e=n.pushes.map(l=>({...l,force:l.force&&Tn(l.force,Float32Array)})),{drives:i,stages:s}=n;function r(l){let c=s.find(({start:u,end:h})=>l>u&&l<=h);return i.map(({strength:u,rise:h},f)=>c?.drives.includes(f)?u*(h>0?Math.min(1,(l-c.start)/h):1):0)}let o=(l,c)=>l.reduce((u,h,f)=>u+h*c[f],0),a=l=>l.reduce((c,{shares:u})=>{let h=s.map(f=>Math.abs(o(u,i.map(({strength:d},g)=>f.drives.includes(g)?d:0))));return Math.max(c,...h)},0);return{...n,time:Tn(n.time,Float64Array),turns:t,pushes:e,strengthsAt:r,summed:o,largestTurn:a(t),largestPush:a(e)}}function hm({drives:n,strengthsAt:t},e,i){let s=t(e);return n.flatMap(({text:r,unit:o,factor:a},l)=>s[l]?[`${r}: ${i(a*s[l])} ${o}`]:[])}function um(n){let{time:t,turns:e,pushes:i,strengthsAt:s,summed:r,largestTurn:o,largestPush:a}=n.efforts,l=Math.max(0,...e.map(L=>L.radius)),c=.05*n.mesh.span_m,u=rr(Math.max(l,c)),h=new oi(new Vi(1,1,1,10),u,e.length*Fs+i.length),f=new oi(new ta(1,1,16),u,e.length+i.length),d=new ii;for(let L of[h,f])L.frustumCulled=!1,d.add(L);let g=new Float32Array(3*(Fs+2)),[y,m]=[0,0],p=(L,P,R,F,k)=>ro(g,3*P,3*R,F,L.instanceMatrix.array,16*k);function _(L,P){for(let R=0;R<3;R++)g[3*L+R]=P[R]}function E(L,P,R,F){let[k,N]=Os(t,R),Y=(L.left?Vu(L.left,1,k,N)[0]:1)*r(L.shares,F)/o;if(!(Math.abs(Y)>lm))return;let[G,lt]=L.ends?UM(P,L.ends):[L.pivot,L.axis].map(ut=>Vu(ut,3,k,N)),K=OM(lt,L),Q=FM(lt,K),it=DM*Math.min(1.2,Math.abs(Y))*Math.sign(Y),dt=ut=>G.map((gt,Mt)=>gt+L.radius*(Math.cos(ut)*K[Mt]+Math.sin(ut)*Q[Mt]));for(let ut=0;ut<=Fs;ut++)_(ut,dt(it*(ut/Fs-.5)));let ft=it/2;_(Fs+1,dt(ft+Math.sign(Y)*om));let tt=zu*L.radius;for(let ut=0;ut<Fs;ut++)p(h,ut,ut+1,tt,y++);p(f,Fs,Fs+1,am*tt,m++)}function S(L,P,R,F){let[k,N]=Os(t,R),V=L.force?Vu(L.force,1,k,N)[0]:r(L.shares,F)/a;if(!(Math.abs(V)>lm))return;let Y=NM*n.mesh.span_m*V,G=P.subarray(3*L.point,3*L.point+3),lt=K=>L.direction.map((Q,it)=>G[it]+K*Q);_(0,G),_(1,lt(Y)),_(2,lt(Y+Math.sign(V)*om*c)),p(h,0,1,zu*c,y++),p(f,1,2,am*zu*c,m++)}function C(L){[y,m]=[0,0];let P=s(L),R=n.pointsAt(L);for(let F of e)E(F,R,L,P);for(let F of i)S(F,R,L,P);[h.count,f.count]=[y,m];for(let F of[h,f])F.instanceMatrix.needsUpdate=!0}let b=()=>u.color.set(new ee(Xe("--effort")));function x(){for(let L of[h,f])L.dispose(),L.geometry.dispose();u.dispose()}return{group:d,pose:C,paint:b,count:()=>m,dispose:x}}function Vu(n,t,e,i){if(n.length===t)return Array.from(n);let s=Math.min(e+1,n.length/t-1);return Array.from({length:t},(r,o)=>{let a=n[e*t+o];return a+i*(n[s*t+o]-a)})}function UM(n,[t,e]){let[i,s]=[t,e].map(a=>Array.from(n.subarray(3*a,3*a+3))),r=i.map((a,l)=>s[l]-a),o=Math.hypot(...r)||1;return[i.map((a,l)=>(a+s[l])/2),r.map(a=>a/o)]}function FM(n,t){return[0,1,2].map(e=>n[(e+1)%3]*t[(e+2)%3]-n[(e+2)%3]*t[(e+1)%3])}function OM(n,t){t.side??=n.map(Math.abs).reduce((r,o,a,l)=>o<l[r]-.001?a:r,2);let e=n[t.side],i=n.map((r,o)=>(o===t.side?1:0)-e*r),s=Math.hypot(...i)||1;return i.map(r=>r/s)}var or="tendon energy";function Tn(n,t){let e=atob(n),i=new Uint8Array(e.length);for(let s=0;s<e.length;s++)i[s]=e.charCodeAt(s);return new t(i.buffer)}function Bs(n){let t=Tn(n.time,Float64Array),e=Tn(n.points,Float32Array),i=3*n.pointCount,s={[or]:{width:n.tendonParts.length,values:Tn(n.tendonEnergy_J,Float32Array)}};for(let m of n.readings)s[m.name]={width:m.parts.length,values:Tn(m.values,Float32Array)};let r=Int32Array.from(n.between),o=Float64Array.from(n.share),a=new Float32Array(i);function l(m,p=a){return Gu(t,e,i,m,p),p}function c(m,p=new Float32Array(3*o.length)){return u(l(m),p)}function u(m,p){for(let _=0;_<o.length;_++){let E=3*r[2*_],S=3*r[2*_+1];for(let C=0;C<3;C++){let b=m[E+C];p[3*_+C]=b+o[_]*(m[S+C]-b)}}return p}function h(m,p,_=new Float32Array(s[m].width)){return Gu(t,s[m].values,s[m].width,p,_),_}function f(m,p){let{width:_,values:E}=s[m];return Float32Array.from(t,(S,C)=>E[C*_+p])}let d=Tn(n.restLength_m,Float32Array);function g(m,p){d.length===p.length?p.set(d):Gu(t,d,p.length,m,p)}let y=n.efforts&&cm(n.efforts);return{name:n.name,reach:Math.max(n.base.radius,y?.pushes.length?.12*n.span_m:0,...(y?.turns??[]).map(m=>.4*m.radius)),mesh:n,marks:n.marks,stages:n.stages,tendons:n.tendonParts.length,readings:n.readings,time:t,start:t[0],end:t[t.length-1],efforts:y,strained:n.built!==null,builtVertices:()=>u(Tn(n.built,Float32Array),new Float32Array(3*o.length)),restLengthsAt:g,pointsAt:l,verticesAt:c,valuesAt:h,line:f,stageAt:m=>n.stages.findLast(p=>p.start<=m)??n.stages[0],markAt:m=>n.marks.find(p=>Math.abs(p.time-m)<1e-9)}}function Gu(n,t,e,i,s){let[r,o]=Os(n,i),a=r*e,l=Math.min(r+1,n.length-1)*e;for(let c=0;c<e;c++){let u=t[a+c];s[c]=o===0?u:u+o*(t[l+c]-u)}}function Os(n,t){if(!(t>n[0]))return[0,0];let e=n.length-1;if(t>=n[e])return[e,0];let i=0,s=e;for(;s-i>1;){let r=i+s>>1;n[r]<=t?i=r:s=r}return[i,(t-n[i])/(n[i+1]-n[i])]}var BM=.3,kM=4,zM=4,dm=[{name:"even motion",value:"even"},{name:"real time",value:1},{name:"1/2",value:1/2},{name:"1/5",value:1/5},{name:"1/10",value:1/10},{name:"1/20",value:1/20},{name:"1/50",value:1/50},{name:"1/100",value:1/100}];function pm(n,t){let e=VM(n,t),i=new Float64Array(e.length);for(let[l,c]of n.entries())GM(c,t.origins[l],e,i);for(let l=1;l<i.length;l++)i[l]+=i[l-1];let s=i[i.length-1],r=s>0?BM:1;for(let l=0;l<i.length;l++){let c=(e[l]-e[0])/(e[e.length-1]-e[0]||1);i[l]=r*c+(1-r)*(i[l]/(s||1))}let o=l=>l.drive!=="none"&&l.start-t.origins[0]<t.end&&l.end-t.origins[0]>t.start,a=n[0].stages.filter(o).length;return{seconds:kM+zM*a,wayAt:l=>fm(e,i,l),timeAt:l=>fm(i,e,l)}}function VM(n,t){let e=new Set([t.start,t.end]);for(let[i,s]of n.entries())for(let r of s.time){let o=r-t.origins[i];o>t.start&&o<t.end&&e.add(o)}return Float64Array.from(e).sort()}function GM(n,t,e,i){let s=n.pointsAt(e[0]+t).slice(),r=s.slice();for(let o=1;o<e.length;o++){n.pointsAt(e[o]+t,r);let a=0;for(let l=0;l<r.length;l+=3){let c=Math.hypot(r[l]-s[l],r[l+1]-s[l+1],r[l+2]-s[l+2]);c>a&&(a=c)}i[o]=Math.max(i[o],a),[s,r]=[r,s]}}function fm(n,t,e){let[i,s]=Os(n,e);return s===0?t[i]:t[i]+s*(t[i+1]-t[i])}var HM=200;function ao(n,t){let e=new Set,i=t[0].start,s=t[0],r="even",o=!1,a=0,l=0,c=new Map;function u(){return c.has(s)||c.set(s,pm(n,s)),c.get(s)}let h=()=>r==="even"&&s.whole;function f(_){return h()?u().wayAt(_):(_-s.start)/(s.end-s.start||1)}function d(_){return h()?u().timeAt(_):s.start+_*(s.end-s.start)}function g(){l||(l=requestAnimationFrame(y))}function y(_){if(l=0,o){let E=Math.min((_-a)/1e3,.1);a=_,m(E),l=requestAnimationFrame(y)}for(let E of e)E()}function m(_){r==="even"?i=u().timeAt(Math.min(1,u().wayAt(i)+_/u().seconds)):i=Math.min(s.end,i+r*_),i>=s.end&&(o=!1)}function p(_){i=Math.min(s.end,Math.max(s.start,_)),g()}return{get time(){return i},get span(){return s},get speed(){return r},get playing(){return o},spans:t,clipTime:(_,E=i)=>Math.min(n[_].end,Math.max(n[_].start,E+s.origins[_])),get stretched(){return h()},shareAt:f,momentAt:d,wayAt:_=>u().wayAt(_),timeAt:_=>u().timeAt(_),get slowness(){if(r!=="even")return 1/r;let _=u().wayAt(i),[E,S]=[Math.max(0,_-5e-4),Math.min(1,_+5e-4)];return(S-E)*u().seconds/(u().timeAt(S)-u().timeAt(E)||1e-12)},onChange(_){return e.add(_),g(),()=>e.delete(_)},seek:p,seekClip(_,E){(E<s.start+s.origins[_]||E>s.end+s.origins[_])&&(s=t.find(S=>E>=S.start+S.origins[_]&&E<=S.end+S.origins[_])??t[0]),p(E-s.origins[_])},step:_=>p(d(f(i)+_/HM)),play(){i>=s.end&&(i=s.start),o=!0,a=performance.now(),g()},pause(){o=!1,g()},setSpeed(_){r=_,g()},setSpan(_){s=_,p(i<s.start||i>s.end?s.start:i)},redraw:g}}function ks(n,t){let e=n.toFixed(t);return(Number(e)===0?0 .toFixed(t):e).replace("-","−")}function Cn(n){let t=Number(n.toPrecision(4)),e=Math.abs(t);return(e!==0&&(e>=1e5||e<.001)?n.toExponential(2):String(t)).replaceAll("-","−")}function ba(n){let t=Math.max(Math.abs(n.start),Math.abs(n.end));return t>=.2?{unit:"s",factor:1}:t>=2e-4?{unit:"ms",factor:1e3}:{unit:"µs",factor:1e6}}function wa(n,t){let{unit:e,factor:i}=ba(t),s=Math.ceil(2.7-Math.log10(i*(t.end-t.start)));return`${ks(i*n,Math.min(6,Math.max(0,s)))} ${e}`}var mm={type:"change"},Wu={type:"start"},_m={type:"end"},Oc=new Js,gm=new ni,WM=Math.cos(70*wu.DEG2RAD),mn=new X,$n=2*Math.PI,Me={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Hu=1e-6,Bc=class extends la{constructor(t,e=null){super(t,e),this.state=Me.NONE,this.target=new X,this.cursor=new X,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Is.ROTATE,MIDDLE:Is.DOLLY,RIGHT:Is.PAN},this.touches={ONE:Ls.ROTATE,TWO:Ls.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new X,this._lastQuaternion=new si,this._lastTargetPosition=new X,this._quat=new si().setFromUnitVectors(t.up,new X(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Jr,this._sphericalDelta=new Jr,this._scale=1,this._panOffset=new X,this._rotateStart=new Jt,this._rotateEnd=new Jt,this._rotateDelta=new Jt,this._panStart=new Jt,this._panEnd=new Jt,this._panDelta=new Jt,this._dollyStart=new Jt,this._dollyEnd=new Jt,this._dollyDelta=new Jt,this._dollyDirection=new X,this._mouse=new Jt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=qM.bind(this),this._onPointerDown=XM.bind(this),this._onPointerUp=YM.bind(this),this._onContextMenu=tb.bind(this),this._onMouseWheel=KM.bind(this),this._onKeyDown=JM.bind(this),this._onTouchStart=jM.bind(this),this._onTouchMove=QM.bind(this),this._onMouseDown=$M.bind(this),this._onMouseMove=ZM.bind(this),this._interceptControlDown=eb.bind(this),this._interceptControlUp=nb.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Me.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(mm),this.update(),this.state=Me.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;mn.copy(e).sub(this.target),mn.applyQuaternion(this._quat),this._spherical.setFromVector3(mn),this.autoRotate&&this.state===Me.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=$n:i>Math.PI&&(i-=$n),s<-Math.PI?s+=$n:s>Math.PI&&(s-=$n),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(mn.setFromSpherical(this._spherical),mn.applyQuaternion(this._quatInverse),e.copy(this.target).add(mn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=mn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new X(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new X(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=mn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Oc.origin.copy(this.object.position),Oc.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Oc.direction))<WM?this.object.lookAt(this.target):(gm.setFromNormalAndCoplanarPoint(this.object.up,this.target),Oc.intersectPlane(gm,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Hu||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Hu||this._lastTargetPosition.distanceToSquared(this.target)>Hu?(this.dispatchEvent(mm),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?$n/60*this.autoRotateSpeed*t:$n/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){mn.setFromMatrixColumn(e,0),mn.multiplyScalar(-t),this._panOffset.add(mn)}_panUp(t,e){this.screenSpacePanning===!0?mn.setFromMatrixColumn(e,1):(mn.setFromMatrixColumn(e,0),mn.crossVectors(this.object.up,mn)),mn.multiplyScalar(t),this._panOffset.add(mn)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;mn.copy(s).sub(this.target);let r=mn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft($n*this._rotateDelta.x/e.clientHeight),this._rotateUp($n*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp($n*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-$n*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft($n*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-$n*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft($n*this._rotateDelta.x/e.clientHeight),this._rotateUp($n*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Jt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function XM(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function qM(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function YM(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(_m),this.state=Me.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function $M(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Is.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Me.DOLLY;break;case Is.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Me.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Me.ROTATE}break;case Is.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Me.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Me.PAN}break;default:this.state=Me.NONE}this.state!==Me.NONE&&this.dispatchEvent(Wu)}function ZM(n){switch(this.state){case Me.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Me.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Me.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function KM(n){this.enabled===!1||this.enableZoom===!1||this.state!==Me.NONE||(n.preventDefault(),this.dispatchEvent(Wu),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(_m))}function JM(n){this.enabled!==!1&&this._handleKeyDown(n)}function jM(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case Ls.ROTATE:if(this.enableRotate===!1){this.state=Me.NONE;break}this._handleTouchStartRotate(n),this.state=Me.TOUCH_ROTATE;break;case Ls.PAN:if(this.enablePan===!1){this.state=Me.NONE;break}this._handleTouchStartPan(n),this.state=Me.TOUCH_PAN;break;default:this.state=Me.NONE}break;case 2:switch(this.touches.TWO){case Ls.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Me.TOUCH_DOLLY_PAN;break;case Ls.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Me.TOUCH_DOLLY_ROTATE;break;default:this.state=Me.NONE}break;default:this.state=Me.NONE}this.state!==Me.NONE&&this.dispatchEvent(Wu)}function QM(n){switch(this._trackPointer(n),this.state){case Me.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Me.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Me.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Me.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Me.NONE}}function tb(n){this.enabled!==!1&&n.preventDefault()}function eb(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function nb(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Xu=120,xm=2,ym=6;function qu(n,t,e){let i=new Map,s=t.reduce((l,c)=>n[c].mesh.tubes.reduce((u,h)=>Math.max(u,h.radius),Math.max(l,n[c].reach)),Math.max(...t.map(l=>n[l].mesh.joints.length?n[l].mesh.jointRadius:0))),r=null;function o(){let{span:l}=e;if(!i.has(l)){let c=Array.from({length:Xu+1},(u,h)=>e.timeAt(h/Xu));i.set(l,c.map(u=>t.map(h=>n[h].pointsAt(e.clipTime(h,u)).slice())))}return i.get(l)}function a(l,c){let u=[...l.flatMap(f=>f.toArray()),...c].join();if(r?.key===u&&r.span===e.span)return r;let h=o().map(f=>ib(f,l,c,s));return r={key:u,span:e.span,rows:sb(h),whole:vm(h)},r}return function(c,u,h,f){let d=new X().crossVectors(u,c).normalize(),g=[d,new X().crossVectors(c,d),c],{rows:y,whole:m}=a(g,h),p=f?rb(y,e.wayAt(e.time)*Xu):m,[_,E,S,C,b,x]=p,T=[(_-E)/2,(S-C)/2,(b-x)/2],L=Math.max((_+E)/(2*h[0]),(S+C)/(2*h[1])),P=new X;for(let[R,F]of g.entries())P.addScaledVector(F,T[R]);return{target:P,distance:L-T[2]||1}}}function ib(n,t,e,i){let s=new Float64Array(ym).fill(-1/0),r=e.map(h=>i*Math.hypot(1,h)),o=[r[0],r[0],r[1],r[1],0,0],[a,l,c]=t.map(h=>h.toArray()),u=(h,f,d)=>h[0]*f[d]+h[1]*f[d+1]+h[2]*f[d+2];for(let h of n)for(let f=0;f<h.length;f+=3){let[d,g,y]=[u(a,h,f),u(l,h,f),u(c,h,f)],[m,p]=[e[0]*y,e[1]*y],_=[d+m,m-d,g+p,p-g,y,-y];for(let E=0;E<ym;E++)_[E]>s[E]&&(s[E]=_[E])}return s.map((h,f)=>h+o[f])}function vm(n){return n.reduce((t,e)=>t.map((i,s)=>Math.max(i,e[s])))}function sb(n){let t=(i,s)=>i.slice(Math.max(0,s-xm),s+xm+1),e=n.map((i,s)=>vm(t(n,s)));return n.map((i,s)=>{let r=t(e,s);return r[0].map((o,a)=>r.reduce((l,c)=>l+c[a],0)/r.length)})}function rb(n,t){let e=Math.min(n.length-2,Math.max(0,Math.floor(t))),i=Math.min(1,Math.max(0,t-e));return n[e].map((s,r)=>s+i*(n[e+1][r]-s))}var Sm=28,ob=1.05,Mm=Math.PI/24,ab=1.15,kc=[{name:"3-D",text:"obliquely from above",towards:[.37,-.695,.616]},{name:"top",text:"from above",towards:[0,-5e-4,1]},{name:"side",text:"from the side, level with what lies flat",towards:[0,-1,1e-4]},{name:"along",text:"from the far end, along the middle",towards:[1,0,1e-4]}];function bm(n,t,e,i,s=Yu()){let{size:r,target:o}=lb(t),a=t.map((C,b)=>b),l=qu(t,a,e),c=a.map(C=>qu(t,[C],e)),u=new Bn(Sm,1,.02*r,60*r);u.up.set(0,0,1);let h=new Bc(u,n);h.minDistance=.1*r,h.maxDistance=20*r;let f=null;function d(C=0){let b=s.oneScale?l:c[C],x=Math.tan(Sm*Math.PI/360)/ob;f=b(s.towards,u.up,[x*u.aspect,x],s.following),s.oneScale&&(f.distance*=s.scale),h.target.copy(f.target).addScaledVector(s.aside,f.distance),u.position.copy(h.target).addScaledVector(s.towards,s.closer*f.distance),u.lookAt(h.target),u.updateMatrixWorld()}function g(){d(),i()}h.addEventListener("change",()=>{let C=u.position.clone().sub(h.target);s.closer=C.length()/f.distance,s.towards.copy(C).normalize(),s.aside.copy(h.target).sub(f.target).divideScalar(f.distance),g()});let y=C=>{document.activeElement!==n&&!C.ctrlKey&&C.stopImmediatePropagation()};n.parentElement.addEventListener("wheel",y,{capture:!0});function m({towards:C}){s.towards.set(...C).normalize(),s.closer=1,s.aside.set(0,0,0),g()}function p(C,b){let x=s.towards.clone().applyAxisAngle(u.up,C*Mm),T=new X().crossVectors(u.up,x).normalize(),L=x.clone().applyAxisAngle(T,-b*Mm);s.towards.copy(Math.abs(L.z)<.9999?L:x),g()}function _(C){let b=s.closer*f.distance*ab**-C;s.closer=Math.min(h.maxDistance,Math.max(h.minDistance,b))/f.distance,g()}function E(C){Object.assign(s,C),g()}function S(C,b){u.aspect=C,u.updateProjectionMatrix(),h.rotateSpeed=b,h.panSpeed=b,g()}return{camera:u,controls:h,look:s,size:r,target:o,aim:d,show:m,turn:p,zoom:_,choose:E,resize:S,dispose:()=>h.dispose()}}function Yu(){return{towards:new X(...kc[0].towards).normalize(),closer:1,aside:new X,following:!0,oneScale:!0,scale:1}}function lb(n){let t=new X(1/0,1/0,1/0),e=new X(-1/0,-1/0,-1/0),i=new X;for(let r of n){let o=Math.max(1,Math.floor(r.time.length/60));for(let a=0;a<r.time.length;a+=o){let l=r.pointsAt(r.time[a]);for(let c=0;c<l.length;c+=3)i.fromArray(l,c),t.min(i),e.max(i)}}let s=t.clone().add(e).multiplyScalar(.5);return{target:s,size:e.distanceTo(s)||1}}var cb=[["space","play or pause"],["← →","a little back or on"],["page down, page up","further back or on"],["home, end","start, end"]],hb="shift with ← → ↑ ↓",ub=[["+ −","nearer, further"],["0","the first view again"]];function wm(n,t,e){let s=(n.length===1?n[0].marks:[]).map((o,a)=>[String(a+1),o.name]),r=[...cb,...s,...t?[[hb,`turn the ${e}`],...ub]:[]].map(([o,a])=>W("tr",{},W("th",{scope:"row"},o),W("td",{},a)));return W("details",{className:"keys"},W("summary",{},"Keys"),W("table",{},W("tbody",{},...r)))}function Tm(n,t,e,i,s){let r={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]},o={ArrowLeft:-1,ArrowRight:1,PageUp:10,PageDown:-10};function a(u){e.pause(),u()}function l(u){let{key:h}=u;if(u.shiftKey&&h in r)i?.turn(...r[h]);else if(h in o)a(()=>e.step(o[h]));else if(h===" ")e.playing?e.pause():e.play();else if(h==="Home")a(()=>e.seek(e.span.start));else if(h==="End")a(()=>e.seek(e.span.end));else if(t.length===1&&t[0].marks[Number(h)-1])a(()=>e.seekClip(0,t[0].marks[Number(h)-1].time));else if(h==="+"||h==="=")i?.zoom(1);else if(h==="-"||h==="−")i?.zoom(-1);else if(h==="0")i?.show(s);else return!1;return!0}function c(u){let h=document.activeElement;!(n.contains(h)||h===document.body||h===null)||u.ctrlKey||u.metaKey||u.altKey||h instanceof HTMLSelectElement||u.key===" "&&/^(BUTTON|SUMMARY|A)$/.test(h?.tagName??"")||h===document.body&&/^(Home|End|PageUp|PageDown)$/.test(u.key)||l(u)&&u.preventDefault()}return document.addEventListener("keydown",c),()=>document.removeEventListener("keydown",c)}var Am=2.4;function $u(n){let t=10**Math.floor(Math.log10(n/Am));return t*[5,2,1].find(e=>e*t<=n/Am)}function Em(n,t){let e=$u(n),i=e*Math.ceil(1.25*n/e),s=[],[r,o]=[t.x,t.y].map(c=>e*Math.round(c/e));for(let c=-i;c<=i+e/2;c+=e)s.push(r+c,o-i,0,r+c,o+i,0,r-i,o+c,0,r+i,o+c,0);let a=new Vn().setAttribute("position",new je(s,3)),l=new Ko(a,new Yr({transparent:!0,opacity:.5,depthWrite:!1}));return l.frustumCulled=!1,l}function Zu(n,t,e,i){let s=i?["marks on the time line: the states of each run, in its colour"]:[];return W("ul",{className:"legend"},...n.map(({sample:r,text:o})=>r==="tendon"?db(o,t):fb(r,o)),...n.some(({sample:r})=>r==="tendon")?[W("li",{},"slack tendons hang, drawn with their resting length")]:[],W("li",{},`squares of the grid: ${pb($u(e))}`),...s.map(r=>W("li",{},r)))}function fb(n,t){let[e,i]=n.split(" "),s={mountain:{color:Nc},valley:{color:Uc},region:{background:Ma(i)}};return W("li",{className:e==="region"?"of-region":""},Cm(e==="region"?"panel":e,s[e]??{}),t)}function db(n,t){let e=W("li",{className:"energy"},`${n}: 0`,Ku(oo));return e.append(`${Cn(t.factor*t.largest_J)} ${t.unit}`),e}function Ku(n){return Cm("bar",{background:n.gradient})}function Cm(n,t){let e=W("span",{className:`swatch ${n}`,"aria-hidden":"true"});return Object.assign(e.style,t),e}function pb(n){let[t,e]=n>=1?["m",1]:n>=.01?["cm",100]:n>=1e-4?["mm",1e3]:["µm",1e6];return`${Cn(e*n)} ${t}`}function Rm(n,t){if(!(t>n*(1+1e-6)))return 0;let[e,i]=[0,t/2];for(let s=0;s<40;s++){let r=(e+i)/2;mb(n,r)<t?e=r:i=r}return(e+i)/2}function mb(n,t){return t===0?n:Math.hypot(n,4*t)/2+n*n*Math.asinh(4*t/(n||1e-12))/(8*t)}function Im(n){let{triangles:t,faces:e}=n.mesh,i=n.builtVertices(),s=Array.from({length:e.length},(c,u)=>Pm(i,t,u)),r=new Float32Array(e.reduce((c,u)=>Math.max(c,u),0)+1),o=new Float32Array(e.length);function a(c){r.fill(-1/0);for(let u=0;u<e.length;u++){let[h,f,d]=s[u],g=h*d-f*f;if(g<=1e-9*(h+d)**2)continue;let[y,m,p]=Pm(c,t,u),_=(d*y-2*f*m+h*p)/(2*g),E=(y*p-m*m)/g,S=(_+Math.sqrt(Math.max(_*_-E,0))-1)/2;r[e[u]]=Math.max(r[e[u]],S)}for(let u=0;u<e.length;u++)o[u]=Math.max(0,r[e[u]]);return o}function l(){let c=new Float32Array(i.length),u=0;for(let h of n.time)u=a(n.verticesAt(h,c)).reduce((f,d)=>Math.max(f,d),u);return u}return{at:a,largest:l}}function Pm(n,t,e){let[i,s,r]=[0,1,2].map(c=>3*t[3*e+c]),[o,a,l]=[0,0,0];for(let c=0;c<3;c++){let u=n[s+c]-n[i+c],h=n[r+c]-n[i+c];o+=u*u,a+=u*h,l+=h*h}return[o,a,l]}var gb=.9,Lm=.4,_b=.02,xb=["crease","rim","edge"],zs=12;function Nm(n,t){let{mesh:e}=n,i=new Float32Array(3*e.share.length),s=new Float32Array(n.tendons),r=Math.max(0,...e.tubes.map(L=>L.radius)),[o,a]=[!1,!0].map(L=>vb(e,L)),l=Dm(e.tubes.filter(L=>L.kind==="bar"),20,0),c=Dm(e.tubes.filter(L=>xb.includes(L.kind)),8,.4*r),u=Sb(n,2.4*r),h=bb(e.base),f=n.efforts?um(n):null,d=n.strained?Im(n):null,g=0,y=wb(e),m=new ii;m.add(h.object,a.object,l.object,y.object,c.object,u.object,o.object),f&&m.add(f.group);let p=yb(o.object,a.object,l.object),_=[0,0,0],E=new ee;function S(L){n.verticesAt(L,i),o.pose(i),a.pose(i);for(let R of[l,c,y])R.pose(i);n.valuesAt(or,L,s);let P=s.map(R=>t>0?R/t:0);u.pose(i,L,R=>Lm+(1-Lm)*Math.min(1,Math.max(0,P[R])/_b));for(let R=0;R<n.tendons;R++)oo.at(P[R],_),u.colour(R,E.setRGB(..._,"srgb"));n.tendons&&(u.object.instanceColor.needsUpdate=!0),f?.pose(L),g&&C()}function C(){let L=d.at(i),P=[0,0,0];for(let R of[o,a])R.colour(F=>E.setRGB(...Fc.at(L[F]/g,P),"srgb"))}function b(L){g=d?L:0;for(let P of[o,a])P.flat(g>0),g||P.colour(R=>E.set(Ma(e.regions[R])));g&&C()}function x(){for(let L of[l,c,y,h])L.paint();f?.paint(),p.children[0].material.color.set(Xe("--shadow"))}function T(){for(let L of[l,c,u,y])L.object.dispose();for(let L of[o,a])L.dispose();f?.dispose(),h.dispose();for(let L of[l,c,u,y])L.object.geometry.dispose(),L.object.material.dispose();p.children[0].material.dispose()}return{group:m,shadow:p,pose:S,paint:x,sort:o.sort,vertices:i,tendons:u.object,efforts:f,strains:d,showStrain:b,dispose:T}}function yb(...n){let t=new js({side:qn,transparent:!0,opacity:.12,depthWrite:!1,stencilWrite:!0,stencilRef:1,stencilFunc:mu,stencilZPass:pu}),e=new ii;for(let i of n){let s=i.isInstancedMesh?new oi(i.geometry,t,i.count):new Gn(i.geometry,t);i.isInstancedMesh&&(s.instanceMatrix=i.instanceMatrix),s.frustumCulled=!1,e.add(s)}return e.scale.z=1e-5,e}function vb(n,t){let e=n.regions.flatMap((S,C)=>n.solid[S]===t?[C]:[]),i=e.flatMap(S=>n.triangles.slice(3*S,3*S+3)),s=e.length,r=new kn(new Float32Array(3*i.length),3).setUsage(_a),o=new kn(new Float32Array(3*i.length),3).setUsage(_a),a=new kn(new Uint32Array(i.length),1).setUsage(_a);for(let S=0;S<i.length;S++)a.array[S]=S;let l=new Vn;l.setAttribute("position",r),l.setAttribute("color",o),l.setIndex(a);let c=new Qs({vertexColors:!0,side:qn,flatShading:!0,transparent:!t,opacity:t?1:gb,depthWrite:t,forceSinglePass:!0});c.onBeforeCompile=S=>{S.fragmentShader=S.fragmentShader.replace("#include <color_fragment>",`#include <color_fragment>
if (!gl_FrontFacing) diffuseColor.rgb *= 0.84;`)};let u=new js({vertexColors:!0,side:qn}),h=new Gn(l,c);h.frustumCulled=!1,h.renderOrder=t?0:1;let f=new ee;d(S=>f.set(Ma(n.regions[S])));function d(S){for(let[C,b]of e.entries()){let x=S(b);for(let T=0;T<3;T++)x.toArray(o.array,9*C+3*T)}o.needsUpdate=!0}let g=S=>{h.material=S?u:c};function y(){l.dispose(),c.dispose(),u.dispose()}function m(S){for(let C=0;C<i.length;C++)for(let b=0;b<3;b++)r.array[3*C+b]=S[3*i[C]+b];r.needsUpdate=!0}let p=new Float32Array(s),_=Array.from({length:s},(S,C)=>C);function E(S){let C=r.array;for(let b=0;b<s;b++){let x=0;for(let T=0;T<3;T++){let L=9*b+T;x+=((C[L]+C[L+3]+C[L+6])/3-S.getComponent(T))**2}p[b]=x}_.sort((b,x)=>p[x]-p[b]);for(let b=0;b<s;b++)for(let x=0;x<3;x++)a.array[3*b+x]=3*_[b]+x;a.needsUpdate=!0}return{object:h,pose:m,sort:E,colour:d,flat:g,dispose:y}}function Dm(n,t,e){let i=new oi(new Vi(1,1,1,t),rr(e),n.length);i.frustumCulled=!1,o();let s=n.map(a=>[3*a.ends[0],3*a.ends[1],a.radius]);function r(a,l=()=>1){let c=i.instanceMatrix.array;for(let[u,[h,f,d]]of s.entries())ro(a,h,f,l(u)*d,c,16*u);i.instanceMatrix.needsUpdate=!0}function o(){let a={M:new ee(Nc),V:new ee(Uc),B:new ee(Xe("--bar"))};for(let[l,c]of n.entries())i.setColorAt(l,a[c.crease]);n.length&&(i.instanceColor.needsUpdate=!0)}return{object:i,pose:r,paint:o}}function Sb(n,t){let e=n.mesh.tubes.filter(l=>l.kind==="tendon"),i=new oi(new Vi(1,1,1,12),rr(t),e.length*zs);i.frustumCulled=!1;let s=new Float32Array(e.length),r=new Float32Array(3*(zs+1));function o(l,c,u){n.restLengthsAt(c,s);let h=i.instanceMatrix.array;for(let[f,{ends:d,radius:g}]of e.entries()){Mb(l,3*d[0],3*d[1],s[f],r);for(let y=0;y<zs;y++)ro(r,3*y,3*y+3,u(f)*g,h,16*(f*zs+y))}i.instanceMatrix.needsUpdate=!0}function a(l,c){for(let u=0;u<zs;u++)i.setColorAt(l*zs+u,c)}return{object:i,pose:o,colour:a}}function Mb(n,t,e,i,s){let r=[0,1,2].map(f=>n[e+f]-n[t+f]),o=Math.hypot(...r),a=Rm(o,i),l=Math.abs(r[2])>.999*o?[1,0,0]:[0,0,-1],c=l.reduce((f,d,g)=>f+d*r[g],0)/(o*o||1),u=l.map((f,d)=>f-c*r[d]),h=Math.hypot(...u)||1;for(let f=0;f<=zs;f++){let d=f/zs,g=4*a*d*(1-d)/h;for(let y=0;y<3;y++)s[3*f+y]=n[t+y]+d*r[y]+g*u[y]}}function bb({rods:n,radius:t}){let e=new Float32Array(n.flat(2)),i=rr(0),s=new oi(new Vi(1,1,1,16),i,n.length),r=new oi(new Zr(1,16,12),i,2*n.length),o=new ii;for(let l of[s,r])l.frustumCulled=!1,o.add(l);for(let l=0;l<n.length;l++)ro(e,6*l,6*l+3,t,s.instanceMatrix.array,16*l);for(let l=0;l<2*n.length;l++){let c=r.instanceMatrix.array;for(let u=0;u<3;u++)[c[16*l+5*u],c[16*l+12+u]]=[t,e[3*l+u]];c[16*l+15]=1}function a(){for(let l of[s,r])l.dispose(),l.geometry.dispose();i.dispose()}return{object:o,paint:()=>i.color.set(Xe("--base")),dispose:a}}function wb(n){let t=new oi(new Zr(1,16,12),rr(0),n.joints.length);t.frustumCulled=!1;let e=()=>t.material.color.set(Xe("--joint"));e();function i(s){let r=t.instanceMatrix.array;for(let[o,a]of n.joints.entries()){for(let l=0;l<3;l++)r[16*o+5*l]=n.jointRadius,r[16*o+12+l]=s[3*a+l];r[16*o+15]=1}t.instanceMatrix.needsUpdate=!0}return{object:t,pose:i,paint:e}}var Tb=4096,Ab=3.2,Eb=new X(-.45,.75,1),Cb=.42*Math.PI,Rb=.64*Math.PI,Pb=.5,Ib=.14;function Ju(n,t,e,i,s){let r=W("canvas",{tabIndex:0,role:"img","aria-label":`${i} ${Lb}`}),o=r.getContext("webgl2",{antialias:!0,alpha:!0,stencil:!0});if(!o)return null;let a=n.map(()=>W("div",{className:"cell"})),l=n.length>1,c=W("div",{className:l?"stage several":"stage"},r,...a);c.style.setProperty("--columns",String(n.length===4?2:Math.min(n.length,n.length>6?4:3)));let u=()=>l?Math.ceil(Ab*parseFloat(getComputedStyle(a[0]).fontSize)):0,h=new Ic({canvas:r,context:o,antialias:!0,alpha:!0,stencil:!0});h.setScissorTest(!0);let f=bm(r,n,t,m,s),d=n.map(P=>Db(P,e,f)),g=0,y=!1;function m(){g||(g=requestAnimationFrame(_))}function p(){for(let[P,R]of d.entries())R.shape.pose(t.clipTime(P));y=!0}function _(){cancelAnimationFrame(g),g=0,y||p();let P=r.clientHeight,R=u();h.setScissor(0,0,r.clientWidth,P),h.setViewport(0,0,r.clientWidth,P),h.clear();for(let[F,k]of d.entries()){f.aim(F);let N=a[F],V=[N.offsetLeft,P-N.offsetTop-N.offsetHeight,N.offsetWidth,N.offsetHeight-R];h.setViewport(...V),h.setScissor(...V),k.light.position.copy(Eb).applyQuaternion(f.camera.quaternion);let Y=f.camera.position.z>k.floor.position.z;k.floor.material.opacity=Y?Pb:Ib,k.shape.shadow.visible=Y,k.shape.sort(f.camera.position),h.render(k.scene,f.camera)}f.aim()}function E(){for(let P of d)P.floor.material.color.set(Xe("--floor")),P.shape.paint();m()}function S(){let[P,R]=[c.clientWidth,c.clientHeight];if(!P||!R)return;h.setPixelRatio(Math.min(devicePixelRatio,2,Tb/Math.max(P,R))),h.setSize(P,R,!1);let F=a[0].offsetHeight-u();f.resize(a[0].offsetWidth/F,R/F),_()}let C=new ResizeObserver(S);C.observe(c);let b=t.onChange(()=>{y=!1,_()}),x=Us(E);r.addEventListener("webglcontextrestored",m),E();function T(){cancelAnimationFrame(g),b(),x(),C.disconnect(),f.dispose();for(let{shape:P,floor:R}of d)P.dispose(),R.geometry.dispose(),R.material.dispose();h.dispose(),h.forceContextLoss(),c.remove()}function L(P){let R=P?d.reduce((F,{shape:k})=>Math.max(F,k.strains?.largest()??0),0):0;for(let{shape:F}of d)F.showStrain(R||(P?Number.MIN_VALUE:0));return m(),R}return{element:c,canvas:r,cells:a,eye:f,pose:p,draw:_,views:d,showStrain:L,statistics:()=>h.info.render,dispose:T}}var Lb="Drag to turn it, pinch to zoom; keys are listed below.";function Db(n,t,e){let i=Nm(n,t.largest_J),s=Em(e.size,e.target);s.position.z=Nb(n)-.06*e.size,i.shadow.position.z=s.position.z+.001*e.size;let r=new aa("#ffffff",Cb),o=new Xo;return o.add(i.group,i.shadow,s,r,new sa("#ffffff","#dde2e8",Rb)),{shape:i,floor:s,light:r,scene:o}}function Nb(n){let t=1/0,e=Math.max(1,Math.floor(n.time.length/200));for(let i=0;i<n.time.length;i+=e){let s=n.pointsAt(n.time[i]);for(let r=2;r<s.length;r+=3)t=Math.min(t,s[r])}return t}var Ub="M7 4.5v15l12-7.5z",Fb="M7 5h3.5v14H7zM13.5 5H17v14h-3.5z",ju=1e4;function Fm(n,t){let e=W("button",{type:"button",className:"play"}),i=W("input",{type:"range",min:0,max:ju,step:1,"aria-label":"time"}),s=W("div",{className:"bands","aria-hidden":"true"}),r=W("div",{className:"ticks","aria-hidden":"true"}),o=W("p",{className:"time"}),a=W("p",{className:"spoken",role:"status"}),l=n.length===1?n[0].marks.map(d=>Ob(d,t)):[],c=W("div",{className:"transport"},W("div",{className:"line"},e,W("div",{className:"track"},s,i,r)),W("div",{className:"choices"},o,...l.length?[W("div",{className:"states"},...l)]:[],Bb(t),...kb(t),a));e.addEventListener("click",()=>t.playing?t.pause():t.play()),i.addEventListener("input",()=>{t.pause(),t.seek(t.momentAt(i.value/ju))});let u=null,h=null,f=0;return t.onChange(()=>{let d=`${t.spans.indexOf(t.span)} ${t.stretched}`;d!==u&&zb(n,t,s,r),u=d,i.value=Math.round(ju*t.shareAt(t.time)),i.setAttribute("aria-valuetext",Um(n,t));let g=n.length===1?` · ${zc(n[0],t.clipTime(0))}`:t.span.label.replace("time",""),y=t.playing?`, ${Vb(t.slowness)}`:"";o.textContent=`${wa(t.time,t.span)}${g}${y}`;for(let[m,p]of(n.length===1?n[0].marks:[]).entries())l[m].setAttribute("aria-pressed",String(Math.abs(p.time-t.clipTime(0))<1e-9));t.playing!==h&&(e.replaceChildren(rd(t.playing?Fb:Ub)),e.setAttribute("aria-label",t.playing?"pause":"play"),h=t.playing),clearTimeout(f),t.playing||(f=setTimeout(()=>{a.textContent=Um(n,t)},600))}),c}function Ob(n,t){let e=W("button",{type:"button",className:"state"},W("b",{},n.letter),` ${n.name}`);return e.addEventListener("click",()=>{t.pause(),t.seekClip(0,n.time)}),e}function Bb(n){let t=dm.map(({name:i,value:s})=>W("option",{value:String(s)},i)),e=W("select",{},...t);return e.addEventListener("change",()=>n.setSpeed(e.value==="even"?"even":Number(e.value))),W("label",{},"speed ",e)}function kb(n){if(n.spans.length<2)return[];let t=n.spans.map((i,s)=>W("option",{value:String(s)},i.name)),e=W("select",{},...t);return e.addEventListener("change",()=>n.setSpan(n.spans[Number(e.value)])),n.onChange(()=>{e.value=String(n.spans.indexOf(n.span))}),[W("label",{},"show ",e)]}function zb(n,t,e,i){let{span:s}=t,r=o=>Math.min(1,Math.max(0,t.shareAt(o)));e.replaceChildren(),i.replaceChildren();for(let[o,a]of n.entries()){let l=s.origins[o];for(let c of a.stages.filter(u=>u.driven&&n.length===1)){let[u,h]=[r(c.start-l),r(c.end-l)],f=W("span",{className:"band"});f.style.left=`${100*u}%`,f.style.width=`${100*(h-u)}%`,h>u&&e.append(f)}for(let c of a.marks){let u=c.time-l;if(u<s.start-1e-9||u>s.end+1e-9)continue;let h=W("span",{className:"tick"},n.length===1?c.letter:"");h.style.left=`${100*r(u)}%`,n.length>1&&h.style.setProperty("--tick",`var(--line-${o%7})`),i.append(h)}}}function Vb(n){return n<1.05?"real time":`${n<10?ks(n,1):Math.round(n)} times slower`}function zc(n,t){let e=n.markAt(t);return e?`${e.letter} ${e.name}`:n.stageAt(t).name}function Um(n,t){let e=n.map((i,s)=>{let r=t.clipTime(s);return`${n.length>1?`${i.name}: `:""}${zc(i,r)}${Gb(i,r)}`});return`${wa(t.time,t.span)}: ${e.join("; ")}`}function Gb(n,t){let[e]=n.readings;if(!e)return"";let i=n.markAt(t)?.readings[e.name]?.mean??n.valuesAt(e.name,t),s=e.unit==="deg"?"degrees":e.unit,r=[Math.min(...i),Math.max(...i)].map(a=>ks(a,1)),o=i.length>1;return`, ${e.label}${o?"s":""} ${o?r.join(" to "):r[0]} ${s}`}function lo(n,t,e,{energy:i,legend:s,text:r,whole:o},a){let l=Ju(t,e,i,r,a),c=l?W("div",{className:"picture"},l.element,Vm(l.eye,t.length>1||a?o:null)):W("p",{className:"note"},zm(o));l&&t.length===1&&Hb(l.cells[0],t[0],e);let u=l?[Zu(s,i,l.eye.size,t.length>1?o:null)]:[];l&&t.some(d=>d.strained)&&u.unshift(km(l,u[0])),l&&t.length===1&&t[0].efforts?.drives.length&&Wb(u.at(-1),t[0],e),l&&t.length>1&&t.some(d=>d.efforts?.drives.some(g=>g.arrow))&&u.at(-1).append(W("li",{className:"effort"},Bm(),"torque or force of a drive, while it acts")),n.replaceChildren(c,Fm(t,e),...u,wm(t,l!==null,o)),n.classList.add("player"),n.setAttribute("role","region"),n.setAttribute("aria-label",`the ${o} moving`);let h=Tm(n,t,e,l?.eye,kc[0]);function f(){e.pause(),h(),l?.dispose(),n.replaceChildren()}return{stage:l,dispose:f}}function Om(n,t,e,{energy:i,legend:s,text:r,whole:o}){let a=Ju(t,e,i,r);if(!a)return n.replaceChildren(W("p",{className:"note"},zm(o))),{stage:a};let l=W("div",{className:"picture"},a.element,Vm(a.eye,null)),c=[Zu(s,i,a.eye.size,null)];return t.some(u=>u.strained)&&c.unshift(km(a,c[0])),n.replaceChildren(l,...c),n.classList.add("player"),n.setAttribute("role","region"),n.setAttribute("aria-label",`the ${o} where the sliders are`),{stage:a}}function Hb(n,t,e){let i=W("p",{className:"now","aria-hidden":"true"});n.append(i),e.onChange(()=>{i.textContent=zc(t,e.clipTime(0))})}function Bm(){return W("span",{className:"swatch arrow","aria-hidden":"true"})}function Wb(n,t,e){let i=t.efforts.drives.some(r=>r.arrow),s=W("span");n.append(W("li",{className:"effort"},...i?[Bm()]:[],s)),e.onChange(()=>{s.textContent=hm(t.efforts,e.clipTime(0),Cn).join("; ")||"no drive acts now"})}function km(n,t){let e=["panels","membrane strain"],i=W("li",{className:"energy",hidden:!0});t.append(i);let s=e.map((r,o)=>{let a=W("button",{type:"button","aria-pressed":String(!o)},r);return a.addEventListener("click",()=>{let l=n.showStrain(!!o);i.replaceChildren("membrane strain, Green’s: 0",Ku(Fc),`${Cn(100*l)} %`),i.hidden=!o;for(let c of t.querySelectorAll(".of-region"))c.hidden=!!o;for(let c of s)c.setAttribute("aria-pressed",String(c===a))}),a});return W("div",{className:"colours",role:"group","aria-label":"colour of the sheet"},"colour:",W("span",{},...s))}function zm(n){return`This browser has no WebGL, so the ${n} cannot be drawn in 3-D. The plots and all numbers are here.`}function Vm(n,t){let e=(l,c,u)=>{let h=W("button",{type:"button",title:c,"aria-label":c},l);return h.addEventListener("click",u),h},i=kc.map(l=>e(l.name,`${l.name}: view ${l.text}`,()=>n.show(l))),s=[["←","turn left",[-1,0]],["→","turn right",[1,0]],["↑","turn up",[0,1]],["↓","turn down",[0,-1]]].map(([l,c,u])=>e(l,c,()=>n.turn(...u))),r=(l,c,u)=>{let h=e(l,c,()=>{n.choose({[u]:!n.look[u]}),h.setAttribute("aria-pressed",String(n.look[u]))});return h.setAttribute("aria-pressed",String(n.look[u])),h},o=[r("follow","follow: keep the picture filled as it moves","following"),...t?[r("one scale",`one scale: all ${t}s as large as they are by each other`,"oneScale")]:[]],a=[e("+","nearer",()=>n.zoom(1)),e("−","further",()=>n.zoom(-1))];return W("div",{className:"views",role:"group","aria-label":"view"},W("span",{},...o),W("span",{},...i),W("span",{className:"turns"},...s),W("span",{},...a))}var Xb="uplot",qb="u-hz",Yb="u-vt",$b="u-title",Zb="u-wrap",Kb="u-under",Jb="u-over",jb="u-axis",cr="u-off",Qb="u-select",tw="u-cursor-x",ew="u-cursor-y",nw="u-cursor-pt",iw="u-legend",sw="u-live",rw="u-inline",ow="u-series",aw="u-marker",Gm="u-label",lw="u-value",Aa="width",Ea="height";var Hm="bottom",co="left",Qu="right",_f="#000",Wm=_f+"0",tf="mousemove",Xm="mousedown",ef="mouseup",qm="mouseenter",Ym="mouseleave",$m="dblclick",cw="resize",hw="scroll",Zm="change",Xc="dppxchange",xf="--",_o=typeof window<"u",af=_o?document:null,uo=_o?window:null,uw=_o?navigator:null,be,Vc;function lf(){let n=devicePixelRatio;be!=n&&(be=n,Vc&&hf(Zm,Vc,lf),Vc=matchMedia(`(min-resolution: ${be-.001}dppx) and (max-resolution: ${be+.001}dppx)`),hr(Zm,Vc,lf),uo.dispatchEvent(new CustomEvent(Xc)))}function li(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function cf(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function Ve(n,t,e){n.style[t]=e+"px"}function Ci(n,t,e,i){let s=af.createElement(n);return t!=null&&li(s,t),e?.insertBefore(s,i),s}function gi(n,t){return Ci("div",n,t)}var Km=new WeakMap;function qi(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=Km.get(n);r!=o&&(n.style.transform=r,Km.set(n,r),t<0||e<0||t>i||e>s?li(n,cr):cf(n,cr))}var Jm=new WeakMap;function jm(n,t,e){let i=t+e,s=Jm.get(n);i!=s&&(Jm.set(n,i),n.style.background=t,n.style.borderColor=e)}var Qm=new WeakMap;function tg(n,t,e,i){let s=t+""+e,r=Qm.get(n);s!=r&&(Qm.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var yf={passive:!0},fw={...yf,capture:!0};function hr(n,t,e,i){t.addEventListener(n,e,i?fw:yf)}function hf(n,t,e,i){t.removeEventListener(n,e,yf)}_o&&lf();function Ri(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:ci((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function Cg(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var Rg=n=>n!=null,Pg=n=>n!=null&&n>0,$c=Cg(Rg),dw=Cg(Pg);function pw(n,t,e,i=0,s=!1){let r=s?dw:$c,o=s?Pg:Rg;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??De,l??-De]}function Zc(n,t,e,i){let s=ig(n),r=ig(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?ds:Ig,a=s==1?ci:_i,l=r==1?_i:ci,c=a(o(_n(n))),u=l(o(_n(t))),h=fo(e,c),f=fo(e,u);return e==10&&(c<0&&(h=Ne(h,-c)),u<0&&(f=Ne(f,-u))),i||e==2?(n=h*s,t=f*r):(n=Ug(n,h),t=Kc(t,f)),[n,t]}function vf(n,t,e,i){let s=Zc(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var Sf=.1,eg={mode:3,pad:Sf},Ra={pad:0,soft:null,mode:0},mw={min:Ra,max:Ra};function qc(n,t,e,i){return Jc(e)?ng(n,t,e):(Ra.pad=e,Ra.soft=i?0:null,Ra.mode=i?3:0,ng(n,t,mw))}function ve(n,t){return n??t}function gw(n,t,e){for(t=ve(t,0),e=ve(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function ng(n,t,e){let i=e.min,s=e.max,r=ve(i.pad,0),o=ve(s.pad,0),a=ve(i.hard,-De),l=ve(s.hard,De),c=ve(i.soft,De),u=ve(s.soft,-De),h=ve(i.mode,0),f=ve(s.mode,0),d=t-n,g=ds(d),y=Wn(_n(n),_n(t)),m=ds(y),p=_n(m-g);(d<1e-24||p>10)&&(d=0,(n==0||t==0)&&(d=1e-24,h==2&&c!=De&&(r=0),f==2&&u!=-De&&(o=0)));let _=d||y||1e3,E=ds(_),S=fo(10,ci(E)),C=_*(d==0?n==0?.1:1:r),b=Ne(Ug(n-C,S/10),24),x=n>=c&&(h==1||h==3&&b<=c||h==2&&b>=c)?c:De,T=Wn(a,b<x&&n>=x?x:Pi(x,b)),L=_*(d==0?t==0?.1:1:o),P=Ne(Kc(t+L,S/10),24),R=t<=u&&(f==1||f==3&&P>=u||f==2&&P<=u)?u:-De,F=Pi(l,P>R&&t<=R?R:Wn(R,P));return T==F&&T==0&&(F=100),[T,F]}var _w=new Intl.NumberFormat(_o?uw.language:"en-US"),Mf=n=>_w.format(n),hi=Math,Wc=hi.PI,_n=hi.abs,ci=hi.floor,gn=hi.round,_i=hi.ceil,Pi=hi.min,Wn=hi.max,fo=hi.pow,ig=hi.sign,ds=hi.log10,Ig=hi.log2,xw=(n,t=1)=>hi.sinh(n)*t,nf=(n,t=1)=>hi.asinh(n/t),De=1/0;function sg(n){return(ds((n^n>>31)-(n>>31))|0)+1}function uf(n,t,e){return Pi(Wn(n,t),e)}function Lg(n){return typeof n=="function"}function _e(n){return Lg(n)?n:()=>n}var yw=()=>{},Dg=n=>n,Ng=(n,t)=>t,vw=n=>null,rg=n=>!0,og=(n,t)=>n==t,Sw=/\.\d*?(?=9{6,}|0{6,})/gm,ur=n=>{if(Og(n)||Gs.has(n))return n;let t=`${n}`,e=t.match(Sw);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${ur(s)}e${r}`}return Ne(n,i)};function ar(n,t){return ur(Ne(ur(n/t))*t)}function Kc(n,t){return ur(_i(ur(n/t))*t)}function Ug(n,t){return ur(ci(ur(n/t))*t)}function Ne(n,t=0){if(Og(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return gn(i)/e}var Gs=new Map;function Fg(n){return((""+n).split(".")[1]||"").length}function Ia(n,t,e,i){let s=[],r=i.map(Fg);for(let o=t;o<e;o++){let a=_n(o),l=Ne(fo(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=n==10?u:Ne(u,h);s.push(f),Gs.set(f,h)}}return s}var Pa={},bf=[],po=[null,null],Vs=Array.isArray,Og=Number.isInteger,Mw=n=>n===void 0;function ag(n){return typeof n=="string"}function Jc(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function bw(n){return n!=null&&typeof n=="object"}var ww=Object.getPrototypeOf(Uint8Array),Bg="__proto__";function mo(n,t=Jc){let e;if(Vs(n)){let i=n.find(s=>s!=null);if(Vs(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=mo(n[s],t)}else e=n.slice()}else if(n instanceof ww)e=n.slice();else if(t(n)){e={};for(let i in n)i!=Bg&&(e[i]=mo(n[i],t))}else e=n;return e}function hn(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=Bg&&(Jc(n[s])?hn(n[s],mo(i[s])):n[s]=mo(i[s]))}return n}var Tw=0,Aw=1,Ew=2;function Cw(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function Rw(n,t){if(Lw(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return Dw(o[0])||(o=Iw(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),f=t?t[o][c]:Aw,d=[];for(let g=0;g<u.length;g++){let y=u[g],m=r.get(l[g]);y===null?f!=Tw&&(h[m]=y,f==Ew&&d.push(m)):h[m]=y}Cw(h,d,s),i.push(h)}}return i}var Pw=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function Iw(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function Lw(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function Dw(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Wn(1,ci((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var kg=["January","February","March","April","May","June","July","August","September","October","November","December"],zg=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Vg(n){return n.slice(0,3)}var Nw=zg.map(Vg),Uw=kg.map(Vg),Fw={MMMM:kg,MMM:Uw,WWWW:zg,WWW:Nw};function Ta(n){return(n<10?"0":"")+n}function Ow(n){return(n<10?"00":n<100?"0":"")+n}var Bw={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>Ta(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Ta(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>Ta(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Ta(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Ta(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>Ow(n.getMilliseconds())};function wf(n,t){t=t||Fw;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?Bw[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var kw=new Intl.DateTimeFormat().resolvedOptions().timeZone;function zw(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==kw?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var Gg=n=>n%1==0,Yc=[1,2,2.5,5],Vw=Ia(10,-32,0,Yc),Hg=Ia(10,0,32,Yc),Gw=Hg.filter(Gg),lr=Vw.concat(Hg),Tf=`
`,Wg="{YYYY}",lg=Tf+Wg,Xg="{M}/{D}",Ca=Tf+Xg,Gc=Ca+"/{YY}",qg="{aa}",Hw="{h}:{mm}",ho=Hw+qg,cg=Tf+ho,hg=":{ss}",Te=null;function Yg(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?Ia(10,0,3,Yc).filter(Gg):Ia(10,-3,0,Yc)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Wg,Te,Te,Te,Te,Te,Te,1],[s*28,"{MMM}",lg,Te,Te,Te,Te,Te,1],[s,Xg,lg,Te,Te,Te,Te,Te,1],[i,"{h}"+qg,Gc,Te,Ca,Te,Te,Te,1],[e,ho,Gc,Te,Ca,Te,Te,Te,1],[t,hg,Gc+" "+ho,Te,Ca+" "+ho,Te,cg,Te,1],[n,hg+".{fff}",Gc+" "+ho,Te,Ca+" "+ho,Te,cg,Te,1]];function u(h){return(f,d,g,y,m,p)=>{let _=[],E=m>=o,S=m>=r&&m<o,C=h(g),b=Ne(C*n,3),x=sf(C.getFullYear(),E?0:C.getMonth(),S||E?1:C.getDate()),T=Ne(x*n,3);if(S||E){let L=S?m/r:0,P=E?m/o:0,R=b==T?b:Ne(sf(x.getFullYear()+P,x.getMonth()+L,1)*n,3),F=new Date(gn(R/n)),k=F.getFullYear(),N=F.getMonth();for(let V=0;R<=y;V++){let Y=sf(k+P*V,N+L*V,1),G=Y-h(Ne(Y*n,3));R=Ne((+Y+G)*n,3),R<=y&&_.push(R)}}else{let L=m>=s?s:m,P=ci(g)-ci(b),R=T+P+Kc(b-T,L);_.push(R);let F=h(R),k=F.getHours()+F.getMinutes()/e+F.getSeconds()/i,N=m/i,V=f.axes[d]._space,Y=p/V;for(;R=Ne(R+m,n==1?0:3),!(R>y);)if(N>1){let G=ci(Ne(k+N,6))%24,Q=h(R).getHours()-G;Q>1&&(Q=-1),R-=Q*i,k=(k+N)%24;let it=_[_.length-1];Ne((R-it)/m,3)*Y>=.7&&_.push(R)}else _.push(R)}return _}}return[l,c,u]}var[Ww,Xw,qw]=Yg(1),[Yw,$w,Zw]=Yg(.001);Ia(2,-53,53,[1]);function ug(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function fg(n,t){return(e,i,s,r,o)=>{let a=t.find(g=>o>=g[0])||t[t.length-1],l,c,u,h,f,d;return i.map(g=>{let y=n(g),m=y.getFullYear(),p=y.getMonth(),_=y.getDate(),E=y.getHours(),S=y.getMinutes(),C=y.getSeconds(),b=m!=l&&a[2]||p!=c&&a[3]||_!=u&&a[4]||E!=h&&a[5]||S!=f&&a[6]||C!=d&&a[7]||a[1];return l=m,c=p,u=_,h=E,f=S,d=C,b(y)})}}function Kw(n,t){let e=wf(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function sf(n,t,e){return new Date(n,t,e)}function dg(n,t){return t(n)}var Jw="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function pg(n,t){return(e,i,s,r)=>r==null?xf:t(n(i))}function jw(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function Qw(n,t){return n.series[t].fill(n,t)}var t1={show:!0,live:!0,isolate:!1,mount:yw,markers:{show:!0,width:2,stroke:jw,fill:Qw,dash:"solid"},idx:null,idxs:null,values:[]};function e1(n,t){let e=n.cursor.points,i=gi(),s=e.size(n,t);Ve(i,Aa,s),Ve(i,Ea,s);let r=s/-2;Ve(i,"marginLeft",r),Ve(i,"marginTop",r);let o=e.width(n,t,s);return o&&Ve(i,"borderWidth",o),i}function n1(n,t){let e=n.series[t].points;return e._fill||e._stroke}function i1(n,t){let e=n.series[t].points;return e._stroke||e._fill}function s1(n,t){return n.series[t].points.size}var rf=[0,0];function r1(n,t,e){return rf[0]=t,rf[1]=e,rf}function Hc(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function of(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var o1={show:!0,x:!0,y:!0,lock:!1,move:r1,points:{one:!1,show:e1,size:s1,width:0,stroke:i1,fill:n1},bind:{mousedown:Hc,mouseup:Hc,click:Hc,dblclick:Hc,mousemove:of,mouseleave:of,mouseenter:of},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},$g={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Af=hn({},$g,{filter:Ng}),Zg=hn({},Af,{size:10}),Kg=hn({},$g,{show:!1}),Ef='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Jg="bold "+Ef,jg=1.5,mg={show:!0,scale:"x",stroke:_f,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Jg,side:2,grid:Af,ticks:Zg,border:Kg,font:Ef,lineGap:jg,rotate:0},a1="Value",l1="Time",gg={show:!0,scale:"x",auto:!1,sorted:1,min:De,max:-De,idxs:[]};function c1(n,t,e,i,s){return t.map(r=>r==null?"":Mf(r))}function h1(n,t,e,i,s,r,o){let a=[],l=Gs.get(s)||0;e=o?e:Ne(Kc(e,s),l);for(let c=e;c<=i;c=Ne(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function ff(n,t,e,i,s,r,o){let a=[],l=n.scales[n.axes[t].scale].log,c=l==10?ds:Ig,u=ci(c(e));s=fo(l,u),l==10&&(s=lr[Ri(s,lr)]);let h=e,f=s*l;l==10&&(f=lr[Ri(f,lr)]);do a.push(h),h=h+s,l==10&&!Gs.has(h)&&(h=Ne(h,Gs.get(s))),h>=f&&(s=h,f=s*l,l==10&&(f=lr[Ri(f,lr)]));while(h<=i);return a}function u1(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?ff(n,t,Wn(l,e),i,s):[l],u=i>=0&&e<=0?[0]:[];return(e<-l?ff(n,t,Wn(l,-i),-e,s):[l]).reverse().map(f=>-f).concat(u,c)}var Qg=/./,f1=/[12357]/,d1=/[125]/,_g=/1/,df=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function p1(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?Qg:l(7,o)-u>=c?f1:l(5,o)-u>=c?d1:_g;if(h==_g){let f=_n(l(1,o)-u);if(f<c)return df(t.slice().reverse(),a.distr,h,_i(c/f)).reverse()}return df(t,a.distr,h,1)}function m1(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=_n(l(1,o)-l(2,o));return c<a?df(t.slice().reverse(),3,Qg,_i(a/c)).reverse():t}function g1(n,t,e,i){return i==null?xf:t==null?"":Mf(t)}var xg={show:!0,scale:"y",stroke:_f,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Jg,side:3,grid:Af,ticks:Zg,border:Kg,font:Ef,lineGap:jg,rotate:0};function _1(n,t){let e=3+(n||1)*2;return Ne(e*t,3)}function x1(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=_n(o-r),l=n.series[t],c=a/(l.points.space*be);return i[1]-i[0]<=c}var yg={scale:null,auto:!0,sorted:0,min:De,max:-De},t0=(n,t,e,i,s)=>s,vg={show:!0,auto:!0,sorted:0,gaps:t0,alpha:1,facets:[hn({},yg,{scale:"x"}),hn({},yg,{scale:"y"})]},Sg={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:t0,alpha:1,points:{show:x1,filter:null},values:null,min:De,max:-De,idxs:[],path:null,clip:null};function y1(n,t,e,i,s){return e/10}var e0={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},v1=hn({},e0,{time:!1,ori:1}),Mg={};function n0(n,t){let e=Mg[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(Mg[n]=e)),e}var go=1,pf=2;function fr(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[t],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],f=a.left,d=a.top,g=a.width,y=a.height,m=n.valToPosH,p=n.valToPosV;return u.ori==0?e(s,l,c,u,h,m,p,f,d,g,y,Qc,xo,eh,s0,o0):e(s,l,c,u,h,p,m,d,f,y,g,th,yo,Pf,r0,a0)}function Cf(n,t){let e=0,i=0,s=ve(n.bands,bf);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function S1(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function ps(n,t,e,i,s,r){return fr(n,t,(o,a,l,c,u,h,f,d,g,y,m)=>{let p=o.pxRound,_=c.dir*(c.ori==0?1:-1),E=c.ori==0?xo:yo,S,C;_==1?(S=e,C=i):(S=i,C=e);let b=p(h(a[S],c,y,d)),x=p(f(l[S],u,m,g)),T=p(h(a[C],c,y,d)),L=p(f(r==1?u.max:u.min,u,m,g)),P=new Path2D(s);return E(P,T,L),E(P,b,L),E(P,b,x),P})}function jc(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?eh:Pf,l=e;for(let h=0;h<n.length;h++){let f=n[h];if(f[1]>f[0]){let d=f[0]-l;d>0&&a(o,l,i,d,i+r),l=f[1]}}let c=e+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function M1(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function Rf(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let h=c,f=c;if(s==1)for(;++c<=i&&t[c]===null;)f=c;else for(;--c>=e&&t[c]===null;)f=c;let d=r(n[h]),g=f==h?d:r(n[f]),y=h-s;d=o<=0&&y>=0&&y<l?r(n[y]):d;let p=f+s;g=o>=0&&p>=0&&p<l?r(n[p]):g,g>=d&&a.push([d,g])}return a}function bg(n){return n==0?Dg:n==1?gn:t=>ar(t,n)}function i0(n){let t=n==0?Qc:th,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Pi(c,a/2,l/2),u=Pi(u,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,u),e(s,r,o+l,r,o,u),e(s,r,o,r+a,o,c),s.closePath())}}var Qc=(n,t,e)=>{n.moveTo(t,e)},th=(n,t,e)=>{n.moveTo(e,t)},xo=(n,t,e)=>{n.lineTo(t,e)},yo=(n,t,e)=>{n.lineTo(e,t)},eh=i0(0),Pf=i0(1),s0=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},r0=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},o0=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},a0=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function l0(n){return(t,e,i,s,r)=>fr(t,e,(o,a,l,c,u,h,f,d,g,y,m)=>{let{pxRound:p,points:_}=o,E,S;c.ori==0?(E=Qc,S=s0):(E=th,S=r0);let C=Ne(_.width*be,3),b=(_.size-_.width)/2*be,x=Ne(b*2,3),T=new Path2D,L=new Path2D,{left:P,top:R,width:F,height:k}=t.bbox;eh(L,P-x,R-x,F+x*2,k+x*2);let N=V=>{if(l[V]!=null){let Y=p(h(a[V],c,y,d)),G=p(f(l[V],u,m,g));E(T,Y+b,G),S(T,Y,G,b,0,Wc*2)}};if(r)r.forEach(N);else for(let V=i;V<=s;V++)N(V);return{stroke:C>0?T:null,fill:T,clip:L,flags:go|pf}})}function c0(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var b1=c0(xo),w1=c0(yo);function h0(n){let t=ve(n?.alignGaps,0);return(e,i,s,r)=>fr(e,i,(o,a,l,c,u,h,f,d,g,y,m)=>{[s,r]=$c(l,s,r);let p=o.pxRound,_=k=>p(h(k,c,y,d)),E=k=>p(f(k,u,m,g)),S,C;c.ori==0?(S=xo,C=b1):(S=yo,C=w1);let b=c.dir*(c.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:go},T=x.stroke,L=!1;if(r-s>=y*4){let k=ft=>e.posToVal(ft,c.key,!0),N=null,V=null,Y,G,lt,K=_(a[b==1?s:r]),Q=_(a[s]),it=_(a[r]),dt=k(b==1?Q+1:it-1);for(let ft=b==1?s:r;ft>=s&&ft<=r;ft+=b){let tt=a[ft],gt=(b==1?tt<dt:tt>dt)?K:_(tt),Mt=l[ft];gt==K?Mt!=null?(G=Mt,N==null?(S(T,gt,E(G)),Y=N=V=G):G<N?N=G:G>V&&(V=G)):Mt===null&&(L=!0):(N!=null&&C(T,K,E(N),E(V),E(Y),E(G)),Mt!=null?(G=Mt,S(T,gt,E(G)),N=V=Y=G):(N=V=null,Mt===null&&(L=!0)),K=gt,dt=k(K+b))}N!=null&&N!=V&&lt!=K&&C(T,K,E(N),E(V),E(Y),E(G))}else for(let k=b==1?s:r;k>=s&&k<=r;k+=b){let N=l[k];N===null?L=!0:N!=null&&S(T,_(a[k]),E(N))}let[R,F]=Cf(e,i);if(o.fill!=null||R!=0){let k=x.fill=new Path2D(T),N=o.fillTo(e,i,o.min,o.max,R),V=E(N),Y=_(a[s]),G=_(a[r]);b==-1&&([G,Y]=[Y,G]),S(k,G,V),S(k,Y,V)}if(!o.spanGaps){let k=[];L&&k.push(...Rf(a,l,s,r,b,_,t)),x.gaps=k=o.gaps(e,i,s,r,k),x.clip=jc(k,c.ori,d,g,y,m)}return F!=0&&(x.band=F==2?[ps(e,i,s,r,T,-1),ps(e,i,s,r,T,1)]:ps(e,i,s,r,T,F)),x})}function T1(n){let t=ve(n.align,1),e=ve(n.ascDesc,!1),i=ve(n.alignGaps,0),s=ve(n.extend,!1);return(r,o,a,l)=>fr(r,o,(c,u,h,f,d,g,y,m,p,_,E)=>{[a,l]=$c(h,a,l);let S=c.pxRound,{left:C,width:b}=r.bbox,x=Q=>S(g(Q,f,_,m)),T=Q=>S(y(Q,d,E,p)),L=f.ori==0?xo:yo,P={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:go},R=P.stroke,F=f.dir*(f.ori==0?1:-1),k=T(h[F==1?a:l]),N=x(u[F==1?a:l]),V=N,Y=N;s&&t==-1&&(Y=C,L(R,Y,k)),L(R,N,k);for(let Q=F==1?a:l;Q>=a&&Q<=l;Q+=F){let it=h[Q];if(it==null)continue;let dt=x(u[Q]),ft=T(it);t==1?L(R,dt,k):L(R,V,ft),L(R,dt,ft),k=ft,V=dt}let G=V;s&&t==1&&(G=C+b,L(R,G,k));let[lt,K]=Cf(r,o);if(c.fill!=null||lt!=0){let Q=P.fill=new Path2D(R),it=c.fillTo(r,o,c.min,c.max,lt),dt=T(it);L(Q,G,dt),L(Q,Y,dt)}if(!c.spanGaps){let Q=[];Q.push(...Rf(u,h,a,l,F,x,i));let it=c.width*be/2,dt=e||t==1?it:-it,ft=e||t==-1?-it:it;Q.forEach(tt=>{tt[0]+=dt,tt[1]+=ft}),P.gaps=Q=c.gaps(r,o,a,l,Q),P.clip=jc(Q,f.ori,m,p,_,E)}return K!=0&&(P.band=K==2?[ps(r,o,a,l,R,-1),ps(r,o,a,l,R,1)]:ps(r,o,a,l,R,K)),P})}function wg(n,t,e,i,s,r,o=De){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let u=_n(n[l]-n[a]);u<c&&(c=u,o=_n(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function A1(n){n=n||Pa;let t=ve(n.size,[.6,De,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=_e(s),o=1-t[0],a=ve(t[1],De),l=ve(t[2],1),c=ve(n.disp,Pa),u=ve(n.each,d=>{}),{fill:h,stroke:f}=c;return(d,g,y,m)=>fr(d,g,(p,_,E,S,C,b,x,T,L,P,R)=>{let F=p.pxRound,k=e,N=i*be,V=a*be,Y=l*be,G,lt;S.ori==0?[G,lt]=r(d,g):[lt,G]=r(d,g);let K=S.dir*(S.ori==0?1:-1),Q=S.ori==0?eh:Pf,it=S.ori==0?u:(Rt,Yt,re,wt,Le,zt,Xt)=>{u(Rt,Yt,re,Le,wt,Xt,zt)},dt=ve(d.bands,bf).find(Rt=>Rt.series[0]==g),ft=dt!=null?dt.dir:0,tt=p.fillTo(d,g,p.min,p.max,ft),ut=F(x(tt,C,R,L)),gt,Mt,bt,Ht=P,se=F(p.width*be),Vt=!1,he=null,ae=null,ne=null,Ge=null;h!=null&&(se==0||f!=null)&&(Vt=!0,he=h.values(d,g,y,m),ae=new Map,new Set(he).forEach(Rt=>{Rt!=null&&ae.set(Rt,new Path2D)}),se>0&&(ne=f.values(d,g,y,m),Ge=new Map,new Set(ne).forEach(Rt=>{Rt!=null&&Ge.set(Rt,new Path2D)})));let{x0:Ue,size:nn}=c;if(Ue!=null&&nn!=null){k=1,_=Ue.values(d,g,y,m),Ue.unit==2&&(_=_.map(re=>d.posToVal(T+re*P,S.key,!0)));let Rt=nn.values(d,g,y,m);nn.unit==2?Mt=Rt[0]*P:Mt=b(Rt[0],S,P,T)-b(0,S,P,T),Ht=wg(_,E,b,S,P,T,Ht),bt=Ht-Mt+N}else Ht=wg(_,E,b,S,P,T,Ht),bt=Ht*o+N,Mt=Ht-bt;bt<1&&(bt=0),se>=Mt/2&&(se=0),bt<5&&(F=Dg);let Re=bt>0,xn=Ht-bt-(Re?se:0);Mt=F(uf(xn,Y,V)),gt=(k==0?Mt/2:k==K?0:Mt)-k*K*((k==0?N/2:0)+(Re?se/2:0));let xe={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},un=Vt?null:new Path2D,Ye=null;if(dt!=null)Ye=d.data[dt.series[1]];else{let{y0:Rt,y1:Yt}=c;Rt!=null&&Yt!=null&&(E=Yt.values(d,g,y,m),Ye=Rt.values(d,g,y,m))}let sn=G*Mt,B=lt*Mt;for(let Rt=K==1?y:m;Rt>=y&&Rt<=m;Rt+=K){let Yt=E[Rt];if(Yt==null)continue;if(Ye!=null){let q=Ye[Rt]??0;if(Yt-q==0)continue;ut=x(q,C,R,L)}let re=S.distr!=2||c!=null?_[Rt]:Rt,wt=b(re,S,P,T),Le=x(ve(Yt,tt),C,R,L),zt=F(wt-gt),Xt=F(Wn(Le,ut)),I=F(Pi(Le,ut)),M=Xt-I;if(Yt!=null){let q=Yt<0?B:sn,ht=Yt<0?sn:B;Vt?(se>0&&ne[Rt]!=null&&Q(Ge.get(ne[Rt]),zt,I+ci(se/2),Mt,Wn(0,M-se),q,ht),he[Rt]!=null&&Q(ae.get(he[Rt]),zt,I+ci(se/2),Mt,Wn(0,M-se),q,ht)):Q(un,zt,I+ci(se/2),Mt,Wn(0,M-se),q,ht),it(d,g,Rt,zt-se/2,I,Mt+se,M)}}return se>0?xe.stroke=Vt?Ge:un:Vt||(xe._fill=p.width==0?p._fill:p._stroke??p._fill,xe.width=0),xe.fill=Vt?ae:un,xe})}function E1(n,t){let e=ve(t?.alignGaps,0);return(i,s,r,o)=>fr(i,s,(a,l,c,u,h,f,d,g,y,m,p)=>{[r,o]=$c(c,r,o);let _=a.pxRound,E=G=>_(f(G,u,m,g)),S=G=>_(d(G,h,p,y)),C,b,x;u.ori==0?(C=Qc,x=xo,b=o0):(C=th,x=yo,b=a0);let T=u.dir*(u.ori==0?1:-1),L=E(l[T==1?r:o]),P=L,R=[],F=[];for(let G=T==1?r:o;G>=r&&G<=o;G+=T)if(c[G]!=null){let K=l[G],Q=E(K);R.push(P=Q),F.push(S(c[G]))}let k={stroke:n(R,F,C,x,b,_),fill:null,clip:null,band:null,gaps:null,flags:go},N=k.stroke,[V,Y]=Cf(i,s);if(a.fill!=null||V!=0){let G=k.fill=new Path2D(N),lt=a.fillTo(i,s,a.min,a.max,V),K=S(lt);x(G,P,K),x(G,L,K)}if(!a.spanGaps){let G=[];G.push(...Rf(l,c,r,o,T,E,e)),k.gaps=G=a.gaps(i,s,r,o,G),k.clip=jc(G,u.ori,g,y,m,p)}return Y!=0&&(k.band=Y==2?[ps(i,s,r,o,N,-1),ps(i,s,r,o,N,1)]:ps(i,s,r,o,N,Y)),k})}function C1(n){return E1(R1,n)}function R1(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=t[f+1]-t[f],h[f]=n[f+1]-n[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,n[f]+h[f]/3,t[f]+l[f]*h[f]/3,n[f+1]-h[f]/3,t[f+1]-l[f+1]*h[f]/3,n[f+1],t[f+1])}return a}var mf=new Set;function Tg(){for(let n of mf)n.syncRect(!0)}_o&&(hr(cw,uo,Tg),hr(hw,uo,Tg,!0),hr(Xc,uo,()=>{en.pxRatio=be}));var P1=h0(),I1=l0();function Ag(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>gf(r,o,t,e))}function L1(n,t){return n.map((e,i)=>i==0?{}:hn({},t,e))}function gf(n,t,e,i){return hn({},t==0?e:i,n)}function u0(n,t,e){return t==null?po:[t,e]}var D1=u0;function N1(n,t,e){return t==null?po:qc(t,e,Sf,!0)}function f0(n,t,e,i){return t==null?po:Zc(t,e,n.scales[i].log,!1)}var U1=f0;function d0(n,t,e,i){return t==null?po:vf(t,e,n.scales[i].log,!1)}var F1=d0;function O1(n,t,e,i,s){let r=Wn(sg(n),sg(t)),o=t-n,a=Ri(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?Gs.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function Eg(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=gn((e=+s)*be))+"px"),[n,t,e]}function B1(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=Ne(t[2]*be,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function en(n,t,e){let i={mode:ve(n.mode,1)},s=i.mode;function r(v,w,D,U){let H=w.valToPct(v);return U+D*(w.dir==-1?1-H:H)}function o(v,w,D,U){let H=w.valToPct(v);return U+D*(w.dir==-1?H:1-H)}function a(v,w,D,U){return w.ori==0?r(v,w,D,U):o(v,w,D,U)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=gi(Xb);if(n.id!=null&&(c.id=n.id),li(c,n.class),n.title){let v=gi($b,c);v.textContent=n.title}let u=Ci("canvas"),h=i.ctx=u.getContext("2d"),f=gi(Zb,c);hr("click",f,v=>{v.target===g&&(Oe!=Sr||He!=Mr)&&An.click(i,v)},!0);let d=i.under=gi(Kb,f);f.appendChild(u);let g=i.over=gi(Jb,f);n=mo(n);let y=+ve(n.pxAlign,1),m=bg(y);(n.plugins||[]).forEach(v=>{v.opts&&(n=v.opts(i,n)||n)});let p=n.ms||.001,_=i.series=s==1?Ag(n.series||[],gg,Sg,!1):L1(n.series||[null],vg),E=i.axes=Ag(n.axes||[],mg,xg,!0),S=i.scales={},C=i.bands=n.bands||[];C.forEach(v=>{v.fill=_e(v.fill||null),v.dir=ve(v.dir,-1)});let b=s==2?_[1].facets[0].scale:_[0].scale,x={axes:Ki,series:fe},T=(n.drawOrder||["axes","series"]).map(v=>x[v]);function L(v){let w=v.distr==3?D=>ds(D>0?D:v.clamp(i,D,v.min,v.max,v.key)):v.distr==4?D=>nf(D,v.asinh):v.distr==100?D=>v.fwd(D):D=>D;return D=>{let U=w(D),{_min:H,_max:J}=v,at=J-H;return(U-H)/at}}function P(v){let w=S[v];if(w==null){let D=(n.scales||Pa)[v]||Pa;if(D.from!=null){P(D.from);let U=hn({},S[D.from],D,{key:v});U.valToPct=L(U),S[v]=U}else{w=S[v]=hn({},v==b?e0:v1,D),w.key=v;let U=w.time,H=w.range,J=Vs(H);if((v!=b||s==2&&!U)&&(J&&(H[0]==null||H[1]==null)&&(H={min:H[0]==null?eg:{mode:1,hard:H[0],soft:H[0]},max:H[1]==null?eg:{mode:1,hard:H[1],soft:H[1]}},J=!1),!J&&Jc(H))){let at=H;H=(pt,vt,Dt)=>vt==null?po:qc(vt,Dt,at)}w.range=_e(H||(U?D1:v==b?w.distr==3?U1:w.distr==4?F1:u0:w.distr==3?f0:w.distr==4?d0:N1)),w.auto=_e(J?!1:w.auto),w.clamp=_e(w.clamp||y1),w._min=w._max=null,w.valToPct=L(w)}}}P("x"),P("y"),s==1&&_.forEach(v=>{P(v.scale)}),E.forEach(v=>{P(v.scale)});for(let v in n.scales)P(v);let R=S[b],F=R.distr,k,N;R.ori==0?(li(c,qb),k=r,N=o):(li(c,Yb),k=o,N=r);let V={};for(let v in S){let w=S[v];(w.min!=null||w.max!=null)&&(V[v]={min:w.min,max:w.max},w.min=w.max=null)}let Y=n.tzDate||(v=>new Date(gn(v/p))),G=n.fmtDate||wf,lt=p==1?qw(Y):Zw(Y),K=fg(Y,ug(p==1?Xw:$w,G)),Q=pg(Y,dg(Jw,G)),it=[],dt=i.legend=hn({},t1,n.legend),ft=i.cursor=hn({},o1,{drag:{y:s==2}},n.cursor),tt=dt.show,ut=ft.show,gt=dt.markers;dt.idxs=it,gt.width=_e(gt.width),gt.dash=_e(gt.dash),gt.stroke=_e(gt.stroke),gt.fill=_e(gt.fill);let Mt,bt,Ht,se=[],Vt=[],he,ae=!1,ne={};if(dt.live){let v=_[1]?_[1].values:null;ae=v!=null,he=ae?v(i,1,0):{_:0};for(let w in he)ne[w]=xf}if(tt)if(Mt=Ci("table",iw,c),Ht=Ci("tbody",null,Mt),dt.mount(i,Mt),ae){bt=Ci("thead",null,Mt,Ht);let v=Ci("tr",null,bt);Ci("th",null,v);for(var Ge in he)Ci("th",Gm,v).textContent=Ge}else li(Mt,rw),dt.live&&li(Mt,sw);let Ue={show:!0},nn={show:!1};function Re(v,w){if(w==0&&(ae||!dt.live||s==2))return po;let D=[],U=Ci("tr",ow,Ht,Ht.childNodes[w]);li(U,v.class),v.show||li(U,cr);let H=Ci("th",null,U);if(gt.show){let pt=gi(aw,H);if(w>0){let vt=gt.width(i,w);vt&&(pt.style.border=vt+"px "+gt.dash(i,w)+" "+gt.stroke(i,w)),pt.style.background=gt.fill(i,w)}}let J=gi(Gm,H);v.label instanceof HTMLElement?J.appendChild(v.label):J.textContent=v.label,w>0&&(gt.show||(J.style.color=v.width>0?gt.stroke(i,w):gt.fill(i,w)),xe("click",H,pt=>{if(ft._lock)return;Zt(pt);let vt=_.indexOf(v);if((pt.ctrlKey||pt.metaKey)!=dt.isolate){let Dt=_.some((Nt,Ft)=>Ft>0&&Ft!=vt&&Nt.show);_.forEach((Nt,Ft)=>{Ft>0&&Ni(Ft,Dt?Ft==vt?Ue:nn:Ue,!0,ln.setSeries)})}else Ni(vt,{show:!v.show},!0,ln.setSeries)},!1),Kt&&xe(qm,H,pt=>{ft._lock||(Zt(pt),Ni(_.indexOf(v),wr,!0,ln.setSeries))},!1));for(var at in he){let pt=Ci("td",lw,U);pt.textContent="--",D.push(pt)}return[U,D]}let xn=new Map;function xe(v,w,D,U=!0){let H=xn.get(w)||{},J=ft.bind[v](i,w,D,U);J&&(hr(v,w,H[v]=J),xn.set(w,H))}function un(v,w,D){let U=xn.get(w)||{};for(let H in U)(v==null||H==v)&&(hf(H,w,U[H]),delete U[H]);v==null&&xn.delete(w)}let Ye=0,sn=0,B=0,Rt=0,Yt=0,re=0,wt=Yt,Le=re,zt=B,Xt=Rt,I=0,M=0,q=0,ht=0;i.bbox={};let ot=!1,xt=!1,yt=!1,et=!1,st=!1,mt=!1;function O(v,w,D){(D||v!=i.width||w!=i.height)&&rt(v,w),le(!1),yt=!0,xt=!0,Rn()}function rt(v,w){i.width=Ye=B=v,i.height=sn=Rt=w,Yt=re=0,St(),Gt();let D=i.bbox;I=D.left=ar(Yt*be,.5),M=D.top=ar(re*be,.5),q=D.width=ar(B*be,.5),ht=D.height=ar(Rt*be,.5)}let nt=3;function Tt(){let v=!1,w=0;for(;!v;){w++;let D=xr(w),U=Di(w);v=w==nt||D&&U,v||(rt(i.width,i.height),xt=!0)}}function _t({width:v,height:w}){O(v,w)}i.setSize=_t;function St(){let v=!1,w=!1,D=!1,U=!1;E.forEach((H,J)=>{if(H.show&&H._show){let{side:at,_size:pt}=H,vt=at%2,Dt=H.label!=null?H.labelSize:0,Nt=pt+Dt;Nt>0&&(vt?(B-=Nt,at==3?(Yt+=Nt,U=!0):D=!0):(Rt-=Nt,at==0?(re+=Nt,v=!0):w=!0))}}),Ii[0]=v,Ii[1]=D,Ii[2]=w,Ii[3]=U,B-=xi[1]+xi[3],Yt+=xi[3],Rt-=xi[2]+xi[0],re+=xi[0]}function Gt(){let v=Yt+B,w=re+Rt,D=Yt,U=re;function H(J,at){switch(J){case 1:return v+=at,v-at;case 2:return w+=at,w-at;case 3:return D-=at,D+at;case 0:return U-=at,U+at}}E.forEach((J,at)=>{if(J.show&&J._show){let pt=J.side;J._pos=H(pt,J._size),J.label!=null&&(J._lpos=H(pt,J.labelSize))}})}if(ft.dataIdx==null){let v=ft.hover,w=v.skip=new Set(v.skip??[]);w.add(void 0);let D=v.prox=_e(v.prox),U=v.bias??=0;ft.dataIdx=(H,J,at,pt)=>{if(J==0)return at;let vt=at,Dt=D(H,J,at,pt)??De,Nt=Dt>=0&&Dt<De,Ft=R.ori==0?B:Rt,ie=ft.left,Se=t[0],ye=t[J];if(w.has(ye[at])){vt=null;let pe=null,$t=null,Wt;if(U==0||U==-1)for(Wt=at;pe==null&&Wt-- >0;)w.has(ye[Wt])||(pe=Wt);if(U==0||U==1)for(Wt=at;$t==null&&Wt++<ye.length;)w.has(ye[Wt])||($t=Wt);if(pe!=null||$t!=null)if(Nt){let ke=pe==null?-1/0:k(Se[pe],R,Ft,0),Ke=$t==null?1/0:k(Se[$t],R,Ft,0),Mn=ie-ke,Pe=Ke-ie;Mn<=Pe?Mn<=Dt&&(vt=pe):Pe<=Dt&&(vt=$t)}else vt=$t==null?pe:pe==null?$t:at-pe<=$t-at?pe:$t}else Nt&&_n(ie-k(Se[at],R,Ft,0))>Dt&&(vt=null);return vt}}let Zt=v=>{ft.event=v};ft.idxs=it,ft._lock=!1;let ct=ft.points;ct.show=_e(ct.show),ct.size=_e(ct.size),ct.stroke=_e(ct.stroke),ct.width=_e(ct.width),ct.fill=_e(ct.fill);let Ot=i.focus=hn({},n.focus||{alpha:.3},ft.focus),Kt=Ot.prox>=0,Ct=Kt&&ct.one,oe=[],Fe=[],Dn=[];function So(v,w){let D=ct.show(i,w);if(D instanceof HTMLElement)return li(D,nw),li(D,v.class),qi(D,-10,-10,B,Rt),g.insertBefore(D,oe[w]),D}function mr(v,w){if(s==1||w>0){let D=s==1&&S[v.scale].time,U=v.value;v.value=D?ag(U)?pg(Y,dg(U,G)):U||Q:U||g1,v.label=v.label||(D?l1:a1)}if(Ct||w>0){v.width=v.width==null?1:v.width,v.paths=v.paths||P1||vw,v.fillTo=_e(v.fillTo||S1),v.pxAlign=+ve(v.pxAlign,y),v.pxRound=bg(v.pxAlign),v.stroke=_e(v.stroke||null),v.fill=_e(v.fill||null),v._stroke=v._fill=v._paths=v._focus=null;let D=_1(Wn(1,v.width),1),U=v.points=hn({},{size:D,width:Wn(1,D*.2),stroke:v.stroke,space:D*2,paths:I1,_stroke:null,_fill:null},v.points);U.show=_e(U.show),U.filter=_e(U.filter),U.fill=_e(U.fill),U.stroke=_e(U.stroke),U.paths=_e(U.paths),U.pxAlign=v.pxAlign}if(tt){let D=Re(v,w);se.splice(w,0,D[0]),Vt.splice(w,0,D[1]),dt.values.push(null)}if(ut){it.splice(w,0,null);let D=null;Ct?w==0&&(D=So(v,w)):w>0&&(D=So(v,w)),oe.splice(w,0,D),Fe.splice(w,0,0),Dn.splice(w,0,0)}Sn("addSeries",w)}function hh(v,w){w=w??_.length,v=s==1?gf(v,w,gg,Sg):gf(v,w,{},vg),_.splice(w,0,v),mr(_[w],w)}i.addSeries=hh;function Da(v){if(_.splice(v,1),tt){dt.values.splice(v,1),Vt.splice(v,1);let w=se.splice(v,1)[0];un(null,w.firstChild),w.remove()}ut&&(it.splice(v,1),oe.splice(v,1)[0].remove(),Fe.splice(v,1),Dn.splice(v,1)),Sn("delSeries",v)}i.delSeries=Da;let Ii=[!1,!1,!1,!1];function Yi(v,w){if(v._show=v.show,v.show){let D=v.side%2,U=S[v.scale];U==null&&(v.scale=D?_[1].scale:b,U=S[v.scale]);let H=U.time;v.size=_e(v.size),v.space=_e(v.space),v.rotate=_e(v.rotate),Vs(v.incrs)&&v.incrs.forEach(at=>{!Gs.has(at)&&Gs.set(at,Fg(at))}),v.incrs=_e(v.incrs||(U.distr==2?Gw:H?p==1?Ww:Yw:lr)),v.splits=_e(v.splits||(H&&U.distr==1?lt:U.distr==3?ff:U.distr==4?u1:h1)),v.stroke=_e(v.stroke),v.grid.stroke=_e(v.grid.stroke),v.ticks.stroke=_e(v.ticks.stroke),v.border.stroke=_e(v.border.stroke);let J=v.values;v.values=Vs(J)&&!Vs(J[0])?_e(J):H?Vs(J)?fg(Y,ug(J,G)):ag(J)?Kw(Y,J):J||K:J||c1,v.filter=_e(v.filter||(U.distr>=3&&U.log==10?p1:U.distr==3&&U.log==2?m1:Ng)),v.font=Eg(v.font),v.labelFont=Eg(v.labelFont),v._size=v.size(i,null,w,0),v._space=v._rotate=v._incrs=v._found=v._splits=v._values=null,v._size>0&&(Ii[w]=!0,v._el=gi(jb,f))}}function $i(v,w,D,U){let[H,J,at,pt]=D,vt=w%2,Dt=0;return vt==0&&(pt||J)&&(Dt=w==0&&!H||w==2&&!at?gn(mg.size/3):0),vt==1&&(H||at)&&(Dt=w==1&&!J||w==3&&!pt?gn(xg.size/2):0),Dt}let Mo=i.padding=(n.padding||[$i,$i,$i,$i]).map(v=>_e(ve(v,$i))),xi=i._padding=Mo.map((v,w)=>v(i,w,Ii,0)),$e,Qe=null,tn=null,Li=s==1?_[0].idxs:null,Zn=null,ms=!1;function bo(v,w){if(t=v??[],i.data=i._data=t,s==2){$e=0;for(let D=1;D<_.length;D++)$e+=t[D][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),Zn=t[0],$e=Zn.length;let D=t;if(F==2){D=t.slice();let U=D[0]=Array($e);for(let H=0;H<$e;H++)U[H]=H}i._data=t=D}if(le(!0),Sn("setData"),F==2&&(yt=!0),w!==!1){let D=R;D.auto(i,ms)?wo():xs(b,D.min,D.max),et=et||ft.left>=0,mt=!0,Rn()}}i.setData=bo;function wo(){ms=!0;let v,w;s==1&&($e>0?(Qe=Li[0]=0,tn=Li[1]=$e-1,v=t[0][Qe],w=t[0][tn],F==2?(v=Qe,w=tn):v==w&&(F==3?[v,w]=Zc(v,v,R.log,!1):F==4?[v,w]=vf(v,v,R.log,!1):R.time?w=v+gn(86400/p):[v,w]=qc(v,w,Sf,!0))):(Qe=Li[0]=v=null,tn=Li[1]=w=null)),xs(b,v,w)}let gr,gs,_r,A,z,j,$,Z,At,Pt;function Et(v,w,D,U,H,J){v??=Wm,D??=bf,U??="butt",H??=Wm,J??="round",v!=gr&&(h.strokeStyle=gr=v),H!=gs&&(h.fillStyle=gs=H),w!=_r&&(h.lineWidth=_r=w),J!=z&&(h.lineJoin=z=J),U!=j&&(h.lineCap=j=U),D!=A&&h.setLineDash(A=D)}function It(v,w,D,U){w!=gs&&(h.fillStyle=gs=w),v!=$&&(h.font=$=v),D!=Z&&(h.textAlign=Z=D),U!=At&&(h.textBaseline=At=U)}function kt(v,w,D,U,H=0){if(U.length>0&&v.auto(i,ms)&&(w==null||w.min==null)){let J=ve(Qe,0),at=ve(tn,U.length-1),pt=D.min==null?pw(U,J,at,H,v.distr==3):[D.min,D.max];v.min=Pi(v.min,D.min=pt[0]),v.max=Wn(v.max,D.max=pt[1])}}let jt={min:null,max:null};function ue(){for(let U in S){let H=S[U];V[U]==null&&(H.min==null||V[b]!=null&&H.auto(i,ms))&&(V[U]=jt)}for(let U in S){let H=S[U];V[U]==null&&H.from!=null&&V[H.from]!=null&&(V[U]=jt)}V[b]!=null&&le(!0);let v={};for(let U in V){let H=V[U];if(H!=null){let J=v[U]=mo(S[U],bw);if(H.min!=null)hn(J,H);else if(U!=b||s==2)if($e==0&&J.from==null){let at=J.range(i,null,null,U);J.min=at[0],J.max=at[1]}else J.min=De,J.max=-De}}if($e>0){_.forEach((U,H)=>{if(s==1){let J=U.scale,at=V[J];if(at==null)return;let pt=v[J];if(H==0){let vt=pt.range(i,pt.min,pt.max,J);pt.min=vt[0],pt.max=vt[1],Qe=Ri(pt.min,t[0]),tn=Ri(pt.max,t[0]),tn-Qe>1&&(t[0][Qe]<pt.min&&Qe++,t[0][tn]>pt.max&&tn--),U.min=Zn[Qe],U.max=Zn[tn]}else U.show&&U.auto&&kt(pt,at,U,t[H],U.sorted);U.idxs[0]=Qe,U.idxs[1]=tn}else if(H>0&&U.show&&U.auto){let[J,at]=U.facets,pt=J.scale,vt=at.scale,[Dt,Nt]=t[H],Ft=v[pt],ie=v[vt];Ft!=null&&kt(Ft,V[pt],J,Dt,J.sorted),ie!=null&&kt(ie,V[vt],at,Nt,at.sorted),U.min=at.min,U.max=at.max}});for(let U in v){let H=v[U],J=V[U];if(H.from==null&&(J==null||J.min==null)){let at=H.range(i,H.min==De?null:H.min,H.max==-De?null:H.max,U);H.min=at[0],H.max=at[1]}}}for(let U in v){let H=v[U];if(H.from!=null){let J=v[H.from];if(J.min==null)H.min=H.max=null;else{let at=H.range(i,J.min,J.max,U);H.min=at[0],H.max=at[1]}}}let w={},D=!1;for(let U in v){let H=v[U],J=S[U];if(J.min!=H.min||J.max!=H.max){J.min=H.min,J.max=H.max;let at=J.distr;J._min=at==3?ds(J.min):at==4?nf(J.min,J.asinh):at==100?J.fwd(J.min):J.min,J._max=at==3?ds(J.max):at==4?nf(J.max,J.asinh):at==100?J.fwd(J.max):J.max,w[U]=D=!0}}if(D){_.forEach((U,H)=>{s==2?H>0&&w.y&&(U._paths=null):w[U.scale]&&(U._paths=null)});for(let U in w)yt=!0,Sn("setScale",U);ut&&ft.left>=0&&(et=mt=!0)}for(let U in V)V[U]=null}function Bt(v){let w=uf(Qe-1,0,$e-1),D=uf(tn+1,0,$e-1);for(;v[w]==null&&w>0;)w--;for(;v[D]==null&&D<$e-1;)D++;return[w,D]}function fe(){if($e>0){let v=_.some(w=>w._focus)&&Pt!=Ot.alpha;v&&(h.globalAlpha=Pt=Ot.alpha),_.forEach((w,D)=>{if(D>0&&w.show&&(qe(D,!1),qe(D,!0),w._paths==null)){let U=Pt;Pt!=w.alpha&&(h.globalAlpha=Pt=w.alpha);let H=s==2?[0,t[D][0].length-1]:Bt(t[D]);w._paths=w.paths(i,D,H[0],H[1]),Pt!=U&&(h.globalAlpha=Pt=U)}}),_.forEach((w,D)=>{if(D>0&&w.show){let U=Pt;Pt!=w.alpha&&(h.globalAlpha=Pt=w.alpha),w._paths!=null&&Ae(D,!1);{let H=w._paths!=null?w._paths.gaps:null,J=w.points.show(i,D,Qe,tn,H),at=w.points.filter(i,D,J,H);(J||at)&&(w.points._paths=w.points.paths(i,D,Qe,tn,at),Ae(D,!0))}Pt!=U&&(h.globalAlpha=Pt=U),Sn("drawSeries",D)}}),v&&(h.globalAlpha=Pt=1)}}function qe(v,w){let D=w?_[v].points:_[v];D._stroke=D.stroke(i,v),D._fill=D.fill(i,v)}function Ae(v,w){let D=w?_[v].points:_[v],{stroke:U,fill:H,clip:J,flags:at,_stroke:pt=D._stroke,_fill:vt=D._fill,_width:Dt=D.width}=D._paths;Dt=Ne(Dt*be,3);let Nt=null,Ft=Dt%2/2;w&&vt==null&&(vt=Dt>0?"#fff":pt);let ie=D.pxAlign==1&&Ft>0;if(ie&&h.translate(Ft,Ft),!w){let Se=I-Dt/2,ye=M-Dt/2,pe=q+Dt,$t=ht+Dt;Nt=new Path2D,Nt.rect(Se,ye,pe,$t)}w?Ut(pt,Dt,D.dash,D.cap,vt,U,H,at,J):Ee(v,pt,Dt,D.dash,D.cap,vt,U,H,at,Nt,J),ie&&h.translate(-Ft,-Ft)}function Ee(v,w,D,U,H,J,at,pt,vt,Dt,Nt){let Ft=!1;vt!=0&&C.forEach((ie,Se)=>{if(ie.series[0]==v){let ye=_[ie.series[1]],pe=t[ie.series[1]],$t=(ye._paths||Pa).band;Vs($t)&&($t=ie.dir==1?$t[0]:$t[1]);let Wt,ke=null;ye.show&&$t&&gw(pe,Qe,tn)?(ke=ie.fill(i,Se)||J,Wt=ye._paths.clip):$t=null,Ut(w,D,U,H,ke,at,pt,vt,Dt,Nt,Wt,$t),Ft=!0}}),Ft||Ut(w,D,U,H,J,at,pt,vt,Dt,Nt)}let fn=go|pf;function Ut(v,w,D,U,H,J,at,pt,vt,Dt,Nt,Ft){Et(v,w,D,U,H),(vt||Dt||Ft)&&(h.save(),vt&&h.clip(vt),Dt&&h.clip(Dt)),Ft?(pt&fn)==fn?(h.clip(Ft),Nt&&h.clip(Nt),me(H,at),rn(v,J,w)):pt&pf?(me(H,at),h.clip(Ft),rn(v,J,w)):pt&go&&(h.save(),h.clip(Ft),Nt&&h.clip(Nt),me(H,at),h.restore(),rn(v,J,w)):(me(H,at),rn(v,J,w)),(vt||Dt||Ft)&&h.restore()}function rn(v,w,D){D>0&&(w instanceof Map?w.forEach((U,H)=>{h.strokeStyle=gr=H,h.stroke(U)}):w!=null&&v&&h.stroke(w))}function me(v,w){w instanceof Map?w.forEach((D,U)=>{h.fillStyle=gs=U,h.fill(D)}):w!=null&&v&&h.fill(w)}function Zi(v,w,D,U){let H=E[v],J;if(U<=0)J=[0,0];else{let at=H._space=H.space(i,v,w,D,U),pt=H._incrs=H.incrs(i,v,w,D,U,at);J=O1(w,D,pt,U,at)}return H._found=J}function on(v,w,D,U,H,J,at,pt,vt,Dt){let Nt=at%2/2;y==1&&h.translate(Nt,Nt),Et(pt,at,vt,Dt,pt),h.beginPath();let Ft,ie,Se,ye,pe=H+(U==0||U==3?-J:J);D==0?(ie=H,ye=pe):(Ft=H,Se=pe);for(let $t=0;$t<v.length;$t++)w[$t]!=null&&(D==0?Ft=Se=v[$t]:ie=ye=v[$t],h.moveTo(Ft,ie),h.lineTo(Se,ye));h.stroke(),y==1&&h.translate(-Nt,-Nt)}function xr(v){let w=!0;return E.forEach((D,U)=>{if(!D.show)return;let H=S[D.scale];if(H.min==null){D._show&&(w=!1,D._show=!1,le(!1));return}else D._show||(w=!1,D._show=!0,le(!1));let J=D.side,at=J%2,{min:pt,max:vt}=H,[Dt,Nt]=Zi(U,pt,vt,at==0?B:Rt);if(Nt==0)return;let Ft=H.distr==2,ie=D._splits=D.splits(i,U,pt,vt,Dt,Nt,Ft),Se=H.distr==2?ie.map(Wt=>Zn[Wt]):ie,ye=H.distr==2?Zn[ie[1]]-Zn[ie[0]]:Dt,pe=D._values=D.values(i,D.filter(i,Se,U,Nt,ye),U,Nt,ye);D._rotate=J==2?D.rotate(i,pe,U,Nt):0;let $t=D._size;D._size=_i(D.size(i,pe,U,v)),$t!=null&&D._size!=$t&&(w=!1)}),w}function Di(v){let w=!0;return Mo.forEach((D,U)=>{let H=D(i,U,Ii,v);H!=xi[U]&&(w=!1),xi[U]=H}),w}function Ki(){for(let v=0;v<E.length;v++){let w=E[v];if(!w.show||!w._show)continue;let D=w.side,U=D%2,H,J,at=w.stroke(i,v),pt=D==0||D==3?-1:1,[vt,Dt]=w._found;if(w.label!=null){let Fn=w.labelGap*pt,jn=gn((w._lpos+Fn)*be);It(w.labelFont[0],at,"center",D==2?"top":Hm),h.save(),U==1?(H=J=0,h.translate(jn,gn(M+ht/2)),h.rotate((D==3?-Wc:Wc)/2)):(H=gn(I+q/2),J=jn);let Xs=Lg(w.label)?w.label(i,v,vt,Dt):w.label;h.fillText(Xs,H,J),h.restore()}if(Dt==0)continue;let Nt=S[w.scale],Ft=U==0?q:ht,ie=U==0?I:M,Se=w._splits,ye=Nt.distr==2?Se.map(Fn=>Zn[Fn]):Se,pe=Nt.distr==2?Zn[Se[1]]-Zn[Se[0]]:vt,$t=w.ticks,Wt=w.border,ke=$t.show?$t.size:0,Ke=gn(ke*be),Mn=gn((w.alignTo==2?w._size-ke-w.gap:w.gap)*be),Pe=w._rotate*-Wc/180,Je=m(w._pos*be),Kn=(Ke+Mn)*pt,Un=Je+Kn;J=U==0?Un:0,H=U==1?Un:0;let ui=w.font[0],yi=w.align==1?co:w.align==2?Qu:Pe>0?co:Pe<0?Qu:U==0?"center":D==3?Qu:co,Fi=Pe||U==1?"middle":D==2?"top":Hm;It(ui,at,yi,Fi);let Jn=w.font[1]*w.lineGap,fi=Se.map(Fn=>m(a(Fn,Nt,Ft,ie))),vi=w._values;for(let Fn=0;Fn<vi.length;Fn++){let jn=vi[Fn];if(jn!=null){U==0?H=fi[Fn]:J=fi[Fn],jn=""+jn;let Xs=jn.indexOf(`
`)==-1?[jn]:jn.split(/\n/gm);for(let On=0;On<Xs.length;On++){let sd=Xs[On];Pe?(h.save(),h.translate(H,J+On*Jn),h.rotate(Pe),h.fillText(sd,0,0),h.restore()):h.fillText(sd,H,J+On*Jn)}}}$t.show&&on(fi,$t.filter(i,ye,v,Dt,pe),U,D,Je,Ke,Ne($t.width*be,3),$t.stroke(i,v),$t.dash,$t.cap);let Oi=w.grid;Oi.show&&on(fi,Oi.filter(i,ye,v,Dt,pe),U,U==0?2:1,U==0?M:I,U==0?ht:q,Ne(Oi.width*be,3),Oi.stroke(i,v),Oi.dash,Oi.cap),Wt.show&&on([Je],[1],U==0?1:0,U==0?1:2,U==1?M:I,U==1?ht:q,Ne(Wt.width*be,3),Wt.stroke(i,v),Wt.dash,Wt.cap)}Sn("drawAxes")}function le(v){_.forEach((w,D)=>{D>0&&(w._paths=null,v&&(s==1?(w.min=null,w.max=null):w.facets.forEach(U=>{U.min=null,U.max=null})))})}let Ze=!1,Nn=!1,Ce=[];function an(){Nn=!1;for(let v=0;v<Ce.length;v++)Sn(...Ce[v]);Ce.length=0}function Rn(){Ze||(Pw(zf),Ze=!0)}function Na(v,w=!1){Ze=!0,Nn=w,v(i),zf(),w&&Ce.length>0&&queueMicrotask(an)}i.batch=Na;function zf(){if(ot&&(ue(),ot=!1),yt&&(Tt(),yt=!1),xt){if(Ve(d,co,Yt),Ve(d,"top",re),Ve(d,Aa,B),Ve(d,Ea,Rt),Ve(g,co,Yt),Ve(g,"top",re),Ve(g,Aa,B),Ve(g,Ea,Rt),Ve(f,Aa,Ye),Ve(f,Ea,sn),u.width=gn(Ye*be),u.height=gn(sn*be),E.forEach(({_el:v,_show:w,_size:D,_pos:U,side:H})=>{if(v!=null)if(w){let J=H===3||H===0?D:0,at=H%2==1;Ve(v,at?"left":"top",U-J),Ve(v,at?"width":"height",D),Ve(v,at?"top":"left",at?re:Yt),Ve(v,at?"height":"width",at?Rt:B),cf(v,cr)}else li(v,cr)}),gr=gs=_r=z=j=$=Z=At=A=null,Pt=1,Eo(!0),Yt!=wt||re!=Le||B!=zt||Rt!=Xt){le(!1);let v=B/zt,w=Rt/Xt;if(ut&&!et&&ft.left>=0){ft.left*=v,ft.top*=w,yr&&qi(yr,gn(ft.left),0,B,Rt),vr&&qi(vr,0,gn(ft.top),B,Rt);for(let D=0;D<oe.length;D++){let U=oe[D];U!=null&&(Fe[D]*=v,Dn[D]*=w,qi(U,_i(Fe[D]),_i(Dn[D]),B,Rt))}}if(Be.show&&!st&&Be.left>=0&&Be.width>0){Be.left*=v,Be.width*=v,Be.top*=w,Be.height*=w;for(let D in gh)Ve(br,D,Be[D])}wt=Yt,Le=re,zt=B,Xt=Rt}Sn("setSize"),xt=!1}Ye>0&&sn>0&&(h.clearRect(0,0,u.width,u.height),Sn("drawClear"),T.forEach(v=>v()),Sn("draw")),Be.show&&st&&(Ua(Be),st=!1),ut&&et&&(Ws(null,!0,!1),et=!1),dt.show&&dt.live&&mt&&(ph(),mt=!1),l||(l=!0,i.status=1,Sn("ready")),ms=!1,Ze=!1}i.redraw=(v,w)=>{yt=w||!1,v!==!1?xs(b,R.min,R.max):Rn()};function uh(v,w){let D=S[v];if(D.from==null){if($e==0){let U=D.range(i,w.min,w.max,v);w.min=U[0],w.max=U[1]}if(w.min>w.max){let U=w.min;w.min=w.max,w.max=U}if($e>1&&w.min!=null&&w.max!=null&&w.max-w.min<1e-16)return;v==b&&D.distr==2&&$e>0&&(w.min=Ri(w.min,t[0]),w.max=Ri(w.max,t[0]),w.min==w.max&&w.max++),V[v]=w,ot=!0,Rn()}}i.setScale=uh;let fh,dh,yr,vr,Vf,Gf,Sr,Mr,Hf,Wf,Oe,He,_s=!1,An=ft.drag,yn=An.x,vn=An.y;ut&&(ft.x&&(fh=gi(tw,g)),ft.y&&(dh=gi(ew,g)),R.ori==0?(yr=fh,vr=dh):(yr=dh,vr=fh),Oe=ft.left,He=ft.top);let Be=i.select=hn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),br=Be.show?gi(Qb,Be.over?g:d):null;function Ua(v,w){if(Be.show){for(let D in v)Be[D]=v[D],D in gh&&Ve(br,D,v[D]);w!==!1&&Sn("setSelect")}}i.setSelect=Ua;function N0(v){if(_[v].show)tt&&cf(se[v],cr);else if(tt&&li(se[v],cr),ut){let D=Ct?oe[0]:oe[v];D!=null&&qi(D,-10,-10,B,Rt)}}function xs(v,w,D){uh(v,{min:w,max:D})}function Ni(v,w,D,U){w.focus!=null&&k0(v),w.show!=null&&_.forEach((H,J)=>{J>0&&(v==J||v==null)&&(H.show=w.show,N0(J),s==2?(xs(H.facets[0].scale,null,null),xs(H.facets[1].scale,null,null)):xs(H.scale,null,null),Rn())}),D!==!1&&Sn("setSeries",v,w),U&&Co("setSeries",i,v,w)}i.setSeries=Ni;function U0(v,w){hn(C[v],w)}function F0(v,w){v.fill=_e(v.fill||null),v.dir=ve(v.dir,-1),w=w??C.length,C.splice(w,0,v)}function O0(v){v==null?C.length=0:C.splice(v,1)}i.addBand=F0,i.setBand=U0,i.delBand=O0;function B0(v,w){_[v].alpha=w,ut&&oe[v]!=null&&(oe[v].style.opacity=w),tt&&se[v]&&(se[v].style.opacity=w)}let Ji,ys,Hs,wr={focus:!0};function k0(v){if(v!=Hs){let w=v==null,D=Ot.alpha!=1;_.forEach((U,H)=>{if(s==1||H>0){let J=w||H==0||H==v;U._focus=w?null:J,D&&B0(H,J?1:Ot.alpha)}}),Hs=v,D&&Rn()}}tt&&Kt&&xe(Ym,Mt,v=>{ft._lock||(Zt(v),Hs!=null&&Ni(null,wr,!0,ln.setSeries))});function Ui(v,w,D){let U=S[w];D&&(v=v/be-(U.ori==1?re:Yt));let H=B;U.ori==1&&(H=Rt,v=H-v),U.dir==-1&&(v=H-v);let J=U._min,at=U._max,pt=v/H,vt=J+(at-J)*pt,Dt=U.distr;return Dt==3?fo(10,vt):Dt==4?xw(vt,U.asinh):Dt==100?U.bwd(vt):vt}function z0(v,w){let D=Ui(v,b,w);return Ri(D,t[0],Qe,tn)}i.valToIdx=v=>Ri(v,t[0]),i.posToIdx=z0,i.posToVal=Ui,i.valToPos=(v,w,D)=>S[w].ori==0?r(v,S[w],D?q:B,D?I:0):o(v,S[w],D?ht:Rt,D?M:0),i.setCursor=(v,w,D)=>{Oe=v.left,He=v.top,Ws(null,w,D)};function Xf(v,w){Ve(br,co,Be.left=v),Ve(br,Aa,Be.width=w)}function qf(v,w){Ve(br,"top",Be.top=v),Ve(br,Ea,Be.height=w)}let To=R.ori==0?Xf:qf,Ao=R.ori==1?Xf:qf;function V0(){if(tt&&dt.live)for(let v=s==2?1:0;v<_.length;v++){if(v==0&&ae)continue;let w=dt.values[v],D=0;for(let U in w)Vt[v][D++].firstChild.nodeValue=w[U]}}function ph(v,w){if(v!=null&&(v.idxs?v.idxs.forEach((D,U)=>{it[U]=D}):Mw(v.idx)||it.fill(v.idx),dt.idx=it[0]),tt&&dt.live){for(let D=0;D<_.length;D++)(D>0||s==1&&!ae)&&G0(D,it[D]);V0()}mt=!1,w!==!1&&Sn("setLegend")}i.setLegend=ph;function G0(v,w){let D=_[v],U=v==0&&F==2?Zn:t[v],H;ae?H=D.values(i,v,w)??ne:(H=D.value(i,w==null?null:U[w],v,w),H=H==null?ne:{_:H}),dt.values[v]=H}function Ws(v,w,D){Hf=Oe,Wf=He,[Oe,He]=ft.move(i,Oe,He),ft.left=Oe,ft.top=He,ut&&(yr&&qi(yr,gn(Oe),0,B,Rt),vr&&qi(vr,0,gn(He),B,Rt));let U,H=Qe>tn;Ji=De,ys=null;let J=R.ori==0?B:Rt,at=R.ori==1?B:Rt;if(Oe<0||$e==0||H){U=ft.idx=null;for(let pt=0;pt<_.length;pt++){let vt=oe[pt];vt!=null&&qi(vt,-10,-10,B,Rt)}Kt&&Ni(null,wr,!0,v==null&&ln.setSeries),dt.live&&(it.fill(U),mt=!0)}else{let pt,vt,Dt;s==1&&(pt=R.ori==0?Oe:He,vt=Ui(pt,b),U=ft.idx=Ri(vt,t[0],Qe,tn),Dt=k(t[0][U],R,J,0));let Nt=-10,Ft=-10,ie=0,Se=0,ye=!0,pe="",$t="";for(let Wt=s==2?1:0;Wt<_.length;Wt++){let ke=_[Wt],Ke=it[Wt],Mn=Ke==null?null:s==1?t[Wt][Ke]:t[Wt][1][Ke],Pe=ft.dataIdx(i,Wt,U,vt),Je=Pe==null?null:s==1?t[Wt][Pe]:t[Wt][1][Pe];if(mt=mt||Je!=Mn||Pe!=Ke,it[Wt]=Pe,Wt>0&&ke.show){let Kn=Pe==null?-10:Pe==U?Dt:k(s==1?t[0][Pe]:t[Wt][0][Pe],R,J,0),Un=Je==null?-10:N(Je,s==1?S[ke.scale]:S[ke.facets[1].scale],at,0);if(Kt&&Je!=null){let ui=R.ori==1?Oe:He,yi=_n(Ot.dist(i,Wt,Pe,Un,ui));if(yi<Ji){let Fi=Ot.bias;if(Fi!=0){let Jn=Ui(ui,ke.scale),fi=Je>=0?1:-1,vi=Jn>=0?1:-1;vi==fi&&(vi==1?Fi==1?Je>=Jn:Je<=Jn:Fi==1?Je<=Jn:Je>=Jn)&&(Ji=yi,ys=Wt)}else Ji=yi,ys=Wt}}if(mt||Ct){let ui,yi;R.ori==0?(ui=Kn,yi=Un):(ui=Un,yi=Kn);let Fi,Jn,fi,vi,Oi,Fn,jn=!0,Xs=ct.bbox;if(Xs!=null){jn=!1;let On=Xs(i,Wt);fi=On.left,vi=On.top,Fi=On.width,Jn=On.height}else fi=ui,vi=yi,Fi=Jn=ct.size(i,Wt);if(Fn=ct.fill(i,Wt),Oi=ct.stroke(i,Wt),Ct)Wt==ys&&Ji<=Ot.prox&&(Nt=fi,Ft=vi,ie=Fi,Se=Jn,ye=jn,pe=Fn,$t=Oi);else{let On=oe[Wt];On!=null&&(Fe[Wt]=fi,Dn[Wt]=vi,tg(On,Fi,Jn,jn),jm(On,Fn,Oi),qi(On,_i(fi),_i(vi),B,Rt))}}}}if(Ct){let Wt=Ot.prox,ke=Hs==null?Ji<=Wt:Ji>Wt||ys!=Hs;if(mt||ke){let Ke=oe[0];Ke!=null&&(Fe[0]=Nt,Dn[0]=Ft,tg(Ke,ie,Se,ye),jm(Ke,pe,$t),qi(Ke,_i(Nt),_i(Ft),B,Rt))}}}if(Be.show&&_s)if(v!=null){let[pt,vt]=ln.scales,[Dt,Nt]=ln.match,[Ft,ie]=v.cursor.sync.scales,Se=v.cursor.drag;if(yn=Se._x,vn=Se._y,yn||vn){let{left:ye,top:pe,width:$t,height:Wt}=v.select,ke=v.scales[Ft].ori,Ke=v.posToVal,Mn,Pe,Je,Kn,Un,ui=pt!=null&&Dt(pt,Ft),yi=vt!=null&&Nt(vt,ie);ui&&yn?(ke==0?(Mn=ye,Pe=$t):(Mn=pe,Pe=Wt),Je=S[pt],Kn=k(Ke(Mn,Ft),Je,J,0),Un=k(Ke(Mn+Pe,Ft),Je,J,0),To(Pi(Kn,Un),_n(Un-Kn))):To(0,J),yi&&vn?(ke==1?(Mn=ye,Pe=$t):(Mn=pe,Pe=Wt),Je=S[vt],Kn=N(Ke(Mn,ie),Je,at,0),Un=N(Ke(Mn+Pe,ie),Je,at,0),Ao(Pi(Kn,Un),_n(Un-Kn))):Ao(0,at)}else _h()}else{let pt=_n(Hf-Vf),vt=_n(Wf-Gf);if(R.ori==1){let ie=pt;pt=vt,vt=ie}yn=An.x&&pt>=An.dist,vn=An.y&&vt>=An.dist;let Dt=An.uni;Dt!=null?yn&&vn&&(yn=pt>=Dt,vn=vt>=Dt,!yn&&!vn&&(vt>pt?vn=!0:yn=!0)):An.x&&An.y&&(yn||vn)&&(yn=vn=!0);let Nt,Ft;yn&&(R.ori==0?(Nt=Sr,Ft=Oe):(Nt=Mr,Ft=He),To(Pi(Nt,Ft),_n(Ft-Nt)),vn||Ao(0,at)),vn&&(R.ori==1?(Nt=Sr,Ft=Oe):(Nt=Mr,Ft=He),Ao(Pi(Nt,Ft),_n(Ft-Nt)),yn||To(0,J)),!yn&&!vn&&(To(0,0),Ao(0,0))}if(An._x=yn,An._y=vn,v==null){if(D){if(id!=null){let[pt,vt]=ln.scales;ln.values[0]=pt!=null?Ui(R.ori==0?Oe:He,pt):null,ln.values[1]=vt!=null?Ui(R.ori==1?Oe:He,vt):null}Co(tf,i,Oe,He,B,Rt,U)}if(Kt){let pt=D&&ln.setSeries,vt=Ot.prox;Hs==null?Ji<=vt&&Ni(ys,wr,!0,pt):Ji>vt?Ni(null,wr,!0,pt):ys!=Hs&&Ni(ys,wr,!0,pt)}}mt&&(dt.idx=U,ph()),w!==!1&&Sn("setCursor")}let vs=null;Object.defineProperty(i,"rect",{get(){return vs==null&&Eo(!1),vs}});function Eo(v=!1){v?vs=null:(vs=g.getBoundingClientRect(),Sn("syncRect",vs))}function Yf(v,w,D,U,H,J,at){ft._lock||_s&&v!=null&&v.movementX==0&&v.movementY==0||(mh(v,w,D,U,H,J,at,!1,v!=null),v!=null?Ws(null,!0,!0):Ws(w,!0,!1))}function mh(v,w,D,U,H,J,at,pt,vt){if(vs==null&&Eo(!1),Zt(v),v!=null)D=v.clientX-vs.left,U=v.clientY-vs.top;else{if(D<0||U<0){Oe=-10,He=-10;return}let[Dt,Nt]=ln.scales,Ft=w.cursor.sync,[ie,Se]=Ft.values,[ye,pe]=Ft.scales,[$t,Wt]=ln.match,ke=w.axes[0].side%2==1,Ke=R.ori==0?B:Rt,Mn=R.ori==1?B:Rt,Pe=ke?J:H,Je=ke?H:J,Kn=ke?U:D,Un=ke?D:U;if(ye!=null?D=$t(Dt,ye)?a(ie,S[Dt],Ke,0):-10:D=Ke*(Kn/Pe),pe!=null?U=Wt(Nt,pe)?a(Se,S[Nt],Mn,0):-10:U=Mn*(Un/Je),R.ori==1){let ui=D;D=U,U=ui}}vt&&(w==null||w.cursor.event.type==tf)&&((D<=1||D>=B-1)&&(D=ar(D,B)),(U<=1||U>=Rt-1)&&(U=ar(U,Rt))),pt?(Vf=D,Gf=U,[Sr,Mr]=ft.move(i,D,U)):(Oe=D,He=U)}let gh={width:0,height:0,left:0,top:0};function _h(){Ua(gh,!1)}let $f,Zf,Kf,Jf;function jf(v,w,D,U,H,J,at){_s=!0,yn=vn=An._x=An._y=!1,mh(v,w,D,U,H,J,at,!0,!1),v!=null&&(xe(ef,af,Qf,!1),Co(Xm,i,Sr,Mr,B,Rt,null));let{left:pt,top:vt,width:Dt,height:Nt}=Be;$f=pt,Zf=vt,Kf=Dt,Jf=Nt}function Qf(v,w,D,U,H,J,at){_s=An._x=An._y=!1,mh(v,w,D,U,H,J,at,!1,!0);let{left:pt,top:vt,width:Dt,height:Nt}=Be,Ft=Dt>0||Nt>0,ie=$f!=pt||Zf!=vt||Kf!=Dt||Jf!=Nt;if(Ft&&ie&&Ua(Be),An.setScale&&Ft&&ie){let Se=pt,ye=Dt,pe=vt,$t=Nt;if(R.ori==1&&(Se=vt,ye=Nt,pe=pt,$t=Dt),yn&&xs(b,Ui(Se,b),Ui(Se+ye,b)),vn)for(let Wt in S){let ke=S[Wt];Wt!=b&&ke.from==null&&ke.min!=De&&xs(Wt,Ui(pe+$t,Wt),Ui(pe,Wt))}_h()}else ft.lock&&(ft._lock=!ft._lock,Ws(w,!0,v!=null));v!=null&&(un(ef,af),Co(ef,i,Oe,He,B,Rt,null))}function H0(v,w,D,U,H,J,at){if(ft._lock)return;Zt(v);let pt=_s;if(_s){let vt=!0,Dt=!0,Nt=10,Ft,ie;R.ori==0?(Ft=yn,ie=vn):(Ft=vn,ie=yn),Ft&&ie&&(vt=Oe<=Nt||Oe>=B-Nt,Dt=He<=Nt||He>=Rt-Nt),Ft&&vt&&(Oe=Oe<Sr?0:B),ie&&Dt&&(He=He<Mr?0:Rt),Ws(null,!0,!0),_s=!1}Oe=-10,He=-10,it.fill(null),Ws(null,!0,!0),pt&&(_s=pt)}function td(v,w,D,U,H,J,at){ft._lock||(Zt(v),wo(),_h(),v!=null&&Co($m,i,Oe,He,B,Rt,null))}function ed(){E.forEach(B1),O(i.width,i.height,!0)}hr(Xc,uo,ed);let Tr={};Tr.mousedown=jf,Tr.mousemove=Yf,Tr.mouseup=Qf,Tr.dblclick=td,Tr.setSeries=(v,w,D,U)=>{let H=ln.match[2];D=H(i,w,D),D!=-1&&Ni(D,U,!0,!1)},ut&&(xe(Xm,g,jf),xe(tf,g,Yf),xe(qm,g,v=>{Zt(v),Eo(!1)}),xe(Ym,g,H0),xe($m,g,td),mf.add(i),i.syncRect=Eo);let Fa=i.hooks=n.hooks||{};function Sn(v,w,D){Nn?Ce.push([v,w,D]):v in Fa&&Fa[v].forEach(U=>{U.call(null,i,w,D)})}(n.plugins||[]).forEach(v=>{for(let w in v.hooks)Fa[w]=(Fa[w]||[]).concat(v.hooks[w])});let nd=(v,w,D)=>D,ln=hn({key:null,setSeries:!1,filters:{pub:rg,sub:rg},scales:[b,_[1]?_[1].scale:null],match:[og,og,nd],values:[null,null]},ft.sync);ln.match.length==2&&ln.match.push(nd),ft.sync=ln;let id=ln.key,xh=n0(id);function Co(v,w,D,U,H,J,at){ln.filters.pub(v,w,D,U,H,J,at)&&xh.pub(v,w,D,U,H,J,at)}xh.sub(i);function W0(v,w,D,U,H,J,at){ln.filters.sub(v,w,D,U,H,J,at)&&Tr[v](null,w,D,U,H,J,at)}i.pub=W0;function X0(){xh.unsub(i),mf.delete(i),xn.clear(),hf(Xc,uo,ed),c.remove(),Mt?.remove(),Sn("destroy")}i.destroy=X0;function yh(){Sn("init",n,t),bo(t||n.data,!1),V[b]?uh(b,V[b]):wo(),st=Be.show&&(Be.width>0||Be.height>0),et=mt=!0,O(n.width,n.height)}return _.forEach(mr),E.forEach(Yi),e?e instanceof HTMLElement?(e.appendChild(c),yh()):e(i,yh):yh(),i}en.assign=hn;en.fmtNum=Mf;en.rangeNum=qc;en.rangeLog=Zc;en.rangeAsinh=vf;en.orient=fr;en.pxRatio=be;en.join=Rw;en.fmtDate=wf,en.tzDate=zw;en.sync=n0;{en.addGap=M1,en.clipGaps=jc;let n=en.paths={points:l0};n.linear=h0,n.stepped=T1,n.bars=A1,n.spline=C1}var nh=210,k1=64,z1=[.01,.02,.05,.1,.2,.5,1,2,5,10,15,30,45,90,180,360,...Z1(3,20)];function vo(n,t,e,i){let s=t.map(r=>V1(r,e,i));n.replaceChildren(...s.map(r=>r.element)),n.classList.add("plots");for(let r of s)r.start();return{charts:s.map(r=>r.chart),dispose:()=>s.forEach(r=>r.dispose())}}function V1(n,t,e){let i=n.lines.map(p=>p.readings?t[p.clip].line(p.readings,p.part):Tn(p.values,Float32Array)),{element:s,key:r,place:o}=If(n),a=W("div",{className:"cursor"}),l=null,c=null,u=!1,h=[],f=new ResizeObserver(()=>l?.setSize({width:o.clientWidth,height:nh}));function d(){let{word:p}=n,_=n.lines.map((E,S)=>W("li",{},qs(fs(S)),p?E.name.slice(p.length+1):E.name));r.replaceChildren(...p?[W("li",{},p)]:[],..._)}function g(){(e.span!==c||e.stretched!==u)&&(c=e.span,u=e.stretched,l.setData(p0(n,i,t,c),!1),l.setScale("x",{min:c.start,max:c.end})),a.style.transform=`translateX(${l.valToPos(e.time,"x").toFixed(2)}px)`}function y(){c=e.span,u=e.stretched,l=new en(G1(n,t,e,o.clientWidth),p0(n,i,t,c),o),l.setScale("x",{min:c.start,max:c.end}),l.over.append(a),$1(l,e),f.observe(o),l.hooks.setSize=[g];let p=()=>{d(),l.redraw(!1)};h=[e.onChange(g),Us(p)],d()}function m(){for(let p of h)p();f.disconnect(),l.destroy()}return{element:s,start:y,dispose:m,get chart(){return l}}}function If(n){let t=W("div",{className:"chart",role:"img","aria-label":n.text}),e=W("ul",{className:"key"}),i=W("h2",{},`${n.title[0].toUpperCase()}${n.title.slice(1)} (${n.unit})`);return{element:W("figure",{},i,e,t,W("figcaption",{},n.text)),key:e,place:t}}function p0(n,t,e,i){let s=n.lines.map((r,o)=>[Float64Array.from(e[r.clip].time,a=>a-i.origins[r.clip]),t[o]]);return n.lines.every(r=>r.clip===n.lines[0].clip)?[s[0]?.[0]??[],...s.map(r=>r[1])]:en.join(s)}function G1(n,t,e,i){let s=ih();return{width:i,height:nh,legend:{show:!1},cursor:{show:!1},padding:[8,10,0,0],scales:{x:{time:!1,auto:!1,distr:100,fwd:e.shareAt,bwd:e.momentAt},y:{range:(r,o,a)=>X1(n,o,a)}},series:[{},...Lf(n.lines)],axes:[{...s,...Df,labelFont:s.font,label:()=>`${e.span.label} (${ba(e.span).unit})${e.stretched?", stretched":""}`,filter:(r,o)=>o,splits:(r,o,a,l,c)=>e.stretched?H1(r,e):W1(a,l,c),values:(r,o)=>o.map(a=>a===null?"":m0(a*ba(e.span).factor)),space:56},Nf(n)],hooks:{drawClear:[r=>q1(r,t,e.span)],draw:[r=>Y1(r,t,e.span)]}}}function H1(n,t){let e=Math.max(2,Math.floor(n.bbox.width/devicePixelRatio/k1)),{factor:i}=ba(t.span),s=new Set;for(let r=0;r<=e;r++){let o=t.momentAt(r/e),a=[1,2,3,4,5,6].map(c=>Number((i*o).toPrecision(c))/i),l=c=>Math.abs(t.shareAt(c)-r/e)<.2/e;s.add(a.find(l)??a[a.length-1])}return[...s].filter(r=>r>=t.span.start&&r<=t.span.end)}function W1(n,t,e){let i=Math.ceil(n/e-1e-9);return Array.from({length:Math.floor(t/e+1e-9)-i+1},(s,r)=>(i+r)*e)}function Lf(n){return n.map((t,e)=>({stroke:()=>fs(e).colour,dash:fs(e).dash,width:1.6,points:{show:!1},spanGaps:!0}))}var Df={size:24,gap:3,labelSize:18,labelGap:0};function ih(){return{stroke:()=>Xe("--muted"),grid:{stroke:()=>Xe("--grid"),width:1},ticks:{stroke:()=>Xe("--grid"),width:1,size:4},font:"12px system-ui, sans-serif"}}function Nf(n){return{...ih(),size:(t,e)=>Math.max(48,16+7*Math.max(0,...(e??[]).map(i=>i.length))),gap:3,values:(t,e)=>e.map(i=>i===null?"":m0(i)),...n.unit==="deg"?{incrs:z1,space:26}:{space:30}}}function X1(n,t,e){let[i,s]=[Math.min(0,t??0),Math.max(0,e??0)],r=.06*(s-i||1);return[n.unit==="deg"||i<0?i-r:i,s+2*r]}function m0(n){let t=Math.abs(n)<1e-12?"0":String(Number(n.toPrecision(6)));return t.length>7?Cn(n):t.replace("-","−")}function q1(n,t,e){if(t.length>1)return;let{ctx:i,bbox:s}=n;i.save(),i.fillStyle=Xe("--band");for(let r of t[0].stages.filter(o=>o.driven)){let[o,a]=[r.start,r.end].map(c=>n.valToPos(c-e.origins[0],"x",!0)),l=Math.max(o,s.left);i.fillRect(l,s.top,Math.max(0,Math.min(a,s.left+s.width)-l),s.height)}i.restore()}function Y1(n,t,e){if(t.length>1)return;let{ctx:i,bbox:s}=n,r=devicePixelRatio;i.save(),i.strokeStyle=Xe("--muted"),i.font=`bold ${12*r}px system-ui, sans-serif`,i.setLineDash([2*r,3*r]);for(let o of t[0].marks){let a=n.valToPos(o.time-e.origins[0],"x",!0);if(a<s.left-1||a>s.left+s.width+1)continue;i.beginPath(),i.moveTo(a,s.top),i.lineTo(a,s.top+s.height),i.stroke();let l=a>s.left+s.width-16*r?-1:1;i.fillStyle=Xe("--page"),i.fillRect(a+(l>0?2:-14)*r,s.top+1*r,12*r,15*r),i.fillStyle=Xe("--ink"),i.textAlign="center",i.fillText(o.letter,a+l*8*r,s.top+13*r)}i.restore()}function $1(n,t){let e=i=>{t.pause(),t.seek(n.posToVal(i.clientX-n.over.getBoundingClientRect().left,"x"))};n.over.addEventListener("pointerdown",i=>{i.button===0&&(n.over.setPointerCapture(i.pointerId),e(i))}),n.over.addEventListener("pointermove",i=>{n.over.hasPointerCapture(i.pointerId)&&e(i)})}function Z1(n,t){return Array.from({length:t-n},(e,i)=>[1,2,5].map(s=>s*10**(n+i))).flat()}function sh(n,t){if(matchMedia("(prefers-reduced-motion: reduce)").matches)return;let e=new IntersectionObserver(i=>{i.some(s=>s.isIntersecting)&&(e.disconnect(),t.play())},{threshold:.3});e.observe(n.querySelector(".picture")??n),n.addEventListener("pointerdown",()=>e.disconnect(),{once:!0})}function g0(n){let t=n.clips.map(Bs),e=ao(t,n.spans),i=lo(document.getElementById("player"),t,e,n);i.stage&&Uf(i.stage.cells,t,e,n.energy);let s=vo(document.getElementById("plots"),n.plots,t,e);return sh(document.getElementById("player"),e),{clips:t,clock:e,player:i,plots:s}}function Uf(n,t,e,i){let s=t.map((r,o)=>{let a=W("span",{className:"state-now"}),l=W("b",{},qs(fs(o)),r.name);return Us(()=>l.replaceChild(qs(fs(o)),l.firstChild)),n[o].append(l,a),a});e.onChange(()=>{for(let[r,o]of t.entries()){let a=e.clipTime(r),c=[e.time+e.span.origins[r]>o.end?"ended":o.stageAt(a).name],[u]=o.readings;u&&c.push(K1(o.valuesAt(u.name,a),u.unit));let h=o.valuesAt(or,a).reduce((f,d)=>f+d,0);o.tendons&&c.push(`${Cn(i.factor*h)} ${i.unit}`),s[r].textContent=c.join(" · ")}})}function K1(n,t){let e=s=>t==="deg"?`${ks(s,0)}°`:`${Cn(s)} ${t}`,i=[Math.min(...n),Math.max(...n)].map(e);return i[0]===i[1]?i[0]:i.join(" to ")}var J1=[.1,.2,.5,1,2,5,10,15,30,45,60,90,180],j1=1.35;function La(n,t,e=[],i=null,s=null){let r=t.map(o=>Q1(o,e[0],i,s));n.replaceChildren(...r.map(o=>o.element)),n.classList.add("plots");for(let o of r)o.start();return r}function Q1(n,t,e,i){let[s,r,o]=[n.lines,n.balls,n.marks].map(b=>b.map(tT)),{element:a,key:l,place:c}=If(n),u=(r.length?r:[s[0]]).map(b=>W("span",{className:"ball"},r.length&&b.name.length<3?b.name:"")),h=r.map(b=>[b.places[0],b.values[0]]),f=Math.round(j1*nh),d=eT(s),g=d,y=null;function m(){let b=s.map((T,L)=>W("li",{},qs(fs(L)),T.name)),x=r.length?"the run now":"moved by the slider";l.replaceChildren(...b,W("li",{},W("span",{className:"ball still"}),x))}function p(){for(let[b,[x,T]]of h.entries()){let[L,P]=[y.valToPos(x,"x"),y.valToPos(T,"y")];u[b].style.transform=`translate(${L.toFixed(2)}px, ${P.toFixed(2)}px)`}}function _(){let[b,x]=Os(t.time,e.clipTime(0));for(let[T,{places:L,values:P}]of r.entries())h[T]=[Ff(L,b,x),Ff(P,b,x)];p()}function E(b){g=b,y.setScale("x",{min:b[0],max:b[1]})}function S(b,x,T){if(g!==d){let{places:R,values:F}=s[0],k=F.filter((Y,G)=>R[G]>=g[0]&&R[G]<=g[1]),[N,V]=[Math.min(...k),Math.max(...k)];return[N-.25*(V-N),V+.25*(V-N)]}let L=r.reduce((R,F)=>Math.max(R,F.most),T),P=Math.min(0,x);return[P-.06*(L-P||1),L+.1*(L-P||1)]}function C(){let b=en.join(s.map(x=>[x.sorted.places,x.sorted.values]));y=new en(nT({data:n,lines:s,balls:r,marks:o,energyRange:S},c.clientWidth,f),b,c),y.over.append(...u),new ResizeObserver(()=>y.setSize({width:c.clientWidth,height:f})).observe(c),y.hooks.setSize=[p],y.hooks.setScale=[p],m(),Us(()=>{m(),y.redraw(!1)}),n.top&&c.after(rT(d,n.top,E)),r.length?(e.onChange(_),oT(y,r,t,e)):aT(n,s[0],c,(x,T)=>{h[0]=[x,T],p()},i),E(d)}return{element:a,start:C,now:h,get chart(){return y}}}function tT({name:n,places:t,values:e}){let i={name:n,places:Tn(t,Float32Array),values:Tn(e,Float32Array)},s=Array.from(i.places.keys()).sort((r,o)=>i.places[r]-i.places[o]);return i.most=i.values.reduce((r,o)=>Math.max(r,o),0),i.sorted={places:s.map(r=>i.places[r]),values:s.map(r=>i.values[r])},i}function Ff(n,t,e){let i=n[Math.min(t+1,n.length-1)];return n[t]+e*(i-n[t])}function eT(n){let t=n.flatMap(s=>[s.sorted.places[0],s.sorted.places.at(-1)]),[e,i]=[Math.min(...t),Math.max(...t)];return[e-.03*(i-e),i+.03*(i-e)]}function nT({data:n,lines:t,balls:e,marks:i,energyRange:s},r,o){let a=ih(),l=Nf(n);return{width:r,height:o,legend:{show:!1},cursor:{show:!1},pxAlign:0,padding:[10,12,0,0],scales:{x:{time:!1,auto:!1,dir:n.backwards?-1:1},y:{range:s}},series:[{},...Lf(t)],axes:[{...a,...Df,labelFont:a.font,label:`${n.axis} (deg)`,values:l.values,incrs:J1,space:44},l],hooks:{draw:[c=>iT(c,e),c=>sT(c,i)]}}}function iT(n,t){let{ctx:e,bbox:i}=n,s=1.6*devicePixelRatio;e.save(),e.globalAlpha=.55,e.fillStyle=Xe("--accent");for(let{places:r,values:o}of t)for(let a=0;a<r.length;a++){let[l,c]=[n.valToPos(r[a],"x",!0),n.valToPos(o[a],"y",!0)];l>i.left&&l<i.left+i.width&&c>i.top&&c<i.top+i.height&&e.fillRect(l-s/2,c-s/2,s,s)}e.restore()}function sT(n,t){let{ctx:e,bbox:i}=n,s=devicePixelRatio;e.save(),e.beginPath(),e.rect(i.left-6*s,i.top,i.width+12*s,i.height+6*s),e.clip(),e.setLineDash([]),e.font=`${12*s}px system-ui, sans-serif`;for(let{name:r,places:o,values:a}of t){let l=Array.from(o,d=>n.valToPos(d,"x",!0)),c=Array.from(a,d=>n.valToPos(d,"y",!0)),[u,h]=[l[l.length>>1],c[c.length>>1]];if(e.beginPath(),l.length===1)e.arc(u,h,4.5*s,0,2*Math.PI),e.fillStyle=Xe("--page"),e.fill(),e.strokeStyle=Xe("--ink"),e.lineWidth=1.4*s,e.stroke();else{e.globalAlpha=.35;for(let d of l.keys())e.lineTo(l[d],c[d]);e.strokeStyle=Xe("--line-2"),e.lineWidth=7*s,e.stroke(),e.globalAlpha=1}let f=l.length>1?0:u>i.left+i.width/2?-1:1;e.fillStyle=Xe("--ink"),e.textAlign=["right","center","left"][f+1],e.fillText(r,u+12*f*s,h-9*s)}e.restore()}function rT(n,t,e){let i=[["whole curve",n],["barrier close up",t]].map(([s,r],o)=>{let a=W("button",{type:"button","aria-pressed":String(o===0)},s);return a.addEventListener("click",()=>{for(let l of i)l.setAttribute("aria-pressed",String(l===a));e(r)}),a});return W("div",{className:"ranges",role:"group","aria-label":"part of the curve"},...i)}function oT(n,t,e,i){let s=r=>{let o=n.over.getBoundingClientRect(),[a,l]=[r.clientX-o.left,r.clientY-o.top],[c,u]=[0,1/0];for(let{places:h,values:f}of t)for(let d=0;d<h.length;d++){let g=Math.hypot(n.valToPos(h[d],"x")-a,n.valToPos(f[d],"y")-l);g<u&&([c,u]=[d,g])}i.pause(),i.seekClip(0,e.time[c])};n.over.addEventListener("pointerdown",r=>{r.button===0&&(n.over.setPointerCapture(r.pointerId),s(r))}),n.over.addEventListener("pointermove",r=>{n.over.hasPointerCapture(r.pointerId)&&s(r)})}function aT(n,t,e,i,s){let r=t.places.length-1,o=W("input",{type:"range",min:"0",max:String(r),value:"0"});o.setAttribute("aria-label",`${n.axis} along the curve`);let a=W("output",{}),l=()=>{let f=Number(o.value);i(t.places[f],t.values[f]),a.textContent=`${Cn(t.places[f])}°, ${Cn(t.values[f])} ${n.unit}`,o.setAttribute("aria-valuetext",a.textContent)},c=n.poses&&s?Tn(n.poses,Float32Array):null,u=!1;o.addEventListener("input",()=>{l(),u=!0,c&&s.seek(lT(c,t.places[Number(o.value)]))}),c&&s.onChange(()=>{u||(o.value=String(cT(t.places,Ff(c,Math.floor(s.time),s.time%1))),l()),u=!1});let h=n.drawn?[W("p",{className:"note"},n.drawn)]:[];e.after(W("div",{className:"slide"},o,a),...h),l()}function lT(n,t){let e=n[n.length-1]>=n[0]?1:-1,i=n.findIndex(r=>e*r>=e*t);if(i<=0)return i===0?0:n.length-1;let s=n[i]-n[i-1];return i-1+(s?(t-n[i-1])/s:0)}function cT(n,t){return n.reduce((e,i,s)=>Math.abs(i-t)<Math.abs(n[e]-t)?s:e,0)}function _0(n){let t=new Set,e={start:n.start,end:n.end,origins:[0]},i=n.start,s=0;function r(){s||=requestAnimationFrame(()=>{s=0;for(let o of t)o()})}return{get time(){return i},span:e,clipTime:(o,a=i)=>Math.min(n.end,Math.max(n.start,a)),timeAt:o=>e.start+o*(e.end-e.start),wayAt:o=>(o-e.start)/(e.end-e.start||1),onChange(o){return t.add(o),r(),()=>t.delete(o)},seek(o){i=Math.min(e.end,Math.max(e.start,o)),r()}}}function x0(n){let t=document.getElementById("curves");if(!n.clips)return{curves:La(t,n.curves)};let e=n.clips.map(Bs),i=_0(e[0]),s=Om(document.getElementById("player"),e,i,n);return{clips:e,clock:i,player:s,curves:La(t,n.curves,[],null,i)}}var hT={deg:.05};function rh(n,t,e,i,s=0){let{heading:r,names:o}=t.mesh.parts,a=t.readings.map(g=>({name:g.name,title:g.row,parts:g.parts,text:y=>Of(y,g.unit),ofState:y=>y.readings[g.name]&&uT(y.readings[g.name],g.unit)})),l=g=>Cn(i.factor*g);t.tendons&&a.push({name:or,title:`tendon energy (${i.unit})`,parts:t.mesh.tendonParts,text:l,ofState:g=>g.tendonEnergy_J.map(l)});let c=a.map(()=>o.map(()=>W("td"))),u=W("caption"),h=W("tr",{},W("th",{scope:"col"},r),...o.map(g=>W("th",{scope:"col"},g))),f=a.map((g,y)=>W("tr",{},W("th",{scope:"row"},g.title),...c[y])),d=W("table",{className:"numbers"},u,W("thead",{},h),W("tbody",{},...f));return n.replaceChildren(W("div",{className:"table"},d)),n.classList.add("readout"),e.onChange(()=>{let g=e.clipTime(s),y=t.markAt(g),m=y?`, ${y.name} (means)`:"";u.textContent=`${r?`Every ${r}`:"Everything"} at ${wa(e.time,e.span)}${m}`;for(let[p,_]of a.entries()){let E=y&&_.ofState(y)||Array.from(t.valuesAt(_.name,g),_.text);for(let[S,C]of _.parts.entries())c[p][C].textContent=E[S]}})}function Of(n,t){return t==="deg"?ks(n,1):Cn(n)}function uT({mean:n,swing:t},e){return n.map((i,s)=>{let r=t[s]>(hT[e]??.005*Math.abs(i));return`${Of(i,e)}${r?` ± ${Of(t[s],e)}`:""}`})}function y0(n){let t=n.clips.map(Bs),e=ao(t,n.spans),i=lo(document.getElementById("player"),t,e,n),s=n.curves?La(document.getElementById("curves"),n.curves,t,e):[],r=vo(document.getElementById("plots"),n.plots,t,e);return rh(document.getElementById("readout"),t[0],e,n.energy),sh(document.getElementById("player"),e),{clips:t,clock:e,player:i,curves:s,plots:r}}function oh(n){return n.energy?oo:rm}function v0(n,t){let e=n.at(t).map(s=>Math.round(255*s)),i=.299*e[0]+.587*e[1]+.114*e[2]>118;return{face:`rgb(${e.join(" ")})`,ink:i?"#000":"#fff"}}var fT={"●":"opened","◆":"folded","■":"closed","×":"unfolded","✱":"stuck","↺":"returned","↻":"reclosed","▷":"moving","◁":"opening","≠":"untrusted","✚":"diverged","⊘":"unbuilt","–":"untried","·":"unrun","⊗":"before"};function dr(n){return`what ${fT[n]??"other"}`}var dT=["energy","time by torque"];function S0(n,t){let{factors:e,quantities:i,words:s}=n,r=e.map(h=>h.values.length),o=new Map;for(let h of t)o.set(h.point,[...o.get(h.point)??[],h]);function a(h){if(n.sampled)return e.map(()=>h);let f=[];for(let d=r.length-1;d>=0;d--)f[d]=h%r[d],h=Math.floor(h/r[d]);return f}let l=h=>h.reduce((f,d,g)=>f*r[g]+d,0);function c(h){let d=(dT.includes(h.group)?i.filter(_=>_.group===h.group):[h]).flatMap(_=>_.values??[]).filter(_=>_!==null);if(!d.length)return null;let[g,y]=[d.reduce((_,E)=>Math.min(_,E)),d.reduce((_,E)=>Math.max(_,E))],m=_=>y>g?(_-g)/(y-g):.5,p=pT((h.values??[]).filter(_=>_!==null));return{low:g,high:y,colour:_=>v0(oh(h),m(_)),text:_=>ah(Number(_.toFixed(p)))}}let u=(h,f)=>`${h.name} ${h.texts[f]}${h.unit?` ${h.unit}`:""}`;return{study:n,sizes:r,placesOf:a,pointAt:l,scaleOf:c,factorText:u,largestSpan:t.reduce((h,f)=>Math.max(h,f.play.clips[0].span_m),0),runsOf:h=>o.get(h)??[],word:h=>s[h],pointText:h=>a(h).map((f,d)=>u(e[d],f)).join(", "),valueText(h,f){let d=h.values?.[f]??null;return d===null?s[h.reasons[f]].word:`${ah(d)} ${h.unit}`}}}function pT(n){let t=n.reduce((e,i)=>Math.max(e,Math.abs(i)),0);return Math.min(20,Math.max(0,2-Math.floor(Math.log10(t||1))))}function ah(n){return String(Number(n.toPrecision(3))).replace("-","−")}var mT="http://www.w3.org/2000/svg",[M0,Bf]=[600,420],lh={left:64,right:14,top:12,bottom:52};function w0(n,t,e){let{factors:i,points:s}=n.study,{quantity:r}=t,o=Array.from({length:s},(g,y)=>y),a=n.scaleOf(r),l=b0(i[t.x].values,i[t.x],lh.left,M0-lh.right),c=t.y===null?r.values??o.map(()=>0):i[t.y].values,u=t.y===null?{name:r.title,unit:r.unit}:i[t.y],h=b0(c,u,Bf-lh.bottom,lh.top),f=pr("svg",{viewBox:`0 0 ${M0} ${Bf}`,class:"scatter",role:"listbox","aria-label":`${r.title} of ${s} drawn points; arrows move between them, enter opens one`});f.append(...yT(l,h));let d=o.map(g=>gT(n,t,a,g,l.place(g),h.place(g)));return f.append(...d),(d[t.current??0]??d[0])?.setAttribute("tabindex","0"),_T(f,d,e),{element:W("div",{className:"scroll"},f),points:o}}function gT(n,t,e,i,s,r){let{quantity:o}=t,a=o.values?.[i]??null,l=`${n.pointText(i)}: ${n.valueText(o,i)}`,c=pr("g",{role:"option",tabindex:"-1","aria-label":l,"aria-selected":String(t.opened===i),"data-point":i,transform:`translate(${s.toFixed(1)} ${r.toFixed(1)})`}),u=pr("title",{});u.textContent=l,c.append(u);let h=a===null?n.word(o.reasons[i]).sign:"";if(h&&c.setAttribute("class",dr(h)),c.append(pr("circle",{r:8,class:a===null?"missing":"found",fill:a===null?"transparent":e.colour(a).face})),h){let f=pr("text",{"text-anchor":"middle",dy:"0.36em"});f.textContent=h,c.append(f)}return c}function _T(n,t,e){let i=r=>r.target.closest("[data-point]");n.addEventListener("click",r=>{i(r)&&e(Number(i(r).dataset.point))});let s={ArrowLeft:-1,ArrowUp:-1,ArrowRight:1,ArrowDown:1};n.addEventListener("keydown",r=>{let o=i(r);if(!o||r.ctrlKey||r.metaKey||r.altKey)return;let a=Number(o.dataset.point);if(r.key==="Enter"||r.key===" ")e(a);else if(r.key in s)t[a+s[r.key]]&&(o.setAttribute("tabindex","-1"),t[a+s[r.key]].setAttribute("tabindex","0"),t[a+s[r.key]].focus());else return;r.preventDefault()})}function b0(n,t,e,i){let s=t.unit?`${t.name} (${t.unit})`:t.name,r=n.filter(d=>typeof d=="number"),o=[...new Set(n.filter(d=>typeof d=="string"))],a=o.length?d=>o.indexOf(d):d=>d,l=o.length?-.5:Math.min(...r),c=o.length?o.length-.5:Math.max(...r),u=.04*(i-e),h=d=>e+u+(a(d)-l)/(c-l||1)*(i-e-2*u),f=o.length?o:r.length?xT(l,c):[];return{label:s,from:e,to:i,ticks:f.map(d=>[h(d),typeof d=="number"?ah(d):d]),place:d=>n[d]===null?e:h(n[d])}}function xT(n,t){if(!(t>n))return[n];let e=(t-n)/5,i=10**Math.floor(Math.log10(e)),s=i*([1,2,5].find(o=>o*i>=e)??10),r=[];for(let o=Math.ceil(n/s)*s;o<=t+1e-9*s;o+=s)r.push(Number(o.toPrecision(12)));return r}function yT(n,t){let e=[pr("path",{class:"axis",d:`M${n.from} ${t.to}V${t.from}H${n.to}`})],i=(s,r)=>{let o=pr("text",{class:"label",...r});o.textContent=s,e.push(o)};for(let[s,r]of n.ticks)i(r,{x:s,y:t.from+18,"text-anchor":"middle"});for(let[s,r]of t.ticks)i(r,{x:n.from-8,y:s,dy:"0.35em","text-anchor":"end"});return i(n.label,{x:(n.from+n.to)/2,y:Bf-8,"text-anchor":"middle"}),i(t.label,{transform:`translate(14 ${(t.from+t.to)/2}) rotate(-90)`,"text-anchor":"middle"}),e}function pr(n,t){let e=document.createElementNS(mT,n);for(let[i,s]of Object.entries(t))e.setAttribute(i,s);return e}var vT=2e4,ST=16,MT=16,T0={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]};function C0(n,t){let{quantities:e,sampled:i}=n.study,s=n.study.axes.filter(y=>n.sizes[y]>1),[r,o]=s.length>1?s:[null,s[0]??0],a={quantity:e[0],x:o,y:r,fixed:[...n.study.cuts],current:null,opened:null},l=W("div",{className:"map-place"}),c=W("div",{className:"map-legend"}),u=W("p",{className:"note"}),h=()=>{let y=i?w0(n,a,f):TT(n,a,f);l.replaceChildren(y.element),c.replaceChildren(...CT(n,a.quantity,y.points)),u.textContent=RT(n,a.quantity,y.points)},f=y=>{a.current=a.opened=y,bT(l,y),t(y,a.quantity)},d=wT(n,a,s,h),g=W("section",{className:"map"},W("h2",{},"Map"),d.element,l,c,u);return h(),{element:g,show(y){a.current=a.opened=y,i||(a.fixed=n.placesOf(y)),d.fill(),h()}}}function bT(n,t){for(let e of n.querySelectorAll("[data-point]")){let i=Number(e.dataset.point)===t;e.setAttribute("aria-selected",String(i)),e.tabIndex=i?0:-1}}function wT(n,t,e,i){let{factors:s,quantities:r,sampled:o}=n.study,a=W("div",{className:"choices"}),l=(h,f,d,g)=>{let y=W("select",{},...f.map(([m,p])=>W("option",{value:String(m)},p)));return y.value=String(d),y.addEventListener("change",()=>{g(Number(y.value)),u(),i(),[...a.querySelectorAll("label")].find(m=>m.dataset.name===h)?.querySelector("select").focus()}),W("label",{},`${h} `,y)},c=(h,f)=>d=>{t[f]===d&&(t[f]=t[h]),t[h]=d};function u(){let h=[l("show",r.map((f,d)=>[d,f.title]),r.indexOf(t.quantity),f=>{t.quantity=r[f]})];if(e.length>2){let f=e.map(d=>[d,s[d].name]);h.push(l("across",f,t.x,c("x","y")),l("upwards",f,t.y,c("y","x")))}for(let f of e.filter(d=>!o&&d!==t.x&&d!==t.y)){let d=s[f].texts.map((g,y)=>[y,s[f].unit?`${g} ${s[f].unit}`:g]);h.push(l(s[f].name,d,t.fixed[f],g=>{t.fixed[f]=g}))}for(let f of h)f.dataset.name=f.firstChild.textContent.trim();a.replaceChildren(...h)}return u(),{element:a,fill:u}}function TT(n,t,e){let{factors:i}=n.study,[s,r]=[n.sizes[t.x],t.y===null?1:n.sizes[t.y]];if(s*r>vT)return{element:W("p",{className:"note"},"This map has too many cells for a page; the study's figures have it."),points:[]};let o=n.scaleOf(t.quantity),a=s<=ST,l=(p,_)=>n.pointAt(t.fixed.map((E,S)=>S===t.x?p:S===t.y?_:E)),c=new Map,u=[],h=[];for(let p=r-1;p>=0;p--){let _=W("tr",{},W("th",{scope:"row"},t.y===null?"":E0(i[t.y],p)));for(let E=0;E<s;E++){let S=l(E,p),C=W("td",{tabIndex:-1,role:"gridcell"});AT(C,n,t,o,S,a),c.set(`${E} ${p}`,C),h.push(S),_.append(C)}u.push(_)}let f=i[t.x].texts.map((p,_)=>W("th",{scope:"col"},E0(i[t.x],_)));u.push(W("tr",{className:"feet"},W("td"),...f));let d=W("table",{role:"grid",className:a?"grid":"grid small","aria-label":IT(n,t)},W("tbody",{},...u));d.style.setProperty("--columns",s);let g=[...c.values()].find(p=>Number(p.dataset.point)===t.current)??c.get("0 0");g.tabIndex=0,ET(d,c,e);let y=W("div",{className:"upwards"},t.y===null?"":A0(i[t.y])),m=W("div",{className:"across"},A0(i[t.x]));return{element:W("div",{className:r<6?"axes low":"axes"},y,W("div",{},W("div",{className:"scroll"},d),m)),points:h}}function AT(n,t,e,i,s,r){let{quantity:o}=e,a=o.values?.[s]??null;n.dataset.point=s,n.setAttribute("aria-selected",String(e.opened===s));let l=`${t.pointText(s)}: ${o.values?`${o.title} `:""}${t.valueText(o,s)}`;if(n.setAttribute("aria-label",l),n.title=l,a===null){let{sign:h}=t.word(o.reasons[s]);n.className=dr(h),n.append(W("span",{},r?h:""));return}let{face:c,ink:u}=i.colour(a);n.style.background=c,n.style.color=u,n.textContent=r?i.text(a):""}function ET(n,t,e){let i=new Map([...t].map(([s,r])=>[r,s.split(" ").map(Number)]));n.addEventListener("click",s=>{let r=s.target.closest("[data-point]");r&&e(Number(r.dataset.point))}),n.addEventListener("keydown",s=>{let r=s.target.closest("[data-point]");if(!r||s.ctrlKey||s.metaKey||s.altKey)return;let[o,a]=i.get(r),[l,c]=T0[s.key]??[0,0],u=Math.max(...[...i.values()].map(([f])=>f)),h={Home:`0 ${a}`,End:`${u} ${a}`}[s.key]??`${o+l} ${a+c}`;if(s.key==="Enter"||s.key===" ")e(Number(r.dataset.point));else{if(!(s.key in T0)&&s.key!=="Home"&&s.key!=="End")return;t.has(h)&&(r.tabIndex=-1,t.get(h).tabIndex=0,t.get(h).focus())}s.preventDefault()})}function CT(n,t,e){let i=[],s=n.scaleOf(t);if(s){let o=W("span",{className:"bar","aria-hidden":"true"});o.style.background=oh(t).gradient,i.push(W("p",{className:"scale"},`${t.title} (${t.unit})`,W("span",{},s.text(s.low)),o,W("span",{},s.text(s.high))))}let r=[...R0(t,e)].map(([o,a])=>{let{word:l,sign:c}=n.word(o);return W("li",{},W("span",{className:dr(c),"aria-hidden":"true"},W("span",{},c)),`${l} (${a})`)});return r.length&&i.push(W("ul",{},...r)),i}function R0(n,t){let e=new Map;for(let i of t){let s=n.reasons[i];s!==null&&e.set(s,(e.get(s)??0)+1)}return new Map([...e].sort(([i],[s])=>i-s))}function RT(n,t,e){let i=e.filter(c=>(t.values?.[c]??null)!==null),s=[...R0(t,e)].map(([c,u])=>`${u} ${n.word(c).word}`),r=`${t.title[0].toUpperCase()}${t.title.slice(1)}`;if(!i.length)return`${r} of ${e.length} points: ${s.join(", ")||"none"}.`;let o=s.length?` The others: ${s.join(", ")}.`:"",[a,l]=[Math.min,Math.max].map(c=>PT(n,t,i,c));return`${r}, known of ${i.length} of ${e.length} points: from ${a} to ${l}.${o}`}function PT(n,t,e,i){let s=e.map(a=>t.values[a]).reduce((a,l)=>i(a,l)),r=e.filter(a=>t.values[a]===s),o=r.length>1?`${r.length} points`:n.pointText(r[0]);return`${n.valueText(t,r[0])} (${o})`}function IT(n,t){let{factors:e}=n.study,i=t.y===null?e[t.x].name:`${e[t.x].name} across and ${e[t.y].name} upwards`;return`${t.quantity.title} over ${i}; arrows move between cells, enter opens one`}function A0(n){return n.unit?`${n.name} (${n.unit})`:n.name}function E0(n,t){let e=Math.ceil(n.texts.length/MT);return t%e?"":n.texts[t]}function ch(n=document){let t=new ResizeObserver(e=>{for(let{target:i}of e)i.scrollWidth>i.clientWidth?i.tabIndex=0:i.removeAttribute("tabindex")});for(let e of n.querySelectorAll(".table"))t.observe(e)}var LT=["torque","time","work","energy"];function P0(n){let t=W("h2"),e=W("p",{className:"outcome",role:"status"}),i=W("table",{className:"numbers"}),s=W("section",{className:"facts",id:"point"},t,e,W("div",{className:"table"},i)),r=W("div",{className:"parts",role:"group","aria-label":"runs of this point"}),o=W("div"),a=W("section",{className:"run",id:"run","aria-label":"the run that is open"},r,o),l={facts:s,element:a,point:null,playing:null,open:h,show:g},c=null,u=Yu();function h(m,{play:p=!1,transition:_=null}={}){l.point=m;let E=n.runsOf(m);t.textContent=`Point ${m+1}`,e.textContent=`${kf(n.pointText(m))}: ${n.study.statuses[m]}.`,i.replaceChildren(W("caption",{},"In the study’s table"),W("tbody",{},...FT(n,m))),r.replaceChildren(...E.length>1?E.map(f):E.map(S=>W("b",{},kf(S.title)))),E.length?g((_===null?null:E.find(S=>S.transition===_))??E[0],{play:p}):(d(),o.replaceChildren(W("p",{className:"note"},OT(n,m))))}function f(m){let p=W("button",{type:"button"},m.title);return p.dataset.part=m.part,p.addEventListener("click",()=>g(m,{play:!0})),p}function d(){l.playing?.dispose(),l.playing=null}function g(m,{play:p=!1}={}){d();for(let b of r.querySelectorAll("button"))b.setAttribute("aria-pressed",String(b.dataset.part===m.part));let _=c&&c!==m?c:null,E={player:W("div"),plots:W("div"),readout:W("div")},S=W("div",{className:"table"});S.innerHTML=m.numbers;let C=W("details",{},W("summary",{},"States of this run"),S);o.replaceChildren(W("p",{},m.text),y(m),...m.advice?[W("p",{className:"note"},m.advice)]:[],E.player,..._?[W("p",{className:"note"},`The plots and numbers below are those of point ${m.point+1}.`)]:[],E.plots,E.readout,C,BT(m)),u.scale=n.largestSpan/m.play.clips[0].span_m,l.playing={run:m,beside:_,...DT(E,m,_,n,u)},ch(o),p&&!matchMedia("(prefers-reduced-motion: reduce)").matches&&l.playing.clock.play()}function y(m){let _=W("button",{type:"button",className:"pin"},c?`unpin point ${c.point+1}`:"pin, to compare it with another");return _.setAttribute("aria-pressed",String(c!==null)),_.addEventListener("click",()=>{c=c?null:m,g(m),o.querySelector(".pin").focus()}),_}return l}function DT(n,t,e,i,s){let r=e?[e,t]:[t],o=r.map(g=>({...Bs(g.play.clips[0]),...e?{name:NT(g,i)}:{}})),a=ao(o,e?[UT(o)]:t.play.spans),l=r.map(g=>g.play.energy).reduce((g,y)=>y.largest_J>g.largest_J?y:g),c=e?`${kf(o[0].name)} and ${o[1].name}, side by side on one clock.`:t.play.text,u=lo(n.player,o,a,{...t.play,energy:l,text:c},s);e&&u.stage&&Uf(u.stage.cells,o,a,l);let h=o.length-1,f=t.play.plots.map(g=>({...g,lines:g.lines.map(y=>({...y,clip:h}))})),d=vo(n.plots,f,o,a);return rh(n.readout,o[h],a,l,h),{clips:o,clock:a,player:u,plots:d,dispose(){u.dispose(),d.dispose()}}}function NT(n,t){let{factors:e}=t.study,i=t.placesOf(n.point).map((s,r)=>`${e[r].texts[s]} ${e[r].unit}`.trim());return`point ${n.point+1}: ${i.join(", ")}`}function UT(n){let t=n.map(s=>s.stages.find(r=>r.driven)?.start??s.start),[e,i]=[Math.min(...n.map((s,r)=>s.start-t[r])),Math.max(...n.map((s,r)=>s.end-t[r]))];return{name:"whole runs",label:"time since the first drive acts",start:e,end:i,origins:t,whole:!0}}function FT(n,t){return n.study.quantities.filter(i=>LT.includes(i.group)).map(i=>W("tr",{},W("th",{scope:"row"},i.title),W("td",{},n.valueText(i,t))))}function OT(n,t){return n.study.built[t]?"This run was not kept, so it cannot be played here. The study keeps the runs of as many points as --keep says.":"There is nothing to play: this point cannot be built."}function BT(n){let t=[`forficula run ${n.folder}/design.toml`,`forficula film ${n.folder} --out film.mp4`];return W("details",{},W("summary",{},"Commands"),W("p",{className:"note"},"In the study’s folder, these run it again, and film it:"),W("pre",{},W("code",{},t.join(`
`))))}function kf(n){return`${n[0]?.toUpperCase()??""}${n.slice(1)}`}function I0(n,t,e,i){let s=n?.querySelector("table");if(!s)return;let r=[...s.tBodies[0].rows],o=W("p",{className:"note",role:"status"}),a=kT(t,()=>{let u=a.shown(),h=0;for(let[f,d]of r.entries())d.hidden=!u.has(t.study.verdicts[f]),h+=d.hidden?0:1;o.textContent=`${h} of ${r.length} points shown.`});for(let[u,h]of r.entries()){let f=W("button",{type:"button","aria-label":`open point ${u+1}`},h.cells[0].textContent);f.addEventListener("click",()=>i(u)),h.cells[0].replaceChildren(f)}let l=t.study.factors.length+1;for(let u of[s.tHead.rows[0],...r])u.cells[l].classList.add("words");VT(s,r,zT(t));let c=W("div",{className:"choices"},a.element,...e?[HT(e)]:[]);s.closest(".table").before(c,o),a.changed()}function kT(n,t){let e=new Map,i=n.study.words.flatMap(({word:r,sign:o,count:a},l)=>{if(!a)return[];let c=W("input",{type:"checkbox",checked:!0});return c.addEventListener("change",t),e.set(l,c),[W("label",{},c,W("span",{className:dr(o),"aria-hidden":"true"},W("span",{},o)),`${r} (${a})`)]});return{element:W("fieldset",{className:"filter"},W("legend",{},"Show points that"),...i),changed:t,shown:()=>new Set([...e].filter(([,r])=>r.checked).map(([r])=>r))}}function zT(n){let{study:t}=n,e=t.statuses.map((r,o)=>o),i=t.factors.map((r,o)=>e.map(a=>r.values[n.placesOf(a)[o]])),s=t.quantities.filter(r=>["torque","time","work","energy"].includes(r.group)).map(r=>r.values);return[e,...i,t.statuses,...s]}function VT(n,t,e){let i=[...n.tHead.rows[0].cells];for(let[s,r]of i.entries()){let o=W("button",{type:"button"},...r.childNodes);r.replaceChildren(o),o.addEventListener("click",()=>{let a=r.getAttribute("aria-sort")==="ascending";for(let c of i)c.removeAttribute("aria-sort");r.setAttribute("aria-sort",a?"descending":"ascending");let l=t.map((c,u)=>u).sort((c,u)=>GT(e[s][c],e[s][u],a?-1:1)||c-u);n.tBodies[0].append(...l.map(c=>t[c]))})}i[0].setAttribute("aria-sort","ascending")}function GT(n,t,e){if(n===null||t===null)return(n===null)-(t===null);let i=typeof n=="number"?n-t:String(n).localeCompare(String(t),"en");return e*i}function HT(n){let t=W("button",{type:"button",className:"button"},"Download table.csv");return t.addEventListener("click",()=>{let e=URL.createObjectURL(new Blob([n],{type:"text/csv;charset=utf-8"}));W("a",{href:e,download:"table.csv"}).click(),setTimeout(()=>URL.revokeObjectURL(e),1e4)}),t}function L0(n){let t=S0(n.study,n.runs),e=P0(t),i=(a,l=null)=>{e.open(a,{play:!0,transition:l}),XT(e)},s=C0(t,(a,l)=>i(a,l.transition)),r=W("div",{},s.element,e.facts);document.getElementById("explorer").replaceChildren(W("div",{className:"explorer"},r,e.element)),I0(document.getElementById("points"),t,n.csv,a=>{s.show(a),i(a)});let o=WT(t,n.runs);return e.open(o),s.show(o),{model:t,map:s,panel:e,open:i}}function WT(n,t){let e=n.study.quantities.filter(o=>o.group==="torque"),i=o=>[n.study.verdicts[o],...e.map(a=>a.values[o]??1/0),o],s=(o,a)=>{let l=o.findIndex((c,u)=>c!==a[u]);return l>=0&&o[l]<a[l]};return t.map(o=>o.point).reduce((o,a)=>o===null||s(i(a),i(o))?a:o,null)??0}function XT({facts:n,element:t}){let{top:e}=t.getBoundingClientRect();if(e>=0&&e<.5*innerHeight)return;let i=n.getBoundingClientRect().left===t.getBoundingClientRect().left,s=matchMedia("(prefers-reduced-motion: reduce)").matches;(i?n:t).scrollIntoView({behavior:s?"auto":"smooth",block:"start"})}var qT={run:y0,compare:g0,curves:x0,study:L0},D0=JSON.parse(document.getElementById("data").textContent);try{window.forficula=qT[D0.kind](D0)}catch(n){let t=`What moves cannot be shown in this browser (${n.message}); the numbers below are all there.`;throw document.querySelector("main").prepend(W("p",{className:"note",role:"alert"},t)),n}ch();})();
